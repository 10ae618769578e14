//! Games made by hand. Key `A` is that of an assumption, `G` and `H` are those of guarantees.

use super::{State, game, solved, solved_ending};
use synth_core::game::Turn;

const A: u32 = 0;
const G: u32 = 1;
const H: u32 = 2;

/// A state with these open keys and edges, each with its target and what it discharges.
fn state<const N: usize>(turn: Turn, open: &[u32], edges: [(usize, &[u32]); N]) -> State {
    let edges = edges.iter().map(|&(target, discharged)| (target, discharged.to_vec())).collect();
    State { turn, silent: false, open: open.to_vec(), edges }
}

fn environment<const N: usize>(open: &[u32], edges: [(usize, &[u32]); N]) -> State {
    state(Turn::EnvironmentAny, open, edges)
}

fn silent<const N: usize>(open: &[u32], edges: [(usize, &[u32]); N]) -> State {
    State { silent: true, ..environment(open, edges) }
}

fn system<const N: usize>(open: &[u32], edges: [(usize, &[u32]); N]) -> State {
    state(Turn::SystemUrgent, open, edges)
}

fn lost() -> State {
    state(Turn::Lost, &[], [])
}

/// The states of the strategy's nodes; none if the environment wins.
#[track_caller]
fn check(states: &[State], expect: &[u32]) {
    let strategy = solved(&game(states, 1, 2));
    assert_eq!(strategy.map_or(Vec::new(), |strategy| strategy.state), expect);
}

#[test]
fn silence_that_breaks_an_assumption_is_no_danger() {
    check(&[silent(&[A, G], [(0, &[A, G])])], &[0]);
}

#[test]
fn silence_that_breaks_no_assumption_is_a_danger() {
    check(&[silent(&[G], [(0, &[G])])], &[]);
}

#[test]
fn an_idle_environment_owes_nothing() {
    check(&[silent(&[], [])], &[0]);
}

#[test]
fn the_environment_may_do_something_else_only_while_it_is_not_unfair() {
    check(&[environment(&[A, G], [(0, &[]), (1, &[A])]), system(&[G], [(0, &[G])])], &[0, 1]);
    check(&[environment(&[G], [(0, &[]), (1, &[A])]), system(&[G], [(0, &[G])])], &[]);
}

#[test]
fn discharging_counts_although_the_key_is_open_before_and_after() {
    check(&[environment(&[G], [(0, &[G])])], &[0]);
    check(&[environment(&[G], [(0, &[H])])], &[]);
}

#[test]
fn a_key_that_is_not_open_now_and_then_is_met() {
    check(&[environment(&[G], [(1, &[])]), environment(&[], [(0, &[])])], &[0, 1]);
}

#[test]
fn the_initial_state_may_be_lost() {
    check(&[lost()], &[]);
}

#[test]
fn the_system_keeps_away_from_where_the_environment_can_leave_for_lost() {
    let trap = environment(&[], [(0, &[]), (2, &[])]);
    check(&[system(&[], [(1, &[]), (3, &[])]), trap, lost(), silent(&[], [])], &[0, 3]);
}

#[test]
fn won_meets_everything() {
    check(&[system(&[G], [(1, &[])]), state(Turn::Won, &[A, G, H], [])], &[0, 1]);
}

#[test]
fn a_super_step_has_to_end() {
    check(&[system(&[], [(1, &[])]), system(&[], [(0, &[])])], &[]);
}

#[test]
fn a_super_step_without_end_wins_while_an_assumption_is_open() {
    // Not a welcome win, but the winning condition says so: the environment is kept from meeting its assumption.
    check(&[system(&[A], [(0, &[])])], &[0]);
}

#[test]
fn a_super_step_without_end_does_not_win_where_super_steps_must_end() {
    assert_eq!(solved_ending(&game(&[system(&[A], [(0, &[])])], 1, 2)), None);
}

#[test]
fn super_steps_end_where_that_is_possible() {
    // Two assumptions, 0 and 1. A super step without end meets neither; one that ends still does not meet the second.
    let states = [system(&[0, 1, 2], [(0, &[]), (1, &[])]), environment(&[1, 2], [(0, &[])])];
    let game = game(&states, 2, 1);
    let endless = solved(&game).expect("a strategy");
    assert_eq!((endless.state.as_slice(), endless.endless_run(&game)), ([0].as_slice(), Some(0)));
    let ending = solved_ending(&game).expect("a strategy");
    assert_eq!((ending.state.as_slice(), ending.endless_run(&game)), ([0, 1].as_slice(), None));
}

#[test]
fn the_shorter_super_step_is_preferred() {
    let end = silent(&[], []);
    check(&[system(&[], [(1, &[]), (2, &[])]), system(&[], [(2, &[])]), end], &[0, 2]);
}

#[test]
fn progress_is_preferred_to_a_short_super_step_and_then_the_shorter_one() {
    let states = [
        system(&[G], [(1, &[]), (2, &[]), (3, &[])]),
        system(&[], [(2, &[])]),
        system(&[], [(3, &[])]),
        environment(&[G], [(0, &[])]),
    ];
    check(&states, &[0, 2, 3]);
}

#[test]
fn the_first_of_equal_moves_is_preferred() {
    check(&[system(&[], [(2, &[]), (1, &[])]), silent(&[], []), silent(&[], [])], &[0, 2]);
}

#[test]
fn a_yield_is_preferred_to_an_event_that_serves_nothing() {
    let eventually = |open: &[u32]| state(Turn::SystemEventually, open, [(1, &[G]), (2, &[])]);
    let ends = [environment(&[], [(0, &[])]), environment(&[], [(0, &[])])];
    check(&[&[eventually(&[])], &ends[..]].concat(), &[0, 2]);
}

#[test]
fn two_goals_that_one_state_serves_by_different_moves_need_memory() {
    let lamp = |key: u32| environment(&[G, H], if key == G { [(0, &[G])] } else { [(0, &[H])] });
    let choice = system(&[G, H], [(1, &[]), (2, &[])]);
    check(&[choice, lamp(G), lamp(H)], &[0, 1, 0, 2]);
}

#[test]
fn goals_that_can_be_served_one_after_the_other_need_no_memory() {
    // Both keys are open, each move serves one, and the environment opens both again.
    let states = [
        system(&[G, H], [(1, &[G]), (2, &[H])]),
        system(&[H], [(3, &[H])]),
        system(&[G], [(3, &[G])]),
        environment(&[], [(0, &[])]),
    ];
    check(&states, &[0, 1, 3]);
}

//! Plays that the environment forces, checked against the definition of who wins a play.

use super::{State, game, naive, solved};
use std::collections::BTreeMap;
use synth_core::game::{
    CounterPlay, CounterStrategy, Game, Loss, Solution, Standing, Turn, counter_play, solve,
};

/// Panics unless the play is one of the game, leads through losing states only and is lost as it says.
pub(crate) fn assert_lost(game: &Game, winning: &[bool], counter: &CounterPlay) {
    let CounterPlay { play, cycle, loss } = counter;
    let end = walk(game, winning, game.initial, play);
    match loss {
        Loss::Violation => {
            assert!(cycle.is_empty());
            let stuck = game.turn[end as usize].is_system() && game.edges_of(end).is_empty();
            assert!(
                game.turn[end as usize] == Turn::Lost || stuck,
                "the play does not end in the losing state"
            );
        }
        Loss::Starvation(key) => {
            assert!(game.guarantees.contains(key), "key {key} is not one of a guarantee");
            let met = meets(game, *key, end, cycle);
            assert!(!met, "key {key} is met");
        }
        Loss::Endless => {
            let is_system = |edge: &u32| {
                let source = game.first.partition_point(|&first| first <= *edge) - 1;
                game.turn[source].is_system()
            };
            assert!(!cycle.is_empty() && cycle.iter().all(is_system), "the super step ends");
        }
    }
    if *loss != Loss::Violation {
        assert_eq!(walk(game, winning, end, cycle), end, "the cycle does not close");
        assert!(!cycle.is_empty() || game.silent[end as usize], "the environment may not be silent");
        for &key in &game.assumptions {
            assert!(meets(game, key, end, cycle), "the cycle is not fair to assumption {key}");
        }
    }
}

/// Panics unless the environment's strategy wins whatever the system does: the system does not win the game in which
/// the environment has no choice but that of its strategy.
pub(crate) fn assert_forced(game: &Game, solution: &Solution) {
    let mut strategy = CounterStrategy::new(game, solution).expect("a strategy of the environment");
    let mut places = vec![strategy.begin()];
    let mut ids: BTreeMap<Standing, u32> = BTreeMap::from([(places[0], 0)]);
    let mut played = Game {
        initial: 0,
        turn: Vec::new(),
        silent: Vec::new(),
        open: Vec::new(),
        first: vec![0],
        action: Vec::new(),
        target: Vec::new(),
        ..game.clone()
    };
    let mut next = 0;
    while let Some(&at) = places.get(next) {
        next += 1;
        let state = at.state as usize;
        let edges: Vec<u32> = if game.turn[state].is_system() {
            game.edges_of(at.state).map(|edge| edge as u32).collect()
        } else {
            strategy.choose(at).into_iter().collect()
        };
        let is_silent = edges.is_empty() && game.turn[state].is_environment();
        assert!(!is_silent || game.silent[state], "the environment may not be silent");
        played.turn.push(game.turn[state]);
        played.silent.push(is_silent);
        played.open.push(game.open[state]);
        for edge in edges {
            assert!(game.edges_of(at.state).contains(&(edge as usize)), "edge {edge} does not leave {at:?}");
            let target = strategy.follow(at, edge);
            let id = *ids.entry(target).or_insert_with(|| {
                places.push(target);
                places.len() as u32 - 1
            });
            played.action.push(game.action[edge as usize]);
            played.target.push(id);
        }
        played.first.push(played.target.len() as u32);
    }
    let winning = naive::Graph::new(&played).winning(false);
    assert!(
        !winning[..places.len()].contains(&true),
        "the system can win against the environment's strategy"
    );
}

/// The state to which the edges lead, one after the other, all of them inside the losing region.
fn walk(game: &Game, winning: &[bool], mut state: u32, edges: &[u32]) -> u32 {
    assert!(!winning[state as usize]);
    for &edge in edges {
        assert!(game.edges_of(state).contains(&(edge as usize)), "edge {edge} does not leave state {state}");
        state = game.target[edge as usize];
        assert!(!winning[state as usize], "the play comes to state {state}, which the system wins");
    }
    state
}

/// Whether a key is met on the cycle (or the silence) that begins in `state`.
fn meets(game: &Game, key: u32, state: u32, cycle: &[u32]) -> bool {
    let contains = |set: u32| game.key_sets.contains(set, key);
    let closed = |state: u32| !contains(game.open[state as usize]);
    closed(state)
        || cycle
            .iter()
            .any(|&edge| closed(game.target[edge as usize]) || contains(game.discharged(edge as usize)))
}

const A: u32 = 0;
const B: u32 = 1;
const G: u32 = 2;

fn state<const N: usize>(turn: Turn, open: &[u32], edges: [(usize, &[u32]); N]) -> State {
    let edges = edges.iter().map(|&(target, discharged)| (target, discharged.to_vec())).collect();
    State { turn, silent: false, open: open.to_vec(), edges }
}

/// The edges of the play and of the cycle, and the loss.
#[track_caller]
fn check(states: &[State], play: &[u32], cycle: &[u32], loss: Loss) {
    let game = game(states, 2, 1);
    assert_eq!(solved(&game), None);
    let counter = counter_play(&game, &solve(&game));
    assert_eq!(counter, Some(CounterPlay { play: play.to_vec(), cycle: cycle.to_vec(), loss }));
}

#[test]
fn there_is_none_where_the_system_wins() {
    let game = game(&[state(Turn::EnvironmentAny, &[], [(0, &[])])], 2, 1);
    assert_eq!(counter_play(&game, &solve(&game)), None);
}

#[test]
fn the_environment_goes_straight_to_the_loss_and_the_system_holds_out() {
    let states = [
        state(Turn::SystemUrgent, &[], [(2, &[]), (1, &[])]),
        state(Turn::EnvironmentAny, &[], [(0, &[]), (2, &[])]),
        state(Turn::EnvironmentAny, &[], [(1, &[]), (3, &[])]),
        state(Turn::Lost, &[], []),
    ];
    check(&states, &[1, 3, 5], &[], Loss::Violation);
}

#[test]
fn silence_is_an_empty_cycle() {
    let silent = State { silent: true, ..state(Turn::EnvironmentAny, &[G], [(1, &[])]) };
    let states = [state(Turn::EnvironmentAny, &[], [(1, &[])]), silent];
    check(&states, &[0], &[], Loss::Starvation(G));
}

#[test]
fn every_assumption_is_seen_to_in_the_cycle() {
    let states = [
        State { silent: true, ..state(Turn::EnvironmentAny, &[A, B, G], [(0, &[]), (0, &[A]), (1, &[])]) },
        state(Turn::SystemUrgent, &[A, B, G], [(2, &[])]),
        state(Turn::EnvironmentAny, &[A, B, G], [(0, &[A, G]), (0, &[B])]),
    ];
    check(&states, &[], &[1, 2, 3, 5], Loss::Starvation(G));
}

#[test]
fn a_super_step_without_end_is_a_loss() {
    let states = [
        state(Turn::EnvironmentAny, &[], [(1, &[])]),
        state(Turn::SystemUrgent, &[G], [(2, &[G])]),
        state(Turn::SystemUrgent, &[G], [(1, &[G])]),
    ];
    check(&states, &[0], &[1, 2], Loss::Endless);
}

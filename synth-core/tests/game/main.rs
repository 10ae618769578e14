//! The solver against a naive one, on random games and on small ones made by hand.

mod counter;
mod naive;
mod small;

use proptest::bool::weighted;
use proptest::collection::vec;
use proptest::prelude::{Just, ProptestConfig, Strategy as Strategy_, any, prop_oneof, proptest};
use synth_core::game::{
    Actions, ActionsBuilder, ExtractError, Game, KeySetsBuilder, Strategy, Turn, YIELD, counter_play,
    extract, extract_on, solve, solve_ending, solve_on,
};

/// A state for [`game`].
#[derive(Clone, Debug)]
pub(crate) struct State {
    turn: Turn,
    silent: bool,
    open: Vec<u32>,
    edges: Vec<(usize, Vec<u32>)>,
}

/// A game from its states; keys `0..assumptions` are those of assumptions, the next ones those of guarantees.
pub(crate) fn game(states: &[State], assumptions: u32, guarantees: u32) -> Game {
    let mut actions = ActionsBuilder::default();
    let mut sets = KeySetsBuilder::default();
    sets.intern(&(0..assumptions + guarantees).collect::<Vec<_>>());
    let mut game = Game {
        initial: 0,
        turn: states.iter().map(|state| state.turn).collect(),
        silent: states.iter().map(|state| state.silent).collect(),
        open: states.iter().map(|state| sets.intern(&state.open)).collect(),
        first: vec![0],
        action: Vec::new(),
        actions: Actions::default(),
        target: Vec::new(),
        key_sets: KeySetsBuilder::default().finish(),
        assumptions: (0..assumptions).collect(),
        guarantees: (assumptions..assumptions + guarantees).collect(),
    };
    for state in states {
        for (index, (target, discharged)) in state.edges.iter().enumerate() {
            let last = state.turn == Turn::SystemEventually && index + 1 == state.edges.len();
            let label = if last { YIELD } else { index as u32 };
            game.action.push(actions.intern(label, sets.intern(discharged)));
            game.target.push(*target as u32);
        }
        game.first.push(game.target.len() as u32);
    }
    game.key_sets = sets.finish();
    game.actions = actions.finish();
    game
}

/// Solves and extracts, and compares with the naive solver; the strategy if the system wins.
pub(crate) fn solved(game: &Game) -> Option<Strategy> {
    let solution = solve(game);
    let naive = naive::Graph::new(game);
    let winning = naive.winning(false);
    let expected: Vec<usize> = (0..naive.states).filter(|&state| winning[state]).collect();
    assert_eq!(solution.winning.ones().collect::<Vec<_>>(), expected);
    assert_eq!(solution.winning_states(), expected.len());
    match extract(game, &solution) {
        Ok(strategy) => {
            assert!(solution.wins(game.initial));
            naive::assert_wins(game, &strategy, false);
            assert_eq!(extract(game, &solve(game)).as_ref(), Ok(&strategy));
            assert_eq!(extract_on(game, &solve_on(game, 2), 3).as_ref(), Ok(&strategy));
            Some(strategy)
        }
        Err(error) => {
            assert_eq!(error, ExtractError::Unrealizable);
            assert!(!solution.wins(game.initial));
            let counter = counter_play(game, &solution).expect("a play that the environment wins");
            counter::assert_lost(game, &winning, &counter);
            counter::assert_forced(game, &solution);
            None
        }
    }
}

/// The same where super steps must end whatever becomes of the assumptions.
pub(crate) fn solved_ending(game: &Game) -> Option<Strategy> {
    let solution = solve_ending(game);
    let winning = naive::Graph::new(game).winning(true);
    let expected: Vec<usize> = (0..game.states()).filter(|&state| winning[state]).collect();
    assert_eq!(solution.winning.ones().collect::<Vec<_>>(), expected);
    let strategy = extract(game, &solution).ok();
    assert_eq!(strategy.is_some(), winning[game.initial as usize]);
    if let Some(strategy) = &strategy {
        naive::assert_wins(game, strategy, true);
    }
    strategy
}

fn keys(keys: u32, probability: f64) -> impl Strategy_<Value = Vec<u32>> {
    vec(weighted(probability), keys as usize).prop_map(|present| {
        (0u32..).zip(present).filter(|(_, present)| *present).map(|(key, _)| key).collect()
    })
}

/// How keys, silence and the ends of the game are spread.
#[derive(Clone, Copy)]
struct Odds {
    /// At most so many of them.
    assumptions: u32,
    open: f64,
    discharged: f64,
    silent: f64,
    stuck: f64,
    /// The last states, by which a play can end, are among the targets.
    ends: usize,
}

/// All sorts of games.
const MIXED: Odds = Odds { assumptions: 3, open: 0.6, discharged: 0.25, silent: 0.5, stuck: 0.1, ends: 2 };
/// Games in which the system has to do something for each guarantee: memory is needed.
const DEMANDING: Odds =
    Odds { assumptions: 1, open: 0.95, discharged: 0.15, silent: 0.02, stuck: 0.0, ends: 0 };

fn state(states: usize, key_count: u32, odds: Odds) -> impl Strategy_<Value = State> {
    let turn = prop_oneof![
        2 => Just(Turn::SystemCommitted),
        1 => Just(Turn::EnvironmentCommitted),
        3 => Just(Turn::SystemEventually),
        6 => Just(Turn::EnvironmentAny),
    ];
    let edges = vec((0..states + odds.ends, keys(key_count, odds.discharged)), 1..=4);
    let (silent, stuck) = (weighted(odds.silent), weighted(odds.stuck));
    let parts = (turn, silent, stuck, keys(key_count, odds.open), edges);
    parts.prop_map(|(turn, silent, stuck, open, mut edges)| {
        let environment = turn.is_environment();
        if environment && stuck {
            edges.clear();
        }
        State { turn, silent: environment && (silent || stuck), open, edges }
    })
}

fn random_game(odds: Odds) -> impl Strategy_<Value = Game> {
    let sizes = (1..=10usize, 0..=odds.assumptions, 0..=3u32, any::<bool>());
    sizes.prop_flat_map(move |(states, assumptions, guarantees, lost)| {
        let state = state(states, assumptions + guarantees, odds);
        vec(state, states).prop_map(move |mut listed| {
            let all = (0..assumptions + guarantees).collect();
            listed.push(State { turn: Turn::Won, silent: false, open: all, edges: Vec::new() });
            let end = if lost { Turn::Lost } else { Turn::EnvironmentAny };
            listed.push(State { turn: end, silent: !lost, open: Vec::new(), edges: Vec::new() });
            game(&listed, assumptions, guarantees)
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn agrees_with_the_naive_solver(game in random_game(MIXED)) {
        solved(&game);
    }

    #[test]
    fn agrees_with_the_naive_solver_where_memory_is_needed(game in random_game(DEMANDING)) {
        solved(&game);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn agrees_with_the_naive_solver_where_super_steps_must_end(game in random_game(MIXED)) {
        solved_ending(&game);
    }

    #[test]
    fn agrees_with_the_naive_solver_where_they_must_end_and_memory_is_needed(game in random_game(DEMANDING)) {
        solved_ending(&game);
    }
}

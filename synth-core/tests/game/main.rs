//! The solver against a naive one, on random games and on small ones made by hand.

mod naive;
mod small;

use proptest::prelude::{Just, ProptestConfig, Strategy as Strategy_, any, prop_oneof, proptest};
use synth_core::game::{ExtractError, Game, KeySetsBuilder, Strategy, Turn, YIELD, extract, solve};

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
    let mut sets = KeySetsBuilder::default();
    sets.intern(&(0..assumptions + guarantees).collect::<Vec<_>>());
    let mut game = Game {
        initial: 0,
        turn: states.iter().map(|state| state.turn).collect(),
        silent: states.iter().map(|state| state.silent).collect(),
        open: states.iter().map(|state| sets.intern(&state.open)).collect(),
        first: vec![0],
        label: Vec::new(),
        target: Vec::new(),
        discharged: Vec::new(),
        key_sets: KeySetsBuilder::default().finish(),
        assumptions: (0..assumptions).collect(),
        guarantees: (assumptions..assumptions + guarantees).collect(),
    };
    for state in states {
        for (index, (target, discharged)) in state.edges.iter().enumerate() {
            let last = state.turn == Turn::SystemEventually && index + 1 == state.edges.len();
            game.label.push(if last { YIELD } else { index as u32 });
            game.target.push(*target as u32);
            game.discharged.push(sets.intern(discharged));
        }
        game.first.push(game.target.len() as u32);
    }
    game.key_sets = sets.finish();
    game
}

/// Solves and extracts, and compares with the naive solver; the strategy if the system wins.
pub(crate) fn solved(game: &Game) -> Option<Strategy> {
    let solution = solve(game);
    let naive = naive::Graph::new(game);
    let winning = naive.winning();
    let expected: Vec<usize> = (0..naive.states).filter(|&state| winning[state]).collect();
    assert_eq!(solution.winning.ones().collect::<Vec<_>>(), expected);
    assert_eq!(solution.winning_states(), expected.len());
    match extract(game, &solution) {
        Ok(strategy) => {
            assert!(solution.wins(game.initial));
            naive::assert_wins(game, &strategy);
            assert_eq!(extract(game, &solve(game)).as_ref(), Ok(&strategy));
            Some(strategy)
        }
        Err(error) => {
            assert_eq!(error, ExtractError::Unrealizable);
            assert!(!solution.wins(game.initial));
            None
        }
    }
}

fn keys(keys: u32, probability: f64) -> impl Strategy_<Value = Vec<u32>> {
    proptest::collection::vec(proptest::bool::weighted(probability), keys as usize).prop_map(|present| {
        (0u32..).zip(present).filter(|(_, present)| *present).map(|(key, _)| key).collect()
    })
}

/// A random state. In a demanding game keys are open nearly everywhere and seldom discharged.
fn state(states: usize, key_count: u32, demanding: bool) -> impl Strategy_<Value = State> {
    let turn = prop_oneof![
        2 => Just(Turn::SystemCommitted),
        1 => Just(Turn::EnvironmentCommitted),
        3 => Just(Turn::SystemEventually),
        6 => Just(Turn::EnvironmentAny),
    ];
    let edge = (0..states + 2, keys(key_count, if demanding { 0.15 } else { 0.25 }));
    let edges = proptest::collection::vec(edge, 1..=4);
    (
        turn,
        any::<bool>(),
        keys(key_count, if demanding { 0.95 } else { 0.6 }),
        edges,
        proptest::bool::weighted(0.1),
    )
        .prop_map(move |(turn, silent, open, mut edges, stuck)| {
            // `Lost` and `Won`, the last two states, are rarer targets.
            for (target, _) in &mut edges {
                if *target >= states && open.len() % 2 == 0 {
                    *target %= states;
                }
            }
            let environment = turn.is_environment();
            if environment && stuck {
                edges.clear();
            }
            State { turn, silent: environment && (silent || stuck), open, edges }
        })
}

fn random_game() -> impl Strategy_<Value = Game> {
    let sizes = (1..=10usize, 0..=3u32, 0..=3u32, any::<bool>(), any::<bool>());
    sizes.prop_flat_map(|(states, assumptions, guarantees, demanding, lost)| {
        let state = state(states, assumptions + guarantees, demanding);
        proptest::collection::vec(state, states).prop_map(move |mut listed| {
            for turn in [Turn::Won, if lost { Turn::Lost } else { Turn::EnvironmentAny }] {
                let silent = turn == Turn::EnvironmentAny;
                listed.push(State { turn, silent, open: Vec::new(), edges: Vec::new() });
            }
            game(&listed, assumptions, guarantees)
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn agrees_with_the_naive_solver(game in random_game()) {
        solved(&game);
    }
}

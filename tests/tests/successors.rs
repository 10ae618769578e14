//! The successor function on packed states says exactly what play-out says, in every mode.

use sml_tests::random::{Features, Options, specification};
use sml_tests::{corpus, fast};
use synth_core::explore::StateStore;
use synth_core::game::YIELD;
use synth_core::model::{Kind, Spec};
use synth_core::playout::{Config, Moves, Playout, Semantics};
use synth_core::successors::PackedMoves;

/// What was compared.
#[derive(Default, Debug)]
struct Tally {
    moves: usize,
    yields: usize,
    ends: usize,
    completed: usize,
    mistakes: usize,
}

/// Compares the moves of so many states, found breadth first, twice each: what was learned says the same again.
fn compare(playout: &mut Playout<'_>, most: usize, tally: &mut Tally) -> Result<(), String> {
    let Ok(initial) = playout.begin() else { return Ok(()) };
    let mut store = StateStore::new(playout, &initial.config);
    let (mut config, mut moves, mut packed) = (Config::default(), Moves::default(), PackedMoves::default());
    let mut state = 0;
    while (state as usize) < store.len().min(most) {
        store.load(playout, state, &mut config);
        let expected = playout.moves(&config, &mut moves);
        for _ in 0..2 {
            let found = store.moves(playout, state, &mut packed);
            if found != expected {
                return Err(format!("state {state}: {expected:?}, but packed {found:?}"));
            }
            if found.is_ok() {
                same(playout, &mut store, &config, &moves, &packed, tally)
                    .map_err(|error| format!("state {state}: {error}"))?;
            }
        }
        tally.mistakes += usize::from(expected.is_err());
        state += 1;
    }
    Ok(())
}

fn same(
    playout: &mut Playout<'_>,
    store: &mut StateStore,
    config: &Config,
    moves: &Moves,
    packed: &PackedMoves,
    tally: &mut Tally,
) -> Result<(), String> {
    let mut open = Vec::new();
    playout.open_keys(config, &mut open);
    let keys = |set| store.keys(set).collect::<Vec<_>>();
    if (moves.turn, moves.silent, &open) != (packed.turn, packed.silent, &keys(packed.open)) {
        return Err(format!(
            "{:?} {} {open:?}, but packed {:?} {} {:?}",
            moves.turn,
            moves.silent,
            packed.turn,
            packed.silent,
            keys(packed.open)
        ));
    }
    if moves.moves.len() != packed.edges().len() {
        return Err(format!("{:?}, but packed {:?}", moves.moves, packed.edges()));
    }
    let mut target = Config::default();
    for (one, edge) in moves.moves.iter().zip(packed.edges()) {
        let is_same = (one.event.unwrap_or(YIELD), one.end, one.completed)
            == (edge.event, edge.end, edge.completed)
            && store.keys(edge.discharged).eq(one.discharged.iter().copied());
        if one.end.is_none() {
            let id = store.intern(packed.target(edge));
            store.load(playout, id, &mut target);
        }
        if !is_same || one.end.is_none() && one.config != target {
            return Err(format!("{one:?}, but packed {edge:?} to {target:?}"));
        }
        tally.moves += 1;
        tally.yields += usize::from(one.event.is_none());
        tally.ends += usize::from(one.end.is_some());
        tally.completed += usize::from(one.completed);
    }
    Ok(())
}

/// Compares in default and classic semantics: as it is, with each existential scenario followed, and with some scenarios
/// relaxed.
fn check(spec: &Spec, most: usize, tally: &mut Tally) -> Result<(), String> {
    for classic in [false, true] {
        let semantics = Semantics { classic };
        let Ok(mut playout) = Playout::new(spec, semantics) else { return Ok(()) };
        compare(&mut playout, most, tally)?;
        for step in 1..4 {
            let relaxed: Vec<usize> = (0..spec.scenarios.len()).filter(|s| s % step == step / 2).collect();
            playout.relax(relaxed.iter().copied());
            compare(&mut playout, most, tally).map_err(|error| format!("relaxed {relaxed:?}: {error}"))?;
        }
        for index in (0..spec.scenarios.len()).filter(|&s| spec.scenarios[s].kind == Kind::Existential) {
            let Ok(mut playout) = Playout::following(spec, semantics, index) else { continue };
            compare(&mut playout, most, tally).map_err(|error| format!("following {index}: {error}"))?;
        }
    }
    Ok(())
}

#[test]
fn on_the_corpus() {
    let mut tally = Tally::default();
    for entry in corpus::all() {
        let Ok(spec) = fast::resolved(&entry.text) else { continue };
        if let Err(error) = check(&spec, 1_000, &mut tally) {
            panic!("{}: {error}", entry.name);
        }
    }
    assert!(tally.moves > 100_000 && tally.yields > 1_000 && tally.ends > 100, "{tally:?}");
}

#[test]
fn on_random_specifications() {
    let seeds = std::env::var("SML_SEEDS").ok().and_then(|n| n.parse().ok()).unwrap_or(150);
    let mut tally = Tally::default();
    for (features, seeds) in [
        (Features::CORE, seeds),
        (Features::FULL, seeds),
        (Features { errors: true, ..Features::FULL }, seeds),
    ] {
        for seed in 0..seeds {
            let text = specification(seed, Options { features, ..Options::default() });
            let spec = fast::resolved(&text).expect("a specification");
            if let Err(error) = check(&spec, 200, &mut tally) {
                panic!("seed {seed}: {error}\n{text}");
            }
        }
    }
    assert!(tally.moves > 100_000 && tally.ends > 1_000 && tally.mistakes > 100, "{tally:?}");
}

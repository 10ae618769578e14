//! Random specifications through the whole pipeline: each is synthesized, explained, or refused for a reason.

use std::collections::BTreeMap;

use sml_tests::random::{self, specification as random_specification};
use synth_core::existential::existential;
use synth_core::explain::SILENCE;
use synth_core::explore::Limits;
use synth_core::pipeline::{Failure, Options, Timings, play_and_solve, specification, synthesize};
use synth_core::playout::Semantics;
use synth_core::syntax::load;

/// What came of one specification.
fn outcome(text: &str, options: &Options) -> &'static str {
    let loaded = load("random.sml", text.as_bytes(), &mut |_| Err("no imports".to_owned()));
    let spec = specification(&loaded).expect("a specification");
    let mut timings = Timings::default();
    let mut solved = match play_and_solve(&spec, options, &mut timings) {
        Ok(solved) => solved,
        Err(Failure::Limit(_)) => return "too large",
        Err(Failure::Wrong(_)) => return "wrong",
        Err(failure) => panic!("{failure:?}"),
    };
    match synthesize(&mut solved, options, &mut timings) {
        Ok(verified) => {
            for found in
                existential(&spec, options, &solved, Some(&verified.controller)).into_iter().flatten()
            {
                assert!(found.possible || !found.reachable && found.witness.is_empty(), "{found:?}");
            }
            "synthesized"
        }
        Err(Failure::Unrealizable(unrealizable)) => {
            let explanation = unrealizable.explanation;
            let is_violation = explanation.cause.as_str() == "environment_violates";
            assert_eq!(explanation.cycle.is_empty(), is_violation, "{explanation:?}");
            assert!(!is_violation || !explanation.play.is_empty(), "{explanation:?}");
            assert!(explanation.cycle.len() == 1 || !explanation.cycle.iter().any(|text| text == SILENCE));
            assert!(!explanation.scenarios.is_empty());
            for found in existential(&spec, options, &solved, None).into_iter().flatten() {
                assert!(!found.possible, "{found:?}");
            }
            explanation.cause.as_str()
        }
        Err(Failure::Wrong(_)) => "endless super step",
        // The product with a controller can be larger than the game.
        Err(Failure::Limit(_)) => "too large",
        Err(failure) => panic!("{failure:?}"),
    }
}

#[test]
fn every_specification_comes_to_something() {
    let mut outcomes: BTreeMap<&str, u32> = BTreeMap::new();
    for seed in 0..250 {
        let text = random_specification(seed, random::Options::default());
        for classic in [false, true] {
            let semantics = Semantics { classic };
            let limits = Limits { states: 3000, ..Limits::default() };
            let options = Options { semantics, limits, ..Options::default() };
            let outcome = std::panic::catch_unwind(|| outcome(&text, &options));
            let Ok(outcome) = outcome else { panic!("seed {seed}, classic {classic}:\n{text}") };
            *outcomes.entry(outcome).or_default() += 1;
        }
    }
    for expected in
        ["synthesized", "environment_violates", "urgent_blocked", "guarantees_conflict", "obligation_starved"]
    {
        assert!(outcomes.contains_key(expected), "{outcomes:?}");
    }
}

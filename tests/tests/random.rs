//! Random specifications are well formed, and the naive implementation plays all of them.

use sml_tests::corpus;
use sml_tests::naive::eval::EvalError;
use sml_tests::naive::settle::SettleError;
use sml_tests::naive::{ExploreError, Semantics, Spec, explore, solve};
use sml_tests::random::{Features, Options, specification};

/// Explores and solves so many specifications: they parse, and none runs into an error it should not.
#[track_caller]
fn check(seeds: u64, options: Options) {
    let (mut realizable, mut unrealizable) = (0, 0);
    for seed in 0..seeds {
        let text = specification(seed, options);
        let explain = |error: String| -> String { format!("seed {seed}: {error}\n{text}") };
        let file = corpus::parse(&text).unwrap_or_else(|error| panic!("{}", explain(error)));
        let spec = Spec::new(&file).unwrap_or_else(|error| panic!("{}", explain(error)));
        for semantics in [Semantics::Default, Semantics::Classic] {
            match explore(&spec, semantics, 300) {
                Ok(graph) if solve(&graph)[0] => realizable += 1,
                Ok(_) => unrealizable += 1,
                Err(ExploreError::TooManyStates) => {}
                Err(error) if options.features.errors && is_error_of_playout(&error) => {}
                Err(error) => panic!("{}", explain(format!("{error:?}"))),
            }
        }
    }
    assert!(realizable > seeds / 4, "{realizable} of {seeds} specifications are realizable");
    assert!(unrealizable > seeds / 4, "{unrealizable} of {seeds} specifications are not realizable");
}

/// One that section 6 of the language reference knows, not a mistake of the generator.
fn is_error_of_playout(error: &ExploreError) -> bool {
    match error {
        ExploreError::Play { cause: SettleError::Eval(cause), .. } => {
            matches!(cause, EvalError::Null(_) | EvalError::Range(_))
        }
        ExploreError::Initial(_) | ExploreError::Play { cause: SettleError::Loop, .. } => true,
        ExploreError::TooManyStates => false,
    }
}

#[test]
fn the_core() {
    check(100, Options { features: Features::CORE, ..Options::default() });
}

#[test]
fn the_full_language() {
    check(100, Options::default());
}

#[test]
fn errors_of_playout() {
    check(100, Options { features: Features { errors: true, ..Features::FULL }, ..Options::default() });
}

#[test]
fn same_seed_same_text() {
    let text = specification(7, Options::default());
    assert_eq!(text, specification(7, Options::default()));
    assert_ne!(text, specification(8, Options::default()));
}

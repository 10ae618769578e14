//! How large and how often realizable the random specifications are: `distribution [seeds] [size] [core]`.

use sml_tests::corpus;
use sml_tests::naive::{ExploreError, Semantics, Spec, explore, solve};
use sml_tests::random::{Features, Options, specification};
use std::collections::BTreeMap;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |index: usize, default: usize| {
        arguments.get(index).and_then(|argument| argument.parse().ok()).unwrap_or(default)
    };
    let features = match arguments.get(2).map(String::as_str) {
        Some("core") => Features::CORE,
        Some("errors") => Features { errors: true, ..Features::FULL },
        _ => Features::FULL,
    };
    let options = Options { size: number(1, 4), features };
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for seed in 0..number(0, 1000) as u64 {
        let text = specification(seed, options);
        let outcome = corpus::parse(&text).and_then(|file| Spec::new(&file));
        let label = match outcome.map(|spec| explore(&spec, Semantics::Default, 2000)) {
            Err(error) => {
                println!("seed {seed}: {error}\n{text}");
                "malformed".into()
            }
            Ok(Err(ExploreError::TooManyStates)) => "more than 2000 states".into(),
            Ok(Err(ExploreError::Play { cause, .. })) => format!("play-out: {cause:?}"),
            Ok(Err(ExploreError::Initial(message))) => format!("initial: {message}"),
            Ok(Ok(graph)) => {
                let figures = graph.figures(&solve(&graph));
                let size = match figures.states {
                    1 => "   1",
                    2..=4 => "   2..=4",
                    5..=20 => "   5..=20",
                    21..=100 => "  21..=100",
                    101..=500 => " 101..=500",
                    _ => " 501..=2000",
                };
                *counts.entry(format!("{size} states")).or_default() += 1;
                let partly = figures.winning_states > 0 && figures.winning_states < figures.states;
                if partly {
                    *counts.entry("won in part".into()).or_default() += 1;
                }
                if figures.assumption_sets > 0 {
                    *counts.entry("with assumption keys".into()).or_default() += 1;
                }
                (if figures.realizable { "realizable" } else { "unrealizable" }).into()
            }
        };
        *counts.entry(label).or_default() += 1;
    }
    for (label, count) in counts {
        println!("{count:6} {label}");
    }
}

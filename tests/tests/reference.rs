//! The naive implementation finds the figures of the corpus.

use sml_tests::corpus;
use sml_tests::naive::{Semantics, Spec, explore, solve};

/// Compares the figures of every specification of the corpus for which some are given.
fn check(semantics: Semantics, section: &str) {
    let mut checked = 0;
    let mut wrong = Vec::new();
    for entry in corpus::all() {
        let Some(expected) = entry.expected.get(section) else { continue };
        let file = corpus::parse(&entry.text).unwrap_or_else(|error| panic!("{}: {error}", entry.name));
        let spec = Spec::new(&file).unwrap_or_else(|error| panic!("{}: {error}", entry.name));
        let graph =
            explore(&spec, semantics, 20_000).unwrap_or_else(|error| panic!("{}: {error:?}", entry.name));
        for (figure, found) in graph.figures(&solve(&graph)).named() {
            let value = &expected[figure];
            let agrees = match value.as_bool() {
                Some(value) => found == usize::from(value),
                None => value.as_u64() == Some(found as u64),
            };
            if !agrees {
                wrong.push(format!("{}: {figure} is {found}, not {value}", entry.name));
            }
        }
        checked += 1;
    }
    assert!(wrong.is_empty(), "{section} semantics:\n{}", wrong.join("\n"));
    assert!(checked > 0, "no figures for {section} semantics");
}

#[test]
fn default_semantics() {
    check(Semantics::Default, "default");
}

#[test]
fn classic_semantics() {
    check(Semantics::Classic, "classic");
}

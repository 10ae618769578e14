//! Whatever the grammar allows can be read, and means the same when it was printed.

use std::collections::BTreeSet;

use sml_tests::random::grammar::sentence;
use sml_tests::random::{Features, Options, specification};
use sml_tests::survive::shape;
use sml_tests::{corpus, survive};
use synth_core::syntax::ast::{File, Section};
use synth_core::syntax::{RESERVED, print};

/// `SML_SEEDS=10000` for a long run.
fn seeds(usual: u64) -> u64 {
    std::env::var("SML_SEEDS").ok().and_then(|seeds| seeds.parse().ok()).unwrap_or(usual)
}

#[track_caller]
fn read(text: &str, what: &str) -> File {
    corpus::parse(text).unwrap_or_else(|errors| panic!("{what}: {errors}\n{text}"))
}

/// Reads, prints, reads again: the same tree, and printed the same.
#[track_caller]
fn check(text: &str, what: &str) -> File {
    let tree = read(text, what);
    let printed = print(&tree);
    let again = read(&printed, what);
    assert_eq!(shape(&tree), shape(&again), "{what}\n{text}\n{printed}");
    assert_eq!(print(&again), printed, "{what}");
    tree
}

#[test]
fn sentences_of_the_whole_grammar() {
    let mut words = BTreeSet::new();
    for seed in 0..seeds(400) {
        let text = sentence(seed);
        let tree = check(&text, &format!("seed {seed}"));
        // Requirement texts are the only comments that mean anything.
        let told: usize = tree.sections.iter().map(requirements).sum();
        assert_eq!(told, text.matches("/// requirement").count(), "seed {seed}\n{text}");
        let printed = print(&tree);
        words.extend(printed.split(|c: char| !c.is_alphanumeric()).map(str::to_owned));
    }
    for &keyword in RESERVED {
        assert!(words.contains(keyword), "`{keyword}` occurs in no sentence");
    }
}

fn requirements(section: &Section) -> usize {
    let Section::Collaboration(collaboration) = section else { return 0 };
    collaboration.scenarios.iter().filter(|scenario| !scenario.requirement.is_empty()).count()
}

#[test]
fn specifications_that_mean_something() {
    let features = Features { errors: true, ..Features::FULL };
    for seed in 0..seeds(200) {
        check(&specification(seed, Options { size: 8, features }), &format!("seed {seed}"));
    }
}

#[test]
fn sentences_are_resolved_or_refused() {
    for seed in 0..seeds(200) {
        survive::check(sentence(seed).as_bytes());
    }
}

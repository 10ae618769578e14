//! What was saved by other tables is not gone on from: whatever changes tables changes their version, which is the same in
//! Rust and in Structured Text.

use std::collections::BTreeMap;

use sml_tests::{corpus, fast, tables};
use synth_core::controller::tables::{Provenance, Tables};
use synth_core::emit::{rust, st};
use synth_core::pipeline::{Timings, synthesize};

/// The number behind `before`.
#[track_caller]
fn number(text: &str, before: &str) -> u32 {
    let (_, rest) = text.split_once(before).unwrap_or_else(|| panic!("no {before:?} in\n{text}"));
    let digits = rest.chars().take_while(|c| c.is_ascii_digit() || *c == '_');
    digits.filter(char::is_ascii_digit).collect::<String>().parse().expect("a number")
}

#[test]
fn rust_and_structured_text_have_the_same() {
    let corpus = corpus::controllers().into_iter();
    let corpus = corpus.map(|(name, controller)| Tables::new(&name, &controller, Provenance::default()));
    for tables in corpus.chain([tables::cell(), tables::inner(), tables::empty()]) {
        let version = tables.version();
        for engine in rust::Engine::ALL {
            for ordered in [false, true] {
                let text = rust::text(&tables, &rust::Options { ordered, engine });
                assert_eq!(
                    number(&text, "pub const TABLE_VERSION: u32 = "),
                    version,
                    "{}",
                    tables.specification
                );
            }
        }
        for target in st::Target::ALL {
            let text = st::text(&tables, &st::Options { retain: true, target, ..st::Options::default() });
            let text = text.expect("it fits").replace('#', "");
            assert_eq!(number(&text, "table_version <> "), version, "{}", tables.specification);
        }
    }
}

/// All that a state, an event or a code means.
fn meaning(tables: &Tables) -> String {
    let Tables { specification, states, initial, events, super_steps, components, .. } = tables;
    format!("{specification:?} {states} {initial} {events:?} {super_steps:?} {components:?}")
}

/// The tables of a specification, if it is right and realizable.
fn synthesized(name: &str, text: &str) -> Option<Tables> {
    let spec = fast::resolved(text).ok()?;
    let options = fast::options(false, 5_000);
    let mut solved = fast::solved(&spec, &options).ok()?;
    let verified = synthesize(&mut solved, &options, &mut Timings::default()).ok()?;
    Some(Tables::new(name, &verified.controller, Provenance::default()))
}

/// Each specification without one of its lines, for each of them: the version differs if and only if the meaning does, and
/// no two meanings have the same.
#[test]
fn every_mutation_that_changes_tables_changes_the_version() {
    let mut meanings: BTreeMap<u32, String> = BTreeMap::new();
    let (mut same, mut others) = (0, 0);
    for entry in corpus::all().iter().filter(|entry| entry.text.len() < 1500) {
        let Some(original) = synthesized(&entry.name, &entry.text) else { continue };
        let lines: Vec<&str> = entry.text.lines().collect();
        for left_out in 0..=lines.len() {
            let kept = lines.iter().enumerate().filter(|(line, _)| *line != left_out).map(|(_, text)| *text);
            let Some(mutant) = synthesized(&entry.name, &kept.collect::<Vec<_>>().join("\n")) else {
                continue;
            };
            let is_same = meaning(&mutant) == meaning(&original);
            assert_eq!(mutant.version() == original.version(), is_same, "{} without {left_out}", entry.name);
            *if is_same { &mut same } else { &mut others } += 1;
            let known = meanings.entry(mutant.version()).or_insert_with(|| meaning(&mutant));
            assert_eq!(*known, meaning(&mutant), "{} without {left_out}", entry.name);
        }
    }
    assert!(same > 50 && others > 50, "{same} mutations left tables as they were, {others} changed them");
}

//! The tables in both languages, read back from the emitted texts, are the same number for number.

mod st_equals_rust {
    pub(crate) mod rust;
    pub(crate) mod st;
}

use sml_tests::{corpus, fast, tables};
use st_equals_rust::{rust, st};
use synth_core::controller::tables::Tables;
use synth_core::pipeline::{Failure, Options, Timings, compile};

/// What both languages say of a controller.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(crate) struct Controller {
    initial: u32,
    /// In table order.
    events: Vec<Event>,
    super_steps: Mapping,
    /// In order of the objects' names.
    components: Vec<Component>,
}

#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(crate) struct Event {
    text: String,
    mapping: Mapping,
}

#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(crate) struct Mapping {
    source: Vec<u32>,
    target: Vec<u32>,
}

#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(crate) struct Component {
    object: String,
    /// Every command's text and code.
    commands: Vec<(String, u32)>,
    /// Per row of the super steps.
    codes: Vec<u32>,
}

/// The same once more, straight from the tables: two readers that find nothing agree as well.
fn contained(tables: &Tables) -> Controller {
    let mapping = |m: &synth_core::controller::tables::Mapping| Mapping {
        source: m.source.clone(),
        target: m.target.clone(),
    };
    let events = tables.events.iter();
    let components = tables.components.iter();
    Controller {
        initial: tables.initial,
        events: events.map(|e| Event { text: e.event.text.clone(), mapping: mapping(&e.mapping) }).collect(),
        super_steps: mapping(&tables.super_steps),
        components: components
            .map(|c| Component {
                object: c.object.clone(),
                commands: c.commands.iter().map(|command| command.text.clone()).zip(1..).collect(),
                codes: c.codes.clone(),
            })
            .collect(),
    }
}

#[track_caller]
fn check(name: &str, tables: &Tables) {
    use synth_core::emit::{rust as rust_emitter, st as st_emitter};
    let published =
        rust_emitter::Options { engine: rust_emitter::Engine::Search, ..rust_emitter::Options::default() };
    let rust = rust::read(&rust_emitter::text(tables, &published));
    let expected = contained(tables);
    assert_eq!(rust, expected, "{name}, Rust");
    for drain in [false, true] {
        for integers in [st_emitter::Integers::Unsigned, st_emitter::Integers::Signed] {
            let encoding = st_emitter::Encoding::Rows;
            let options = st_emitter::Options { drain, integers, encoding, ..st_emitter::Options::default() };
            let text = st_emitter::text(tables, &options).expect("it fits");
            let st = st::read(&text, &st_emitter::names(tables, &options));
            assert_eq!(st, rust, "{name}, Structured Text");
        }
    }
}

#[test]
fn of_the_corpus() {
    let mut realizable = 0;
    for entry in corpus::all() {
        match compile(&fast::loaded(&entry.text), &Options::default(), &mut Timings::default()) {
            Ok(tables) => check(&entry.name, &tables),
            Err(Failure::Unrealizable(_)) => continue,
            Err(other) => panic!("{}: {other:?}", entry.name),
        }
        realizable += 1;
    }
    assert!(realizable > 20, "only {realizable}");
}

#[test]
fn at_random_of_every_width() {
    for (seed, states) in [(1, 12), (2, 256), (3, 257), (4, 6000), (5, 70_000)] {
        let size = tables::Size { states, events: 5, rows: 30, components: 3 };
        check(&format!("random of {states}"), &tables::random("Random", size, seed));
    }
}

#[test]
fn made_by_hand() {
    check("cell", &tables::cell());
    check("empty", &tables::empty());
    check("inner", &tables::inner());
}

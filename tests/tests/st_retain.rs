//! With `--retain`, Structured Text goes on after a power cycle where it was, unless its tables are others.
//!
//! `SML_CYCLES` asks for more than 1000 calls of each text.

use sml_tests::beside::{Model, Running, compiled, first_difference, stimuli};
use sml_tests::tables::{self, Size};
use synth_core::controller::tables::Tables;
use synth_core::emit::st::{self, Encoding, Integers, Options, Target, Trigger, Unexpected};

fn calls() -> usize {
    std::env::var("SML_CYCLES").ok().and_then(|text| text.parse().ok()).unwrap_or(1000)
}

/// Everything that makes a difference to what is remembered, for every target.
fn options(retain: bool) -> Vec<Options> {
    let mut all = Vec::new();
    for target in Target::ALL {
        for trigger in [Trigger::Edge, Trigger::Level] {
            for unexpected in [Unexpected::Keep, Unexpected::Drop, Unexpected::Fault] {
                let integers = if all.len() % 2 == 0 { Integers::Unsigned } else { Integers::Signed };
                let encoding = if all.len() % 3 == 0 { Encoding::Rows } else { Encoding::Runs };
                let (drain, owed) = (all.len() % 4 == 0, true);
                all.push(Options { target, trigger, integers, drain, unexpected, encoding, owed, retain });
            }
        }
    }
    all
}

fn text(tables: &Tables, options: &Options) -> String {
    st::text(tables, options).expect("it fits")
}

#[test]
fn power_cycles_change_nothing() {
    let size = Size { states: 30, events: 4, rows: 40, components: 2 };
    for tables in [tables::cell(), tables::random("Random", size, 9), tables::inner(), tables::empty()] {
        let controller = tables::controller(&tables);
        for options in options(true) {
            let unit = compiled(&text(&tables, &options), options.target);
            let mut running = Running::new(&unit, &tables, &options);
            let model = Model::new(&tables, &controller, options);
            for (call, (inputs, expected)) in stimuli(model).take(calls() / 5).enumerate() {
                assert_eq!(running.call(&inputs), Ok(expected), "call {call}, {options:?}");
                if call % 4 == 0 || call % 7 == 0 {
                    running = running.after_power_cycle(Running::new(&unit, &tables, &options));
                }
            }
        }
    }
}

/// A text that got through a power cycle in the middle of its work begins anew with other tables, and so does any without
/// the option.
#[test]
fn other_tables_begin_anew() {
    let tables = tables::cell();
    let mut others = tables.clone();
    others.events[0].mapping.target[0] = 6;
    for (retain, later) in [(false, &tables), (true, &others)] {
        let controllers = [&tables, later].map(tables::controller);
        for options in options(retain) {
            let [before, after] =
                [&tables, later].map(|tables| compiled(&text(tables, &options), options.target));
            let mut old = Running::new(&before, &tables, &options);
            let model = Model::new(&tables, &controllers[0], options);
            for (inputs, expected) in stimuli(model).take(calls() / 50) {
                assert_eq!(old.call(&inputs), Ok(expected), "{options:?}");
                assert_eq!(old.retains(), retain, "{options:?}");
                let new = old.after_power_cycle(Running::new(&after, later, &options));
                let model = Model::new(later, &controllers[1], options);
                assert_eq!(first_difference(new, model, 6), None, "{options:?}");
            }
        }
    }
}

/// Whatever changes what a state or an event is changes the version, and nothing else does.
#[test]
fn versions_tell_tables_apart() {
    let version = |tables: &Tables| {
        let text = text(tables, &Options { retain: true, ..Options::default() });
        let line = text.lines().find(|line| line.contains("table_version <> ")).expect("it is compared");
        line.trim().to_owned()
    };
    let cell = tables::cell();
    let changes: [fn(&mut Tables); 8] = [
        |tables| tables.initial = 2,
        |tables| tables.states += 1,
        |tables| tables.events.swap(0, 1),
        |tables| tables.events[2].mapping.source[0] = 5,
        |tables| tables.super_steps.target[1] = 0,
        |tables| tables.components[0].codes[0] = 2,
        |tables| tables.components[0].commands.swap(0, 1),
        |tables| tables.specification.push('2'),
    ];
    let mut versions = vec![version(&cell)];
    for change in changes {
        let mut changed = cell.clone();
        change(&mut changed);
        versions.push(version(&changed));
    }
    versions.sort();
    versions.dedup();
    assert_eq!(versions.len(), changes.len() + 1);
    let mut same = cell.clone();
    same.provenance.hash = "another".to_owned();
    same.owed[0] = vec![1];
    assert_eq!(version(&same), version(&cell));
}

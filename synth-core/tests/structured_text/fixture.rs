//! Tables to write: a small one by hand, and random ones.

use proptest::prelude::*;
use synth_core::controller::Event;
use synth_core::controller::tables::{ComponentTable, EventTable, Mapping, Provenance, Tables};
use synth_core::emit::st::{Encoding, Integers, Options, Target, Trigger, Unexpected};

/// An event of which only the text matters.
pub(crate) fn event(text: &str) -> Event {
    let [sender, receiver, operation] = [(); 3].map(|()| String::new());
    Event { text: text.to_owned(), sender, receiver, operation, arguments: Vec::new() }
}

pub(crate) fn table(text: &str, source: &[u32], target: &[u32]) -> EventTable {
    EventTable { event: event(text), mapping: Mapping { source: source.to_vec(), target: target.to_vec() } }
}

/// Press: 0 → 1, 2 → 3; tick: 2 → 2; super steps: 1 → 2 with `on`, 3 → 0 with `off`.
pub(crate) fn lamp() -> Tables {
    Tables {
        specification: "Lamp".to_owned(),
        states: 4,
        initial: 0,
        events: vec![
            table("button -> control.press()", &[0, 2], &[1, 3]),
            table("clock -> control.tick(-1)", &[2], &[2]),
        ],
        super_steps: Mapping { source: vec![1, 3], target: vec![2, 0] },
        components: vec![ComponentTable {
            object: "lamp".to_owned(),
            commands: vec![event("control -> lamp.off()"), event("control -> lamp.on()")],
            codes: vec![2, 1],
        }],
        owed: vec![Vec::new(); 4],
        provenance: Provenance {
            file: "specs/lamp.sml".to_owned(),
            hash: "0123456789abcdef".to_owned(),
            options: String::new(),
            level: synth_core::controller::Level::Exact,
            monitor: false,
            requirements: Vec::new(),
        },
    }
}

pub(crate) fn any_options() -> impl Strategy<Value = Options> {
    let target = prop::sample::select(Target::ALL.to_vec());
    let trigger = prop::sample::select(vec![Trigger::Edge, Trigger::Level]);
    let integers = prop::sample::select(vec![Integers::Unsigned, Integers::Signed]);
    let unexpected = prop::sample::select(vec![Unexpected::Keep, Unexpected::Drop, Unexpected::Fault]);
    let encoding = prop::sample::select(vec![Encoding::Runs, Encoding::Rows]);
    let flags = any::<[bool; 3]>();
    (target, trigger, integers, flags, unexpected, encoding).prop_map(
        |(target, trigger, integers, [drain, owed, retain], unexpected, encoding)| Options {
            target,
            trigger,
            integers,
            drain,
            unexpected,
            encoding,
            owed,
            retain,
        },
    )
}

/// Up to 300 states, so that the types differ; each has a super step or rows of some events.
pub(crate) fn any_tables() -> impl Strategy<Value = Tables> {
    (1u32..300, 0usize..6, 0usize..4).prop_flat_map(|(states, events, components)| {
        let row = (any::<bool>(), prop::collection::vec(prop::option::of(0..states), events));
        let step = (0..states, prop::collection::vec(0u32..4, components));
        let state = (row, step);
        (prop::collection::vec(state, states as usize), 0..states)
            .prop_map(move |(rows, initial)| assemble(&rows, initial, events, components))
    })
}

type Row = ((bool, Vec<Option<u32>>), (u32, Vec<u32>));

fn assemble(rows: &[Row], initial: u32, events: usize, components: usize) -> Tables {
    let mut tables = lamp();
    tables.states = rows.len() as u32;
    tables.initial = initial;
    tables.events = (0..events).map(|e| table(&format!("sensor{e} -> control.seen()"), &[], &[])).collect();
    tables.super_steps = Mapping::default();
    tables.components = (0..components)
        .map(|c| ComponentTable {
            object: format!("part{c}"),
            commands: (0..3).map(|k| event(&format!("control -> part{c}.act({k})"))).collect(),
            codes: Vec::new(),
        })
        .collect();
    for (state, ((acts, targets), (next, codes))) in (0..).zip(rows) {
        if *acts {
            tables.super_steps.source.push(state);
            tables.super_steps.target.push(*next);
            for (component, code) in tables.components.iter_mut().zip(codes) {
                component.codes.push(*code);
            }
            continue;
        }
        for (table, target) in tables.events.iter_mut().zip(targets) {
            if let Some(target) = target {
                table.mapping.source.push(state);
                table.mapping.target.push(*target);
            }
        }
    }
    tables
}

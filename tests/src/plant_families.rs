//! Families of plants with a parameter, whose feedback is known by counting.

use crate::plant_builder::PlantBuilder;
use crate::tables::Random;
use synth_core::plant::{Automaton, Edge, EventId, Plant, State};
use synth_core::syntax::Span;

/// Machines in a line, with a buffer of two places between neighbours: the feedback has `2 * 5^(machines - 1)` entries.
#[must_use]
pub fn transfer_line(machines: u32) -> Plant {
    let mut builder = PlantBuilder::new();
    for i in 1..=machines {
        builder = builder.controllable(&format!("start{i}")).uncontrollable(&format!("done{i}"));
    }
    for i in 1..=machines {
        builder = builder.component(&format!("Machine{i}"), &format!("I start{i} W, W done{i} I"));
    }
    for i in 1..machines {
        let (fill, empty) = (format!("done{i}"), format!("start{}", i + 1));
        let edges = format!("0 {fill} 1, 1 {fill} 2, 1 {empty} 0, 2 {empty} 1");
        builder = builder.constraint(&format!("Buffer{i}"), &edges);
    }
    builder.build()
}

/// Philosophers at a round table who take the left fork, then the right one, which is the left one of the next, and lay both
/// down together. All are to be able to think again.
#[must_use]
pub fn philosophers(count: u32) -> Plant {
    let mut builder = PlantBuilder::new();
    for i in 0..count {
        builder = builder.controllable(&format!("left{i} right{i}")).uncontrollable(&format!("down{i}"));
    }
    for i in 0..count {
        let edges = format!("T* left{i} L, L right{i} E, E down{i} T");
        builder = builder.component(&format!("Philosopher{i}"), &edges);
    }
    for i in 0..count {
        let before = (i + count - 1) % count;
        let edges = format!(
            "Free left{i} Left, Left down{i} Free, Free right{before} Right, Right down{before} Free"
        );
        builder = builder.component(&format!("Fork{i}"), &edges);
    }
    builder.build()
}

/// Machines that start on command and end by themselves, under one constraint automaton with so many states. `next` says
/// where an event leads, the starts first, then the ends in the same order.
fn workshop(machines: u32, states: u32, mut next: impl FnMut(u32, EventId) -> Option<u32>) -> Plant {
    let mut builder = PlantBuilder::new();
    for what in ["start", "done"] {
        for i in 0..machines {
            let name = format!("{what}{i}");
            builder =
                if what == "start" { builder.controllable(&name) } else { builder.uncontrollable(&name) };
        }
    }
    for i in 0..machines {
        builder = builder.component(&format!("Machine{i}"), &format!("I start{i} W, W done{i} I"));
    }
    let mut plant = builder.build();
    let mut state = |state: u32| State {
        name: format!("s{state}"),
        marked: true,
        formula: None,
        edges: (0..2 * machines)
            .filter_map(|event| Some(Edge { event, target: next(state, event)?, span: Span::default() }))
            .collect(),
        doc: Vec::new(),
        span: Span::default(),
    };
    plant.automata.push(Automaton {
        name: "Constraint".to_owned(),
        states: (0..states).map(&mut state).collect(),
        initial: 0,
        alphabet: (0..2 * machines).collect(),
        doc: Vec::new(),
        span: Span::default(),
    });
    plant
}

/// A buffer between two machines.
#[must_use]
pub fn buffer(places: u32) -> Plant {
    workshop(2, places + 1, |state, event| match event {
        1 => state.checked_sub(1),
        2 => Some(state + 1).filter(|&after| after <= places),
        _ => Some(state),
    })
}

/// Machines whose order is constrained at random.
#[must_use]
pub fn random_order(machines: u32, states: u32, seed: u64) -> Plant {
    let mut random = Random::new(seed);
    workshop(machines, states, |_, event| {
        let target = random.below(states);
        (event >= machines || random.below(4) > 0).then_some(target)
    })
}

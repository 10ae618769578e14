//! Random small plants from a seed.

use crate::plant_builder::PlantBuilder;
use crate::tables::Random;
use std::fmt::Write as _;
use synth_core::plant::{Condition, Plant, Rule, StateRef};

/// A plant of one to three components and up to two constraint automata with a few states each, events shared at random, up to
/// three conditions.
#[must_use]
pub fn plant(seed: u64) -> Plant {
    let random = &mut Random::new(seed);
    let mut builder = PlantBuilder::new();
    let (controllable, uncontrollable) = (1 + random.below(4), random.below(4));
    for event in 0..controllable {
        builder = builder.controllable(&format!("c{event}"));
    }
    for event in 0..uncontrollable {
        builder = builder.uncontrollable(&format!("u{event}"));
    }
    let events: Vec<String> = (0..controllable)
        .map(|event| format!("c{event}"))
        .chain((0..uncontrollable).map(|event| format!("u{event}")))
        .collect();
    for component in 0..1 + random.below(3) {
        let named = some(random, &events);
        builder = builder.component(&format!("P{component}"), &automaton(random, &named, 4));
        if random.below(8) == 0 {
            builder = builder.naming(&events[random.below(events.len() as u32) as usize]);
        }
    }
    for constraint in 0..random.below(3) {
        let named = some(random, &events);
        builder = builder.constraint(&format!("C{constraint}"), &automaton(random, &named, 3));
    }
    conditions(random, builder)
}

/// About half of the events: what automata share can stop them, so that little is left if they share all.
fn some(random: &mut Random, events: &[String]) -> Vec<String> {
    events.iter().filter(|_| random.below(2) == 0).cloned().collect()
}

/// The edges of an automaton; sometimes some states are marked.
fn automaton(random: &mut Random, events: &[String], most: u32) -> String {
    let states = 1 + random.below(most);
    let marks = random.below(2) == 0;
    let mut text = String::new();
    for state in 0..states {
        let mark = if marks && random.below(3) == 0 { "*" } else { "" };
        let _ = write!(text, "{}s{state}{mark}", if state == 0 { "" } else { ", " });
    }
    for source in 0..states {
        for event in events {
            if random.below(2) == 0 {
                let _ = write!(text, ", s{source} {event} s{}", random.below(states));
            }
        }
    }
    text
}

fn conditions(random: &mut Random, mut builder: PlantBuilder) -> Plant {
    let plant = builder.clone().build();
    for number in 0..random.below(4) {
        let condition = condition(random, &plant, 2);
        let event = random.below(plant.events.len() as u32);
        let rule = match random.below(3) {
            0 => Rule::Never(Condition::And(vec![condition, self::condition(random, &plant, 1)])),
            _ => Rule::Only { event, when: condition },
        };
        builder.rule(&format!("R{number}"), rule);
    }
    builder.build()
}

fn condition(random: &mut Random, plant: &Plant, depth: u32) -> Condition<StateRef> {
    match random.below(if depth == 0 { 1 } else { 5 }) {
        1 => Condition::Not(Box::new(condition(random, plant, depth - 1))),
        2 => Condition::And((0..2).map(|_| condition(random, plant, depth - 1)).collect()),
        3 => Condition::Or((0..2).map(|_| condition(random, plant, depth - 1)).collect()),
        _ => {
            let automaton = random.below(plant.automata.len() as u32);
            let state = random.below(plant.automata[automaton as usize].states.len() as u32);
            Condition::Atom(StateRef { automaton, state })
        }
    }
}

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
    let (controllable, uncontrollable) = (2 + random.below(4), random.below(3));
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
    let components = 1 + random.below(3);
    for component in 0..components {
        let named = some(random, &events, |event| if event as u32 % components == component { 8 } else { 1 });
        builder = builder.component(&format!("P{component}"), &automaton(random, &named, 4, 2));
        if random.below(8) == 0 {
            builder = builder.naming(&events[random.below(events.len() as u32) as usize]);
        }
    }
    for constraint in 0..random.below(3) {
        let named = some(random, &events, |_| 2);
        builder = builder.constraint(&format!("C{constraint}"), &automaton(random, &named, 3, 3));
    }
    conditions(random, builder)
}

/// Each event with a chance of so many eighths. What automata share can stop them, so that little is left if they share much.
fn some(random: &mut Random, events: &[String], eighths: impl Fn(usize) -> u32) -> Vec<String> {
    let chosen = events.iter().enumerate().filter(|(event, _)| random.below(8) < eighths(*event));
    chosen.map(|(_, event)| event.clone()).collect()
}

/// The edges of an automaton of up to so many states, so many quarters of those that could be; sometimes some states are
/// marked.
fn automaton(random: &mut Random, events: &[String], most: u32, density: u32) -> String {
    let states = 2 + random.below(most - 1);
    let marks = random.below(2) == 0;
    let mut text = String::new();
    for state in 0..states {
        let mark = if marks && random.below(3) == 0 { "*" } else { "" };
        let _ = write!(text, "{}s{state}{mark}", if state == 0 { "" } else { ", " });
    }
    for source in 0..states {
        // On to the next state by some event, so that most can be reached.
        let on = random.below(events.len().max(1) as u32) as usize;
        for (position, event) in events.iter().enumerate() {
            if position == on {
                let _ = write!(text, ", s{source} {event} s{}", (source + 1) % states);
            } else if random.below(4) < density {
                let _ = write!(text, ", s{source} {event} s{}", random.below(states));
            }
        }
    }
    text
}

fn conditions(random: &mut Random, mut builder: PlantBuilder) -> Plant {
    let plant = builder.clone().build();
    for number in 0..random.below(4) {
        let rule = match random.below(3) {
            0 => Rule::Never(Condition::And((0..2).map(|_| condition(random, &plant, 1)).collect())),
            which => {
                // Forbidding what nobody can prevent rarely leaves anything.
                let controllable = plant.events.iter().filter(|event| event.controllable).count();
                let among =
                    if which == 1 && random.below(4) == 0 { plant.events.len() } else { controllable };
                Rule::Only { event: random.below(among as u32), when: condition(random, &plant, 2) }
            }
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

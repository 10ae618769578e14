//! Closed loops of plants without bad states, breadth first, for tests of what comes after them.

use super::{ClosedLoop, EventId, Plant, Rule, read};
use crate::syntax::FileId;
use std::collections::BTreeMap;

/// A plant from its text.
#[track_caller]
pub(super) fn plant(text: &str) -> Plant {
    read(text, FileId(0)).expect("a plant").0
}

/// Festo's distribution station.
pub(super) fn station() -> Plant {
    plant(include_str!("../../../tests/plants/distribution_station.plant"))
}

/// Where an event leads; `None` if an automaton that names it does not allow it.
fn step(plant: &Plant, states: &[u16], event: EventId, automata: usize) -> Option<Vec<u16>> {
    let mut next = states.to_vec();
    let mut named = false;
    for (automaton, state) in plant.automata[..automata].iter().zip(&mut next) {
        if automaton.alphabet.contains(&event) {
            let edges = &automaton.states[*state as usize].edges;
            *state = edges.iter().find(|edge| edge.event == event)?.target as u16;
            named = true;
        }
    }
    named.then_some(next)
}

/// All that can be reached if every constraint forbids just what it says.
pub(super) fn closed_loop(plant: &Plant) -> ClosedLoop {
    let allowed = |states: &[u16], event: EventId| {
        plant.constraints.iter().all(|constraint| match &constraint.rule {
            Rule::Only { event: of, when } => {
                *of != event || when.eval(&|at| u32::from(states[at.automaton as usize]) == at.state)
            }
            Rule::Never(_) => panic!("only for plants without bad states"),
        })
    };
    let events = 0..plant.events.len() as EventId;
    let initial: Vec<u16> = plant.automata.iter().map(|automaton| automaton.initial as u16).collect();
    let mut found = BTreeMap::from([(initial.clone(), Vec::new())]);
    let mut open = vec![initial.clone()];
    while let Some(states) = open.pop() {
        for event in events.clone() {
            let next = step(plant, &states, event, plant.automata.len());
            let Some(next) = next.filter(|_| allowed(&states, event)) else { continue };
            found.get_mut(&states).expect("found").push((event, next.clone()));
            found.entry(next).or_insert_with_key(|next| {
                open.push(next.clone());
                Vec::new()
            });
        }
    }
    let number: BTreeMap<&Vec<u16>, u32> = found.keys().zip(0..).collect();
    let mut closed = ClosedLoop {
        plant: (0, 0),
        constrained: (0, 0),
        automata: plant.automata.len(),
        states: found.keys().flatten().copied().collect(),
        initial: number[&initial],
        first: vec![0],
        edges: Vec::new(),
        first_inhibited: vec![0],
        inhibited: Vec::new(),
    };
    for (states, edges) in &found {
        closed.edges.extend(edges.iter().map(|(event, next)| (*event, number[next])));
        closed.first.push(closed.edges.len() as u32);
        closed.inhibited.extend(events.clone().filter(|&event| {
            plant.events[event as usize].controllable
                && step(plant, states, event, plant.components).is_some()
                && !edges.iter().any(|(other, _)| *other == event)
        }));
        closed.first_inhibited.push(closed.inhibited.len() as u32);
    }
    closed
}

//! What a rung is for, in the words of the plant.

use crate::plant::{ClosedLoop, EventId, Plant, Rule};

/// Where an event is possible, and what inhibits it how often; back ends know what the event itself says.
pub(super) fn of_event(plant: &Plant, closed: &ClosedLoop, event: EventId) -> Vec<String> {
    let mut lines = Vec::new();
    let places: Vec<String> = plant.automata[..plant.components]
        .iter()
        .filter(|component| component.alphabet.binary_search(&event).is_ok())
        .map(|component| {
            let possible =
                component.states.iter().filter(|state| state.edges.iter().any(|edge| edge.event == event));
            let names: Vec<String> =
                possible.map(|state| format!("{}.{}", component.name, state.name)).collect();
            names.join(" or ")
        })
        .collect();
    let inhibited: Vec<usize> =
        (0..closed.len()).filter(|&entry| closed.inhibited(entry).binary_search(&event).is_ok()).collect();
    let enabled = (0..closed.len()).filter(|&entry| happens(closed, entry, event)).count();
    let all = enabled + inhibited.len();
    lines.push(format!("possible in {}: {enabled} of {all} entries enable it", places.join(", ")));
    let mut ahead = vec![true; inhibited.len()];
    for (name, forbids) in constraints(plant, event) {
        let mut count = 0;
        for (&entry, ahead) in inhibited.iter().zip(&mut ahead) {
            if forbids(closed.entry(entry)) {
                count += 1;
                *ahead = false;
            }
        }
        if count > 0 {
            lines.push(format!("inhibited by {name} in {count}"));
        }
    }
    let ahead = ahead.into_iter().filter(|ahead| *ahead).count();
    if ahead > 0 {
        lines.push(format!("inhibited because of what would follow in {ahead}"));
    }
    lines
}

fn happens(closed: &ClosedLoop, entry: usize, event: EventId) -> bool {
    closed.edges(entry).binary_search_by_key(&event, |&(event, _)| event).is_ok()
}

type Forbids<'a> = Box<dyn Fn(&[u16]) -> bool + 'a>;

/// The constraints on an event by name, and in which states they forbid it.
fn constraints(plant: &Plant, event: EventId) -> Vec<(&str, Forbids<'_>)> {
    let mut all: Vec<(&str, Forbids<'_>)> = Vec::new();
    for constraint in &plant.constraints {
        if let Rule::Only { event: of, when } = &constraint.rule
            && *of == event
        {
            all.push((
                &constraint.name,
                Box::new(move |states| {
                    !when.eval(&|at| u32::from(states[at.automaton as usize]) == at.state)
                }),
            ));
        }
    }
    for (position, automaton) in plant.automata.iter().enumerate().skip(plant.components) {
        if automaton.alphabet.binary_search(&event).is_ok() {
            all.push((
                &automaton.name,
                Box::new(move |states| {
                    let state = &automaton.states[states[position] as usize];
                    state.edges.iter().all(|edge| edge.event != event)
                }),
            ));
        }
    }
    all
}

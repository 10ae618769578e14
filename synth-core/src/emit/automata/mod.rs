//! Diagrams of a plant: components, constraint automata, and the closed loop if it is small enough to be looked at.
//!
//! | function | language |
//! |---|---|
//! | [`dot`] | that of Graphviz |
//! | [`mermaid`] | Mermaid, for Markdown |
//! | [`svg`] | a drawing |
//!
//! Controllable events have solid arrows and uncontrollable ones dashed arrows where the language has both; marked states have
//! a double line, if there are others.

mod dot;
mod mermaid;
mod svg;

use std::collections::BTreeMap;

use super::scan::formula::PLANT;
use crate::plant::{Automaton, ClosedLoop, Condition, EventId, Plant, SignalId};

/// Closed loops of more entries are not drawn: nobody could read them.
pub const MAX_ENTRIES: usize = 64;

/// Automata and closed loop as a DOT digraph, a cluster each.
#[must_use]
pub fn dot(plant: &Plant, closed: Option<&ClosedLoop>) -> String {
    dot::text(&plant.name, &graphs(plant, closed))
}

/// Automata and closed loop as a `stateDiagram-v2`, a composite state each.
#[must_use]
pub fn mermaid(plant: &Plant, closed: Option<&ClosedLoop>) -> String {
    mermaid::text(&graphs(plant, closed))
}

/// Automata and closed loop as SVG, one below the other.
#[must_use]
pub fn svg(plant: &Plant, closed: Option<&ClosedLoop>) -> String {
    svg::drawing(&plant.name, &graphs(plant, closed))
}

/// An automaton to be drawn.
struct Graph {
    title: String,
    nodes: Vec<Node>,
    /// By source, then target.
    edges: Vec<Edge>,
    initial: usize,
}

struct Node {
    /// Name, and below it the formula of a state.
    lines: Vec<String>,
    /// Drawn with a double line.
    marked: bool,
}

struct Edge {
    source: usize,
    target: usize,
    /// Names of events, separated by commas.
    label: String,
    controllable: bool,
}

fn graphs(plant: &Plant, closed: Option<&ClosedLoop>) -> Vec<Graph> {
    let automata = plant.automata.iter().map(|automaton| of_automaton(plant, automaton));
    let closed = closed.filter(|closed| closed.len() <= MAX_ENTRIES);
    automata.chain(closed.map(|closed| of_closed_loop(plant, closed))).collect()
}

fn of_automaton(plant: &Plant, automaton: &Automaton) -> Graph {
    let all_marked = automaton.states.iter().all(|state| state.marked);
    let nodes = automaton.states.iter().map(|state| Node {
        lines: std::iter::once(state.name.clone())
            .chain(state.formula.as_ref().map(|formula| condition(plant, formula)))
            .collect(),
        marked: state.marked && !all_marked,
    });
    let edges = automaton.states.iter().enumerate().flat_map(|(source, state)| {
        state.edges.iter().map(move |edge| (source, edge.target as usize, edge.event))
    });
    Graph {
        title: automaton.name.clone(),
        nodes: nodes.collect(),
        edges: merged(plant, edges),
        initial: automaton.initial as usize,
    }
}

fn of_closed_loop(plant: &Plant, closed: &ClosedLoop) -> Graph {
    let node = |entry| {
        let states = plant.automata.iter().zip(closed.entry(entry));
        let lines = states.map(|(automaton, &state)| automaton.states[state as usize].name.clone());
        Node { lines: vec![lines.collect::<Vec<_>>().join(" ")], marked: false }
    };
    let edges = (0..closed.len()).flat_map(|entry| {
        closed.edges(entry).iter().map(move |&(event, target)| (entry, target as usize, event))
    });
    Graph {
        title: "closed loop".to_owned(),
        nodes: (0..closed.len()).map(node).collect(),
        edges: merged(plant, edges),
        initial: closed.initial as usize,
    }
}

/// One arrow for all events of a kind between two states.
fn merged(plant: &Plant, edges: impl Iterator<Item = (usize, usize, EventId)>) -> Vec<Edge> {
    let mut labels: BTreeMap<(usize, usize, bool), Vec<&str>> = BTreeMap::new();
    for (source, target, event) in edges {
        let event = &plant.events[event as usize];
        labels.entry((source, target, !event.controllable)).or_default().push(&event.name);
    }
    let edge = |((source, target, uncontrollable), names): ((usize, usize, bool), Vec<&str>)| Edge {
        source,
        target,
        label: names.join(", "),
        controllable: !uncontrollable,
    };
    labels.into_iter().map(edge).collect()
}

/// A condition as it was written, but for parentheses that it does not need.
fn condition(plant: &Plant, of: &Condition<SignalId>) -> String {
    let name = |signal: &SignalId| plant.signals[*signal as usize].name.clone();
    PLANT.condition(of, &name)
}

//! Does a controller win? The game is cut down to the moves that the controller leaves, and solved once more.

use super::explore::{Edge, Graph, Node, Owner};
use super::solve::solve;
use super::turn::Case;
use std::collections::BTreeMap;
use synth_core::controller::Controller;

/// Where the product stands: a node of the game, a state of the controller, the position in its super step.
type Place = (usize, u32, usize);

/// Whether `controller` wins the game: it refuses nothing that the environment can do, sends only what is allowed and
/// in time, and then every play is won.
#[must_use]
pub fn wins(graph: &Graph, controller: &Controller) -> bool {
    let mut product = Graph { nodes: Vec::new(), edges: Vec::new(), keys: graph.keys.clone() };
    let mut index: BTreeMap<Place, usize> = BTreeMap::new();
    let mut places = vec![(0, controller.initial, 0)];
    index.insert(places[0], 0);
    let mut from = 0;
    while from < places.len() {
        let node = places[from].0;
        product.nodes.push(graph.nodes[node].clone());
        let Some(choices) = choices(graph, controller, places[from]) else { return false };
        if matches!(graph.nodes[node].owner, Owner::Lost) {
            return false;
        }
        for (edge, state, position) in choices {
            let place = (edge.to, state, position);
            let to = *index.entry(place).or_insert_with(|| {
                places.push(place);
                places.len() - 1
            });
            product.edges.push(Edge { from, to, ..edge.clone() });
        }
        from += 1;
    }
    solve(&product)[0]
}

/// What can happen next; `None` if the controller is wrong here.
fn choices<'g>(
    graph: &'g Graph,
    controller: &Controller,
    (node, state, position): Place,
) -> Option<Vec<(&'g Edge, u32, usize)>> {
    let Node { owner, .. } = &graph.nodes[node];
    let edges: Vec<&Edge> = graph.edges.iter().filter(|edge| edge.from == node).collect();
    let due = controller.super_steps.iter().find(|step| step.source == state);
    let Owner::Turn(case) = owner else { return Some(Vec::new()) };
    match due {
        Some(step) => {
            let text = &controller.commands[step.events[position] as usize].text;
            let sent = edges.into_iter().find(|edge| text_of(edge).as_ref() == Some(text))?;
            if !case.is_system() {
                return None;
            }
            let last = position + 1 == step.events.len();
            Some(vec![if last { (sent, step.target, 0) } else { (sent, state, position + 1) }])
        }
        None if *case == Case::SystemEventually => {
            let pass = edges.into_iter().find(|edge| edge.event.is_none())?;
            Some(vec![(pass, state, 0)])
        }
        None if case.is_system() => None,
        None => edges
            .into_iter()
            .map(|edge| {
                let text = text_of(edge)?;
                let event = controller.events.iter().position(|event| event.text == text)?;
                let rows = &controller.environment[event];
                let row = rows.iter().find(|row| row.0 == state)?;
                Some((edge, row.1, 0))
            })
            .collect(),
    }
}

fn text_of(edge: &Edge) -> Option<String> {
    edge.event.as_ref().map(ToString::to_string)
}

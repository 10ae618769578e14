//! Which constraint automata the feedback depends on.

use crate::plant::{AutomatonId, ClosedLoop, EventId, Plant};

/// The constraint automata without which the states of components, and of the others, would not say what is enabled.
///
/// They are left out one after the other, the last first, wherever that is possible: none of those that remain can be
/// left out.
pub(super) fn needed(plant: &Plant, closed: &ClosedLoop) -> Vec<AutomatonId> {
    let mut kept: Vec<usize> = (0..closed.automata).collect();
    for automaton in (plant.components..closed.automata).rev() {
        let without: Vec<usize> = kept.iter().copied().filter(|&a| a != automaton).collect();
        if determine(plant, closed, &without) {
            kept = without;
        }
    }
    kept.into_iter().filter(|&a| a >= plant.components).map(|a| a as AutomatonId).collect()
}

/// Whether the states of some automata determine what is enabled.
fn determine(plant: &Plant, closed: &ClosedLoop, automata: &[usize]) -> bool {
    let key = |entry: u32| automata.iter().map(move |&a| closed.entry(entry as usize)[a]);
    let mut order: Vec<u32> = (0..closed.len() as u32).collect();
    order.sort_unstable_by(|&a, &b| key(a).cmp(key(b)));
    order.windows(2).all(|pair| {
        !key(pair[0]).eq(key(pair[1])) || enabled(plant, closed, pair[0]).eq(enabled(plant, closed, pair[1]))
    })
}

/// The controllable events that are enabled in an entry, ascending.
pub(super) fn enabled(plant: &Plant, closed: &ClosedLoop, entry: u32) -> impl Iterator<Item = EventId> {
    let edges = closed.edges(entry as usize).iter().map(|&(event, _)| event);
    edges.filter(|&event| plant.events[event as usize].controllable)
}

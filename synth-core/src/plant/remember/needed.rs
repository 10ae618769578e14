//! Which constraint automata the feedback depends on.

use crate::intern::{Indexed, Rows};
use crate::plant::{AutomatonId, ClosedLoop, EventId, Plant};

/// Per entry a number for the set of controllable events that are enabled in it.
pub(super) fn enabled(plant: &Plant, closed: &ClosedLoop) -> Vec<u32> {
    let mut sets: Indexed<Vec<EventId>> = Indexed::default();
    (0..closed.len()).map(|entry| sets.intern(closed.enabled(plant, entry).collect()).0).collect()
}

/// The constraint automata without which the states of components, and of the others, would not say what is enabled.
///
/// They are left out one after the other, the last first, wherever that is possible: none of those that remain can be
/// left out.
pub(super) fn needed(plant: &Plant, closed: &ClosedLoop, enabled: &[u32]) -> Vec<AutomatonId> {
    let mut kept: Vec<usize> = (0..closed.automata).collect();
    for automaton in (plant.components..closed.automata).rev() {
        let without: Vec<usize> = kept.iter().copied().filter(|&a| a != automaton).collect();
        if determine(closed, &without, enabled) {
            kept = without;
        }
    }
    kept.into_iter().filter(|&a| a >= plant.components).map(|a| a as AutomatonId).collect()
}

/// Whether the states of some automata determine what is enabled.
fn determine(closed: &ClosedLoop, automata: &[usize], enabled: &[u32]) -> bool {
    let mut rows: Rows<u16> = Rows::new(automata.len());
    let mut found: Vec<u32> = Vec::new();
    let mut row = Vec::with_capacity(automata.len());
    (0..closed.len()).all(|entry| {
        let states = closed.entry(entry);
        row.clear();
        row.extend(automata.iter().map(|&automaton| states[automaton]));
        let id = rows.intern(&row) as usize;
        if id == found.len() {
            found.push(enabled[entry]);
        }
        found[id] == enabled[entry]
    })
}

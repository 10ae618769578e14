//! Guarantees that the controlled system meets because nothing happens that they speak of.

use super::starts::could_start;
use crate::diagnostic::{Code, Diagnostic};
use crate::explore::Explored;
use crate::game::{Strategy, YIELD};
use crate::model::{ConstraintKind, Kind, NodeKind, Scenario};
use crate::playout::Copy;
use fixedbitset::FixedBitSet;

/// The guarantees that start in some play of the specification, but are not exercised in any play of the strategy:
/// no copy starts, or none comes to a place where it asks for or forbids something. `never` start at all.
pub(super) fn guarantees(
    explored: &Explored<'_>,
    strategy: &Strategy,
    never: &[Diagnostic],
) -> Vec<Diagnostic> {
    let spec = explored.playout.spec();
    let is_known = |scenario: &Scenario| never.iter().any(|warning| warning.span == scenario.span);
    let guarantees = spec.scenarios.iter().enumerate();
    let guarantees =
        guarantees.filter(|(_, scenario)| scenario.kind == Kind::Guarantee && !is_known(scenario));
    let mut open: Vec<usize> = guarantees.map(|(index, _)| index).collect();
    let started = exercise(explored, strategy, &mut open);
    let happening = happening(explored, strategy);
    let happens = |scenario: &Scenario| {
        happening.ones().any(|event| could_start(spec, scenario, explored.playout.event(event as u32)))
    };
    let warnings = open.into_iter().filter_map(|index| {
        let scenario = &spec.scenarios[index];
        let never_starts = !started.contains(index) && !happens(scenario);
        // One that may have started and ended at once shows no copy.
        let ends_unseen = !never_starts && (!started.contains(index) || has_violation(scenario));
        if ends_unseen || !never_starts && !demands_anything(scenario) {
            return None;
        }
        let label = if never_starts {
            "no play of the controller starts it"
        } else {
            "it starts, but never comes to a place where it asks for something or forbids it"
        };
        let message = format!("guarantee `{}` is never exercised in the controlled system", scenario.name);
        Some(Diagnostic::warning(Code::Vacuous, scenario.span, message).label(label).help(
            "see whether its messages are the ones that were meant, and what keeps them from happening",
        ))
    });
    warnings.collect()
}

/// Removes from `open` the scenarios with a copy that demands something; the scenarios that have a copy.
fn exercise(explored: &Explored<'_>, strategy: &Strategy, open: &mut Vec<usize>) -> FixedBitSet {
    let Explored { playout, store, .. } = explored;
    let spec = playout.spec();
    let mut started = FixedBitSet::with_capacity(spec.scenarios.len());
    let mut seen_states = FixedBitSet::with_capacity(store.len());
    let mut seen_copies = FixedBitSet::new();
    let mut copies = Vec::new();
    for &state in &strategy.state {
        if open.is_empty() {
            break;
        }
        if state as usize >= store.len() || seen_states.put(state as usize) {
            continue;
        }
        store.copies(state, &mut copies);
        for &id in &copies {
            seen_copies.grow(id as usize + 1);
            if seen_copies.put(id as usize) {
                continue;
            }
            let copy = playout.copy(id);
            started.insert(copy.scenario);
            if demands(&spec.scenarios[copy.scenario], copy) {
                open.retain(|&index| index != copy.scenario);
            }
        }
    }
    started
}

/// Whether a copy asks for something or forbids it where it stands.
fn demands(scenario: &Scenario, copy: &Copy) -> bool {
    let forbids = || {
        copy.cut.iter().any(|&leaf| {
            let bodies = std::iter::successors(Some(leaf), |&node| {
                (node != 0).then(|| scenario.nodes[usize::from(node)].parent)
            });
            bodies.into_iter().any(|node| forbids(&scenario.nodes[usize::from(node)].kind))
        })
    };
    copy.strict || !copy.obligations.is_empty() || forbids()
}

fn forbids(kind: &NodeKind) -> bool {
    match kind {
        NodeKind::Body { constraints, .. } => constraints.iter().any(|c| c.kind == ConstraintKind::Forbidden),
        _ => false,
    }
}

/// Whether some fragment behind the initial messages asks for something or forbids it.
pub(super) fn demands_anything(scenario: &Scenario) -> bool {
    scenario.nodes.iter().enumerate().any(|(node, each)| match &each.kind {
        NodeKind::Message { strict, modality, .. } => {
            (*strict || modality.is_some()) && !scenario.initial.iter().any(|&n| usize::from(n) == node)
        }
        NodeKind::Wait { strict, eventually, .. } => *strict || *eventually,
        kind => forbids(kind),
    })
}

pub(super) fn has_violation(scenario: &Scenario) -> bool {
    scenario.nodes.iter().any(|node| matches!(node.kind, NodeKind::Violation(_)))
}

/// The events that happen in some play of the strategy.
fn happening(explored: &Explored<'_>, strategy: &Strategy) -> FixedBitSet {
    let Explored { playout, game, .. } = explored;
    let mut happening = FixedBitSet::with_capacity(playout.event_count());
    let labels = strategy.edge.iter().map(|&edge| game.label(edge as usize));
    labels.filter(|&label| label != YIELD).for_each(|event| happening.insert(event as usize));
    happening
}

//! Events of the plant that nobody can see: what happens by itself changes inputs, and never outputs.

use super::readable::Search;
use super::{Condition, Plant, SignalId, SignalKind};
use crate::diagnostic::{Code, Diagnostic};

/// Edges of uncontrollable events between states that no outputs can have in common.
pub(super) fn warnings(plant: &Plant, found: &mut Vec<Diagnostic>) {
    let (doubled, later) = doubled(plant);
    let mut search = Search::new(&doubled);
    for component in &plant.automata[..plant.components] {
        for (state, number) in component.states.iter().zip(0u32..) {
            for edge in state.edges.iter().filter(|edge| edge.target != number) {
                let event = &plant.events[edge.event as usize];
                let target = &component.states[edge.target as usize];
                let (Some(before), Some(after)) = (&state.formula, &target.formula) else { continue };
                if event.controllable {
                    continue;
                }
                let after: Option<Condition<SignalId>> =
                    after.resolved(&mut |&signal| Some(later[signal as usize]));
                if after.is_none_or(|after| search.satisfied(&[before, &after]).is_some()) {
                    continue;
                }
                let message =
                    format!("nobody sees `{}` lead from `{}` to `{}`", event.name, state.name, target.name);
                let warning = Diagnostic::warning(Code::Unnoticed, edge.span, message);
                found.push(
                    warning
                        .also(target.span, "has other outputs, and the plant changes none")
                        .also(event.span, "happens by itself")
                        .help(format!(
                            "tell `{}` from `{}` by an input, or make `{}` controllable with commands",
                            target.name, state.name, event.name
                        )),
                );
            }
        }
    }
}

/// A plant with each input twice, before and after; and per signal the one that stands for it afterwards.
fn doubled(plant: &Plant) -> (Plant, Vec<SignalId>) {
    let analogues = plant.analogues.len() as u32;
    let mut doubled = Plant {
        signals: plant.signals.clone(),
        analogues: [&plant.analogues[..], &plant.analogues[..]].concat(),
        name: String::new(),
        doc: Vec::new(),
        events: Vec::new(),
        automata: Vec::new(),
        components: 0,
        constraints: Vec::new(),
    };
    let mut later = Vec::with_capacity(plant.signals.len());
    for (signal, id) in plant.signals.iter().zip(0..) {
        let kind = match signal.kind {
            SignalKind::Output | SignalKind::Memory => {
                later.push(id);
                continue;
            }
            SignalKind::Input => SignalKind::Input,
            SignalKind::Range { analogue, low, high } => {
                SignalKind::Range { analogue: analogue + analogues, low, high }
            }
        };
        let mut copy = signal.clone();
        copy.kind = kind;
        later.push(doubled.signals.len() as SignalId);
        doubled.signals.push(copy);
    }
    (doubled, later)
}

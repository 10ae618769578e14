//! Signals for random plants: outputs, inputs, formulas and commands, at random, too.

use crate::tables::Random;
use synth_core::plant::{Command, Condition, Plant, Signal, SignalId, SignalKind};
use synth_core::syntax::Span;

/// Gives each component one or two outputs and inputs of its own; some read an output of another. Formulas of states are conjunctions of their literals;
/// commands mostly, but not always, do what the formula of some target asks for. States of one component may look the same.
#[must_use]
pub fn with_signals(mut plant: Plant, seed: u64) -> Plant {
    let random = &mut Random::new(seed ^ 0x5e_ed);
    for component in 0..plant.components {
        let mut own: Vec<SignalId> = [(SignalKind::Output, "Y"), (SignalKind::Input, "X")]
            .into_iter()
            .flat_map(|(kind, letter)| {
                (0..1 + random.below(2)).map(move |number| (kind, letter, number)).collect::<Vec<_>>()
            })
            .map(|(kind, letter, number)| {
                let name = format!("{letter}{component}_{number}");
                plant.signals.push(Signal { name, kind, doc: Vec::new(), span: Span::default() });
                plant.signals.len() as SignalId - 1
            })
            .collect();
        if component > 0 && random.below(4) == 0 {
            // The first output of the first component.
            own.push(0);
        }
        for state in &mut plant.automata[component].states {
            state.formula = Some(conjunction(random, &own));
        }
    }
    for component in 0..plant.components {
        for state in 0..plant.automata[component].states.len() {
            for edge in plant.automata[component].states[state].edges.clone() {
                let target = plant.automata[component].states[edge.target as usize].formula.clone();
                let event = &mut plant.events[edge.event as usize];
                if !event.controllable {
                    continue;
                }
                for (signal, value) in literals(&target.expect("a formula")) {
                    let is_output = plant.signals[signal as usize].kind == SignalKind::Output;
                    if is_output && event.commands.iter().all(|it| it.signal != signal) && random.below(8) > 0
                    {
                        event.commands.push(Command { signal, set: value != (random.below(12) == 0) });
                    }
                }
            }
        }
    }
    plant
}

/// Of most of these signals, at least one.
fn conjunction(random: &mut Random, signals: &[SignalId]) -> Condition<SignalId> {
    let literal = |random: &mut Random, signal| match random.below(2) {
        0 => Condition::Atom(signal),
        _ => Condition::Not(Box::new(Condition::Atom(signal))),
    };
    let mut parts = Vec::new();
    for &signal in signals {
        if random.below(5) > 0 {
            parts.push(literal(random, signal));
        }
    }
    match parts.len() {
        0 => literal(random, signals[0]),
        1 => parts.remove(0),
        _ => Condition::And(parts),
    }
}

fn literals(formula: &Condition<SignalId>) -> Vec<(SignalId, bool)> {
    match formula {
        Condition::Atom(signal) => vec![(*signal, true)],
        Condition::Not(inner) => {
            literals(inner).into_iter().map(|(signal, value)| (signal, !value)).collect()
        }
        Condition::And(parts) | Condition::Or(parts) => parts.iter().flat_map(literals).collect(),
    }
}

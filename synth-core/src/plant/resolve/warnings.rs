//! What is worth a look in a plant that is not wrong.

use super::same_but_case;
use super::signals::noun;
use crate::diagnostic::{Code, Diagnostic};
use crate::plant::{Automaton, Plant, SignalKind};

/// All warnings about a plant, in no particular order.
pub(super) fn warnings(plant: &Plant) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    unused_events(plant, &mut found);
    events_without_commands(plant, &mut found);
    signals(plant, &mut found);
    for automaton in &plant.automata {
        unreachable(automaton, &mut found);
    }
    names(plant, &mut found);
    found
}

fn unused_events(plant: &Plant, found: &mut Vec<Diagnostic>) {
    let mut named = vec![false; plant.events.len()];
    for &event in plant.automata.iter().flat_map(|automaton| &automaton.alphabet) {
        named[event as usize] = true;
    }
    for (event, _) in plant.events.iter().zip(named).filter(|(_, named)| !named) {
        let message = format!("no automaton names the event `{}`", event.name);
        let warning = Diagnostic::warning(Code::Unused, event.span, message);
        found
            .push(warning.note("an event without an edge never happens").help("add its edges, or remove it"));
    }
}

fn events_without_commands(plant: &Plant, found: &mut Vec<Diagnostic>) {
    if plant.signals.is_empty() {
        return;
    }
    for event in plant.events.iter().filter(|event| event.controllable && event.commands.is_empty()) {
        let message = format!("the controllable event `{}` has no commands", event.name);
        let warning = Diagnostic::warning(Code::NoCommands, event.span, message);
        found.push(
            warning.help(format!("write `controllable {} {{ set … }}`, or `uncontrollable`", event.name)),
        );
    }
}

fn signals(plant: &Plant, found: &mut Vec<Diagnostic>) {
    let (mut read, mut written) = (vec![false; plant.signals.len()], vec![false; plant.signals.len()]);
    let states = plant.automata.iter().flat_map(|automaton| &automaton.states);
    for formula in states.filter_map(|state| state.formula.as_ref()) {
        formula.atoms(&mut |&signal| read[signal as usize] = true);
    }
    for command in plant.events.iter().flat_map(|event| &event.commands) {
        written[command.signal as usize] = true;
    }
    for ((signal, read), written) in plant.signals.iter().zip(read).zip(written) {
        let noun = noun(signal.kind);
        let writable = matches!(signal.kind, SignalKind::Output | SignalKind::Memory);
        if !read && !written {
            let message = format!("nothing uses the {noun} `{}`", signal.name);
            found.push(Diagnostic::warning(Code::Unused, signal.span, message).help("remove it, or use it"));
        } else if writable && !written {
            let message = format!("no event sets or resets the {noun} `{}`", signal.name);
            let warning = Diagnostic::warning(Code::NeverWritten, signal.span, message);
            found.push(
                warning.help(format!("add a command such as `set {}`, or make it an input", signal.name)),
            );
        }
    }
}

/// States that no edges lead to.
fn unreachable(automaton: &Automaton, found: &mut Vec<Diagnostic>) {
    let mut reached = vec![false; automaton.states.len()];
    reached[automaton.initial as usize] = true;
    let mut pending = vec![automaton.initial];
    while let Some(state) = pending.pop() {
        for edge in &automaton.states[state as usize].edges {
            if !std::mem::replace(&mut reached[edge.target as usize], true) {
                pending.push(edge.target);
            }
        }
    }
    for (state, _) in automaton.states.iter().zip(reached).filter(|(_, reached)| !reached) {
        let message = format!("no edges lead to the state `{}`", state.name);
        let initial = &automaton.states[automaton.initial as usize];
        let warning = Diagnostic::warning(Code::Unreachable, state.span, message);
        found.push(
            warning.also(initial.span, "where the automaton starts").help("add an edge to it, or remove it"),
        );
    }
}

/// Names that differ by case only; those of signals are errors.
fn names(plant: &Plant, found: &mut Vec<Diagnostic>) {
    let mut pairs = same_but_case(plant.events.iter().map(|event| (event.name.as_str(), event.span)));
    let named = plant.automata.iter().map(|automaton| (automaton.name.as_str(), automaton.span));
    let conditions = plant.constraints.iter().map(|constraint| (constraint.name.as_str(), constraint.span));
    pairs.extend(same_but_case(named.chain(conditions)));
    for automaton in &plant.automata {
        pairs.extend(same_but_case(automaton.states.iter().map(|state| (state.name.as_str(), state.span))));
    }
    for [(first, earlier), (name, span)] in pairs {
        let message = format!("`{name}` and `{first}` differ by case only");
        let warning = Diagnostic::warning(Code::CaseOnly, span, message);
        found.push(warning.also(earlier, "the other one").help("rename one of the two"));
    }
}

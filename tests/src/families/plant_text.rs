//! A plant of automata in the language of plants.

use std::fmt::Write as _;
use synth_core::plant::{Automaton, Edge, Plant};

/// The text of a plant without signals, formulas of states and constraints that are no automata.
#[must_use]
pub fn plant_text(name: &str, plant: &Plant) -> String {
    let mut text = format!("plant {name} {{\n");
    for event in &plant.events {
        let kind = if event.controllable { "controllable" } else { "uncontrollable" };
        let _ = writeln!(text, "    {kind} {}", event.name);
    }
    for (number, automaton) in plant.automata.iter().enumerate() {
        let kind = if number < plant.components { "automaton" } else { "constraint automaton" };
        let _ = writeln!(text, "    {kind} {} {{", automaton.name);
        states(&mut text, plant, automaton);
        text.push_str("    }\n");
    }
    text.push_str("}\n");
    text
}

fn states(text: &mut String, plant: &Plant, automaton: &Automaton) {
    // If all are marked, it need not be said.
    let some = automaton.states.iter().any(|state| !state.marked);
    for (number, state) in automaton.states.iter().enumerate() {
        let initial = if number == automaton.initial as usize { "initial " } else { "" };
        let marked = if some && state.marked { "marked " } else { "" };
        let edge = |edge: &Edge| {
            let target = &automaton.states[edge.target as usize].name;
            format!("{} -> {}", plant.events[edge.event as usize].name, word(target))
        };
        let edges: Vec<String> = state.edges.iter().map(edge).collect();
        let _ =
            writeln!(text, "        {initial}{marked}state {} {{ {} }}", word(&state.name), edges.join(", "));
    }
}

/// Numbers become words.
fn word(name: &str) -> String {
    if name.starts_with(|first: char| first.is_ascii_digit()) { format!("S{name}") } else { name.to_owned() }
}

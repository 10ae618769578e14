//! Mermaid state diagrams.

use std::fmt::Write as _;

use super::Graph;
use crate::emit::mermaid::escaped;

/// A composite state per automaton. Uncontrollable events stand in parentheses, since arrows are all alike.
pub(super) fn text(graphs: &[Graph]) -> String {
    let mut out = String::from("stateDiagram-v2\n  direction LR\n");
    for (number, graph) in graphs.iter().enumerate() {
        // Writing to a string cannot fail.
        let _ = writeln!(out, "  state \"{}\" as a{number} {{", escaped(&graph.title));
        for (node, it) in graph.nodes.iter().enumerate() {
            let marked = if it.marked { " (marked)" } else { "" };
            let lines: Vec<String> = it.lines.iter().map(|line| escaped(line)).collect();
            let _ = writeln!(out, "    state \"{}{marked}\" as a{number}s{node}", lines.join("<br>"));
        }
        let _ = writeln!(out, "    [*] --> a{number}s{}", graph.initial);
        for edge in &graph.edges {
            let (source, target, label) = (edge.source, edge.target, escaped(&edge.label));
            let label = if edge.controllable { label } else { format!("({label})") };
            let _ = writeln!(out, "    a{number}s{source} --> a{number}s{target} : {label}");
        }
        out.push_str("  }\n");
    }
    out
}

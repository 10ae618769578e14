//! The DOT language of Graphviz.

use std::fmt::Write as _;

use super::Graph;
use crate::emit::dot::quoted;

/// A digraph with a cluster per automaton.
pub(super) fn text(plant: &str, graphs: &[Graph]) -> String {
    let mut out = String::new();
    // Writing to a string cannot fail.
    let _ = writeln!(out, "digraph {} {{", quoted(plant));
    out.push_str("  rankdir=LR;\n  node [shape=box, style=rounded];\n");
    for (number, graph) in graphs.iter().enumerate() {
        let _ = writeln!(out, "  subgraph cluster_{number} {{\n    label={};", quoted(&graph.title));
        let _ = writeln!(out, "    a{number}_start [shape=point, label=\"\"];");
        for (node, it) in graph.nodes.iter().enumerate() {
            let double = if it.marked { ", peripheries=2" } else { "" };
            let _ = writeln!(out, "    a{number}_s{node} [label={}{double}];", quoted(&it.lines.join("\n")));
        }
        let _ = writeln!(out, "    a{number}_start -> a{number}_s{};", graph.initial);
        for edge in &graph.edges {
            let (source, target, label) = (edge.source, edge.target, quoted(&edge.label));
            let style = if edge.controllable { "" } else { ", style=dashed" };
            let _ = writeln!(out, "    a{number}_s{source} -> a{number}_s{target} [label={label}{style}];");
        }
        out.push_str("  }\n");
    }
    out.push_str("}\n");
    out
}

//! The controller as a directed graph in the DOT language of Graphviz.

use std::fmt::Write as _;

use super::diagram::edges;
use crate::controller::tables::Tables;

/// The controller as a DOT digraph: circles wait for an event, boxes have a super step to do.
///
/// An edge carries the text of its event, or `/` and the commands of its super step (in bold).
#[must_use]
pub fn text(tables: &Tables) -> String {
    let mut out = String::new();
    // Writing to a string cannot fail.
    let _ = writeln!(out, "digraph {} {{", quoted(&tables.specification));
    out.push_str("  rankdir=LR;\n  node [shape=circle];\n  start [shape=point, label=\"\"];\n");
    for state in &tables.super_steps.source {
        let _ = writeln!(out, "  {state} [shape=box];");
    }
    let _ = writeln!(out, "  start -> {};", tables.initial);
    for edge in edges(tables) {
        let style = if edge.super_step { ", style=bold" } else { "" };
        let _ = writeln!(out, "  {} -> {} [label={}{style}];", edge.source, edge.target, quoted(&edge.label));
    }
    out.push_str("}\n");
    out
}

/// A double-quoted DOT string; in a label a backslash would start an escape sequence.
pub(super) fn quoted(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 2);
    out.push('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            '\n' => out.push_str("\\n"),
            _ => out.push(c),
        }
    }
    out.push('"');
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::emit::diagram::tests::lamp;

    #[test]
    fn draws_events_and_super_steps() {
        let expected = r#"digraph "Lamp" {
  rankdir=LR;
  node [shape=circle];
  start [shape=point, label=""];
  1 [shape=box];
  3 [shape=box];
  start -> 0;
  0 -> 1 [label="a -> c.a()"];
  1 -> 2 [label="/ c -> lamp.on()", style=bold];
  2 -> 2 [label="a -> c.a()"];
  2 -> 3 [label="b -> c.b(\"x\")"];
  3 -> 0 [label="/ no command", style=bold];
}
"#;
        assert_eq!(text(&lamp()), expected);
    }

    #[test]
    fn quotes() {
        assert_eq!(quoted("a\\b\nc"), r#""a\\b\nc""#);
    }
}

//! What the state diagrams have in common: the controller's transitions with readable labels.

use crate::controller::tables::Tables;

/// A transition of the diagram.
pub(super) struct Edge {
    pub(super) source: u32,
    pub(super) target: u32,
    /// An event text, or `/ command, command` for a super step.
    pub(super) label: String,
    pub(super) super_step: bool,
}

/// All transitions, by source, then events in table order, then the super step.
pub(super) fn edges(tables: &Tables) -> Vec<Edge> {
    let mut edges = Vec::new();
    for table in &tables.events {
        for (&source, &target) in table.mapping.source.iter().zip(&table.mapping.target) {
            edges.push(Edge { source, target, label: table.event.text.clone(), super_step: false });
        }
    }
    let steps = &tables.super_steps;
    for (row, (&source, &target)) in steps.source.iter().zip(&steps.target).enumerate() {
        edges.push(Edge { source, target, label: commands(tables, row), super_step: true });
    }
    // Stable: rows of one source stay in the order in which they were pushed.
    edges.sort_by_key(|edge| edge.source);
    edges
}

fn commands(tables: &Tables, row: usize) -> String {
    let texts: Vec<&str> = tables
        .components
        .iter()
        .filter(|component| component.codes[row] != 0)
        .map(|component| component.commands[component.codes[row] as usize - 1].text.as_str())
        .collect();
    if texts.is_empty() { "/ no command".to_owned() } else { format!("/ {}", texts.join(", ")) }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::controller::Event;
    use crate::controller::tables::{ComponentTable, EventTable, Mapping, Provenance};

    fn event(text: &str) -> Event {
        let part = String::new;
        Event {
            text: text.to_owned(),
            sender: part(),
            receiver: part(),
            operation: part(),
            arguments: vec![],
        }
    }

    /// 0 -a-> 1 =on=> 2 -b-> 3 =nothing=> 0, and 2 -a-> 2.
    pub(in crate::emit) fn lamp() -> Tables {
        let table = |text, source: &[u32], target: &[u32]| EventTable {
            event: event(text),
            mapping: Mapping { source: source.to_vec(), target: target.to_vec() },
        };
        Tables {
            specification: "Lamp".to_owned(),
            states: 4,
            initial: 0,
            events: vec![table("a -> c.a()", &[0, 2], &[1, 2]), table("b -> c.b(\"x\")", &[2], &[3])],
            super_steps: Mapping { source: vec![1, 3], target: vec![2, 0] },
            components: vec![ComponentTable {
                object: "lamp".to_owned(),
                commands: vec![event("c -> lamp.on()")],
                codes: vec![1, 0],
            }],
            owed: vec![vec![]; 4],
            provenance: Provenance::default(),
        }
    }

    #[test]
    fn transitions_come_by_source_then_table_order() {
        let listed: Vec<_> =
            edges(&lamp()).into_iter().map(|e| (e.source, e.target, e.label, e.super_step)).collect();
        let expected = [
            (0, 1, "a -> c.a()", false),
            (1, 2, "/ c -> lamp.on()", true),
            (2, 2, "a -> c.a()", false),
            (2, 3, "b -> c.b(\"x\")", false),
            (3, 0, "/ no command", true),
        ];
        assert_eq!(listed, expected.map(|(s, t, l, x)| (s, t, l.to_owned(), x)));
    }
}

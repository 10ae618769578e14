//! What `sml supervise` says, for people.

use super::{ClosedLoop, EventId, Plant};
use std::fmt::Write as _;

impl ClosedLoop {
    /// The controllable events that the feedback enables in an entry.
    pub fn enabled<'a>(&'a self, plant: &'a Plant, entry: usize) -> impl Iterator<Item = EventId> + 'a {
        let events = self.edges(entry).iter().map(|edge| edge.0);
        events.filter(|&event| plant.events[event as usize].controllable)
    }

    /// The figures, a line each.
    #[must_use]
    pub fn figures(&self) -> String {
        let size = |(states, transitions): (u64, u64)| format!("{states} states, {transitions} transitions");
        let plant = self.plant.map_or_else(|| "too many states to count".to_owned(), size);
        let (constrained, entries) = (size(self.constrained), self.len());
        format!("plant: {plant}\nconstrained: {constrained}\nfeedback: {entries} entries\n")
    }

    /// The feedback as a table: the states of components, and of constraint automata that carry memory, what is
    /// inhibited, and what is enabled.
    #[must_use]
    pub fn table(&self, plant: &Plant) -> String {
        let shown: Vec<usize> =
            (0..plant.components).chain(self.memory(plant).into_iter().map(|id| id as usize)).collect();
        let mut rows = vec![
            shown
                .iter()
                .map(|&id| plant.automata[id].name.as_str())
                .chain(["inhibited", "enabled"])
                .map(str::to_owned)
                .collect::<Vec<String>>(),
        ];
        let names = |events: &mut dyn Iterator<Item = EventId>| {
            let names: Vec<&str> = events.map(|event| plant.events[event as usize].name.as_str()).collect();
            if names.is_empty() { "-".to_owned() } else { names.join(" ") }
        };
        for entry in 0..self.len() {
            let states = self.entry(entry);
            let mut row: Vec<String> =
                shown.iter().map(|&id| plant.automata[id].states[states[id] as usize].name.clone()).collect();
            row.push(names(&mut self.inhibited(entry).iter().copied()));
            row.push(names(&mut self.enabled(plant, entry)));
            rows.push(row);
        }
        aligned(&rows)
    }
}

/// Columns as wide as what is in them.
fn aligned(rows: &[Vec<String>]) -> String {
    let columns = rows[0].len();
    let width = |column: usize| rows.iter().map(|row| row[column].len()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let mut text = String::new();
    for row in rows {
        let mut line = String::new();
        for (cell, width) in row.iter().zip(&widths) {
            let _ = write!(line, "{cell:width$}  ");
        }
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text
}

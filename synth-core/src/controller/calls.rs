//! What one call of a controller can come to, computed from its tables: events consumed, super steps done, look-ups.
//!
//! A call consumes each event at most once, because nothing raises events meanwhile.

use super::tables::Tables;

/// The most super steps of a drain: each commands a component for the first time, or nothing; how many of those
/// follow each other is in the tables, and between two such rows stands an event or a command.
pub(crate) fn super_steps(tables: &Tables) -> u64 {
    let events = consumable(tables);
    let commanding =
        tables.components.iter().filter(|c| c.codes.iter().any(|&code| code != 0)).count() as u64;
    let silent = longest_silence(tables);
    commanding.saturating_add(silent.saturating_mul(events + commanding + 1))
}

/// The most super steps in a row that command nothing; there is no circle of them where draining is allowed.
fn longest_silence(tables: &Tables) -> u64 {
    let steps = &tables.super_steps;
    let mut edges = vec![Vec::new(); tables.states as usize];
    for (row, (&source, &target)) in steps.source.iter().zip(&steps.target).enumerate() {
        if tables.components.iter().all(|component| component.codes[row] == 0) {
            edges[source as usize].push(target);
        }
    }
    longest_path(&edges)
}

/// The most events that a cycle consumes: each once, and no more of them than follow each other without a super step.
pub(crate) fn events(tables: &Tables) -> u64 {
    longest_chain(tables).min(consumable(tables))
}

/// The events that can be consumed at all: an event without rows stays pending.
fn consumable(tables: &Tables) -> u64 {
    tables.events.iter().filter(|table| !table.mapping.source.is_empty()).count() as u64
}

/// The most look-ups of events in a cycle: all are pending, every pass but the last consumes one.
pub(crate) fn lookups_of_cycle(tables: &Tables) -> u64 {
    lookups(tables, events(tables))
}

/// The most look-ups of events in a drain: every repetition but one consumes nothing, that one does all.
pub(crate) fn lookups_of_drain(tables: &Tables) -> u64 {
    let all = tables.events.len() as u64;
    all.saturating_mul(super_steps(tables)).saturating_add(lookups(tables, consumable(tables)))
}

/// Of passes that consume so many events, one each, and a last one.
fn lookups(tables: &Tables, consumed: u64) -> u64 {
    let all = tables.events.len() as u64;
    (all - consumed..=all).sum()
}

/// The most events that follow each other without a super step; unlimited if they can go round in a circle.
fn longest_chain(tables: &Tables) -> u64 {
    let mut edges = vec![Vec::new(); tables.states as usize];
    for mapping in tables.events.iter().map(|table| &table.mapping) {
        for (&source, &target) in mapping.source.iter().zip(&mapping.target) {
            edges[source as usize].push(target);
        }
    }
    longest_path(&edges)
}

/// The number of edges of the longest path, `u64::MAX` if there is a circle.
fn longest_path(edges: &[Vec<u32>]) -> u64 {
    let mut open: Vec<u32> = vec![0; edges.len()];
    for &target in edges.iter().flatten() {
        open[target as usize] += 1;
    }
    // States in topological order; those on a circle, and behind one, never come.
    let mut order: Vec<u32> =
        (0..).zip(&open).filter(|(_, open)| **open == 0).map(|(state, _)| state).collect();
    let mut length = vec![0u64; edges.len()];
    let mut at = 0;
    while let Some(&state) = order.get(at) {
        at += 1;
        for &target in &edges[state as usize] {
            length[target as usize] = length[target as usize].max(length[state as usize] + 1);
            open[target as usize] -= 1;
            if open[target as usize] == 0 {
                order.push(target);
            }
        }
    }
    if order.len() < edges.len() { u64::MAX } else { length.into_iter().max().unwrap_or(0) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(states: usize, edges: &[(u32, u32)], expected: u64) {
        let mut lists = vec![Vec::new(); states];
        for &(source, target) in edges {
            lists[source as usize].push(target);
        }
        assert_eq!(longest_path(&lists), expected);
    }

    #[test]
    fn longest_paths() {
        check(0, &[], 0);
        check(3, &[], 0);
        check(3, &[(2, 1), (1, 0)], 2);
        check(4, &[(0, 1), (0, 2), (1, 2), (3, 2)], 2);
        check(3, &[(0, 1), (0, 1)], 1);
    }

    #[test]
    fn circles_have_no_longest_path() {
        check(1, &[(0, 0)], u64::MAX);
        check(4, &[(0, 1), (1, 2), (2, 1), (2, 3)], u64::MAX);
    }
}

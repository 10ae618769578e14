//! What a call costs at most, computed from the tables.
//!
//! The rounds are counted: all but the last consume an event, and the more have been consumed, the fewer are left to be
//! searched.

use std::ops::{Add, AddAssign, Mul};

use super::block::Block;
use super::{Trigger, Unexpected, retain};
use crate::controller::calls;

/// Costs of a piece of text.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Cost {
    /// Statements that begin: assignments, `IF`, `CASE`, loops (once each), calls.
    pub statements: u64,
    /// Times that the body of a loop is entered.
    pub iterations: u64,
    /// Comparisons with an entry of a table; for `CASE`, conditions of branches.
    pub probes: u64,
}

impl Cost {
    pub(super) fn statements(statements: u64) -> Cost {
        Cost { statements, ..Cost::default() }
    }

    /// The greater of each.
    fn max(self, other: Cost) -> Cost {
        Cost {
            statements: self.statements.max(other.statements),
            iterations: self.iterations.max(other.iterations),
            probes: self.probes.max(other.probes),
        }
    }
}

impl Add for Cost {
    type Output = Cost;

    fn add(self, other: Cost) -> Cost {
        Cost {
            statements: self.statements.saturating_add(other.statements),
            iterations: self.iterations.saturating_add(other.iterations),
            probes: self.probes.saturating_add(other.probes),
        }
    }
}

impl AddAssign for Cost {
    fn add_assign(&mut self, other: Cost) {
        *self = *self + other;
    }
}

impl Mul<u64> for Cost {
    type Output = Cost;

    fn mul(self, times: u64) -> Cost {
        Cost {
            statements: self.statements.saturating_mul(times),
            iterations: self.iterations.saturating_mul(times),
            probes: self.probes.saturating_mul(times),
        }
    }
}

/// Costs of the statements that a layout writes.
#[derive(Default)]
pub(super) struct LayoutCost {
    /// What entering the loop over events costs.
    pub(super) entry: Cost,
    /// A round of the loop over events, without its searches.
    pub(super) round: Cost,
    /// Rounds for every event that is consumed; one more ends the loop.
    pub(super) rounds_per_event: u64,
    /// Per event with rows its search in one round if it is pending; none if a round does not search.
    pub(super) searches: Vec<Cost>,
    /// What consuming an event adds.
    pub(super) event: Cost,
    /// Looking for the super step that is due.
    pub(super) seek: Cost,
    /// What doing it adds.
    pub(super) perform: Cost,
    /// What leaving it to the next call adds (drain).
    pub(super) leave: Cost,
    /// What is added if none is due.
    pub(super) wait: Cost,
}

/// What one call costs at most: a cycle, or a drain if `options.drain`.
pub(super) fn call(block: &Block<'_>) -> Cost {
    let owed = block.owed.as_ref().map_or(Cost::default(), |owed| owed.cost() + each_event(block, 1));
    let kept = if block.options.retain { retain::cost(block) } else { Cost::default() };
    frame(block) + kept + run(block).max(reset(block)) + owed
}

/// A call that runs.
fn run(block: &Block<'_>) -> Cost {
    let cost = block.layout().cost(block);
    let events = block.events().count() as u64;
    let raise = each_event(block, 3);
    // Unexpected events are looked for only if no super step is due.
    let waits = cost.wait + refuse(block);
    if block.drains() {
        // Every repetition but the last does a super step, and the last one does none.
        let steps = calls::super_steps(block.tables);
        let cycles = steps.saturating_add(1);
        let repeats = Cost { statements: 1, iterations: cycles, probes: 0 };
        let ends = cost.leave.max(waits);
        raise + repeats + consume(&cost, cycles, events) + cost.seek * cycles + cost.perform * steps + ends
    } else {
        let consumed = calls::events(block.tables);
        raise + consume(&cost, 1, consumed) + cost.seek + cost.perform.max(waits)
    }
}

/// Entering the loop over events so many times, and consuming so many in all.
fn consume(cost: &LayoutCost, cycles: u64, consumed: u64) -> Cost {
    let rounds = cycles.saturating_add(cost.rounds_per_event * consumed);
    let mut total = cost.entry * cycles + cost.round * rounds + cost.event * consumed;
    let mut searches = cost.searches.clone();
    searches.sort_unstable_by_key(|search| std::cmp::Reverse(search.statements));
    // Sums of the most expensive searches: none, one, two, …
    let mut sums = vec![Cost::default()];
    for search in searches {
        sums.push(sums[sums.len() - 1] + search);
    }
    // The loop may end in every cycle but one with everything pending; in the other it is consumed one a round.
    total += sums[sums.len() - 1] * (cycles - 1);
    for left in sums.iter().rev().take(consumed as usize + 1) {
        total += *left;
    }
    total
}

/// What every call does: outputs, `overrun`, `unexpected`, `raised`, `IF reset`, `previous`, `state_no`.
fn frame(block: &Block<'_>) -> Cost {
    let clears = u64::from(block.options.unexpected != Unexpected::Fault);
    let (events, components) = (block.names.events.len() as u64, block.names.components.len() as u64);
    let edges = u64::from(block.options.trigger == Trigger::Edge && events > 0);
    Cost::statements(components + events + 3 + clears + edges)
}

/// What a call with `reset` does: `state`, `unexpected`, and a loop over the events.
fn reset(block: &Block<'_>) -> Cost {
    let clears = u64::from(block.options.unexpected == Unexpected::Fault);
    Cost::statements(1 + clears) + each_event(block, 1)
}

/// Looking for unexpected events.
fn refuse(block: &Block<'_>) -> Cost {
    each_event(block, if block.options.unexpected == Unexpected::Drop { 2 } else { 1 })
}

/// A loop over the events.
pub(super) fn each_event(block: &Block<'_>, statements: u64) -> Cost {
    let events = block.names.events.len() as u64;
    let enters = u64::from(events > 0);
    Cost { statements: enters + statements * events, iterations: events, probes: 0 }
}

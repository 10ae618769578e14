//! How a text holds the transitions and finds the one to follow.

pub(super) mod case;
pub(super) mod rows;
pub(super) mod runs;
pub(super) mod search;
mod step;

use super::block::Block;
use super::bound::LayoutCost;
use super::unit::{Declarations, Section, Unit};
use super::writer::Writer;
use crate::controller::runs::Runs;
use crate::controller::tables::Tables;

/// Declarations and statements that differ with how transitions are held.
pub(super) trait Layout: Sync {
    /// What the function block calls.
    fn functions<'a>(&self, block: &'a Block<'_>) -> Vec<Unit<'a>>;

    /// Sections of variables that hold transitions.
    fn tables(&self, out: &mut Declarations, block: &Block<'_>);

    /// Variables of the statements below.
    fn variables(&self, out: &mut Section, block: &Block<'_>);

    /// Consumes pending events that fit, until none does. There is an event with rows.
    fn consume(&self, out: &mut Writer, block: &Block<'_>);

    /// Does the super step that is due, and sets `due`; with drain, sets `done` if none is, or if a component would be
    /// commanded again, and does nothing then. There is a super step.
    fn super_step(&self, out: &mut Writer, block: &Block<'_>);

    /// The largest number that its indices must hold, beside the number of events.
    fn largest_index(&self, tables: &Tables, runs: &Runs) -> u64;

    /// What its statements cost at most.
    fn cost(&self, block: &Block<'_>) -> LayoutCost;
}

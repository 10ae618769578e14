//! Back ends of [programs of rungs](crate::plant::Program), which are done once a scan.
//!
//! | target | where |
//! |---|---|
//! | ladder as text and as a drawing | [`ladder`] |
//! | ladder as PLCopen XML | `st::plcopen::ladder`, with the feature `plcopen` |
//! | instruction list | [`list`] |
//! | Structured Text | [`st::scan`](crate::emit::st::scan) |
//! | Rust | [`rust::scan`](crate::emit::rust::scan) |
//!
//! All of them mean the same: rungs are done in their order; the condition of a rung is found once, then its coils are driven
//! in their order; a coil is seen by the rungs below it, and its variable keeps the value until the next coil drives it, in
//! this scan or another.
//!
//! # Names
//!
//! What people read (ladder, instruction list) says names as they were written. Rust and Structured Text have them in their own
//! case and clear of their own words; what clashes is numbered `_2`, `_3`, …, those of the interface last.

pub(crate) mod formula;
mod head;
pub mod ladder;
pub mod list;

use crate::controller::tables::Provenance;
use crate::logic::Var;
use crate::plant::{Event, Program, Rung, Use, Variable};

pub(in crate::emit) use head::{commands, origin, rung_lines};

/// A program and what texts say about it.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// What is done in a scan.
    pub program: &'a Program,
    /// The plant's events, which rungs refer to by position.
    pub events: &'a [Event],
    /// Where it comes from.
    pub provenance: &'a Provenance,
}

/// What a text calls things; made for people and tools.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct NameMap {
    /// The target's name.
    pub target: &'static str,
    /// The function block, or the function.
    pub function_block: String,
    /// The program, or the module.
    pub program: String,
    /// Every variable's identifier, in the order of the program.
    pub variables: Vec<String>,
    /// Every analogue input's identifier, in the order of the program.
    pub analogues: Vec<String>,
    /// Every controllable event's identifier, in the order of the plant, where the target has any.
    pub events: Vec<String>,
}

impl<'a> Source<'a> {
    /// The event that a rung causes.
    pub(in crate::emit) fn event(&self, rung: &Rung) -> Option<&'a Event> {
        rung.event.map(|event| &self.events[event as usize])
    }

    /// The name of a variable, as written.
    pub(in crate::emit) fn name(&self, variable: Var) -> &'a str {
        &self.program.variables[variable as usize].name
    }

    /// The ranges, as position of the variable, that of the analogue input, and both ends.
    pub(in crate::emit) fn ranges(&self) -> impl Iterator<Item = (Var, u32, i64, i64)> + use<'a> {
        (0..).zip(&self.program.variables).filter_map(|(variable, Variable { usage, .. })| match *usage {
            Use::Range(analogue, low, high) => Some((variable, analogue, low, high)),
            _ => None,
        })
    }

    /// Per analogue input whether the ends of its ranges all lie between two values, both included.
    pub(in crate::emit) fn analogue_fits(&self, analogue: u32, least: i64, greatest: i64) -> bool {
        self.ranges()
            .filter(|&(_, of, ..)| of == analogue)
            .all(|(_, _, low, high)| low >= least && high <= greatest)
    }
}

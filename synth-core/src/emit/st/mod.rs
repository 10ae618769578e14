//! Structured Text (IEC 61131-3).
//!
//! The text is a library of its own: a `TYPE` for the set of pending events, a `FUNCTION_BLOCK` that holds the
//! tables and does one cycle a call, a `PROGRAM` that passes its inputs and outputs through, and a `CONFIGURATION`
//! that runs it every 10 ms.
//!
//! Where a [`Target`] has no special needs, it keeps to the second edition of the standard, which the strict compilers
//! check: every array that is assigned has a named type, no `//` comments, no pointers, no mixed integer types. What
//! sets targets apart is in `dialect`: words, the layout of transitions (`layout`), and the frame around blocks.
//!
//! # What a call does
//!
//! 1. The outputs `<object>_cmd` become 0, `overrun` and `unexpected` become FALSE.
//! 2. With `reset` TRUE the controller goes back to its initial state and forgets all pending events; it does no
//!    cycle, whatever `enable` says. With `enable` FALSE it does nothing. Events raised in such a call are lost: a
//!    controller that does not run does not listen, and a signal that rose meanwhile is no rising edge later.
//! 3. Otherwise the inputs raise events (one that was pending already sets `overrun`), pending events are consumed
//!    in table order until none fits, and at most one super step is done (all that [`Options::drain`] allows).
//! 4. `unexpected` becomes TRUE if the controller then waits for the environment, but something is pending: none
//!    of it fits the state, nor will it before another event comes. Events pending while a super step is due are
//!    not unexpected; the next call decides about them.
//!
//! With [`Options::retain`] a call begins with what an earlier one kept, or with the initial state if that was one of
//! other tables.

mod block;
mod bound;
mod dialect;
mod fit;
mod header;
mod integer;
mod layout;
mod names;
mod owed;
#[cfg(feature = "plcopen")]
pub mod plcopen;
mod program;
mod retain;
pub mod scan;
mod secondary;
mod unit;
mod writer;

use super::template::Template;
use crate::controller::tables::Tables;
use block::Block;
pub use bound::Cost;
use dialect::Dialect;
pub use fit::Unfit;
pub use names::{ComponentNames, NameMap};
use writer::Writer;

/// The system that the text is for.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Target {
    /// IEC 61131-3, second edition, nothing else.
    #[default]
    Iec,
    /// CODESYS 3.
    Codesys,
    /// TwinCAT 3.
    Twincat,
    /// Siemens SCL, as an external source of TIA Portal.
    Siemens,
    /// IEC 61131-3, second edition, with transitions as branches of `CASE`.
    Case,
}

impl Target {
    /// All of them.
    pub const ALL: [Target; 5] =
        [Target::Iec, Target::Codesys, Target::Twincat, Target::Siemens, Target::Case];

    /// As on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.dialect().name
    }
}

/// When an input raises its event.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Trigger {
    /// In the call in which it becomes TRUE.
    #[default]
    Edge,
    /// In every call in which it is TRUE.
    Level,
}

/// The integer types of states and indices.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Integers {
    /// The narrowest of `USINT`, `UINT`, `UDINT`.
    #[default]
    Unsigned,
    /// The narrower of `INT` and `DINT`, for systems without unsigned types; `state_no` is a `DINT` then.
    Signed,
}

/// What becomes of events that fit nowhere.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Unexpected {
    /// They stay pending; `unexpected` is TRUE as long as they do.
    #[default]
    Keep,
    /// They are forgotten; `unexpected` is TRUE in that call.
    Drop,
    /// The controller stops, with `unexpected` TRUE, until it is reset.
    Fault,
}

/// How tables hold transitions; [`Target::Case`] has none.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Encoding {
    /// One array of all targets, and runs of consecutive states instead of sources (see [`Runs`]): less than half of the
    /// text, and fewer probes.
    ///
    /// [`Runs`]: crate::controller::runs::Runs
    #[default]
    Runs,
    /// Two arrays per event, as published (Gritzner and Greenyer 2018, section 4).
    Rows,
}

/// How to write the text.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Options {
    /// The dialect.
    pub target: Target,
    /// When an input raises its event.
    pub trigger: Trigger,
    /// The family of integer types.
    pub integers: Integers,
    /// A call repeats the cycle until nothing is left to do or a component would get a second command.
    pub drain: bool,
    /// What becomes of events that fit nowhere.
    pub unexpected: Unexpected,
    /// How tables hold transitions.
    pub encoding: Encoding,
    /// There is an output `owed`: which events the environment owes.
    pub owed: bool,
    /// State and pending events survive a power cycle.
    pub retain: bool,
}

/// The whole text, ending in a newline, deterministic.
///
/// # Errors
///
/// What the target cannot hold ([`Unfit`]), before anything is written.
pub fn text(tables: &Tables, options: &Options) -> Result<String, Unfit> {
    let block = Block::new(tables, options)?;
    let Dialect { frame, notes, .. } = block.dialect();
    let mut out = Writer::new(*frame);
    header::header(&block, notes).write(&mut out);
    frame.declare_events(&mut out, &block.names, &block.events_array());
    for unit in block.units().iter().chain([&program::unit(&block)]) {
        frame.unit(&mut out, unit);
    }
    frame.configuration(&mut out, &block.names.runner());
    Ok(out.finish())
}

/// What one call of the function block costs at most, computed from the tables.
///
/// # Errors
///
/// As [`text`].
pub fn bound(tables: &Tables, options: &Options) -> Result<Cost, Unfit> {
    Ok(bound::call(&Block::new(tables, options)?))
}

/// A template of a secondary per component, in order of the objects' names.
///
/// # Errors
///
/// As [`text`].
pub fn templates(tables: &Tables, options: &Options) -> Result<Vec<Template>, Unfit> {
    Ok(secondary::templates(&Block::new(tables, options)?))
}

/// What events, components and codes are called in [`text`]'s output.
#[must_use]
pub fn names(tables: &Tables, options: &Options) -> NameMap {
    NameMap::new(tables, options.target, &names::Names::new(tables, options.target))
}

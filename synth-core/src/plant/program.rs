//! A program of rungs: what all back ends of this route write.

use super::{EventId, Plant, Signal, SignalKind};
use crate::logic::{Expr, Var};

/// Rungs, done in their order once a scan; a coil is seen by the rungs below it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Program {
    /// The plant's name.
    pub name: String,
    /// The plant's `///` lines.
    pub doc: Vec<String>,
    /// All Booleans: the plant's signals in their order, then what synthesis added.
    pub variables: Vec<Variable>,
    /// Digitised analogue inputs.
    pub analogues: Vec<String>,
    /// In the order of a scan.
    pub rungs: Vec<Rung>,
}

impl Program {
    /// The signals of a plant and no rungs; relays are off at first.
    #[must_use]
    pub fn without_rungs(plant: &Plant) -> Program {
        let variable = |signal: &Signal| Variable {
            name: signal.name.clone(),
            usage: match signal.kind {
                SignalKind::Input => Use::Input,
                SignalKind::Output => Use::Output,
                SignalKind::Memory => Use::Memory(false),
                SignalKind::Range { analogue, low, high } => Use::Range(analogue, low, high),
            },
            doc: signal.doc.clone(),
        };
        Program {
            name: plant.name.clone(),
            doc: plant.doc.clone(),
            variables: plant.signals.iter().map(variable).collect(),
            analogues: plant.analogues.clone(),
            rungs: Vec::new(),
        }
    }
}

/// A Boolean of a program.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Variable {
    /// Unique, also without regard to case.
    pub name: String,
    /// What it is.
    pub usage: Use,
    /// For comments.
    pub doc: Vec<String>,
}

/// What a variable is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Use {
    /// Read only.
    Input,
    /// Written and read back.
    Output,
    /// Kept from scan to scan; the value is that of the first scan.
    Memory(bool),
    /// Written before it is read in every scan, so that it need not be kept.
    Scratch,
    /// An analogue input, by its position, lies between two values, both included; computed at the start of a scan.
    Range(u32, i64, i64),
}

/// A condition and what is done where it holds.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Rung {
    /// The controllable event that it causes, if it is one's.
    pub event: Option<EventId>,
    /// What it is for, a line each.
    pub comment: Vec<String>,
    /// Over [`Program::variables`].
    pub condition: Expr,
    /// In their order.
    pub coils: Vec<Coil>,
}

/// What a rung does to a variable.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Coil {
    /// Position among [`Program::variables`].
    pub variable: Var,
    /// How.
    pub drive: Drive,
}

/// How a coil drives its variable.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Drive {
    /// Becomes true where the condition holds.
    Set,
    /// Becomes false where the condition holds.
    Reset,
    /// Becomes the condition's value.
    Out,
}

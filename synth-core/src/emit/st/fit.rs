//! Whether a target can hold a controller.

use std::fmt;

use super::Options;
use crate::controller::tables::Tables;

/// Why a controller cannot be written for a target.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Unfit {
    /// States or rows outnumber the integer types of the chosen family.
    TooLarge {
        /// Number of states.
        states: u32,
    },
    /// A component has more commands than an `INT` can tell apart.
    TooManyCommands {
        /// The component.
        object: String,
        /// Number of its commands.
        commands: usize,
    },
    /// Draining would never end: super steps that command nothing follow each other in a circle.
    EndlessDrain {
        /// A state on the circle.
        state: u32,
    },
}

impl fmt::Display for Unfit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Unfit::TooLarge { states } => {
                write!(f, "the tables of {states} states do not fit the integer types of the target")
            }
            Unfit::TooManyCommands { object, commands } => {
                write!(f, "`{object}` has {commands} commands, but an `INT` output tells only 32767 apart")
            }
            Unfit::EndlessDrain { state } => {
                write!(
                    f,
                    "draining would not end: the super steps from state {state} on command nothing and return to it"
                )
            }
        }
    }
}

impl std::error::Error for Unfit {}

/// Whether a call ends.
pub(super) fn check(tables: &Tables, options: &Options) -> Result<(), Unfit> {
    match options.drain.then(|| silent_circle(tables)).flatten() {
        Some(state) => Err(Unfit::EndlessDrain { state }),
        None => Ok(()),
    }
}

/// A state from which super steps without any command lead back to it.
fn silent_circle(tables: &Tables) -> Option<u32> {
    let steps = &tables.super_steps;
    let silent = |row: usize| tables.components.iter().all(|component| component.codes[row] == 0);
    let next = |state: u32| {
        let row = steps.source.binary_search(&state).ok()?;
        silent(row).then(|| steps.target[row])
    };
    // Every state has at most one successor, so a walk either ends, meets an older walk, or closes its own circle.
    let mut walk_of = vec![0u32; tables.states as usize];
    for (walk, &start) in (1..).zip(&steps.source) {
        let mut state = start;
        while walk_of[state as usize] == 0 {
            walk_of[state as usize] = walk;
            match next(state) {
                Some(target) => state = target,
                None => break,
            }
        }
        if walk_of[state as usize] == walk && next(state).is_some() {
            return Some(state);
        }
    }
    None
}

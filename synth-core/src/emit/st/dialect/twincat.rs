//! TwinCAT 3: one search for all tables, by pointer.

use super::frame::Standard;
use super::words::TWINCAT;
use super::{Dialect, Transitions};
use crate::emit::st::layout::search::Pointers;

pub(super) static DIALECT: Dialect = Dialect {
    name: "twincat",
    words: &TWINCAT,
    // A constant may have no address.
    transitions: Transitions::tables(&Pointers, "VAR"),
    frame: &Standard,
    notes: &[
        "TwinCAT keeps each declaration as an object of its own. What CONFIGURATION says is set in the task's reference.",
    ],
    retaining: &[
        "TwinCAT keeps the whole instance in retained memory, tables included: there must be room for it.",
    ],
};

//! CODESYS 3: one search for all tables, by pointer.

use super::frame::Standard;
use super::words::CODESYS;
use super::{Dialect, Transitions};
use crate::emit::st::layout::search::Pointers;

pub(super) static DIALECT: Dialect = Dialect {
    name: "codesys",
    words: &CODESYS,
    // A constant may have no address.
    transitions: Transitions::tables(&Pointers, "VAR"),
    frame: &Standard,
    notes: &[
        "CODESYS keeps each declaration as an object of its own. What CONFIGURATION says is set in the task configuration.",
    ],
    retaining: &[
        "CODESYS keeps the whole instance in retained memory, tables included: there must be room for it.",
    ],
};

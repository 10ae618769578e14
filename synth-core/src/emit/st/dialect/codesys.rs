//! CODESYS 3: one search for all tables, by pointer.

use super::Dialect;
use super::frame::Standard;
use super::words::CODESYS;
use crate::emit::st::layout::tables::{Pointers, TableLayout};

pub(super) static DIALECT: Dialect = Dialect {
    name: "codesys",
    words: &CODESYS,
    // A constant may have no address.
    layout: &TableLayout { search: &Pointers, section: "VAR" },
    frame: &Standard,
    notes: &[
        "CODESYS keeps each declaration as an object of its own. What CONFIGURATION says is set in the task configuration.",
    ],
};

//! TwinCAT 3: one search for all tables, by pointer.

use super::Dialect;
use super::frame::Standard;
use super::words::TWINCAT;
use crate::emit::st::layout::tables::{Pointers, TableLayout};

pub(super) static DIALECT: Dialect = Dialect {
    name: "twincat",
    words: &TWINCAT,
    // A constant may have no address.
    layout: &TableLayout { search: &Pointers, section: "VAR" },
    frame: &Standard,
    notes: &[
        "TwinCAT keeps each declaration as an object of its own. What CONFIGURATION says is set in the task's reference.",
    ],
};

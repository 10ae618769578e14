//! SCL as an external source of TIA Portal, for S7-1500 and S7-1200.

use super::frame::Scl;
use super::words::SCL;
use super::{Dialect, Transitions};
use crate::emit::st::layout::search::Inline;

pub(super) static DIALECT: Dialect = Dialect {
    name: "siemens",
    words: &SCL,
    // There are no constant arrays.
    transitions: Transitions::tables(&Inline, "VAR"),
    frame: &Scl,
    notes: &[
        "Add the file to the external source files of a project in TIA Portal, and generate blocks from it.",
        "The organization block runs in every cycle of the CPU; for a fixed one call the data block from a cyclic interrupt.",
    ],
    retaining: &[],
};

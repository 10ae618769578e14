//! IEC 61131-3, second edition, nothing else.

use super::Dialect;
use super::frame::Standard;
use super::words::EDITION2;
use crate::emit::st::layout::tables::{Inline, TableLayout};

pub(super) static DIALECT: Dialect = Dialect {
    name: "iec",
    words: &EDITION2,
    layout: &TableLayout { search: &Inline, section: "VAR CONSTANT" },
    frame: &Standard,
    notes: &[],
};

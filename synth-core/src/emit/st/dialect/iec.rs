//! IEC 61131-3, second edition, nothing else.

use super::frame::Standard;
use super::words::EDITION2;
use super::{Dialect, Transitions};
use crate::emit::st::layout::search::Inline;

pub(super) static DIALECT: Dialect = Dialect {
    name: "iec",
    words: &EDITION2,
    transitions: Transitions::tables(&Inline, "VAR CONSTANT"),
    frame: &Standard,
    notes: &[],
    retaining: &[],
};

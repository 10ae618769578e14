//! The second edition again, with the transitions as branches of `CASE` statements: the older machine, to compare with.

use super::frame::Standard;
use super::words::EDITION2;
use super::{Dialect, Transitions};

pub(super) static DIALECT: Dialect = Dialect {
    name: "case",
    words: &EDITION2,
    transitions: Transitions::Branches,
    frame: &Standard,
    notes: &[],
    retaining: &[],
};

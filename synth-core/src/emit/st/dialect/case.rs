//! The second edition again, with the transitions as branches of `CASE` statements: the older machine, to compare with.

use super::Dialect;
use super::frame::Standard;
use super::words::EDITION2;
use crate::emit::st::layout::case::CaseLayout;

pub(super) static DIALECT: Dialect =
    Dialect { name: "case", words: &EDITION2, layout: &CaseLayout, frame: &Standard, notes: &[] };

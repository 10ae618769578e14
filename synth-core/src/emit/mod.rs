//! Back ends: tables in, text out.

pub mod names;
pub mod rust;

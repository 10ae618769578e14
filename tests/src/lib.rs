//! What the tests of several stages share.

pub mod reference;
pub mod scratch;
pub mod tables;

//! What tests share: a naive reference implementation of the language, random specifications, and a reference
//! interpreter of tables.

pub mod beside;
pub mod corpus;
pub mod fast;
pub mod line;
pub mod naive;
pub mod published;
pub mod random;
pub mod reference;
pub mod same;
pub mod scratch;
pub mod survive;
pub mod tables;

//! What tests share: a naive reference implementation of the language, and random specifications.

pub mod corpus;
pub mod naive;
pub mod random;

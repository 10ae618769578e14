//! What tests share: a naive reference implementation of the language, and random specifications.

pub mod naive;
pub mod random;

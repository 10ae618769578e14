//! Boolean functions: minimised, factored, and as instructions of a stack of Booleans.
//!
//! Knows variables by number only; what they mean is said in [`crate::plant`].

mod expr;

pub use expr::{Expr, Literal, Var};

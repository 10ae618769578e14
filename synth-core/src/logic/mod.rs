//! Boolean functions: minimised, factored, and as instructions of a stack of Booleans.
//!
//! Knows variables by number only; what they mean is said in [`crate::plant`].
//!
//! ```text
//!  Function (bdd)   lower and upper bound: what lies between is a don't-care
//!    │ exact, heuristic   fewest terms, then fewest literals  → Cover
//!    │ factor             fewest instructions                 → Expr
//!    ▼ instructions       order of operands                   → Instruction
//! ```

mod bdd;
mod cover;
mod covering;
mod exact;
mod expr;
mod factor;
mod heuristic;
mod instructions;
mod limit;
#[cfg(test)]
mod testing;

pub use bdd::{Bdd, Function};
pub use cover::{Cover, Cube};
pub use exact::{Minimal, minimize};
pub use expr::{Expr, Literal, Var};
pub use factor::factor;
pub use instructions::{Algebra, Instruction, Words, count, depth, instructions, run, stack_depth};
pub use limit::TooLarge;

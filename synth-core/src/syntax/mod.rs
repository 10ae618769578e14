//! From text or macro tokens to a syntax tree: one grammar for both.

pub mod ast;
mod span;

pub use span::{FileId, Pos, Span};

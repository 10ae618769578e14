//! What can be wrong with a text, with a call, and with a name asked for.

use std::fmt;

/// A place in the text; lines and columns (in bytes) count from 1.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
pub(crate) struct Position {
    pub(crate) line: u32,
    pub(crate) column: u32,
}

/// What a compiler would refuse.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Error {
    /// From 1.
    pub line: u32,
    /// In bytes, from 1.
    pub column: u32,
    /// Lowercase, without a full stop.
    pub message: String,
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}", self.line, self.column, self.message)
    }
}

impl std::error::Error for Error {}

/// What stops a call: an index out of its range, a division by zero, a null pointer, too many statements.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct RuntimeError {
    /// From 1.
    pub line: u32,
    /// In bytes, from 1.
    pub column: u32,
    /// Lowercase, without a full stop.
    pub message: String,
}

impl fmt::Display for RuntimeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}", self.line, self.column, self.message)
    }
}

impl std::error::Error for RuntimeError {}

/// A name or value that an [`Instance`](crate::Instance) does not have or take.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct AccessError(pub String);

impl fmt::Display for AccessError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for AccessError {}

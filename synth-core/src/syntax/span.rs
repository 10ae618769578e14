//! Places in a specification.
//!
//! A place is a line and a column rather than a compiler span, so that it means the same for a file, for the
//! tokens of a macro and for JSON, and so that everything after the parser is `Send`.

/// A file of the specification: 0 is the one that was asked for, imported ones follow in order of import.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub struct FileId(pub u32);

/// A line and a column, both counted from 1; columns in characters.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub struct Pos {
    /// Line, from 1.
    pub line: u32,
    /// Column in characters, from 1.
    pub column: u32,
}

/// A piece of one file, from `start` up to, not including, `end`.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub struct Span {
    /// The file.
    pub file: FileId,
    /// First character.
    pub start: Pos,
    /// Just behind the last character.
    pub end: Pos,
}

impl Span {
    /// The smallest span that covers both; both must lie in one file.
    #[must_use]
    pub fn to(self, end: Span) -> Span {
        Span { file: self.file, start: self.start.min(end.start), end: self.end.max(end.end) }
    }
}

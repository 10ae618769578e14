//! The texts that places refer to.

use std::ops::Range;

use super::{FileId, Pos, Span, lexis::BYTE_ORDER_MARK};

/// Path and text of every file of a specification, by [`FileId`].
#[derive(Clone, Debug, Default)]
pub struct Sources {
    files: Vec<Source>,
}

#[derive(Clone, Debug)]
struct Source {
    path: String,
    text: String,
    /// Byte offset of the first character of each line.
    lines: Vec<usize>,
}

impl Sources {
    /// No files.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a file; ids count from 0 in order of addition. `path` is only shown. A byte order mark is dropped, as it
    /// takes part in no place.
    pub fn add(&mut self, path: impl Into<String>, text: impl Into<String>) -> FileId {
        let mut text = text.into();
        if text.starts_with(BYTE_ORDER_MARK) {
            text.drain(..BYTE_ORDER_MARK.len_utf8());
        }
        let mut lines = vec![0];
        lines.extend(text.match_indices('\n').map(|(at, _)| at + 1));
        self.files.push(Source { path: path.into(), text, lines });
        FileId(self.files.len() as u32 - 1)
    }

    /// Number of files; ids are below it.
    #[must_use]
    pub fn len(&self) -> usize {
        self.files.len()
    }

    /// Whether there is no file.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.files.is_empty()
    }

    /// The path of a file, as it was given; empty for a file that was never added.
    #[must_use]
    pub fn path(&self, file: FileId) -> &str {
        self.files.get(file.0 as usize).map_or("", |source| &source.path)
    }

    /// The text of a file, without a byte order mark; empty for a file that was never added.
    #[must_use]
    pub fn text(&self, file: FileId) -> &str {
        self.files.get(file.0 as usize).map_or("", |source| &source.text)
    }

    /// `path:line` of where a span begins.
    #[must_use]
    pub fn place(&self, span: Span) -> String {
        format!("{}:{}", self.path(span.file), span.start.line)
    }

    /// The bytes of [`Self::text`] that `span` covers; what lies beyond the end of a line or of the text is cut off.
    #[must_use]
    pub fn bytes(&self, span: Span) -> Range<usize> {
        let Some(source) = self.files.get(span.file.0 as usize) else { return 0..0 };
        let start = source.offset(span.start);
        start..source.offset(span.end).max(start)
    }
}

impl Source {
    fn offset(&self, pos: Pos) -> usize {
        let line = (pos.line as usize).saturating_sub(1);
        let Some(&start) = self.lines.get(line) else { return self.text.len() };
        let end = self.lines.get(line + 1).map_or(self.text.len(), |next| next - 1);
        let text = &self.text[start..end];
        let column = (pos.column as usize).saturating_sub(1);
        start + text.char_indices().nth(column).map_or(text.len(), |(at, _)| at)
    }
}

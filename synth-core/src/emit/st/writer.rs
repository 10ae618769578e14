//! Indented lines of Structured Text within a line limit.

use std::fmt::{Display, Write as _};

use super::dialect::Frame;

/// The longest line for readers, in characters.
pub(super) const LINE_LIMIT: usize = 120;

const INDENT: &str = "  ";

/// Collects a text line by line.
pub(super) struct Writer {
    out: String,
    depth: usize,
    marks_locals: bool,
    marks_bytes: bool,
    numbers_limit: usize,
}

impl Writer {
    /// For the text of a frame.
    pub(super) fn new(frame: &dyn Frame) -> Writer {
        Writer {
            out: String::new(),
            depth: 0,
            marks_locals: frame.marks_locals(),
            marks_bytes: frame.marks_bytes(),
            numbers_limit: frame.numbers_limit(),
        }
    }

    /// The text, after a byte order mark if the frame wants one.
    pub(super) fn finish(mut self) -> String {
        if self.marks_bytes && !self.out.is_ascii() {
            self.out.insert(0, '\u{feff}');
        }
        self.out
    }

    /// A line at the current depth.
    pub(super) fn line(&mut self, line: impl Display) {
        for _ in 0..self.depth {
            self.out.push_str(INDENT);
        }
        // Writing to a string cannot fail.
        let _ = writeln!(self.out, "{line}");
    }

    /// A line of a statement, in which every local name is marked `#`; only dialects that want it keep the mark.
    pub(super) fn code(&mut self, line: impl Display) {
        self.line(self.unmarked(line.to_string()));
    }

    /// A statement on one line, or on as many as its parts need, from the second on one step deeper.
    pub(super) fn code_in_parts(&mut self, parts: &[impl AsRef<str>]) {
        let mut line = String::new();
        let mut first = true;
        for part in parts {
            let part = self.unmarked(part.as_ref().to_owned());
            let depth = self.depth + usize::from(!first);
            if !line.is_empty() && depth * INDENT.len() + line.len() + 1 + part.len() > LINE_LIMIT {
                self.part(&line, first);
                line.clear();
                first = false;
            }
            if !line.is_empty() {
                line.push(' ');
            }
            line += &part;
        }
        self.part(&line, first);
    }

    fn part(&mut self, line: &str, first: bool) {
        if first { self.line(line) } else { self.indented(|out| out.line(line)) }
    }

    fn unmarked(&self, code: String) -> String {
        if self.marks_locals { code } else { code.replace('#', "") }
    }

    /// Statements under a condition.
    pub(super) fn when(&mut self, condition: impl Display, inside: impl FnOnce(&mut Writer)) {
        self.code(format_args!("IF {condition} THEN"));
        self.indented(inside);
        self.code("END_IF;");
    }

    /// Statements under several conditions.
    pub(super) fn when_all(&mut self, conditions: &[String], inside: impl FnOnce(&mut Writer)) {
        let mut parts: Vec<String> = conditions.iter().map(|condition| format!("AND {condition}")).collect();
        if let Some(first) = parts.first_mut() {
            first.replace_range(.."AND".len(), "IF");
        }
        if let Some(last) = parts.last_mut() {
            last.push_str(" THEN");
        }
        self.code_in_parts(&parts);
        self.indented(inside);
        self.code("END_IF;");
    }

    /// Statements until a condition holds.
    pub(super) fn repeat(&mut self, until: impl Display, inside: impl FnOnce(&mut Writer)) {
        self.code("REPEAT");
        self.indented(inside);
        self.code(format_args!("UNTIL {until}"));
        self.code("END_REPEAT;");
    }

    /// An empty line.
    pub(super) fn gap(&mut self) {
        self.out.push('\n');
    }

    /// `opening`, lines one step deeper, `closing`.
    pub(super) fn block(&mut self, opening: impl Display, closing: &str, inside: impl FnOnce(&mut Writer)) {
        self.line(opening);
        self.indented(inside);
        self.line(closing);
    }

    /// Lines one step deeper.
    pub(super) fn indented(&mut self, inside: impl FnOnce(&mut Writer)) {
        self.depth += 1;
        inside(self);
        self.depth -= 1;
    }

    /// A comment, in as many `(* … *)` lines as it needs.
    pub(super) fn comment(&mut self, text: &str) {
        let width = LINE_LIMIT - self.depth * INDENT.len() - "(*  *)".len();
        for line in wrapped(&harmless(text), width) {
            self.line(format_args!("(* {line} *)"));
        }
    }

    /// A line of a statement, as [`Writer::code`] has it, in a comment.
    pub(super) fn comment_code(&mut self, line: &str) {
        self.comment(&self.unmarked(line.to_owned()));
    }

    /// `opening [ … ];`, several numbers a line.
    pub(super) fn array(&mut self, opening: impl Display, values: &[u32]) {
        let last = values.len().saturating_sub(1);
        self.block(format_args!("{opening} ["), "];", |out| {
            let width = out.numbers_limit - out.depth * INDENT.len();
            let mut line = String::new();
            for (index, value) in values.iter().enumerate() {
                let comma = if index == last { "" } else { "," };
                let number = format!("{value}{comma}");
                if line.len() + number.len() > width {
                    out.line(&line);
                    line.clear();
                }
                line.push_str(&number);
            }
            out.line(&line);
        });
    }
}

/// A text that neither ends the comment it stands in nor opens another.
pub(super) fn harmless(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut before = ' ';
    for c in text.chars() {
        if (before, c) == ('(', '*') || (before, c) == ('*', ')') {
            out.push(' ');
        }
        let c = if c.is_control() { ' ' } else { c };
        out.push(c);
        before = c;
    }
    out
}

/// Breaks at spaces into lines of at most `width` characters (longer words are cut); one line at least. The
/// indentation of the text is that of all its lines.
fn wrapped(text: &str, width: usize) -> Vec<String> {
    let indent: String = text.chars().take_while(|c| *c == ' ').take(width / 2).collect();
    let mut lines = Vec::new();
    let mut line = indent.clone();
    let mut length = indent.len();
    for word in text.split_whitespace() {
        let mut word: Vec<char> = word.chars().collect();
        if length > indent.len() && length + 1 + word.len() > width {
            lines.push(std::mem::replace(&mut line, indent.clone()));
            length = indent.len();
        }
        while word.len() > width - indent.len() {
            let rest = word.split_off(width - indent.len());
            lines.push(indent.chars().chain(word).collect());
            word = rest;
        }
        if length > indent.len() {
            line.push(' ');
            length += 1;
        }
        length += word.len();
        line.extend(word);
    }
    lines.push(line);
    lines
}

#[cfg(test)]
mod tests {
    use super::super::Target;
    use super::*;

    #[track_caller]
    fn check(text: &str, width: usize, lines: &[&str]) {
        assert_eq!(wrapped(text, width), lines);
    }

    #[test]
    fn wraps_at_spaces_and_keeps_the_indentation() {
        check("one two three", 8, &["one two", "three"]);
        check("  one two", 6, &["  one", "  two"]);
        check("abcdefgh i", 3, &["abc", "def", "gh", "i"]);
        check("abcdef i", 3, &["abc", "def", "i"]);
        check("", 3, &[""]);
    }

    #[test]
    fn comments_cannot_be_left() {
        assert_eq!(harmless("a(*)b\n*)"), "a( * )b * )");
    }

    #[test]
    fn arrays_keep_the_line_limit() {
        let frame = Target::Siemens.dialect().frame;
        let mut writer = Writer::new(frame);
        let values: Vec<u32> = (10_000..10_060).collect();
        writer.array("x : ARRAY [0..59] OF UINT :=", &values);
        let text = writer.finish();
        assert!(text.lines().all(|line| line.len() <= frame.numbers_limit()));
        assert_eq!(text.lines().count(), 4);
        assert!(text.starts_with("x : ARRAY [0..59] OF UINT := [\n  10000,10001,"));
        assert!(text.ends_with(",10059\n];\n"));
    }
}

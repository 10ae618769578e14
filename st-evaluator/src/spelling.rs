//! Spellings of the dialects that the grammar does not know, replaced by ones that it knows, byte for byte.
//!
//! The grammar is that of the standard's third edition. What it lacks and controllers need is little, so that a scan
//! over the text, with comments and strings set apart, mends it. No byte moves: places in the text stay what they
//! are. Where the replacement loses something, the place is remembered.
//!
//! | Written | Dialect | Read as |
//! |---|---|---|
//! | `STRING[20]` | all | `STRING(20)`, which the third edition has; the second does not |
//! | `Colour#red` | all | `Colour.red` |
//! | `AND_THEN`, `OR_ELSE` | CODESYS, TwinCAT | `AND`, `OR`, marked |
//! | `PERSISTENT` | CODESYS, TwinCAT | `RETAIN` |
//! | `#local`, `"Name"` | SCL | the name alone, marked: it may be a reserved word |
//! | `BEGIN`, `REGION … END_REGION`, `VERSION : 0.1`, `TITLE = …`, `{ … }` | SCL | nothing |
//! | `TYPE "Name" … STRUCT` | SCL | `TYPE Name : STRUCT` |
//! | `ORGANIZATION_BLOCK` | SCL | `PROGRAM` |
//! | `DATA_BLOCK "Name" "Type" BEGIN END_DATA_BLOCK` | SCL | `VAR_GLOBAL Name : Type; END_VAR` |

use std::collections::BTreeSet;

use crate::dialect::Dialect;
use crate::error::{Error, Position};
use crate::kind::Kind;

/// The text as the grammar reads it.
#[derive(Debug)]
pub(crate) struct Spelled {
    pub(crate) text: String,
    /// Where `AND` was `AND_THEN`, and `OR` `OR_ELSE`.
    pub(crate) shortcuts: BTreeSet<usize>,
    /// Where `(` was `[` behind `STRING`.
    pub(crate) brackets: BTreeSet<usize>,
    /// Where `.` was `#`.
    pub(crate) hashes: BTreeSet<usize>,
    /// Where a name begins that SCL marks as one.
    pub(crate) quoted: BTreeSet<usize>,
    pub(crate) errors: Vec<Error>,
}

/// The place of a byte.
pub(crate) fn position(text: &str, offset: usize) -> Position {
    let before = &text.as_bytes()[..offset.min(text.len())];
    let line_start = before.iter().rposition(|&b| b == b'\n').map_or(0, |at| at + 1);
    let line = before.iter().filter(|&&b| b == b'\n').count() + 1;
    Position { line: line as u32, column: (before.len() - line_start + 1) as u32 }
}

pub(crate) fn spell(text: &str, dialect: Dialect) -> Spelled {
    let mut scan = Scan {
        source: text,
        out: text.as_bytes().to_vec(),
        at: 0,
        dialect,
        spelled: Spelled {
            text: String::new(),
            shortcuts: BTreeSet::new(),
            brackets: BTreeSet::new(),
            hashes: BTreeSet::new(),
            quoted: BTreeSet::new(),
            errors: Vec::new(),
        },
    };
    scan.run();
    let Scan { out, mut spelled, .. } = scan;
    // Only ASCII was replaced, and by ASCII.
    spelled.text = String::from_utf8_lossy(&out).into_owned();
    spelled
}

struct Scan<'a> {
    source: &'a str,
    out: Vec<u8>,
    at: usize,
    dialect: Dialect,
    spelled: Spelled,
}

fn is_word(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_'
}

impl Scan<'_> {
    fn run(&mut self) {
        while self.at < self.out.len() {
            let next = self.out.get(self.at + 1).copied().unwrap_or(0);
            match (self.out[self.at], next) {
                (b'(', b'*') => self.comment(),
                (b'/', b'/') => self.line_comment(),
                (b'\'', _) => self.at = self.end_of_string(b'\''),
                (b'"', _) if self.dialect == Dialect::Siemens => self.quoted_name(),
                (b'"', _) => self.at = self.end_of_string(b'"'),
                (b'{', _) => self.pragma(),
                (b'#', _) => self.hash(),
                (byte, _) if is_word(byte) => self.word(),
                _ => self.at += 1,
            }
        }
    }

    fn error(&mut self, offset: usize, message: impl Into<String>) {
        let Position { line, column } = position(self.source, offset);
        self.spelled.errors.push(Error { line, column, message: message.into() });
    }

    fn find(&self, what: &[u8], from: usize) -> Option<usize> {
        self.out[from.min(self.out.len())..].windows(what.len()).position(|w| w == what).map(|at| from + at)
    }

    fn blank(&mut self, from: usize, to: usize) {
        for byte in &mut self.out[from..to] {
            if !matches!(*byte, b'\n' | b'\r') {
                *byte = b' ';
            }
        }
    }

    /// Replaces a word by one that is not longer.
    fn replace(&mut self, from: usize, to: usize, by: &str) {
        self.blank(from, to);
        self.out[from..from + by.len()].copy_from_slice(by.as_bytes());
    }

    fn comment(&mut self) {
        let start = self.at;
        let Some(end) = self.find(b"*)", start + 2) else {
            self.error(start, "the comment has no end");
            self.at = self.out.len();
            return;
        };
        if let Some(inner) = self.find(b"(*", start + 2).filter(|&inner| inner < end) {
            // The standard forbids it, and the systems differ: some want an end for each.
            self.error(inner, "a comment within a comment");
        }
        self.at = end + 2;
    }

    fn line_comment(&mut self) {
        if self.dialect.is_strict() {
            self.error(self.at, "`//` comments are not in the second edition");
        }
        self.at = self.find(b"\n", self.at).unwrap_or(self.out.len());
    }

    fn end_of_string(&self, quote: u8) -> usize {
        let mut at = self.at + 1;
        while at < self.out.len() {
            match self.out[at] {
                b'$' => at += 2,
                byte if byte == quote => return at + 1,
                b'\n' => return at,
                _ => at += 1,
            }
        }
        self.out.len()
    }

    fn pragma(&mut self) {
        let end = self.find(b"}", self.at).map_or(self.out.len(), |end| end + 1);
        if self.dialect == Dialect::Siemens {
            self.blank(self.at, end);
        }
        self.at = end;
    }

    /// `"Name"`.
    fn quoted_name(&mut self) {
        let end = self.end_of_string(b'"');
        let closed = end - 1 > self.at && self.out[end - 1] == b'"';
        let name = &self.out[self.at + 1..(end - 1).max(self.at + 1)];
        if !closed || name.is_empty() || !name.iter().all(|&b| is_word(b)) || name[0].is_ascii_digit() {
            self.error(self.at, "a quoted name that is no identifier is not supported");
        }
        self.spelled.quoted.insert(self.at + 1);
        self.out[self.at] = b' ';
        self.out[end - 1] = b' ';
        self.at = end;
    }

    fn hash(&mut self) {
        let at = self.at;
        self.at += 1;
        let start = self.out[..at].iter().rposition(|&b| !is_word(b)).map_or(0, |before| before + 1);
        if start == at {
            if self.dialect == Dialect::Siemens {
                self.out[at] = b' ';
                self.spelled.quoted.insert(at + 1);
                // A name that looks like a keyword stays a name.
                while self.at < self.out.len() && is_word(self.out[self.at]) {
                    self.at += 1;
                }
            }
            return;
        }
        let prefix = self.source[start..at].to_ascii_uppercase();
        let letter_follows = self.out.get(at + 1).is_some_and(u8::is_ascii_alphabetic);
        let is_name = !prefix.as_bytes()[0].is_ascii_digit() && Kind::named(&prefix).is_none();
        if letter_follows && is_name {
            self.out[at] = b'.';
            self.spelled.hashes.insert(at);
        }
    }

    fn word(&mut self) {
        let start = self.at;
        while self.at < self.out.len() && is_word(self.out[self.at]) {
            self.at += 1;
        }
        let end = self.at;
        let capitals = self.source[start..end].to_ascii_uppercase();
        match capitals.as_str() {
            "AND_THEN" | "OR_ELSE" => {
                if !self.dialect.has_pointers() {
                    self.error(start, format!("`{capitals}` is no operator of this dialect"));
                }
                self.spelled.shortcuts.insert(start);
                self.replace(start, end, if capitals == "OR_ELSE" { "OR" } else { "AND" });
            }
            "STRING" | "WSTRING" => self.length_of_string(),
            "PERSISTENT" if self.dialect.is_codesys() => self.replace(start, end, "RETAIN"),
            _ if self.dialect == Dialect::Siemens => self.scl_word(&capitals, start, end),
            _ => {}
        }
    }

    fn length_of_string(&mut self) {
        let Some(open) = self.skip_spaces(self.at).filter(|&at| self.out[at] == b'[') else { return };
        let Some(close) = self.find(b"]", open) else { return };
        self.out[open] = b'(';
        self.out[close] = b')';
        self.spelled.brackets.insert(open);
        self.at = close + 1;
    }

    fn skip_spaces(&self, from: usize) -> Option<usize> {
        self.out[from..].iter().position(|b| !b.is_ascii_whitespace()).map(|at| from + at)
    }

    fn end_of_line(&self) -> usize {
        self.find(b"\n", self.at).unwrap_or(self.out.len())
    }

    fn scl_word(&mut self, capitals: &str, start: usize, end: usize) {
        match capitals {
            "BEGIN" | "END_REGION" => self.blank(start, end),
            "REGION" | "TITLE" | "VERSION" => {
                let line_end = self.end_of_line();
                self.blank(start, line_end);
                self.at = line_end;
            }
            "ORGANIZATION_BLOCK" => self.replace(start, end, "PROGRAM"),
            "END_ORGANIZATION_BLOCK" => self.replace(start, end, "END_PROGRAM"),
            "TYPE" => self.name_of_type(),
            "DATA_BLOCK" => self.data_block(start, end),
            _ => {}
        }
    }

    /// `TYPE "Name"` gets the colon that SCL leaves out.
    fn name_of_type(&mut self) {
        let Some(open) = self.skip_spaces(self.at).filter(|&at| self.out[at] == b'"') else { return };
        self.at = open;
        self.quoted_name();
        self.out[self.at - 1] = b':';
    }

    /// An instance of a function block: `DATA_BLOCK "Name" … "Type" BEGIN END_DATA_BLOCK`.
    fn data_block(&mut self, start: usize, end: usize) {
        let Some(block_end) = self.find(b"END_DATA_BLOCK", end) else {
            return self.error(start, "`DATA_BLOCK` has no `END_DATA_BLOCK`");
        };
        let names: Vec<usize> = (end..block_end).filter(|&at| self.out[at] == b'"').collect();
        let begin = self.find(b"BEGIN", end).filter(|&at| at < block_end);
        let (&[a, b, c, d], Some(begin)) = (names.as_slice(), begin) else {
            return self
                .error(start, "only a data block that is the instance of a function block is supported");
        };
        self.replace(start, end, "VAR_GLOBAL");
        self.blank(b + 1, c);
        self.blank(d + 1, block_end);
        for quote in [a, c, d] {
            self.out[quote] = b' ';
        }
        self.out[b] = b':';
        self.out[begin] = b';';
        self.replace(block_end, block_end + "END_DATA_BLOCK".len(), "END_VAR");
        self.spelled.quoted.extend([a + 1, c + 1]);
        self.at = block_end + "END_VAR".len();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(dialect: Dialect, text: &str, expected: &str) {
        let spelled = spell(text, dialect);
        assert_eq!(spelled.errors, []);
        assert_eq!(spelled.text, expected);
        assert_eq!(text.len(), expected.len());
    }

    #[test]
    fn nothing_else_changes() {
        let text = "(* STRING[3] E#x *) s := 'a$'#b STRING[2]'; x := 16#FF + INT#5; t := T#5s; { p }";
        check(Dialect::Edition2, text, text);
        check(Dialect::Codesys, text, text);
    }

    #[test]
    fn of_all_dialects() {
        check(Dialect::Edition2, "s : STRING [3]; c := Colour#red;", "s : STRING (3); c := Colour.red;");
    }

    #[test]
    fn of_codesys() {
        check(Dialect::TwinCat, "a AND_THEN b or_else c", "a AND      b OR      c");
        check(Dialect::Codesys, "VAR PERSISTENT RETAIN", "VAR RETAIN     RETAIN");
    }

    #[test]
    fn of_scl() {
        check(Dialect::Siemens, "#a := \"F\"(#b); {x}", " a :=  F ( b);    ");
        check(
            Dialect::Siemens,
            "VERSION : 0.1\nBEGIN\nREGION a\nEND_REGION",
            "             \n     \n        \n          ",
        );
        check(Dialect::Siemens, "TYPE \"T\"\nSTRUCT", "TYPE  T:\nSTRUCT");
        check(
            Dialect::Siemens,
            "DATA_BLOCK \"A\" \"B\" BEGIN END_DATA_BLOCK",
            "VAR_GLOBAL  A:  B  ;     END_VAR       ",
        );
    }

    #[test]
    fn refuses() {
        let count = |text, dialect| spell(text, dialect).errors.len();
        assert_eq!(count("// a", Dialect::Edition2), 1);
        assert_eq!(count("// a", Dialect::Codesys), 0);
        assert_eq!(count("(* a (* b *)", Dialect::Codesys), 1);
        assert_eq!(count("(* a", Dialect::Codesys), 1);
        assert_eq!(count("a AND_THEN b", Dialect::Siemens), 1);
        assert_eq!(count("x := \"a b\"", Dialect::Siemens), 1);
        assert_eq!(count("x := \"ab", Dialect::Siemens), 1);
        assert_eq!(count("x := \"ab\n", Dialect::Siemens), 1);
        assert_eq!(count("x := \"", Dialect::Siemens), 1);
    }
}

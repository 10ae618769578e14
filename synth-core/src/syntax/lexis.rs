//! The scan of a text before Rust's lexer sees it.
//!
//! Rust's lexer refuses a text as a whole and says little about the reason. This scan finds every character it
//! would refuse and every delimiter without a partner, and makes a text of the same shape without them: what is
//! wrong becomes blank, so that all places stay where they are and the rest can be parsed for further mistakes.

use super::{FileId, MAX_DEPTH, Pos, Span, keywords};
use crate::diagnostic::{Code, Diagnostic};

/// Some editors put it at the start of a file; it belongs to no line.
pub(super) const BYTE_ORDER_MARK: char = '\u{feff}';

/// With so many errors a text is none of a specification, and nobody reads more.
const MOST_ERRORS: usize = 1000;

/// What the scan found.
pub(super) struct Scan {
    /// A text with the same lines and columns that Rust's lexer accepts; `None` if it must not be read at all.
    pub(super) readable: Option<String>,
    /// The last character that is not space or comment, or the start of the text.
    pub(super) end: Option<Span>,
    /// From here on the structure of `readable` is a guess.
    pub(super) cut: Option<Pos>,
    /// The first wrong delimiter is one that closes nothing.
    pub(super) surplus: bool,
    /// The tokens just behind something that became blank: what is missing before them is no news.
    pub(super) behind_blanks: Vec<Pos>,
    /// In the order of their places, mostly.
    pub(super) errors: Vec<Diagnostic>,
}

/// Scans `text`.
pub(super) fn scan(text: &str, file: FileId) -> Scan {
    let chars: Vec<char> = text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text).chars().collect();
    let mut lines = vec![0];
    lines.extend(chars.iter().enumerate().filter(|(_, c)| **c == '\n').map(|(i, _)| i + 1));
    let mut scanner = Scanner {
        readable: chars.clone(),
        chars,
        lines,
        file,
        at: 0,
        end: None,
        open: Vec::new(),
        suspect: None,
        cut: None,
        surplus: false,
        too_deep: false,
        after_blank: false,
        behind_blanks: Vec::new(),
        errors: Vec::new(),
    };
    while scanner.at < scanner.chars.len() && !scanner.gives_up() {
        scanner.token();
    }
    scanner.close_all();
    let end = scanner.end.map_or(0..0, |last| last + 1..last + 1);
    Scan {
        end: Some(scanner.span(end.start, end.end)),
        readable: (!scanner.gives_up()).then(|| scanner.readable.iter().collect()),
        cut: scanner.cut,
        surplus: scanner.surplus,
        behind_blanks: scanner.behind_blanks,
        errors: scanner.errors,
    }
}

struct Scanner {
    chars: Vec<char>,
    readable: Vec<char>,
    /// Index of the first character of each line.
    lines: Vec<usize>,
    file: FileId,
    /// Index of the next character.
    at: usize,
    /// Index of the last character of a token.
    end: Option<usize>,
    /// Indices of the opening delimiters whose partner has not come yet.
    open: Vec<usize>,
    /// The first opening delimiter whose partner is indented less than it.
    suspect: Option<usize>,
    cut: Option<Pos>,
    surplus: bool,
    too_deep: bool,
    /// Whether an error was found since the last token.
    after_blank: bool,
    behind_blanks: Vec<Pos>,
    errors: Vec<Diagnostic>,
}

impl Scanner {
    fn peek(&self, ahead: usize) -> char {
        self.chars.get(self.at + ahead).copied().unwrap_or('\0')
    }

    fn pos(&self, index: usize) -> Pos {
        let line = self.lines.partition_point(|&start| start <= index) - 1;
        Pos { line: line as u32 + 1, column: (index - self.lines[line]) as u32 + 1 }
    }

    fn span(&self, start: usize, end: usize) -> Span {
        Span { file: self.file, start: self.pos(start), end: self.pos(end) }
    }

    fn blank(&mut self, start: usize, end: usize) {
        for c in &mut self.readable[start..end] {
            if *c != '\n' {
                *c = ' ';
            }
        }
    }

    fn cut(&mut self, index: usize) {
        let pos = self.pos(index);
        self.cut = Some(self.cut.map_or(pos, |cut| cut.min(pos)));
    }

    /// Advances while `pred` holds; returns where it stops.
    fn skip_while(&mut self, pred: impl Fn(char) -> bool) -> usize {
        while self.at < self.chars.len() && pred(self.chars[self.at]) {
            self.at += 1;
        }
        self.at
    }

    fn token(&mut self) {
        let (start, known) = (self.at, self.errors.len());
        match self.chars[start] {
            '\r' => {
                // A return inside a line is legal in Rust only outside documentation comments.
                if self.peek(1) != '\n' {
                    self.readable[start] = ' ';
                }
                self.at += 1;
                return;
            }
            c if c.is_whitespace() || matches!(c, '\u{200e}' | '\u{200f}') => {
                self.at += 1;
                return;
            }
            '/' if self.peek(1) == '/' => return self.line_comment(),
            '/' if self.peek(1) == '*' => return self.block_comment(),
            '"' => self.string(),
            '\'' => self.single_quote(),
            '{' | '[' | '(' => self.opening(),
            '}' | ']' | ')' => self.closing(),
            c if c.is_ascii_digit() => self.number(),
            c if is_word(c) => self.word(),
            '#' if !matches!(self.peek(1), '[' | '!') => self.hash_comment(),
            c if c.is_ascii_graphic() && !matches!(c, '\\' | '`') => self.at += 1,
            c => self.stray(c),
        }
        self.end = Some(self.at - 1);
        if std::mem::replace(&mut self.after_blank, self.errors.len() > known) {
            self.behind_blanks.push(self.pos(start));
        }
    }

    /// Documentation comments stay: requirement texts are among them.
    fn line_comment(&mut self) {
        let start = self.at;
        let end = self.skip_while(|c| c != '\n');
        if self.chars[start..end].starts_with(&['/', '/', '/']) && self.chars.get(start + 3) != Some(&'/') {
            for c in &mut self.readable[start..end] {
                if *c == '\r' {
                    *c = ' ';
                }
            }
        } else {
            self.blank(start, end);
        }
    }

    fn block_comment(&mut self) {
        let start = self.at;
        let mut depth = 0;
        while self.at < self.chars.len() {
            match (self.peek(0), self.peek(1)) {
                ('/', '*') => depth += 1,
                ('*', '/') => depth -= 1,
                _ => {
                    self.at += 1;
                    continue;
                }
            }
            self.at += 2;
            if depth == 0 {
                return self.blank(start, self.at);
            }
        }
        self.at = self.chars.len();
        self.blank(start, self.at);
        let error =
            Diagnostic::error(Code::Unterminated, self.span(start, start + 2), "unclosed block comment")
                .label(format!("{depth} `*/` missing"));
        self.errors.push(error.help("close the comment with `*/`; block comments nest"));
        self.cut(start);
    }

    fn string(&mut self) {
        let start = self.at;
        self.at += 1;
        loop {
            match self.peek(0) {
                '"' => {
                    self.at += 1;
                    return;
                }
                '\\' if matches!(self.peek(1), '\\' | '"' | '\'' | 'n' | 'r' | 't' | '0') => self.at += 2,
                '\\' if !matches!(self.peek(1), '\n' | '\r' | '\0') => self.unknown_escape(),
                '\n' => break,
                _ if self.at >= self.chars.len() => break,
                '\r' | '\\' => {
                    self.readable[self.at] = ' ';
                    self.at += 1;
                }
                _ => self.at += 1,
            }
        }
        self.blank(start, self.at);
        let error = Diagnostic::error(Code::Unterminated, self.span(start, start + 1), "unclosed quote");
        self.errors.push(error.help("close the string with `\"` on the same line"));
        self.cut(start);
    }

    fn unknown_escape(&mut self) {
        let (start, escaped) = (self.at, self.peek(1));
        self.at += 2;
        self.blank(start, self.at);
        let span = self.span(start, self.at);
        let shown = show(escaped);
        let error = Diagnostic::error(Code::Lexical, span, format!("unknown escape `\\{shown}` in a string"));
        self.errors.push(error.help("write `/` between the parts of a path, or `\\\\` for a backslash"));
    }

    /// Rust has characters and lifetimes; SML has neither.
    fn single_quote(&mut self) {
        let start = self.at;
        self.at += 1;
        self.skip_while(is_word);
        self.blank(start, start + 1);
        if self.peek(0) == '\'' {
            self.blank(self.at, self.at + 1);
            self.at += 1;
        }
        let error = Diagnostic::error(Code::Lexical, self.span(start, self.at), "stray character `'`");
        self.errors.push(error.help("remove the quotes: names and enum literals stand alone"));
    }

    fn number(&mut self) {
        let start = self.at;
        self.skip_while(is_word);
        let next = self.peek(1);
        if self.peek(0) == '.' && (next.is_ascii_digit() || next != '.' && !is_word(next)) {
            self.at += 1;
            self.skip_while(is_word);
        }
        let text: String = self.chars[start..self.at].iter().collect();
        if let Some(error) = keywords::number_error(&text, self.span(start, self.at)) {
            self.errors.push(error);
            self.readable[start..self.at].fill('0');
        }
    }

    fn word(&mut self) {
        let start = self.at;
        self.skip_while(is_word);
        let text: String = self.chars[start..self.at].iter().collect();
        if self.is_raw_prefix(&text) {
            self.skip_while(|c| c == '#');
            self.blank(start, self.at);
            let error =
                Diagnostic::error(Code::Lexical, self.span(start, self.at), "raw text does not exist here");
            self.errors.push(error.help(format!("remove `{text}`")));
            if self.peek(0) == '"' {
                self.string();
                let behind = self.at;
                self.skip_while(|c| c == '#');
                self.blank(behind, self.at);
            }
        } else if !text.is_ascii() {
            self.errors.extend(keywords::name_error(&text, self.span(start, self.at)));
            self.readable[start..self.at].fill('x');
        }
    }

    fn is_raw_prefix(&self, text: &str) -> bool {
        match self.peek(0) {
            '"' => matches!(text, "r" | "b" | "c" | "br" | "cr"),
            '#' => matches!(text, "r" | "br" | "cr"),
            _ => false,
        }
    }

    fn stray(&mut self, c: char) {
        let start = self.at;
        self.skip_while(|next| next == c);
        self.blank(start, self.at);
        let message =
            if c == '`' { "stray backtick".into() } else { format!("stray character `{}`", show(c)) };
        let mut error = Diagnostic::error(Code::Lexical, self.span(start, self.at), message);
        error.help = Some(meant(c).map_or("remove it".to_owned(), |meant| format!("write `{meant}`")));
        self.errors.push(error);
    }

    /// Whoever begins a comment with `#` means the whole line.
    fn hash_comment(&mut self) {
        let start = self.at;
        let end = self.skip_while(|c| c != '\n');
        self.blank(start, end);
        let error = Diagnostic::error(Code::Lexical, self.span(start, start + 1), "stray character `#`");
        self.errors.push(error.help("begin a comment with `//`"));
    }

    /// Whether the rest of the text would say nothing new.
    fn gives_up(&self) -> bool {
        self.too_deep || self.errors.len() >= MOST_ERRORS
    }

    fn opening(&mut self) {
        let start = self.at;
        self.at += 1;
        self.open.push(start);
        if self.open.len() > MAX_DEPTH {
            self.too_deep = true;
            self.errors.push(too_deep(self.span(start, start + 1)));
        }
    }

    fn closing(&mut self) {
        let at = self.at;
        self.at += 1;
        let partner = opposite(self.chars[at]);
        match self.open.iter().rposition(|&open| self.chars[open] == partner) {
            Some(depth) if depth + 1 == self.open.len() => {
                let open = self.open[depth];
                self.open.truncate(depth);
                self.compare_indentation(open, at);
            }
            Some(depth) => {
                let unclosed = self.open[self.open.len() - 1];
                let text = format!("`{}` stands here before it is closed", self.chars[at]);
                self.delimiter_error(unclosed, self.unclosed(unclosed).also(self.span(at, at + 1), text));
                for open in self.open.drain(depth..).skip(1) {
                    self.readable[open] = ' ';
                }
            }
            None => {
                self.wrong_closing(at);
                self.readable[at] = ' ';
            }
        }
    }

    fn wrong_closing(&mut self, at: usize) {
        let found = self.chars[at];
        let span = self.span(at, at + 1);
        self.surplus |= self.open.is_empty() && self.cut.is_none();
        let error = match self.open.last() {
            None => Diagnostic::error(Code::Delimiter, span, format!("`{found}` closes nothing"))
                .help(format!("remove it, or add the missing `{}` before it", opposite(found))),
            Some(&open) => {
                let (opening, due) = (self.chars[open], opposite(self.chars[open]));
                Diagnostic::error(Code::Delimiter, span, format!("expected `{due}`, found `{found}`"))
                    .also(self.span(open, open + 1), format!("this `{opening}` is to be closed first"))
            }
        };
        self.delimiter_error(at, error);
    }

    fn close_all(&mut self) {
        if let Some(&innermost) = self.open.last().filter(|_| !self.gives_up()) {
            let place = self.suspect.unwrap_or(innermost);
            let mut error = self.unclosed(place);
            if place != innermost {
                let text = "this one has no partner either way, but the indentation points to the other";
                error = error.also(self.span(innermost, innermost + 1), text);
            }
            self.delimiter_error(self.suspect.unwrap_or(self.chars.len()), error);
        }
        while let Some(open) = self.open.pop() {
            self.readable.push(opposite(self.chars[open]));
        }
    }

    fn unclosed(&self, open: usize) -> Diagnostic {
        let (opening, due) = (self.chars[open], opposite(self.chars[open]));
        Diagnostic::error(Code::Delimiter, self.span(open, open + 1), format!("unclosed `{opening}`"))
            .help(format!("add the missing `{due}`"))
    }

    /// Only the first: the others mostly follow from it.
    fn delimiter_error(&mut self, index: usize, error: Diagnostic) {
        if self.cut.is_none() {
            self.errors.push(error);
        }
        self.cut(index);
    }

    fn compare_indentation(&mut self, open: usize, close: usize) {
        let (opening, closing) = (self.indentation(open), self.indentation(close));
        if opening.1 < closing.1 && opening.0 > closing.0 && closing.2 == close {
            self.suspect.get_or_insert(open);
        }
    }

    /// Of the line of `index`: the width of the indentation, the number, the index of the first token.
    fn indentation(&self, index: usize) -> (usize, usize, usize) {
        let line = self.lines.partition_point(|&start| start <= index) - 1;
        let start = self.lines[line];
        let width = self.chars[start..].iter().take_while(|c| matches!(c, ' ' | '\t')).count();
        (width, line, start + width)
    }
}

/// What an editor or a hand accustomed to mathematics writes for these tokens.
fn meant(c: char) -> Option<&'static str> {
    Some(match c {
        '→' | '⟶' | '➔' | '➜' => "->",
        '⇒' | '⟹' => "=>",
        '≤' | '⩽' => "<=",
        '≥' | '⩾' => ">=",
        '≠' => "!=",
        '∧' => "&&",
        '∨' => "||",
        '¬' => "!",
        '×' | '·' | '⋅' => "*",
        '–' | '—' | '−' | '‐' | '‑' => "-",
        '…' => "..=",
        '“' | '”' | '„' | '«' | '»' => "\"",
        '；' => ";",
        '，' => ",",
        '：' => ":",
        _ => return None,
    })
}

/// The error at the first delimiter or operator that is too deep.
pub(super) fn too_deep(span: Span) -> Diagnostic {
    Diagnostic::error(Code::TooDeep, span, "nesting too deep")
        .note(format!("at most {MAX_DEPTH} levels are read"))
}

fn is_word(c: char) -> bool {
    c == '_' || c.is_alphanumeric()
}

fn opposite(delimiter: char) -> char {
    match delimiter {
        '{' => '}',
        '[' => ']',
        '(' => ')',
        '}' => '{',
        ']' => '[',
        _ => '(',
    }
}

/// Invisible characters by their number.
fn show(c: char) -> String {
    let visible = c.is_alphanumeric() || !c.escape_debug().to_string().starts_with("\\u") && !c.is_control();
    if visible { c.to_string() } else { format!("U+{:04X}", c as u32) }
}

//! From text or macro tokens to a syntax tree: one grammar for both.
//!
//! Text goes through `lexis` first, a scan that finds all that Rust's lexer would refuse and that makes the rest
//! of the text readable nevertheless; then both go through `tokens`, which strips documentation comments, and
//! `parse`, the grammar itself. A pass returns what it could read *and* its diagnostics.

pub mod ast;
mod keywords;
mod lexis;
mod load;
pub(crate) mod parse;
mod print;
mod sources;
mod span;
pub(crate) mod tokens;

use std::borrow::Cow;
use std::io::{self, Read as _};

use proc_macro2::TokenStream;

use crate::diagnostic::{Code, Diagnostic};

use parse::Parsed;
use tokens::Keeps;

pub use keywords::RESERVED;
pub use load::{Loaded, Reader, load, load_imports};
pub use print::print;
pub use sources::Sources;
pub use span::{FileId, Pos, Span};

/// How deep delimiters and expressions may nest: far more than anyone writes, far less than a stack holds.
const MAX_DEPTH: usize = 128;

/// What is particular to one of the languages that share the lexis.
pub(crate) struct Grammar<T> {
    /// Which documentation comments are part of the tree.
    pub(crate) keeps: Keeps,
    /// The grammar itself: of tokens, and the place behind the last of them.
    pub(crate) parse: fn(TokenStream, FileId, Span) -> Parsed<T>,
}

/// Specifications.
const SML: Grammar<ast::File> = Grammar { keeps: tokens::opens_scenario, parse: parse::parse };

/// Reads the text of a file.
///
/// The tree holds all that could be read; it is complete if there is no diagnostic, and `None` if not even the
/// specification's name could be found. Diagnostics come in the order of their places. A byte order mark is skipped.
#[must_use]
pub fn parse_text(text: &str, file: FileId) -> (Option<ast::File>, Vec<Diagnostic>) {
    let Read { mut tree, errors, hidden } = read_text(text, file, &SML);
    if let Some(tree) = &mut tree {
        tree.declares_all &= !hidden;
    }
    (tree, errors)
}

/// Reads the tokens of a macro; places are those of the tokens in the file that invokes it.
///
/// Returns the same as [`parse_text`].
#[must_use]
pub fn parse_tokens(tokens: TokenStream, file: FileId) -> (Option<ast::File>, Vec<Diagnostic>) {
    let Parsed { tree, errors, .. } = read_tokens(tokens, file, None, &SML);
    (tree, errors)
}

/// What was read of a text.
pub(crate) struct Read<T> {
    /// Complete if there are no errors.
    pub(crate) tree: Option<T>,
    /// In the order of their places.
    pub(crate) errors: Vec<Diagnostic>,
    /// Something was wrong before the grammar saw the text, and may have cost any part of it.
    pub(crate) hidden: bool,
}

/// Reads a text by `grammar`.
pub(crate) fn read_text<T>(text: &str, file: FileId, grammar: &Grammar<T>) -> Read<T> {
    let lexis::Scan { readable, end, cut, surplus, behind_blanks, mut errors } = lexis::scan(text, file);
    let Some(readable) = readable else { return Read { tree: None, errors, hidden: true } };
    let lexed = tokens::lex(&readable, file, |tokens| read_tokens(tokens, file, end, grammar));
    let Parsed { tree, errors: mut found, unbraced } = match lexed {
        Ok(parsed) => parsed,
        Err(error) => Parsed { tree: None, errors: vec![*error], unbraced: None },
    };
    // A stray character is as good as a space; whatever else is wrong may hide anything.
    let hidden = errors.iter().any(|d| d.code != Code::Lexical);
    if surplus && let Some(place) = unbraced.filter(|&place| cut.is_none_or(|cut| place < cut)) {
        // The grammar knows better where braces went wrong than whoever counts them.
        found.retain(|d| d.span.start <= place);
        errors.retain(|d| d.code != Code::Delimiter);
    }
    // What follows from a mistake that has been reported already is not reported again.
    found.retain(|d| cut.is_none_or(|cut| d.span.start < cut));
    if !errors.is_empty() {
        let lines: Vec<u32> = errors.iter().map(|d| d.span.start.line).collect();
        found.retain(|d| match d.code {
            Code::Syntax => !lines.contains(&d.span.start.line) && !behind_blanks.contains(&d.span.start),
            code => code != Code::Empty,
        });
    }
    errors.append(&mut found);
    errors.sort_by_key(|d| d.span.start);
    Read { tree, errors, hidden }
}

/// Reads tokens by `grammar`; `end`: the place behind the last one, if the caller knows better than the tokens.
pub(crate) fn read_tokens<T>(
    tokens: TokenStream,
    file: FileId,
    end: Option<Span>,
    grammar: &Grammar<T>,
) -> Parsed<T> {
    match tokens::prepare(tokens, file, grammar.keeps) {
        Ok(prepared) => {
            let mut parsed = (grammar.parse)(prepared.tokens, file, end.unwrap_or(prepared.end));
            parsed.errors.sort_by_key(|d| d.span.start);
            parsed
        }
        Err(error) => Parsed { tree: None, errors: vec![*error], unbraced: None },
    }
}

/// The text of a file of `bytes`.
///
/// # Errors
///
/// [`Code::Encoding`] at the first place that is not UTF-8.
pub fn decode(bytes: &[u8], file: FileId) -> Result<&str, Box<Diagnostic>> {
    if is_utf16(bytes) {
        let first = Pos { line: 1, column: 1 };
        let span = Span { file, start: first, end: first };
        let error = Diagnostic::error(Code::Encoding, span, "the file is UTF-16 text, not UTF-8");
        return Err(Box::new(error.help("store the file as UTF-8")));
    }
    std::str::from_utf8(bytes).map_err(|error| {
        let good = std::str::from_utf8(&bytes[..error.valid_up_to()]).unwrap_or_default();
        let good = good.strip_prefix(lexis::BYTE_ORDER_MARK).unwrap_or(good);
        let line = good.matches('\n').count() as u32 + 1;
        let column = good.rsplit('\n').next().unwrap_or_default().chars().count() as u32 + 1;
        let span = Span { file, start: Pos { line, column }, end: Pos { line, column: column + 1 } };
        let error = Diagnostic::error(Code::Encoding, span, "the file is not UTF-8 text")
            .note(format!("the byte 0x{:02X} begins no character", bytes[error.valid_up_to()]));
        Box::new(error.help("store the file as UTF-8"))
    })
}

/// A file of `bytes` as it is shown below messages, whether or not it can be decoded.
#[must_use]
pub fn shown(bytes: &[u8]) -> Cow<'_, str> {
    // Of two bytes a character there is nothing to show.
    if is_utf16(bytes) { "".into() } else { String::from_utf8_lossy(bytes) }
}

/// Whether a byte order mark of UTF-16 begins the text, or every second byte of its beginning is zero, as in ASCII.
fn is_utf16(bytes: &[u8]) -> bool {
    let head = &bytes[..bytes.len().min(64) & !1];
    let zeros = |odd: usize| head.iter().skip(odd).step_by(2).all(|&byte| byte == 0);
    bytes.starts_with(&[0xFF, 0xFE])
        || bytes.starts_with(&[0xFE, 0xFF])
        || !head.is_empty() && zeros(0) != zeros(1)
}

/// A specification or a plant may have this many bytes, 16 MiB: far more than anyone writes, far less than a machine holds.
pub const MAX_BYTES: u64 = 16 << 20;

/// All bytes of a file that is a specification or a plant.
///
/// # Errors
///
/// As the reader says, or that there are more than [`MAX_BYTES`]: a device, or the wrong file.
pub fn read_bounded(file: impl io::Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    file.take(MAX_BYTES + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > MAX_BYTES {
        let why = format!(
            "it is larger than {} MiB, so it is neither a specification nor a plant",
            MAX_BYTES >> 20
        );
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, why));
    }
    Ok(bytes)
}

#[cfg(test)]
pub(crate) mod tests;

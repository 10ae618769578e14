//! From text or macro tokens to a syntax tree: one grammar for both.
//!
//! Text goes through `lexis` first, a scan that finds all that Rust's lexer would refuse and that makes the rest
//! of the text readable nevertheless; then both go through `tokens`, which strips documentation comments, and
//! `parse`, the grammar itself. A pass returns what it could read *and* its diagnostics.

pub mod ast;
mod keywords;
mod lexis;
mod load;
mod parse;
mod print;
mod sources;
mod span;
mod tokens;

use proc_macro2::TokenStream;

use crate::diagnostic::{Code, Diagnostic};

pub use load::{Loaded, Reader, load, load_imports};
pub use print::print;
pub use sources::Sources;
pub use span::{FileId, Pos, Span};

/// How deep delimiters and expressions may nest: far more than anyone writes, far less than a stack holds.
const MAX_DEPTH: usize = 128;

/// Reads the text of a file.
///
/// The tree holds all that could be read; it is complete if there is no diagnostic, and `None` if not even the
/// specification's name could be found. Diagnostics come in the order of their places. A byte order mark is skipped.
#[must_use]
pub fn parse_text(text: &str, file: FileId) -> (Option<ast::File>, Vec<Diagnostic>) {
    let lexis::Scan { readable, end, cut, behind_blanks, mut errors } = lexis::scan(text, file);
    let Some(readable) = readable else { return (None, errors) };
    let lexed = tokens::lex(&readable, file, |tokens| parse_stream(tokens, file, end));
    let (tree, mut found) = match lexed {
        Ok(parsed) => parsed,
        Err(error) => (None, vec![*error]),
    };
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
    (tree, errors)
}

/// Reads the tokens of a macro; places are those of the tokens in the file that invokes it.
///
/// Returns the same as [`parse_text`].
#[must_use]
pub fn parse_tokens(tokens: TokenStream, file: FileId) -> (Option<ast::File>, Vec<Diagnostic>) {
    parse_stream(tokens, file, None)
}

/// `end`: the place behind the last token, if the caller knows better than the tokens.
fn parse_stream(
    tokens: TokenStream,
    file: FileId,
    end: Option<Span>,
) -> (Option<ast::File>, Vec<Diagnostic>) {
    match tokens::prepare(tokens, file) {
        Ok(prepared) => {
            let (tree, mut errors) = parse::parse(prepared.tokens, file, end.unwrap_or(prepared.end));
            errors.sort_by_key(|d| d.span.start);
            (tree, errors)
        }
        Err(error) => (None, vec![*error]),
    }
}

/// The text of a file of `bytes`.
///
/// # Errors
///
/// [`Code::Encoding`] at the first place that is not UTF-8.
pub fn decode(bytes: &[u8], file: FileId) -> Result<&str, Box<Diagnostic>> {
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

#[cfg(test)]
mod tests;

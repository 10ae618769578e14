//! Between Rust's lexer and the grammar: places, documentation comments, invisible groups.

use std::str::FromStr;

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree, fallback};

use super::{FileId, MAX_DEPTH, Pos, Span, lexis::too_deep};
use crate::diagnostic::{Code, Diagnostic};

/// The place of a token.
pub(super) fn place(span: proc_macro2::Span, file: FileId) -> Span {
    let pos = |at: proc_macro2::LineColumn| Pos { line: at.line as u32, column: at.column as u32 + 1 };
    let (start, end) = (pos(span.start()), pos(span.end()));
    Span { file, start, end: end.max(start) }
}

/// Lexes `text` and gives the tokens to `read`; they must not leave it.
///
/// Inside a procedural macro the compiler would lex, and all its tokens would stand at the macro's call. So the lexer
/// of proc-macro2 itself is forced for as long as `read` runs: its tokens know their place in `text`, and the two
/// kinds of token never meet. (`force` and `unforce` are public, though not in the documentation.) A thread may lex
/// any number of texts: each token counts its lines from the start of its own.
pub(super) fn lex<T>(
    text: &str,
    file: FileId,
    read: impl FnOnce(TokenStream) -> T,
) -> Result<T, Box<Diagnostic>> {
    struct Forced;
    impl Drop for Forced {
        fn drop(&mut self) {
            fallback::unforce();
        }
    }
    fallback::force();
    let _forced = Forced;
    match TokenStream::from_str(text) {
        Ok(tokens) => Ok(read(tokens)),
        Err(error) => {
            let span = place(error.span(), file);
            Err(Box::new(Diagnostic::error(Code::Lexical, span, "this is not a token")))
        }
    }
}

/// Tokens ready for the grammar.
pub(super) struct Prepared {
    pub(super) tokens: TokenStream,
    /// The place behind the last token.
    pub(super) end: Span,
}

/// Whether a documentation comment between a token and others is part of the tree.
pub(crate) type Keeps = fn(Option<&TokenTree>, &[TokenTree]) -> bool;

/// Removes documentation comments, except those that the language keeps, and invisible groups.
///
/// # Errors
///
/// [`Code::TooDeep`].
pub(super) fn prepare(tokens: TokenStream, file: FileId, keeps: Keeps) -> Result<Prepared, Box<Diagnostic>> {
    let mut out = Vec::new();
    strip(tokens, file, keeps, 0, &mut out)?;
    let end = out.last().map_or_else(
        || Span { file, start: Pos { line: 1, column: 1 }, end: Pos { line: 1, column: 1 } },
        |last: &TokenTree| {
            let end = place(last.span(), file).end;
            Span { file, start: end, end }
        },
    );
    Ok(Prepared { tokens: out.into_iter().collect(), end })
}

fn strip(
    tokens: TokenStream,
    file: FileId,
    keeps: Keeps,
    depth: usize,
    out: &mut Vec<TokenTree>,
) -> Result<(), Box<Diagnostic>> {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    let mut at = 0;
    while at < trees.len() {
        let comments = at;
        while let Some(length) = comment_length(&trees[at..]) {
            at += length;
        }
        if at > comments && keeps(comments.checked_sub(1).map(|before| &trees[before]), &trees[at..]) {
            keep_lines(&trees[comments..at], file, out);
        }
        match trees.get(at) {
            Some(TokenTree::Group(group)) => {
                if depth >= MAX_DEPTH {
                    return Err(Box::new(too_deep(place(group.span_open(), file))));
                }
                if group.delimiter() == Delimiter::None {
                    strip(group.stream(), file, keeps, depth + 1, out)?;
                } else {
                    let mut inner = Vec::new();
                    strip(group.stream(), file, keeps, depth + 1, &mut inner)?;
                    let mut stripped = Group::new(group.delimiter(), inner.into_iter().collect());
                    stripped.set_span(group.span());
                    out.push(TokenTree::Group(stripped));
                }
            }
            Some(token) => out.push(token.clone()),
            None => {}
        }
        at += 1;
    }
    Ok(())
}

/// The number of tokens of the documentation comment at the start of `trees`: `#[doc = "…"]` or `#![doc = "…"]`.
fn comment_length(trees: &[TokenTree]) -> Option<usize> {
    let TokenTree::Punct(hash) = trees.first()? else { return None };
    let inner = matches!(trees.get(1)?, TokenTree::Punct(bang) if bang.as_char() == '!');
    let length = 2 + usize::from(inner);
    let TokenTree::Group(group) = trees.get(length - 1)? else { return None };
    let is_doc = hash.as_char() == '#'
        && group.delimiter() == Delimiter::Bracket
        && matches!(group.stream().into_iter().next(), Some(TokenTree::Ident(word)) if word == "doc");
    is_doc.then_some(length)
}

/// Requirement texts stand directly above a scenario.
pub(super) fn opens_scenario(_before: Option<&TokenTree>, trees: &[TokenTree]) -> bool {
    const KINDS: [&str; 5] = ["assumption", "guarantee", "existential", "specification", "requirement"];
    matches!(trees, [TokenTree::Ident(kind), TokenTree::Ident(word), ..]
        if word == "scenario" && KINDS.iter().any(|k| kind == k))
}

/// Of the comments, those that were written as lines: block comments are two characters longer than their text and
/// the three that open a line.
fn keep_lines(comments: &[TokenTree], file: FileId, out: &mut Vec<TokenTree>) {
    let mut rest = comments;
    while let Some(length) = comment_length(rest) {
        let text = comment_text(&rest[length - 1]);
        let Span { start, end, .. } = place(rest[0].span(), file);
        let written = if start.line == end.line { end.column - start.column } else { u32::MAX };
        if length == 2 && text.is_some_and(|text| (written as usize) < text.chars().count() + 5) {
            out.extend_from_slice(&rest[..length]);
        }
        rest = &rest[length..];
    }
}

/// The text of `[doc = "text"]`.
pub(super) fn comment_text(group: &TokenTree) -> Option<String> {
    let TokenTree::Group(group) = group else { return None };
    let literal = group.stream().into_iter().last()?;
    syn::parse2::<syn::LitStr>(literal.into()).ok().map(|text| text.value())
}

//! Diagnostics for the compiler: `compile_error!` at the tokens they are about.

use proc_macro2::{LineColumn, Span, TokenStream, TokenTree};
use quote::quote_spanned;

use super::{Diagnostic, Severity, readable, render};
use crate::syntax::{self, Loaded, Pos, Sources};

/// One `::core::compile_error!{"…"}` for each error; warnings are left out, since a macro cannot warn.
///
/// Each stands at the token of `tokens`, the macro's input, that begins where the diagnostic does, as far as the
/// compiler can tell; at the macro's call if there is none. One about an imported file stands at the import and shows
/// the lines of that file.
#[must_use]
pub fn compile_errors(diagnostics: &[Diagnostic], tokens: &TokenStream, loaded: &Loaded) -> TokenStream {
    errors(diagnostics)
        .map(|diagnostic| match loaded.import_of(diagnostic.span.file) {
            None => compile_error(place(diagnostic.span, tokens), &text(diagnostic, &loaded.sources)),
            Some(import) => compile_error(place(import, tokens), &with_lines(diagnostic, &loaded.sources)),
        })
        .collect()
}

/// One `::core::compile_error!{"…"}` at `span` for each error, which shows the lines that it is about.
#[must_use]
pub fn compile_errors_at(span: Span, diagnostics: &[Diagnostic], sources: &Sources) -> TokenStream {
    errors(diagnostics).map(|diagnostic| compile_error(span, &with_lines(diagnostic, sources))).collect()
}

fn errors(diagnostics: &[Diagnostic]) -> impl Iterator<Item = &Diagnostic> {
    diagnostics.iter().filter(|diagnostic| diagnostic.severity == Severity::Error)
}

fn compile_error(span: Span, text: &str) -> TokenStream {
    quote_spanned!(span=> ::core::compile_error! { #text })
}

/// The compiler itself shows the line.
fn text(diagnostic: &Diagnostic, sources: &Sources) -> String {
    let mut text = format!("[{}] {}", diagnostic.code, diagnostic.message);
    if !diagnostic.label.is_empty() {
        text.push_str(&format!("\n  {}", diagnostic.label));
    }
    for (span, label) in &diagnostic.labels {
        let Pos { line, column } = span.start;
        if span.file == diagnostic.span.file {
            text.push_str(&format!("\n  line {line}, column {column}: {label}"));
        } else {
            text.push_str(&format!("\n  {}:{line}:{column}: {label}", sources.path(span.file)));
        }
    }
    for note in &diagnostic.notes {
        text.push_str(&format!("\n  note: {}", readable(note).replace('\n', "\n    ")));
    }
    if let Some(help) = &diagnostic.help {
        text.push_str(&format!("\n  help: {help}"));
    }
    text
}

/// The compiler does not know the file. It writes `error: ` before the text.
fn with_lines(diagnostic: &Diagnostic, sources: &Sources) -> String {
    let rendered = render(std::slice::from_ref(diagnostic), sources, false);
    let title = format!("error[{}]: ", diagnostic.code);
    match rendered.strip_prefix(&title) {
        Some(rest) => format!("[{}] {}", diagnostic.code, rest.trim_end()),
        None => rendered,
    }
}

fn place(span: syntax::Span, tokens: &TokenStream) -> Span {
    let mut found = Found { first: None, last: None };
    find(tokens.clone(), span.start, span.end, &mut found);
    match (found.first, found.last) {
        // Stable compilers do not join; then the first token alone is marked.
        (Some(first), Some(last)) => first.join(last).unwrap_or(first),
        (Some(first), None) => first,
        _ => Span::call_site(),
    }
}

struct Found {
    /// Of the token that begins at the start.
    first: Option<Span>,
    /// Of the last token that ends no later than the end.
    last: Option<Span>,
}

fn find(tokens: TokenStream, start: Pos, end: Pos, found: &mut Found) {
    // An explicit stack: the input may be nested deeper than the parser allows.
    let mut pending = vec![tokens.into_iter()];
    while let Some(trees) = pending.last_mut() {
        let Some(tree) = trees.next() else {
            pending.pop();
            continue;
        };
        let TokenTree::Group(group) = tree else {
            found.offer(tree.span(), start, end);
            continue;
        };
        found.offer(group.span_open(), start, end);
        found.offer(group.span_close(), start, end);
        pending.push(group.stream().into_iter());
    }
}

impl Found {
    fn offer(&mut self, span: Span, start: Pos, end: Pos) {
        let (from, to) = (pos(span.start()), pos(span.end()));
        if from == start && self.first.is_none() {
            self.first = Some(span);
        }
        if from >= start && to <= end && self.last.is_none_or(|last| pos(last.end()) < to) {
            self.last = Some(span);
        }
    }
}

fn pos(at: LineColumn) -> Pos {
    Pos { line: at.line as u32, column: at.column as u32 + 1 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::{FileId, parse_tokens};
    use std::str::FromStr as _;

    /// Where the error of the macro input `text` is reported.
    #[track_caller]
    fn check(text: &str, expect_column: usize, expect: &str) {
        let tokens = TokenStream::from_str(text).expect("tokens of Rust");
        let (_, diagnostics) = parse_tokens(tokens.clone(), FileId(0));
        let errors = compile_errors(&diagnostics[..1], &tokens, &Loaded::default());
        assert_eq!(errors.to_string(), format!(":: core :: compile_error ! {{ {expect:?} }}"));
        let first = errors.into_iter().next().expect("an error");
        assert_eq!(first.span().start().column + 1, expect_column);
    }

    #[test]
    fn at_the_token() {
        check(
            "specification wait { }",
            15,
            "[SML0005] expected the name of the specification, found the keyword `wait`\n  \
             note: `wait` is reserved and cannot be a name",
        );
    }

    #[test]
    fn at_a_closing_delimiter() {
        check("specification X { object }", 26, "[SML0004] expected the name of the object, found `}`");
    }

    #[test]
    fn at_the_call_if_nowhere() {
        let (_, diagnostics) = parse_tokens(TokenStream::new(), FileId(0));
        let errors = compile_errors(&diagnostics, &TokenStream::new(), &Loaded::default()).to_string();
        assert!(errors.contains("the file contains no specification"), "{errors}");
    }

    #[test]
    fn warnings_are_left_out() {
        let code = crate::diagnostic::Code::Syntax;
        let warning = Diagnostic::warning(code, crate::syntax::Span::default(), "odd");
        assert!(compile_errors(&[warning], &TokenStream::new(), &Loaded::default()).is_empty());
    }
}

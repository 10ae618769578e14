//! Diagnostics for programs.

use serde_json::{Value, json};

use super::{Diagnostic, Severity};
use crate::syntax::Sources;

/// An array with an object for each diagnostic: `code`, `severity`, `message`, `file`, `line`, `column`, `notes`.
///
/// Other places involved are notes that begin with their place, help is a note that begins with `help: `. Lines and
/// columns count from 1; a diagnostic without a place stands at 1, 1.
#[must_use]
pub fn to_json(diagnostics: &[Diagnostic], sources: &Sources) -> Value {
    diagnostics.iter().map(|diagnostic| object(diagnostic, sources)).collect()
}

fn object(diagnostic: &Diagnostic, sources: &Sources) -> Value {
    let label = Some(diagnostic.label.clone()).filter(|label| !label.is_empty());
    let places = diagnostic.labels.iter().map(|(span, text)| {
        format!("{}:{}:{}: {text}", sources.path(span.file), span.start.line, span.start.column)
    });
    let help = diagnostic.help.iter().map(|help| format!("help: {help}"));
    let notes: Vec<String> =
        label.into_iter().chain(places).chain(diagnostic.notes.iter().cloned()).chain(help).collect();
    json!({
        "code": diagnostic.code.to_string(),
        "severity": match diagnostic.severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
        },
        "message": diagnostic.message,
        "file": sources.path(diagnostic.span.file),
        "line": diagnostic.span.start.line.max(1),
        "column": diagnostic.span.start.column.max(1),
        "notes": notes,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::parse_text;

    #[test]
    fn every_field() {
        let text = "specification X {\n  object a: A { x: [1 ) }\n}\n";
        let mut sources = Sources::new();
        let file = sources.add("x.sml", text);
        let (_, diagnostics) = parse_text(text, file);
        let expect = json!([{
            "code": "SML0002",
            "severity": "error",
            "message": "expected `]`, found `)`",
            "file": "x.sml",
            "line": 2,
            "column": 23,
            "notes": ["x.sml:2:20: this `[` is to be closed first"],
        }]);
        assert_eq!(to_json(&diagnostics, &sources), expect);
    }

    #[test]
    fn help_and_missing_place() {
        let diagnostic =
            Diagnostic::warning(crate::diagnostic::Code::Empty, crate::syntax::Span::default(), "m");
        let json = to_json(&[diagnostic.note("n").help("h")], &Sources::new());
        assert_eq!(json[0]["notes"], json!(["n", "help: h"]));
        assert_eq!(json[0]["severity"], "warning");
        assert_eq!((&json[0]["line"], &json[0]["column"]), (&json!(1), &json!(1)));
    }
}

//! Diagnostics are values: a stable code, a place, a message and what to do. Renderers live beside them.

mod code;
#[cfg(feature = "json")]
mod json;
mod render;
mod tokens;

pub use code::Code;
#[cfg(feature = "json")]
pub use json::to_json;
pub use render::render;
pub use tokens::{compile_errors, compile_errors_at};

use crate::syntax::Span;
use std::borrow::Cow;

/// `1 state`, `2 states`.
#[must_use]
pub fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}

/// A note as people read it: of a play of thousands of steps its beginning and its end. JSON has all of it.
fn readable(note: &str) -> Cow<'_, str> {
    const FIRST: usize = 20;
    const LAST: usize = 30;
    let lines: Vec<&str> = note.lines().collect();
    let Some(left_out) = lines.len().checked_sub(FIRST + LAST).filter(|&left_out| left_out > 1) else {
        return Cow::Borrowed(note);
    };
    let between = format!("  ... {left_out} lines more");
    let shown = lines[..FIRST]
        .iter()
        .copied()
        .chain([between.as_str()])
        .chain(lines[FIRST + left_out..].iter().copied());
    Cow::Owned(shown.collect::<Vec<_>>().join("\n"))
}

/// How bad it is.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Severity {
    /// Nothing is produced.
    Error,
    /// Worth a look.
    Warning,
}

/// One message to the author of a specification.
///
/// Texts are lowercase fragments without a full stop, names in backticks, help begins with a verb.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Diagnostic {
    /// Which kind of mistake.
    pub code: Code,
    /// Error or warning.
    pub severity: Severity,
    /// What is wrong.
    pub message: String,
    /// Where.
    pub span: Span,
    /// What is said at the place itself; may be empty.
    pub label: String,
    /// Other places involved, each with what it has to do with this.
    pub labels: Vec<(Span, String)>,
    /// Further facts.
    pub notes: Vec<String>,
    /// What to do.
    pub help: Option<String>,
}

impl Diagnostic {
    /// An error at `span`.
    pub fn error(code: Code, span: Span, message: impl Into<String>) -> Self {
        Self::new(code, Severity::Error, span, message.into())
    }

    /// A warning at `span`.
    pub fn warning(code: Code, span: Span, message: impl Into<String>) -> Self {
        Self::new(code, Severity::Warning, span, message.into())
    }

    fn new(code: Code, severity: Severity, span: Span, message: String) -> Self {
        Diagnostic {
            code,
            severity,
            message,
            span,
            label: String::new(),
            labels: Vec::new(),
            notes: Vec::new(),
            help: None,
        }
    }

    /// Says something at the place itself.
    #[must_use]
    pub fn label(mut self, text: impl Into<String>) -> Self {
        self.label = text.into();
        self
    }

    /// Points at another place.
    #[must_use]
    pub fn also(mut self, span: Span, text: impl Into<String>) -> Self {
        self.labels.push((span, text.into()));
        self
    }

    /// Adds a fact.
    #[must_use]
    pub fn note(mut self, text: impl Into<String>) -> Self {
        self.notes.push(text.into());
        self
    }

    /// Says what to do.
    #[must_use]
    pub fn help(mut self, text: impl Into<String>) -> Self {
        self.help = Some(text.into());
        self
    }
}

#[cfg(test)]
mod tests {
    use super::readable;

    #[test]
    fn long_plays_are_shown_in_part() {
        let play = |steps: usize| {
            let steps: Vec<String> = (1..=steps).map(|step| format!("  step {step}")).collect();
            format!("the play:\n{}", steps.join("\n"))
        };
        for whole in [0, 1, 49, 50] {
            assert_eq!(readable(&play(whole)), play(whole));
        }
        let shown = readable(&play(100_000)).into_owned();
        assert_eq!(shown.lines().count(), 51);
        assert!(shown.contains("  step 19\n  ... 99951 lines more\n  step 99971\n"), "{shown}");
        assert!(shown.ends_with("  step 100000"), "{shown}");
    }
}

//! Words and numbers: which are keywords, which have the form of a name, which are integers.

use super::Span;
use crate::diagnostic::{Code, Diagnostic};

/// Words that open or modify a construct and so cannot be names, sorted.
///
/// Words that only continue a construct (`events`, `over`, `to`, …) and those of older spellings (`message`,
/// `system`, …) are told from names by their place.
pub const RESERVED: &[&str] = &[
    "abstract",
    "alternative",
    "and",
    "assumption",
    "bind",
    "bindings",
    "bool",
    "channels",
    "class",
    "collaboration",
    "committed",
    "consider",
    "constraints",
    "controllable",
    "domain",
    "dynamic",
    "effects",
    "enum",
    "eventually",
    "existential",
    "false",
    "forbidden",
    "guarantee",
    "ignore",
    "import",
    "interrupt",
    "monitored",
    "non",
    "null",
    "object",
    "or",
    "parallel",
    "parameter",
    "requested",
    "role",
    "scenario",
    "specification",
    "static",
    "strict",
    "true",
    "urgent",
    "var",
    "violation",
    "wait",
    "while",
];

/// What is wrong with `word` as a name, apart from being a keyword.
pub(super) fn name_error(word: &str, span: Span) -> Option<Diagnostic> {
    if let Some(plain) = word.strip_prefix("r#") {
        let error = Diagnostic::error(Code::NameForm, span, format!("`{word}` is a raw identifier"));
        return Some(error.help(format!("write `{plain}`: Rust's keywords are ordinary names here")));
    }
    let good = word.starts_with(|c: char| c.is_ascii_alphabetic())
        && word.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    (!good).then(|| {
        Diagnostic::error(Code::NameForm, span, format!("`{word}` is not a name"))
            .note("a name is an ASCII letter followed by ASCII letters, digits and `_`")
    })
}

/// What is wrong with the form of the number `text`; its size is another matter.
pub(super) fn number_error(text: &str, span: Span) -> Option<Diagnostic> {
    if text.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    let error = Diagnostic::error(Code::NumberForm, span, format!("`{text}` is not a plain decimal integer"));
    let digits: String = text.chars().filter(|&c| c != '_').collect();
    Some(if text.contains('.') {
        error.note("there are no numbers with a fraction")
    } else if digits.bytes().all(|b| b.is_ascii_digit()) {
        error.help(format!("write `{digits}`"))
    } else if let Some(value) = digits.strip_prefix("0x").and_then(|d| i64::from_str_radix(d, 16).ok()) {
        error.help(format!("write `{value}`"))
    } else {
        error.note("an integer is decimal digits alone")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reserved_words_are_sorted() {
        assert!(RESERVED.is_sorted());
    }

    #[test]
    fn rust_keywords_are_free() {
        for word in ["move", "self", "type", "match", "fn", "crate", "loop", "for", "if"] {
            assert!(!RESERVED.contains(&word), "{word}");
        }
    }
}

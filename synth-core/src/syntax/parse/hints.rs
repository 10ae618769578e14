//! What the author probably meant: help for slips of the keyboard, and for habits from other languages.

use proc_macro2::TokenTree;
use syn::Token;
use syn::parse::ParseStream;
use syn::token::{Brace, Bracket, Paren};

use super::SECTIONS;
use super::fragment::MODIFIERS;
use super::reader::{Reader, operator};
use crate::diagnostic::Diagnostic;
use crate::suggest::nearest;

/// Words of other languages, and what they are here.
const FOREIGN: [(&str, &str); 10] = [
    ("if", "alternative"),
    ("alt", "alternative"),
    ("switch", "alternative"),
    ("else", "or"),
    ("loop", "while"),
    ("for", "while"),
    ("repeat", "while"),
    ("par", "parallel"),
    ("fork", "parallel"),
    ("let", "var"),
];

impl Reader {
    /// `` write `word` `` for the one of `words` that the next word resembles, unless it is a keyword itself.
    pub(crate) fn misspelt(&self, input: ParseStream<'_>, words: &[&str]) -> Option<String> {
        let word = self.word(input).filter(|word| !self.is_reserved(word))?;
        nearest(&word, words.iter().copied()).map(|near| format!("write `{near}`"))
    }

    /// Help for the next token where `what` was expected.
    pub(super) fn hint(&self, input: ParseStream<'_>, what: &str) -> Option<String> {
        let quoted: Vec<&str> = what.split('`').skip(1).step_by(2).collect();
        match input.cursor().token_tree()?.0 {
            TokenTree::Ident(_) => {
                let words: Vec<&str> = quoted
                    .into_iter()
                    .filter(|word| word.chars().all(|c| c.is_ascii_alphabetic() || c == ' '))
                    .collect();
                self.misspelt(input, &words)
            }
            TokenTree::Punct(_) => {
                let found = operator(input);
                if found.starts_with('#') {
                    // With brackets it was `///`.
                    return (!input.peek2(Bracket)).then(|| "begin a comment with `//`".to_owned());
                }
                let due = quoted.first().filter(|_| what.starts_with('`'))?;
                let is_symbol = due.chars().all(|c| c.is_ascii_punctuation() && !"{}[](),".contains(c));
                (is_symbol && !found.starts_with([',', ';'])).then(|| match (*due, found.as_str()) {
                    ("->", ".") => "name the sender, too: `sender -> receiver.operation()`".to_owned(),
                    _ => format!("write `{due}` instead of `{found}`"),
                })
            }
            TokenTree::Literal(literal) if literal.to_string().starts_with('"') => {
                Some("remove the quotes: names and enum literals stand alone".to_owned())
            }
            TokenTree::Group(_) if quoted.first() == Some(&"[") && input.peek(Paren) => {
                Some("write `[ … ]` instead of `( … )`".to_owned())
            }
            TokenTree::Group(_) if quoted.first() == Some(&"(") && input.peek(Bracket) => {
                Some("write `( … )` instead of `[ … ]`".to_owned())
            }
            _ => None,
        }
    }

    /// The error that a `,` or the end of a list should come next, with help.
    pub(crate) fn missing_comma(&self, input: ParseStream<'_>, error: Box<Diagnostic>) -> Box<Diagnostic> {
        match input.cursor().token_tree() {
            _ if error.help.is_some() => error,
            Some((TokenTree::Ident(word), _)) => Box::new(error.help(format!("write `,` before `{word}`"))),
            Some((TokenTree::Literal(value), _)) => {
                Box::new(error.help(format!("write `,` before `{value}`")))
            }
            Some((TokenTree::Punct(_), _)) if operator(input) == ";" => {
                Box::new(error.help("write `,` instead of `;`"))
            }
            _ => error,
        }
    }

    /// What should be written instead of a word that begins no section.
    pub(super) fn misspelt_section(&self, input: ParseStream<'_>) -> Option<String> {
        let word = self.word(input)?;
        let runs_on = ["nonspontaneous", "non_spontaneous", "nonSpontaneous", "spontaneous"];
        if runs_on.contains(&word.as_str()) {
            return Some("write `non-spontaneous events { … }`".to_owned());
        }
        if self.at(input, "import") {
            return Some("move it in front of `specification`".to_owned());
        }
        self.misspelt(input, &SECTIONS)
    }

    /// Help for something that belongs into another place than between sections or scenarios.
    pub(super) fn stray_item(&self, input: ParseStream<'_>) -> Option<String> {
        let word = self.word(input)?;
        let help = match word.as_str() {
            "scenario" => "write `guarantee scenario`, `assumption scenario` or `existential scenario`",
            "role" => "write `static role` or `dynamic role`",
            "constraints" => "move it behind the body of a scenario: `{ … } constraints [ … ]`",
            "class" | "enum" | "abstract" => "put classes and enums into `domain Name { … }`",
            word if SECTIONS.contains(&word) => "close the collaboration before the next section begins",
            word if MODIFIERS.contains(&word) || input.peek2(Token![->]) => {
                "put messages into the body of a scenario"
            }
            _ => return None,
        };
        Some(help.to_owned())
    }

    /// The keyword that was meant by a word which cannot begin a message, for what follows is not `->`.
    pub(super) fn misspelt_fragment(&self, input: ParseStream<'_>, word: &str) -> Option<String> {
        if self.is_reserved(word) {
            return None;
        }
        let words: &[&str] = if input.peek2(Bracket) {
            &["wait", "while", "alternative", "or", "interrupt", "violation"]
        } else if input.peek2(Brace) {
            &["alternative", "parallel", "while", "or", "and"]
        } else if input.peek2(Paren) {
            &["wait", "while"]
        } else if input.cursor().token_tree()?.1.literal().is_some() {
            &["var"]
        } else if input.cursor().token_tree()?.1.ident().is_some() {
            &["strict", "monitored", "eventually", "urgent", "requested", "committed", "wait", "var"]
        } else {
            return None;
        };
        if let Some((_, meant)) = FOREIGN.iter().find(|(foreign, _)| *foreign == word) {
            let condition = if matches!(word, "if" | "switch") { " [ … ] { … }" } else { "" };
            return Some(format!("write `{meant}{condition}`"));
        }
        self.misspelt(input, words)
    }

    /// The error about an assignment to something that is no variable, `lamp.lit = …`, if one comes next.
    pub(super) fn attribute_assignment(&self, input: ParseStream<'_>) -> Option<Box<Diagnostic>> {
        let (_, rest) = input.cursor().ident()?;
        let (_, rest) = rest.punct().filter(|(dot, _)| dot.as_char() == '.')?;
        let (_, rest) = rest.ident()?;
        let (assign, rest) = rest.punct().filter(|(assign, _)| assign.as_char() == '=')?;
        let alone = assign.spacing() == proc_macro2::Spacing::Alone || rest.punct().is_none();
        alone.then(|| {
            let error = self.expected(input, "a fragment");
            let note =
                "only events change attributes: `sender -> receiver.setX(value)`, or any with an effect";
            Box::new(error.note(note).help("put the assignment into the section `effects`"))
        })
    }

    /// The modifiers that come next, in the order in which they are written, or what is wrong with them.
    pub(super) fn order_of_modifiers(&self, before: &[&str], input: ParseStream<'_>) -> String {
        let mut found: Vec<&str> = before.to_vec();
        let mut cursor = input.cursor();
        while let Some((word, rest)) = cursor.ident()
            && let Some(modifier) = MODIFIERS.iter().find(|modifier| word == **modifier)
        {
            found.push(modifier);
            cursor = rest;
        }
        let mut ordered: Vec<&str> = MODIFIERS.iter().copied().filter(|one| found.contains(one)).collect();
        let modalities =
            ordered.split_off(ordered.iter().take_while(|one| MODIFIERS[..2].contains(one)).count());
        if modalities.len() > 1 {
            let choices: Vec<String> = modalities.iter().map(|one| format!("`{one}`")).collect();
            return format!("write only one of {}", choices.join(" and "));
        }
        ordered.extend(modalities);
        format!("write `{}`", ordered.join(" "))
    }

    /// What is written instead of the token that follows an operand, if that is an operator of another language.
    pub(super) fn foreign_operator(&self, input: ParseStream<'_>) -> Option<(String, &'static str)> {
        if let Some(word) = self.word(input) {
            let meant = match word.as_str() {
                "and" | "AND" => "&&",
                "or" | "OR" => "||",
                "implies" => "=>",
                "is" => "==",
                _ => return None,
            };
            // Also a name could stand here, as the next of a list.
            let next = input.cursor().ident()?.1;
            let is_operand = next.ident().is_some() || next.literal().is_some() || input.peek2(Paren);
            let negated = next.punct().is_some_and(|(punct, _)| punct.as_char() == '!');
            return (is_operand || negated || self.is_reserved(&word)).then_some((word, meant));
        }
        let found = input.cursor().punct().map(|_| operator(input))?;
        let meant = match found.as_str() {
            "=<" => "<=",
            "===" => "==",
            "&" => "&&",
            "|" => "||",
            "<>" | "!==" | "/=" => "!=",
            text if text.starts_with('=') && !text.starts_with("==") && !text.starts_with("=>") => {
                return Some(("=".to_owned(), "=="));
            }
            _ => return None,
        };
        Some((found, meant))
    }
}

//! One token too few, too many, or in the wrong place: told near the place, and hardly more than once.

use super::corpus;
use crate::diagnostic::Diagnostic;
use crate::model::resolve::resolve;
use crate::syntax::{FileId, parse_text};

/// All that is found wrong with the text before play-out, if anything is.
fn read(text: &str) -> Result<(), Vec<Diagnostic>> {
    let (tree, mut errors) = parse_text(text, FileId(0));
    if let (Some(tree), []) = (tree, errors.as_slice()) {
        let (spec, found) = resolve(&[tree]);
        if spec.is_some() {
            return Ok(());
        }
        errors = found;
    }
    errors.sort_by_key(|d| d.span.start);
    Err(errors)
}

/// Where the tokens of the text are, comments aside.
fn tokens(text: &str) -> Vec<std::ops::Range<usize>> {
    let bytes = text.as_bytes();
    let is_word = |at: usize| bytes[at].is_ascii_alphanumeric() || bytes[at] == b'_';
    let (mut tokens, mut at) = (Vec::new(), 0);
    while at < bytes.len() {
        let start = at;
        if text[at..].starts_with("//") {
            at += text[at..].find('\n').unwrap_or(text.len() - at);
        } else if is_word(at) {
            while at < bytes.len() && is_word(at) {
                at += 1;
            }
            tokens.push(start..at);
        } else if ["->", "==", "!=", "&&", "||", "=>", "<=", ">="].iter().any(|op| text[at..].starts_with(op))
        {
            at += 2;
            tokens.push(start..at);
        } else {
            at += text[at..].chars().next().map_or(1, char::len_utf8);
            if !text[start..at].trim().is_empty() {
                tokens.push(start..at);
            }
        }
    }
    tokens
}

/// What is done to a token and, with a swap, to the next.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Edit {
    Delete,
    Duplicate,
    Swap,
    Misspell,
}

/// The text with token `at` edited, and the offset of the edit.
fn edited(text: &str, tokens: &[std::ops::Range<usize>], at: usize, edit: Edit) -> Option<String> {
    let token = tokens[at].clone();
    let (before, word, behind) = (&text[..token.start], &text[token.clone()], &text[token.end..]);
    Some(match edit {
        Edit::Delete => format!("{before}{behind}"),
        Edit::Duplicate => format!("{before}{word} {word}{behind}"),
        Edit::Swap => {
            let next = tokens.get(at + 1)?.clone();
            let (between, second) = (&text[token.end..next.start], &text[next.clone()]);
            if second == word {
                return None;
            }
            format!("{before}{second}{between} {word}{}", &text[next.end..])
        }
        Edit::Misspell => {
            let (first, rest) = word.split_at_checked(2).filter(|_| word.len() > 3 && word.is_ascii())?;
            let doubled = first.chars().last().filter(char::is_ascii_alphabetic)?;
            format!("{before}{first}{doubled}{rest}{behind}")
        }
    })
}

/// How many texts had diagnostics, how many of these at most three, and how many the first of them no later than a line
/// behind the edit.
#[derive(Default)]
struct Tally {
    texts: usize,
    few: usize,
    near: usize,
}

/// Every seventh token of every specification of the corpus is edited.
#[track_caller]
fn check(edit: Edit, least_near: usize) {
    check_texts(&corpus(), read, 7, edit, least_near);
}

/// Every `step`th token of every text is edited, and the text then read; of those that are refused nearly all must have
/// few diagnostics, and so many of a hundred one near the edit. `SML_SHOW=1` prints what is worse than wanted.
#[track_caller]
pub(crate) fn check_texts(
    corpus: &[(String, String)],
    read: fn(&str) -> Result<(), Vec<Diagnostic>>,
    step: usize,
    edit: Edit,
    least_near: usize,
) {
    let show = std::env::var_os("SML_SHOW").is_some();
    let mut tally = Tally::default();
    for (path, text) in corpus {
        let tokens = tokens(text);
        for at in (0..tokens.len()).step_by(step) {
            let Some(changed) = edited(text, &tokens, at, edit) else { continue };
            // A specification without `urgent`, or with another name, is one, too.
            let Err(found) = read(&changed) else { continue };
            assert!(!found.is_empty(), "{path}: refused without a word\n{changed}");
            let line = text[..tokens[at].start].matches('\n').count() as u32 + 1;
            let (few, near) = (found.len() <= 3, found[0].span.start.line <= line + 1);
            tally.texts += 1;
            tally.few += usize::from(few);
            tally.near += usize::from(near);
            if show && !(few && near) {
                println!("{path}:{line}: {edit:?} `{}`", &text[tokens[at].clone()]);
                for d in &found {
                    println!("    {}: {} {}", d.span.start.line, d.code, d.message);
                }
            }
        }
    }
    let Tally { texts, few, near } = tally;
    println!("{edit:?}: {texts} texts, {few} with at most three diagnostics, {near} near the edit");
    assert!(texts > 250, "only {texts} texts are wrong");
    assert!(few * 100 >= texts * 99, "{few} of {texts} have at most three diagnostics");
    assert!(near * 100 >= texts * least_near, "{near} of {texts} are told near the edit");
}

#[test]
fn a_token_too_few() {
    check(Edit::Delete, 99);
}

#[test]
fn a_token_too_many() {
    check(Edit::Duplicate, 98);
}

#[test]
fn two_tokens_that_changed_places() {
    check(Edit::Swap, 99);
}

/// A misspelt declaration is told at the first use.
#[test]
fn a_letter_too_many() {
    check(Edit::Misspell, 90);
}

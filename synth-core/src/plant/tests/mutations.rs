//! One token too few, too many, or in the wrong place: told near the place, and hardly more than once.

use super::corpus;
use crate::diagnostic::Diagnostic;
use crate::plant;
use crate::syntax::FileId;
use crate::syntax::tests::mutations::{Edit, check_texts};

fn read(text: &str) -> Result<(), Vec<Diagnostic>> {
    plant::read(text, FileId(0)).map(drop)
}

/// Where a name or a brace is missing or too much, that shows at the next item, often behind an empty line.
#[track_caller]
fn check(edit: Edit, least_near: usize) {
    check_texts(&corpus(), read, 2, edit, least_near);
}

#[test]
fn a_token_too_few() {
    check(Edit::Delete, 98);
}

#[test]
fn a_token_too_many() {
    check(Edit::Duplicate, 97);
}

#[test]
fn two_tokens_that_changed_places() {
    check(Edit::Swap, 98);
}

/// A misspelt declaration is told at the first use.
#[test]
fn a_letter_too_many() {
    check(Edit::Misspell, 50);
}

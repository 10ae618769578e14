//! The corpus round-trips; places are right; every mistake is told; nothing panics.

mod errors;
pub(crate) mod fuzz;
mod help;
pub(crate) mod mutations;
mod trees;

use super::{FileId, Pos, Span, ast, parse_text};
use crate::diagnostic::Diagnostic;

fn parse(text: &str) -> (Option<ast::File>, Vec<Diagnostic>) {
    parse_text(text, FileId(0))
}

/// The tree of `text`, which must have no mistake.
#[track_caller]
fn tree(text: &str) -> ast::File {
    let (tree, errors) = parse(text);
    assert_eq!(errors, [], "{text}");
    tree.expect("a tree without errors")
}

/// Every specification of the corpus, with its path.
fn corpus() -> Vec<(String, String)> {
    let directory = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/specs");
    let mut files: Vec<_> = std::fs::read_dir(directory)
        .expect("the corpus")
        .map(|entry| entry.expect("an entry").path().join("spec.sml"))
        .filter(|path| path.exists())
        .collect();
    files.sort();
    assert!(!files.is_empty());
    files
        .into_iter()
        .map(|path| (path.display().to_string(), std::fs::read_to_string(&path).expect("UTF-8")))
        .collect()
}

/// Takes the lines that mark the line above them with `~~~~` out of `marked`: the text without them, and the place
/// and the words of each mark.
pub(crate) fn unmark(marked: &str) -> (String, Vec<(Span, String)>) {
    let (mut text, mut marks, mut line) = (String::new(), Vec::new(), 0);
    for full in marked.split_inclusive('\n') {
        let mark = full.trim_start();
        if !mark.starts_with('~') {
            text.push_str(full);
            line += 1;
            continue;
        }
        let words = mark.trim_start_matches('~');
        let start = (full.chars().count() - mark.chars().count()) as u32 + 1;
        let pos = |column| Pos { line, column };
        let end = start + (mark.len() - words.len()) as u32;
        marks.push((Span { file: FileId(0), start: pos(start), end: pos(end) }, words.trim().to_owned()));
    }
    (text, marks)
}

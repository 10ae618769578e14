//! The corpus round-trips; places are right; every mistake is told; nothing panics.

use super::{FileId, parse_text, print};
use crate::diagnostic::Diagnostic;

fn parse(text: &str) -> (Option<super::ast::File>, Vec<Diagnostic>) {
    parse_text(text, FileId(0))
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

#[test]
fn corpus_round_trips() {
    for (path, text) in corpus() {
        let (tree, errors) = parse(&text);
        assert_eq!(errors, [], "{path}");
        let printed = print(&tree.expect("a tree"));
        let (again, errors) = parse(&printed);
        assert_eq!(errors, [], "{path}\n{printed}");
        assert_eq!(print(&again.expect("a tree")), printed, "{path}");
    }
}

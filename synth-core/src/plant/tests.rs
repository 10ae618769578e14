//! Plants of the corpus can be read; every mistake is told at its place.

use super::read;
use crate::diagnostic::Diagnostic;
use crate::syntax::FileId;

/// The corpus, by path.
fn corpus() -> Vec<(String, String)> {
    let directory = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/plants");
    let mut files: Vec<_> = std::fs::read_dir(directory)
        .expect("the corpus")
        .map(|entry| entry.expect("an entry").path())
        .collect();
    files.sort();
    files
        .into_iter()
        .map(|path| (path.display().to_string(), std::fs::read_to_string(&path).expect("UTF-8")))
        .collect()
}

#[test]
fn the_corpus_can_be_read() {
    for (path, text) in corpus() {
        let found = read(&text, FileId(0)).map(|(_, warnings)| warnings);
        assert_eq!(found, Ok::<_, Vec<Diagnostic>>(Vec::new()), "{path}");
    }
}

//! The specifications in `tests/specs`, each with the figures that every implementation must find.

use crate::fast;
use serde_json::Value;
use std::path::PathBuf;
use synth_core::controller::Controller;
use synth_core::pipeline::{Timings, synthesize};
use synth_core::syntax::ast::File;
use synth_core::syntax::{FileId, parse_text};

/// A specification of the corpus.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Name of its folder.
    pub name: String,
    /// Its text.
    pub text: String,
    /// Figures by semantics, `default` and perhaps `classic`.
    pub expected: Value,
}

/// All specifications of the corpus, by name.
///
/// # Panics
/// When a file cannot be read: the corpus is part of the tests.
#[must_use]
pub fn all() -> Vec<Entry> {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("specs");
    let mut folders: Vec<PathBuf> = std::fs::read_dir(&root)
        .expect("the corpus exists")
        .map(|entry| entry.expect("the corpus is readable").path())
        .filter(|path| path.is_dir())
        .collect();
    folders.sort();
    folders
        .into_iter()
        .map(|folder| {
            let read = |name: &str| {
                let path = folder.join(name);
                std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
            };
            let expected = serde_json::from_str(&read("expected.json"))
                .unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
            let name = folder.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
            Entry { name, text: read("spec.sml"), expected }
        })
        .collect()
}

/// The controller of every realizable specification of the corpus, with its name.
///
/// # Panics
/// When there are few: the corpus is part of the tests.
#[must_use]
pub fn controllers() -> Vec<(String, Controller)> {
    let mut controllers = Vec::new();
    for entry in all() {
        let spec = fast::resolved(&entry.text).expect("the corpus is right");
        let options = fast::options(false, 20_000);
        let Ok(mut solved) = fast::solved(&spec, &options) else { continue };
        if let Ok(verified) = synthesize(&mut solved, &options, &mut Timings::default()) {
            controllers.push((entry.name, verified.controller));
        }
    }
    assert!(controllers.len() > 20, "only {}", controllers.len());
    controllers
}

/// The syntax tree of a text without errors.
///
/// # Errors
/// The diagnostics, one a line, each with its place.
pub fn parse(text: &str) -> Result<File, String> {
    let (file, diagnostics) = parse_text(text, FileId(0));
    let errors: Vec<String> = diagnostics
        .iter()
        .map(|each| format!("{}:{}: {}", each.span.start.line, each.span.start.column, each.message))
        .collect();
    match file {
        Some(file) if errors.is_empty() => Ok(file),
        _ => Err(errors.join("\n")),
    }
}

//! A plant with its text, for messages, and its origin, for outputs.

use super::{Plant, parse_tokens, print, read, resolved};
use crate::controller::tables::Provenance;
use crate::diagnostic::Diagnostic;
use crate::fnv::Fnv;
use crate::syntax::{FileId, Sources, decode, shown};
use proc_macro2::TokenStream;

/// What became of a file, or of the input of a macro.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// The plant and its warnings; or all that is wrong, in the order of places.
    pub plant: Result<(Plant, Vec<Diagnostic>), Vec<Diagnostic>>,
    /// Its path and its text, for rendering; the input of a macro has none.
    pub sources: Sources,
    /// The canonical form of the input of a macro, which has no text; nothing of a file.
    pub canonical: String,
    /// Path and hash, of the text or the canonical form.
    pub provenance: Provenance,
}

impl Loaded {
    /// Reads the bytes of the file at `path`.
    #[must_use]
    pub fn of_file(path: &str, bytes: &[u8]) -> Loaded {
        let mut sources = Sources::new();
        let (plant, hash) = match decode(bytes, FileId(0)) {
            Ok(text) => {
                let file = sources.add(path, text);
                (read(text, file), hash(sources.text(file)))
            }
            Err(diagnostic) => {
                sources.add(path, shown(bytes));
                (Err(vec![*diagnostic]), hash(""))
            }
        };
        Loaded { plant, sources, canonical: String::new(), provenance: provenance(path, hash) }
    }

    /// Reads the input of a macro, for which `path` stands; places are those of the file that invokes it.
    #[must_use]
    pub fn of_tokens(path: &str, tokens: &TokenStream) -> Loaded {
        let mut sources = Sources::new();
        let (tree, errors) = parse_tokens(tokens.clone(), sources.add(path, ""));
        let canonical = tree.as_ref().map(print).unwrap_or_default();
        let hash = hash(&canonical);
        Loaded { plant: resolved(tree, errors), sources, canonical, provenance: provenance(path, hash) }
    }
}

fn hash(text: &str) -> String {
    let mut hash = Fnv::new();
    hash.text(text);
    hash.hex()
}

fn provenance(path: &str, hash: String) -> Provenance {
    Provenance { file: path.to_owned(), hash, ..Provenance::default() }
}

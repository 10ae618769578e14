//! What a result depends on.

use crate::controller::tables::FORMAT_VERSION;
use crate::syntax::{FileId, Sources};
use std::fmt;

/// Everything that a result depends on, itself and not a hash of it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Key(Vec<u8>);

impl Key {
    /// For results that are made in a way (`what`) with `options`.
    ///
    /// A derived [`fmt::Debug`] shows every field of options, those that will be added, too. So none can be forgotten, and one
    /// that makes no difference costs no more than a synthesis.
    #[must_use]
    pub fn new(what: &str, options: &dyn fmt::Debug) -> Key {
        Key::of_tool(env!("CARGO_PKG_VERSION"), env!("SYNTH_CORE_FINGERPRINT"), FORMAT_VERSION)
            .text(what)
            .text(&format!("{options:?}"))
    }

    /// The fingerprint is of the sources: versions stay the same while a tool is worked on.
    fn of_tool(version: &str, fingerprint: &str, format: u32) -> Key {
        Key(Vec::new()).text(version).text(fingerprint).text(&format.to_string())
    }

    /// The same with a text more, told apart from the one before.
    #[must_use]
    pub fn text(mut self, text: &str) -> Key {
        self.0.extend((text.len() as u64).to_le_bytes());
        self.0.extend(text.as_bytes());
        self
    }

    /// The same with paths and texts of all files.
    #[must_use]
    pub fn sources(self, sources: &Sources) -> Key {
        let files = (0..sources.len() as u32).map(FileId);
        files.fold(self, |key, file| key.text(sources.path(file)).text(sources.text(file)))
    }

    /// All of it.
    pub(super) fn bytes(&self) -> &[u8] {
        &self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whatever_differs_is_another_key() {
        let sources = |files: &[(&str, &str)]| {
            let mut sources = Sources::new();
            for (path, text) in files {
                sources.add(*path, *text);
            }
            Key::new("", &"").sources(&sources)
        };
        let keys = [
            Key::of_tool("0.1.0", "f0", 1),
            Key::of_tool("0.1.1", "f0", 1),
            Key::of_tool("0.1.0", "f1", 1),
            Key::of_tool("0.1.0", "f0", 2),
            Key::new("script", &(1, false)),
            Key::new("script", &(1, true)),
            Key::new("macro", &(1, true)),
            Key::new("", &"").text("ab").text("c"),
            Key::new("", &"").text("a").text("bc"),
            sources(&[("a.sml", "x"), ("b.sml", "y")]),
            sources(&[("a.sml", "x"), ("b.sml", "z")]),
            sources(&[("a.sml", "x"), ("c.sml", "y")]),
            sources(&[("a.sml", "x")]),
        ];
        for (i, a) in keys.iter().enumerate() {
            for (j, b) in keys.iter().enumerate() {
                assert_eq!(a == b, i == j, "{i} {j}");
            }
        }
    }
}

//! What sets the systems apart that Structured Text is written for: one value each.
//!
//! Nothing outside of this module asks which target it writes for. A dialect says which words it keeps, how a
//! controller is laid out, and what stands around it.

mod case;
mod codesys;
mod frame;
mod iec;
mod siemens;
mod twincat;
mod words;

use super::layout::Layout;
use super::layout::case::CaseLayout;
use super::layout::rows::RowLayout;
use super::layout::runs::RunLayout;
use super::layout::search::Search;
use super::{Encoding, Target};
pub(super) use frame::Frame;
pub(super) use words::Words;

/// How the text of a target looks.
pub(super) struct Dialect {
    /// As on the command line.
    pub(super) name: &'static str,
    /// Words that no identifier may be.
    pub(super) words: &'static Words,
    /// How transitions are held and found.
    pub(super) transitions: Transitions,
    /// What stands around declarations and statements.
    pub(super) frame: &'static dyn Frame,
    /// How to load the text, for the comment at its top.
    pub(super) notes: &'static [&'static str],
    /// What there must be for variables to be retained, for the same comment.
    pub(super) retaining: &'static [&'static str],
}

/// The layouts of a dialect.
pub(super) enum Transitions {
    /// Tables, as the options want them.
    Tables {
        /// By runs.
        runs: RunLayout,
        /// As published.
        rows: RowLayout,
    },
    /// Branches.
    Branches,
}

impl Transitions {
    /// Tables in a section of variables.
    const fn tables(search: &'static dyn Search, section: &'static str) -> Transitions {
        Transitions::Tables { runs: RunLayout { search, section }, rows: RowLayout { search, section } }
    }
}

impl Dialect {
    /// The layout that the options ask for.
    pub(super) fn layout(&'static self, encoding: Encoding) -> &'static dyn Layout {
        match (&self.transitions, encoding) {
            (Transitions::Tables { runs, .. }, Encoding::Runs) => runs,
            (Transitions::Tables { rows, .. }, Encoding::Rows) => rows,
            (Transitions::Branches, _) => &CaseLayout,
        }
    }
}

/// The longest identifier, in characters, whatever the dialect, so that names stay when the target changes.
///
/// The standard leaves it to the implementer. 63 is what C promises to tell apart, which compilers that go through C
/// inherit; CODESYS and TwinCAT know no limit, and that of TIA Portal is twice as high.
pub(super) const IDENTIFIER_LIMIT: usize = 63;

impl Target {
    pub(super) fn dialect(self) -> &'static Dialect {
        match self {
            Target::Iec => &iec::DIALECT,
            Target::Codesys => &codesys::DIALECT,
            Target::Twincat => &twincat::DIALECT,
            Target::Siemens => &siemens::DIALECT,
            Target::Case => &case::DIALECT,
        }
    }
}

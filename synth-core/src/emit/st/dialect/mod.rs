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

use super::Target;
use super::layout::Layout;
pub(super) use frame::Frame;
pub(super) use words::Words;

/// How the text of a target looks.
pub(super) struct Dialect {
    /// As on the command line.
    pub(super) name: &'static str,
    /// Words that no identifier may be.
    pub(super) words: &'static Words,
    /// How transitions are held and found.
    pub(super) layout: &'static dyn Layout,
    /// What stands around declarations and statements.
    pub(super) frame: &'static dyn Frame,
    /// How to load the text, for the comment at its top.
    pub(super) notes: &'static [&'static str],
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

//! What is worth a look in a specification that is not wrong: warnings, each with its place.
//!
//! Three groups, by what they need to know. None of them changes a verdict or a product.
//!
//! * [`of_text`]: the specification alone. Costs nothing, so every command shows them.
//! * [`of_game`]: all plays of the explored specification.
//! * [`of_controller`]: the plays that a winning strategy leaves.
//!
//! A warning that is wrong does more harm than one that is missing: each of these says what is true of the specification
//! at hand, and where that takes a play to see, shows a shortest one.

mod causes;
mod mentions;
mod policy;
mod reads;
mod unused;
mod waits;

pub use policy::{Policy, Warning};

use crate::diagnostic::Diagnostic;
use crate::model::Spec;
use crate::syntax::Loaded;

/// Warnings that the text shows, in the order of their places. Those that parsing gave come with them.
#[must_use]
pub fn of_text(loaded: &Loaded, spec: &Spec) -> Vec<Diagnostic> {
    let mut warnings = loaded.diagnostics.clone();
    warnings.extend(unused::declarations(&loaded.files, spec));
    warnings.extend(causes::uncaused(&loaded.files, spec));
    warnings.extend(waits::hopeless(spec));
    sort(&mut warnings);
    warnings
}

/// Into the order of their places.
pub fn sort(warnings: &mut [Diagnostic]) {
    warnings.sort_by_key(|warning| (warning.span.file, warning.span.start, warning.code));
}

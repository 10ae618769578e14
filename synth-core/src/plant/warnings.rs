//! What is worth a look in a plant under its feedback; what its text alone shows comes with [`super::read`].

use super::{ClosedLoop, Plant, effects, never_enabled};
use crate::diagnostic::Diagnostic;

/// Warnings about a plant and its feedback, in the order of places: controllable events that are enabled nowhere, and
/// commands after which states may be read that were not meant.
#[must_use]
pub fn warnings(plant: &Plant, closed: &ClosedLoop) -> Vec<Diagnostic> {
    let mut found = never_enabled::warnings(plant, closed);
    effects::doubtful(plant, closed, &mut found);
    found.sort_by_key(|d| d.span.start);
    found
}

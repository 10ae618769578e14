//! What is worth a look in a plant under its feedback; what its text alone shows comes with [`super::read`].

use super::{ClosedLoop, Plant, circles, effects, never_enabled, unnoticed, unreadable};
use crate::diagnostic::Diagnostic;

/// Warnings about a plant and its feedback, in the order of places: controllable events that are enabled nowhere
/// ([`never_enabled`]); and if inputs and outputs show all states, commands after which states may be read that were not meant,
/// events of the plant that change nothing that can be seen, and commands that undo each other.
#[must_use]
pub fn warnings(plant: &Plant, closed: &ClosedLoop) -> Vec<Diagnostic> {
    let mut found = never_enabled(plant, closed);
    if unreadable(plant).is_empty() {
        effects::doubtful(plant, closed, &mut found);
        unnoticed::warnings(plant, &mut found);
        circles::warnings(plant, closed, &mut found);
    }
    found.sort_by_key(|d| d.span.start);
    found
}

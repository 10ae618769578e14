//! What is worth a look in a specification that is not wrong: warnings, each with its place.
//!
//! Four groups, by what they need to know. None of them changes a verdict or a product.
//!
//! * [`of_text`]: the specification alone. Costs nothing, so every command shows them.
//! * [`of_game`]: all plays of the explored specification.
//! * [`of_controller`]: the plays that a winning strategy leaves.
//! * [`of_assumptions`]: what would be if some scenario were relaxed.
//!
//! A warning that is wrong does more harm than one that is missing: each of these says what is true of the specification
//! at hand, and where that takes a play to see, shows a shortest one.

mod causes;
mod mentions;
mod needed;
mod order;
mod plays;
mod policy;
mod reads;
mod separation;
mod starts;
mod trapped;
mod unused;
mod vacuous;
mod waits;

pub use policy::{Policy, Warning};

use crate::controller::Controller;
use crate::diagnostic::Diagnostic;
use crate::explore::Explored;
use crate::game::Strategy;
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

/// Warnings about what plays of the specification lead to, in the order of their places.
///
/// Costs one more look at every state, and for each event that is asked for and may not happen one more step.
#[must_use]
pub fn of_game(explored: &mut Explored<'_>) -> Vec<Diagnostic> {
    let mut warnings = separation::breaches(explored);
    warnings.extend(starts::never(explored));
    sort(&mut warnings);
    warnings
}

/// Warnings about the system under a winning strategy, in the order of their places. `controller` does what the
/// strategy does and has no states that no environment can tell apart; `warned` is what is known from [`of_game`].
#[must_use]
pub fn of_controller(
    explored: &mut Explored<'_>,
    strategy: &Strategy,
    controller: &Controller,
    warned: &[Diagnostic],
) -> Vec<Diagnostic> {
    let mut warnings = vacuous::guarantees(explored, strategy, warned);
    warnings.extend(trapped::environment(explored, strategy));
    warnings.extend(order::differences(explored, strategy, controller));
    sort(&mut warnings);
    warnings
}

/// Warnings about assumptions that a realizable specification does not need. `warned` is what is known from [`of_text`] and
/// [`of_game`].
///
/// Explores and solves once more for each assumption; nothing is said of a specification for which that is too much.
#[must_use]
pub fn of_assumptions(explored: &Explored<'_>, warned: &[Diagnostic]) -> Vec<Diagnostic> {
    needed::unneeded(explored, warned)
}

/// Into the order of their places.
pub fn sort(warnings: &mut [Diagnostic]) {
    warnings.sort_by_key(|warning| (warning.span.file, warning.span.start, warning.code));
}

#[cfg(test)]
mod tests;

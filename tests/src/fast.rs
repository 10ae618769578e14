//! The real pipeline in the shape that tests want.

use synth_core::diagnostic::{Code, render};
use synth_core::model::Spec;
use synth_core::pipeline::{Failure, Options, Solved, Timings, play_and_solve, specification};
use synth_core::playout::Semantics;
use synth_core::syntax::{Loaded, load};

/// Loads a text without imports.
#[must_use]
pub fn loaded(text: &str) -> Loaded {
    load("spec.sml", text.as_bytes(), &mut |path| Err(format!("{path}: tests import nothing")))
}

/// The resolved specification.
///
/// # Errors
/// The diagnostics as they are shown.
pub fn resolved(text: &str) -> Result<Spec, String> {
    let loaded = loaded(text);
    specification(&loaded).map_err(|failure| render(&failure.diagnostics(), &loaded.sources, false))
}

/// Options with these semantics and at most so many states.
#[must_use]
pub fn options(classic: bool, states: usize) -> Options {
    let mut options = Options { semantics: Semantics { classic }, ..Options::default() };
    options.limits.states = states;
    options
}

/// The solved game.
///
/// # Errors
/// As [`play_and_solve`].
pub fn solved<'s>(spec: &'s Spec, options: &Options) -> Result<Solved<'s>, Failure> {
    play_and_solve(spec, options, &mut Timings::default())
}

/// Whether the system wins only by a super step that never ends, so that there is no controller.
#[must_use]
pub fn is_endless(failure: &Failure) -> bool {
    failure.diagnostics().iter().any(|diagnostic| diagnostic.code == Code::EndlessSuperStep)
}

//! What subcommands do with plants: state feedback instead of play-out.

pub(super) mod check;
mod explanation;
pub(super) mod export;
pub(super) mod follow;
mod modular;
pub(super) mod names;
pub(super) mod play;
pub(super) mod rungs;
pub(super) mod supervise;

use crate::failure::Failure;
use crate::session::Session;
use synth_core::pipeline;
use synth_core::plant::{ClosedLoop, Options, Plant, StateFeedback};

/// Refuses options, each with whether it is given, that mean something to specifications only.
pub(super) fn refuse(options: &[(&str, bool)]) -> Result<(), Failure> {
    refuse_given(options.iter().copied(), "a plant")
}

/// Refuses options, each with whether it is given, that mean nothing to something.
fn refuse_given<'o>(
    options: impl IntoIterator<Item = (&'o str, bool)>,
    something: &str,
) -> Result<(), Failure> {
    match options.into_iter().find(|(_, is_given)| *is_given) {
        Some((option, _)) => Err(Failure::usage(format!("`{option}` means nothing to {something}"))),
        None => Ok(()),
    }
}

/// A plant under control.
struct Controlled {
    closed: ClosedLoop,
    /// None for a plant that declares no signals: it is meant for controllers that follow events.
    feedback: Option<StateFeedback>,
}

/// The feedback, and the program that does it if the plant has signals.
fn control(plant: &Plant, options: Options, session: &mut Session) -> Result<Controlled, pipeline::Failure> {
    if plant.signals.is_empty() {
        return Ok(Controlled { closed: session.feedback(plant)?, feedback: None });
    }
    let supervised = session.control(plant, options)?;
    Ok(Controlled { closed: supervised.closed, feedback: Some(supervised.feedback) })
}

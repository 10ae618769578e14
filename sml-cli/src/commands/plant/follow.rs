//! Controllers that follow the events of a plant instead of reading its states.

use crate::failure::Failure;
use crate::session::{ReadPlant, Session};
use clap::ValueEnum;
use synth_core::controller::tables::{Provenance, Tables};
use synth_core::controller::{Controller, Level};
use synth_core::diagnostic::Diagnostic;
use synth_core::plant::event_based;

/// What a controller goes by.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub(crate) enum Follow {
    /// Rungs, which read the states of the plant from inputs and outputs in every scan
    States,
    /// Tables, which know the state of the plant from the events that have happened
    Events,
}

impl Follow {
    /// Whether an option asks for tables.
    pub(crate) fn events(given: Option<Follow>) -> bool {
        given == Some(Follow::Events)
    }
}

/// Refuses the option, for a specification.
pub(in crate::commands) fn refuse(given: Option<Follow>) -> Result<(), Failure> {
    super::refuse_given([("--follow", given.is_some())], "a specification")
}

/// A controller as tables, with what it is warned of.
pub(in crate::commands) struct Followed {
    pub(in crate::commands) controller: Controller,
    pub(in crate::commands) tables: Tables,
    /// Of the text, then of the controller.
    pub(in crate::commands) warnings: Vec<Diagnostic>,
}

/// Makes the controller; `options` are those of its origin that outputs repeat.
pub(in crate::commands) fn follow(
    read: &mut ReadPlant,
    level: Level,
    options: &str,
    session: &mut Session,
) -> Result<Followed, Failure> {
    if matches!(level, Level::Assume | Level::Ordered) {
        let name = level.name();
        return Err(Failure::usage(format!(
            "`--minimize {name}` is for specifications, whose assumptions it uses"
        )));
    }
    let ReadPlant { sources, plant, warnings, provenance } = read;
    let followed = session.follow(plant, level).map_err(|failure| Failure::of(&failure, sources))?;
    let mut warnings = std::mem::take(warnings);
    warnings.extend(followed.warnings(plant));
    let options = format!(" --follow events{options}");
    let provenance = event_based::provenance(plant, Provenance { options, ..provenance.clone() });
    let tables = Tables::new(&plant.name, &followed.controller, provenance);
    Ok(Followed { controller: followed.controller, tables, warnings })
}

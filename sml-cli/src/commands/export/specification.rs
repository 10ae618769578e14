//! The controller of a specification.

use super::{Arguments, Layout};
use crate::failure::{Exit, Failure};
use crate::input::Given;
use crate::session::Session;
use crate::warnings;
use synth_core::controller::tables::{Provenance, Tables};
use synth_core::pipeline::provenance;

pub(super) fn run(arguments: &Arguments, given: &Given, session: &mut Session) -> Result<Exit, Failure> {
    let layout = Layout::new(arguments)?;
    let loaded = session.parse(given);
    let spec = session.specification(&loaded)?;
    let mut solved = session.solve(&loaded, &spec)?;
    let controller = session.synthesize(&loaded, &mut solved, layout.level)?.controller;
    let policy = arguments.warnings.policy();
    let warnings = session.warnings_beside(&loaded, &mut solved, &policy)?;
    warnings::show(warnings, &policy, &loaded.sources, session)?;
    let options = arguments.general_options(session);
    let provenance = Provenance { options, ..provenance(&loaded, &spec, layout.level) };
    layout.write(&Tables::new(&spec.name, &controller, provenance), &controller, session)
}

//! The controller of a specification.

use super::{Arguments, Layout};
use crate::failure::{Exit, Failure};
use crate::input::Given;
use crate::session::Session;
use crate::warnings;
use synth_core::pipeline::{Options, tables};

pub(super) fn run(arguments: &Arguments, given: &Given, session: &mut Session) -> Result<Exit, Failure> {
    let layout = Layout::new(arguments)?;
    let loaded = session.parse(given);
    let spec = session.specification(&loaded)?;
    let mut solved = session.solve(&loaded, &spec)?;
    let how = Options { monitor: arguments.monitor, ..session.options(layout.level) };
    let controller = session.synthesize(&loaded, &mut solved, &how)?.controller;
    let policy = arguments.warnings.policy();
    let warnings = session.warnings_beside(&loaded, &mut solved, &policy)?;
    warnings::show(warnings, &policy, &loaded.sources, session)?;
    let mut tables = tables(&loaded, &spec, &how, &controller);
    tables.provenance.options = arguments.general_options(session);
    layout.write(&tables, &controller, session)
}

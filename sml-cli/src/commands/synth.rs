//! `sml synth`: a verified controller as JSON.

use crate::failure::{Exit, Failure};
use crate::options::Minimize;
use crate::output;
use crate::session::Session;
use crate::warnings::{self, Warnings};
use std::path::PathBuf;
use synth_core::controller::json::write_json_at;
use synth_core::diagnostic::counted;
use synth_core::verdict::Verdict;

/// Arguments of `sml synth`.
#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    /// The specification; `-` is stdin
    file: PathBuf,
    /// Where to write; stdout otherwise
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    /// Explore only until the system is known to win, and take the strategy found there; the controller knows no other events
    #[arg(long, conflicts_with_all = ["deny", "deny_warnings"])]
    early: bool,
    #[command(flatten)]
    minimize: Minimize,
    #[command(flatten)]
    warnings: Warnings,
}

pub(super) fn run(arguments: &Arguments, session: &mut Session) -> Result<Exit, Failure> {
    let level = arguments.minimize.level();
    output::refuse(arguments.output.as_deref(), &arguments.file)?;
    let loaded = session.load(&arguments.file)?;
    let spec = session.specification(&loaded)?;
    let (mut solved, searched) = if arguments.early {
        session.solve_early(&loaded, &spec)?
    } else {
        (session.solve(&loaded, &spec)?, None)
    };
    let verified = session.synthesize(&loaded, &mut solved, &session.options(level))?;
    let policy = arguments.warnings.policy();
    let warnings = session.warnings_beside(&loaded, &mut solved, &policy)?;
    warnings::show(warnings, &policy, &loaded.sources, session)?;
    let controller = &verified.controller;
    let output = arguments.output.as_deref();
    session.stage("write", || output::product_by(output, |out| write_json_at(controller, level, out)))?;
    let rows: usize = controller.environment.iter().map(Vec::len).sum();
    output::note(&format!(
        "{}: {}, {} before minimisation; {} for events, {}; verified with {}",
        spec.name,
        counted(controller.states as usize, "state"),
        verified.unminimized_states,
        counted(rows, "row"),
        counted(controller.super_steps.len(), "super step"),
        counted(verified.product_nodes, "node"),
    ));
    if let Some(Verdict { found, explored, .. }) = searched {
        let found = counted(found, "state");
        output::note(&format!("{}: {found} were found, and {explored} of these explored", spec.name));
    }
    Ok(Exit::Done)
}

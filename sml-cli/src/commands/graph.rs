//! `sml graph`: the explicit game as JSON.

use crate::failure::{Exit, Failure};
use crate::output;
use crate::session::Session;
use std::path::PathBuf;
use synth_core::explore::write_json;

/// Arguments of `sml graph`.
#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    /// The specification; `-` is stdin
    file: PathBuf,
}

pub(super) fn run(arguments: &Arguments, session: &mut Session) -> Result<Exit, Failure> {
    let loaded = session.load(&arguments.file)?;
    let spec = session.specification(&loaded)?;
    let explored = session.explore(&loaded, &spec)?;
    output::stream(|out| write_json(&explored, out))?;
    Ok(Exit::Done)
}

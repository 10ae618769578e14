//! `sml supervise`: state feedback, not there yet.

use crate::failure::{Exit, Failure};
use std::path::PathBuf;

/// Arguments of `sml supervise`.
#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    /// The plant
    file: PathBuf,
}

pub(super) fn run() -> Result<Exit, Failure> {
    Err(Failure::unsupported("sml supervise"))
}

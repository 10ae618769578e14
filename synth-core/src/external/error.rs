//! What can go wrong.

use crate::explore::ExploreError;
use std::io;
use std::path::PathBuf;

/// Why exploration on disk stopped.
#[derive(Debug)]
pub enum ExternalError {
    /// A mistake of the specification, or a limit; what was found until a limit was reached can be resumed.
    Explore(ExploreError),
    /// Somebody asked to stop; what was found can be resumed.
    Stopped(Progress),
    /// The folder has a checkpoint of something else, which this says.
    Other(PathBuf, &'static str),
    /// A file is not what was written.
    Damaged(PathBuf, String),
    /// A file or folder cannot be read.
    Read(PathBuf, io::Error),
    /// A file or folder cannot be written.
    Write(PathBuf, io::Error),
}

/// How far exploration came.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Progress {
    /// States found.
    pub states: u64,
    /// Those of them whose moves were counted.
    pub explored: u64,
    /// Transitions found.
    pub transitions: u64,
    /// Layers finished, each a step further from the initial state.
    pub layers: usize,
}

pub(super) type Result<T> = std::result::Result<T, ExternalError>;

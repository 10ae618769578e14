//! What runs programs.

use std::time::Duration;

/// A task of the configuration.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Task {
    /// Its name.
    pub name: String,
    /// `INTERVAL`: how often it runs.
    pub interval: Option<Duration>,
    /// `PRIORITY`: 0 is the most urgent.
    pub priority: u32,
    /// The names of the programs that run with it, in the order of the text.
    pub programs: Vec<String>,
}

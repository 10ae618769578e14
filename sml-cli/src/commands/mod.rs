//! The subcommands.

mod check;
mod cycle;
mod explain;
mod export;
mod graph;
mod names;
mod plant;
mod play;
mod synth;
mod verify;

use crate::failure::{Exit, Failure};
use crate::session::Session;
use clap::Subcommand;

/// What to do.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Read, explore and solve a specification; print the verdict, figures and warnings
    Check(check::Arguments),
    /// Make a verified, minimised controller, as JSON
    Synth(synth::Arguments),
    /// Check any controller against a specification
    Verify(verify::Arguments),
    /// Print the explicit game as JSON
    Graph(graph::Arguments),
    /// Run a controller cycle by cycle through a stimulus
    Cycle(cycle::Arguments),
    /// Print the map of generated names as JSON
    Names(names::Arguments),
    /// Write the controller for a target
    Export(export::Arguments),
    /// Play a specification out, by hand or by script
    Play(play::Arguments),
    /// Make a state-feedback controller for a plant
    Supervise(plant::supervise::Arguments),
    /// Print the long text of a diagnostic
    Explain(explain::Arguments),
}

/// Runs a subcommand.
pub(crate) fn run(command: &Command, session: &mut Session) -> Result<Exit, Failure> {
    match command {
        Command::Check(arguments) => check::run(arguments, session),
        Command::Synth(arguments) => synth::run(arguments, session),
        Command::Verify(arguments) => verify::run(arguments, session),
        Command::Graph(arguments) => graph::run(arguments, session),
        Command::Cycle(arguments) => cycle::run(arguments, session),
        Command::Names(arguments) => names::run(arguments, session),
        Command::Export(arguments) => export::run(arguments, session),
        Command::Play(arguments) => play::run(arguments, session),
        Command::Supervise(arguments) => plant::supervise::run(arguments, session),
        Command::Explain(arguments) => explain::run(arguments, session),
    }
}

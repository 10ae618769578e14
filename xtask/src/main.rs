//! Tasks of this repository that are programs.
//!
//! `cargo xtask bare-metal setup` brings what firmware needs, `cargo xtask bare-metal test` builds it, runs it in an
//! emulator and measures it. `cargo xtask msrv` compiles the runtime and generated modules with the oldest compiler that they
//! are for. `cargo xtask compare` measures other ways to write a state machine beside these tables.
//! `cargo xtask performance` measures synthesis on families of specifications that grow.

mod bare_metal;
mod compare;
mod failure;
mod msrv;
mod performance;
mod plot;
mod process;
mod progress;

use bare_metal::target::{self, Target};
use clap::{Parser, Subcommand};
use std::process::ExitCode;

/// Tasks of this repository.
#[derive(Parser)]
#[command(name = "cargo xtask")]
enum Task {
    /// The firmware: built for microcontrollers, run in an emulator, measured.
    #[command(subcommand)]
    BareMetal(BareMetal),
    /// Compile the runtime, and a generated module of each engine, with the oldest compiler that they are for.
    Msrv,
    /// One controller as tables of this project and as other state machines: flash, RAM, instructions, compile time.
    Compare(compare::Options),
    /// Time, memory and instructions of each stage on families of specifications that grow.
    Performance(performance::Options),
}

#[derive(Subcommand)]
enum BareMetal {
    /// Fetch a compiler, its core library for each target, and an emulator, into the target folder.
    Setup {
        /// Targets; all of them if none is named
        #[arg(value_name = "TARGET", value_parser = target::by_name)]
        targets: Vec<&'static Target>,
    },
    /// Build and run every program, and compare its output, sizes and instruction counts with those expected.
    Test {
        /// Targets; all of them if none is named
        #[arg(value_name = "TARGET", value_parser = target::by_name)]
        targets: Vec<&'static Target>,
        /// Make what comes out what is expected
        #[arg(long)]
        bless: bool,
    },
}

fn main() -> ExitCode {
    let done = match Task::parse() {
        Task::BareMetal(BareMetal::Setup { targets }) => bare_metal::setup(&or_all(targets)),
        Task::BareMetal(BareMetal::Test { targets, bless }) => bare_metal::test(&or_all(targets), bless),
        Task::Msrv => msrv::check(),
        Task::Compare(options) => compare::run(&options),
        Task::Performance(options) => performance::run(&options),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("{failure}");
            ExitCode::FAILURE
        }
    }
}

fn or_all(targets: Vec<&'static Target>) -> Vec<&'static Target> {
    if targets.is_empty() { target::ALL.iter().collect() } else { targets }
}

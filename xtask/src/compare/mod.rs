//! The same controller as tables of this project and as other state machines: each built for a Cortex-M3 in the same
//! program, checked against the same run of events in the emulator, and measured.
//!
//! `docs/comparison.md` says what is compared and how.

mod figures;
mod line;
pub(crate) mod machines;
mod measure;
mod page;
mod run;
mod subject;
mod verdict;

use crate::bare_metal::folders::Folders;
use crate::failure::{At, Failure, Result};
use crate::progress::Progress;
use figures::{Figures, Outcome, Report};
use machines::Machine;
use measure::Bench;
use std::fs;

/// Transitions of the controllers.
const SIZES: [u32; 4] = [50, 500, 5_000, 50_000];

/// What is compared.
#[derive(clap::Args)]
pub(crate) struct Options {
    /// Transitions of the controller; 50, 500, 5000 and 50000 if none is named
    #[arg(long, value_name = "NUMBER", value_parser = clap::value_parser!(u32).range(1..=50_000))]
    transitions: Vec<u32>,
    /// Machines; all of them if none is named
    #[arg(long = "machine", value_name = "NAME", value_parser = machines::by_name)]
    machines: Vec<Machine>,
    /// Write nothing; fail if a machine of this project takes more than is written, by more than a tenth
    #[arg(long)]
    check: bool,
}

/// Measures, and writes figures, page and plots; what is not measured stays as it is.
pub(crate) fn run(options: &Options) -> Result<()> {
    let sizes = if options.transitions.is_empty() { &SIZES[..] } else { &options.transitions };
    let machines = if options.machines.is_empty() { &machines::ALL[..] } else { &options.machines };
    let progress = Progress::new();
    progress.tell("compiling what all programs have in common");
    let bench = Bench::new(if options.check { 1 } else { measure::REPETITIONS })?;
    let file = page::figures(&Folders::new());
    let mut report = Report::read(&file)?;
    let mut failed = false;
    for &transitions in sizes {
        let size = bench.size(transitions)?;
        progress.tell("");
        println!(
            "{transitions} transitions: {} states, {} super steps, {} events; a run takes {} transitions and is refused {} times",
            size.subject.states,
            size.subject.steps.len(),
            size.subject.events.len(),
            size.run.taken,
            size.run.refused
        );
        for &machine in machines {
            progress.tell(&format!("{transitions} transitions: {}", machine.name()));
            let outcome = bench.measure(&size, machine)?;
            progress.tell("");
            println!("{transitions} {:7} {}", machine.name(), said(outcome));
            if !options.check {
                report.versions = page::versions(&Folders::new(), bench.compiler())?;
                report.set(transitions, machine, outcome);
                report.write(&file)?;
            } else if machine.is_own()
                && let Err(why) = figures::compare(report.get(transitions, machine), outcome)
            {
                failed = true;
                eprintln!("`{}` with {transitions} transitions: {why}", machine.name());
            }
        }
    }
    if failed {
        return Err(Failure::new("a machine takes more than `docs/comparison.md` says")
            .help("look at the difference, then run `cargo xtask compare`"));
    }
    if options.check { Ok(()) } else { write(&report) }
}

fn said(outcome: Outcome) -> String {
    match outcome {
        Outcome::Measured(Figures { flash, ram, least, mean, most, compile }) => format!(
            "flash {flash:8}  RAM {ram}  min {least:3}  mean {mean:3}  max {most:3}  compiled in {compile} ms"
        ),
        Outcome::TooSlow(seconds) => format!("does not compile in {seconds} s"),
    }
}

/// Page and plots.
fn write(report: &Report) -> Result<()> {
    for (path, text) in page::files(&Folders::new(), report)? {
        fs::write(&path, text).doing(format_args!("write `{}`", path.display()))?;
    }
    Ok(())
}

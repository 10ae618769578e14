//! Synthesis on families that grow: time, memory and instructions of each stage, and how small controllers get.
//!
//! `docs/performance.md` says what is measured and how.

mod controllers;
mod growth;
mod guard;
mod instructions;
mod measure;
mod members;
mod page;
mod report;

use crate::bare_metal::folders::Folders;
use crate::failure::{At, Result};
use crate::progress::Progress;
use measure::Bench;
use report::{Outcome, Report, Version};
use std::fs;
use std::path::{Path, PathBuf};

/// What is measured.
#[derive(clap::Args)]
pub(crate) struct Options {
    /// Only members with at most so many states
    #[arg(long, value_name = "NUMBER", default_value_t = 10_000_000)]
    states: u64,
    /// Instructions only of members with at most so many states
    #[arg(long, value_name = "NUMBER", default_value_t = 7_000)]
    counted: u64,
    /// Only members that take moments: the same as `--states 10000 --counted 1500`
    #[arg(long, conflicts_with_all = ["states", "counted"])]
    quick: bool,
    /// Stop a run after so many seconds; larger members of the family are not tried then
    #[arg(long, value_name = "NUMBER", default_value_t = 60)]
    seconds: u64,
    /// Another build of `sml`, older than what is here, to be measured in the same run
    #[arg(long, value_name = "PATH", conflicts_with = "check")]
    before: Option<PathBuf>,
    /// Write nothing; fail if sizes are not those that are written, or if instructions per state grow too much
    #[arg(long, conflicts_with_all = ["states", "counted", "quick"])]
    check: bool,
}

/// Measures, and writes figures, page and plots. What is not measured stays as it is.
pub(crate) fn run(options: &Options) -> Result<()> {
    let progress = Progress::new();
    progress.tell("building the command");
    let bench = Bench::new(options.seconds)?;
    progress.tell("");
    let file = page::figures(&Folders::new());
    let mut report = Report::read(&file)?;
    if options.check {
        return guard::check(&bench, &report);
    }
    let (states, counted) = if options.quick { (10_000, 1_500) } else { (options.states, options.counted) };
    report.with = bench.with()?;
    for (family, _) in members::FAMILIES.iter().enumerate() {
        measure_family(&bench, family, states, options.before.as_deref(), &mut report)?;
        report.write(&file)?;
    }
    controllers::measure(&bench, &mut report)?;
    for member in members::all().filter(|member| member.states() <= counted) {
        match instructions::count(&bench, member, &bench.text(member)?)? {
            Some(counts) => {
                let all: u64 = counts.iter().map(|(_, count)| count).sum();
                println!("{member}: {all} instructions");
                report.instructions.insert(member, counts);
            }
            None => println!("{member}: counting instructions takes more than {} s", options.seconds),
        }
    }
    report.write(&file)?;
    for (path, text) in page::files(&Folders::new(), &report)? {
        fs::write(&path, text).doing(format_args!("write `{}`", path.display()))?;
    }
    Ok(())
}

/// Members of one family, in each version, until one does not come to an end.
fn measure_family(
    bench: &Bench,
    family: usize,
    states: u64,
    before: Option<&Path>,
    report: &mut Report,
) -> Result<()> {
    let members = || members::all().filter(|member| member.family == family && member.states() <= states);
    let all = members::all().filter(|member| member.family == family).count();
    if members().count() < all {
        println!(
            "{}: {} of {all} members have more states",
            members::FAMILIES[family].name,
            all - members().count()
        );
    }
    let mut versions: Vec<(Version, &Path, &[&str])> = vec![(Version::Now, &bench.sml, &[])];
    if members::FAMILIES[family].on_one_thread {
        versions.push((Version::OneThread, &bench.sml, &["--threads", "1"]));
    }
    versions.extend(before.map(|before| (Version::Before, before, &[][..])));
    for (version, sml, options) in versions {
        let mut stopped = false;
        for member in members() {
            let outcome = if stopped {
                Outcome::Untried
            } else {
                bench.run(sml, member, &bench.text(member)?, options)?
            };
            stopped |= outcome.stages().is_none();
            println!("{member} {}: {}", version.name(), said(&outcome));
            report.runs.insert((member, version), outcome);
        }
    }
    Ok(())
}

fn said(outcome: &Outcome) -> String {
    match outcome {
        Outcome::Measured(_) => {
            let states = outcome.explored().map_or(0, |stage| stage.states);
            let milliseconds = outcome.total().unwrap_or_default() as f64 / 1e3;
            format!("{states} states, {milliseconds:.1} ms")
        }
        other => page::unmeasured(other),
    }
}

//! Runs the command and reads what `--timings` says.

use super::members::Member;
use super::report::{Outcome, Stage};
use crate::bare_metal::folders::Folders;
use crate::failure::{At, Failure, Result};
use crate::process;
use serde_json::Value;
use std::fs;
use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// What is short is run several times, and the fastest run counts: what others take more has other reasons.
const REPETITIONS: usize = 5;
const SHORT: u64 = 3_000_000;

/// Between two looks at a run.
const PAUSE: Duration = Duration::from_millis(5);

/// What is measured with.
pub(super) struct Bench {
    folders: Folders,
    /// The command.
    pub(super) sml: PathBuf,
    /// Seconds after which a run is stopped.
    pub(super) seconds: u64,
}

impl Bench {
    /// Builds the command.
    pub(super) fn new(seconds: u64) -> Result<Bench> {
        let folders = Folders::new();
        let folder = folders.performance();
        fs::create_dir_all(&folder).doing(format_args!("create `{}`", folder.display()))?;
        let mut build = Command::new("cargo");
        process::text(
            build.args(["build", "--quiet", "--release", "-p", "sml-cli"]).current_dir(&folders.repository),
        )?;
        let sml = folders.release().join("sml");
        Ok(Bench { folders, sml, seconds })
    }

    /// The file of a member.
    pub(super) fn text(&self, member: Member) -> Result<PathBuf> {
        let mut print = Command::new("cargo");
        print.args(["run", "--quiet", "-p", "sml-tests", "--example", "family", "--"]).args(member.command());
        let text = process::text(print.current_dir(&self.folders.repository))?;
        let file = self.folders.performance().join(member.file());
        fs::write(&file, text).doing(format_args!("write `{}`", file.display()))?;
        Ok(file)
    }

    /// A file of the repository.
    pub(super) fn repository(&self, path: &str) -> PathBuf {
        self.folders.repository.join(path)
    }

    /// A file beside the members.
    pub(super) fn file(&self, name: &str) -> PathBuf {
        self.folders.performance().join(name)
    }

    /// Compiler and computer.
    pub(super) fn with(&self) -> Result<String> {
        let compiler = process::text(Command::new("rustc").arg("--version"))?;
        let compiler: Vec<&str> = compiler.split(' ').take(2).collect();
        let cores = std::thread::available_parallelism().map_or(1, std::num::NonZeroUsize::get);
        Ok(format!("{}, {cores} processor{}", compiler.join(" "), if cores == 1 { "" } else { "s" }))
    }

    /// From the text to the product.
    pub(super) fn run(&self, sml: &Path, member: Member, text: &Path, options: &[&str]) -> Result<Outcome> {
        let mut best = self.once(sml, member, text, options)?;
        for _ in 1..REPETITIONS {
            let Some(total) = best.total().filter(|total| *total < SHORT) else { break };
            let again = self.once(sml, member, text, options)?;
            if again.total().is_some_and(|again| again < total) {
                best = again;
            }
        }
        Ok(best)
    }

    fn once(&self, sml: &Path, member: Member, text: &Path, options: &[&str]) -> Result<Outcome> {
        let mut command = Command::new(sml);
        command.args(self.arguments(member, text)).args(options);
        let Some((status, said)) = self.bounded(&mut command)? else {
            return Ok(Outcome::Stopped(self.seconds));
        };
        match status.code() {
            Some(0) => Ok(Outcome::Measured(stages(&said)?)),
            Some(code) => Ok(Outcome::Ended(code)),
            None => Err(Failure::new(format!("`{}` was killed: {said}", sml.display()))),
        }
    }

    /// The subcommand with its arguments.
    pub(super) fn arguments(&self, member: Member, text: &Path) -> Vec<PathBuf> {
        let rest = ["--timings", "--format", "json"].map(PathBuf::from);
        let mut arguments = if member.family().is_of_plants() {
            vec!["check".into(), text.to_owned()]
        } else {
            vec!["synth".into(), text.to_owned(), "-o".into(), self.file("controller.json")]
        };
        arguments.extend(rest);
        arguments
    }

    /// Runs a command; what it writes to stderr; none if it takes too long.
    pub(super) fn bounded(&self, command: &mut Command) -> Result<Option<(ExitStatus, String)>> {
        let name = command.get_program().to_string_lossy().into_owned();
        let mut child = command
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .doing(format_args!("run `{name}`"))?;
        let status =
            wait(&mut child, Duration::from_secs(self.seconds)).doing(format_args!("run `{name}`"))?;
        let mut said = String::new();
        if let Some(mut stderr) = child.stderr.take() {
            stderr.read_to_string(&mut said).doing(format_args!("read what `{name}` says"))?;
        }
        Ok(status.map(|status| (status, said)))
    }
}

/// Waits for the end, or stops it.
fn wait(child: &mut Child, most: Duration) -> std::io::Result<Option<ExitStatus>> {
    let start = Instant::now();
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status));
        }
        if start.elapsed() > most {
            child.kill()?;
            child.wait()?;
            return Ok(None);
        }
        sleep(PAUSE);
    }
}

/// The stages in the last line of stderr.
pub(super) fn stages(said: &str) -> Result<Vec<Stage>> {
    let wrong = || Failure::new(format!("`--timings` cannot be read: {said}"));
    let line = said.lines().last().ok_or_else(wrong)?;
    let timings: Value = serde_json::from_str(line).map_err(|_| wrong())?;
    let stage = |stage: &Value| {
        let number = |field: &str| stage[field].as_u64().unwrap_or_default();
        Some(Stage {
            name: stage["stage"].as_str()?.to_owned(),
            micros: (stage["milliseconds"].as_f64()? * 1e3).round() as u64,
            peak: number("peak_bytes"),
            states: number("states"),
            transitions: number("transitions"),
            of_states: number("bytes_of_states"),
            of_transitions: number("bytes_of_transitions"),
        })
    };
    let stages = timings["timings"].as_array().ok_or_else(wrong)?;
    stages.iter().map(stage).collect::<Option<_>>().ok_or_else(wrong)
}

#[cfg(test)]
mod tests {
    use super::{Stage, stages};

    #[test]
    fn the_last_line_has_the_stages() {
        let said = "a warning\n{\"version\":1,\"milliseconds\":2.0,\"timings\":[{\"stage\":\"explore\",\
                    \"milliseconds\":1.5,\"peak_bytes\":7,\"states\":3,\"transitions\":4,\"bytes_of_states\":5,\
                    \"bytes_of_transitions\":6},{\"stage\":\"number\",\"milliseconds\":0.5,\"peak_bytes\":null}]}\n";
        let explore = Stage {
            name: "explore".to_owned(),
            micros: 1500,
            peak: 7,
            states: 3,
            transitions: 4,
            of_states: 5,
            of_transitions: 6,
        };
        let number = Stage { name: "number".to_owned(), micros: 500, ..Stage::default() };
        assert_eq!(stages(said).unwrap(), [explore, number]);
        assert!(stages("").is_err());
    }
}

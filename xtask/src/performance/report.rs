//! What was measured, in a file of lines `what …`, from which the page and the plots are made.

use super::controllers::Size;
use super::members::Member;
use crate::failure::{At, Failure, Result};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

/// How the command ran.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum Version {
    /// As it is.
    Now,
    /// On one thread.
    OneThread,
    /// Another build of it.
    Before,
}

const VERSIONS: [(Version, &str); 3] =
    [(Version::Now, "now"), (Version::OneThread, "one-thread"), (Version::Before, "before")];

impl Version {
    pub(super) fn name(self) -> &'static str {
        VERSIONS.iter().find(|(version, _)| *version == self).map_or("", |(_, name)| name)
    }

    fn called(name: &str) -> Option<Version> {
        VERSIONS.iter().find(|(_, each)| *each == name).map(|(version, _)| *version)
    }
}

/// A stage, as `--timings` tells of it; 0 where it tells nothing.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub(super) struct Stage {
    pub(super) name: String,
    pub(super) micros: u64,
    /// Most bytes of the process up to its end.
    pub(super) peak: u64,
    pub(super) states: u64,
    pub(super) transitions: u64,
    pub(super) of_states: u64,
    pub(super) of_transitions: u64,
}

/// What came of a run.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Outcome {
    Measured(Vec<Stage>),
    /// It was stopped after so many seconds.
    Stopped(u64),
    /// It ended with this exit code; 3 is a limit on memory.
    Ended(i32),
    /// A smaller member had been stopped or had ended so.
    Untried,
}

impl Outcome {
    pub(super) fn stages(&self) -> Option<&[Stage]> {
        match self {
            Outcome::Measured(stages) => Some(stages),
            _ => None,
        }
    }

    /// The stage of this name, the last if it ran more than once.
    pub(super) fn stage(&self, name: &str) -> Option<&Stage> {
        self.stages()?.iter().rfind(|stage| stage.name == name)
    }

    /// Microseconds of all stages.
    pub(super) fn total(&self) -> Option<u64> {
        Some(self.stages()?.iter().map(|stage| stage.micros).sum())
    }

    /// Most bytes of the process.
    pub(super) fn peak(&self) -> Option<u64> {
        self.stages()?.last().map(|stage| stage.peak)
    }

    /// What finds the states: exploration of the game, or synthesis of a feedback and what follows its plays.
    pub(super) fn explored(&self) -> Option<Stage> {
        if let Some(explored) = self.stage("explore") {
            return Some(explored.clone());
        }
        let supervised = self.stage("supervise")?;
        Some(match self.stage("close") {
            Some(closed) => Stage { micros: supervised.micros + closed.micros, ..closed.clone() },
            None => supervised.clone(),
        })
    }
}

/// Stages of [`Outcome::explored`].
pub(super) const EXPLORING: [&str; 3] = ["explore", "supervise", "close"];

/// Instructions of each stage, in order; a stage can run twice.
pub(super) type Instructions = Vec<(String, u64)>;

/// All that was measured.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub(super) struct Report {
    /// Compiler and computer.
    pub(super) with: String,
    pub(super) runs: BTreeMap<(Member, Version), Outcome>,
    pub(super) instructions: BTreeMap<Member, Instructions>,
    /// Sizes of controllers, by subject and level.
    pub(super) controllers: BTreeMap<(String, String), Size>,
}

impl Report {
    /// What is written; nothing if there is no file.
    pub(super) fn read(path: &Path) -> Result<Report> {
        let Ok(text) = fs::read_to_string(path) else { return Ok(Report::default()) };
        Report::parse(&text)
            .map_err(|line| Failure::new(format!("cannot read `{line}` in `{}`", path.display())))
    }

    /// Writes it.
    pub(super) fn write(&self, path: &Path) -> Result<()> {
        fs::write(path, self.print()).doing(format_args!("write `{}`", path.display()))
    }

    pub(super) fn parse(text: &str) -> std::result::Result<Report, String> {
        let mut report = Report::default();
        for line in text.lines() {
            report.line(line).ok_or(line)?;
        }
        Ok(report)
    }

    fn line(&mut self, line: &str) -> Option<()> {
        let (what, rest) = line.split_once(' ')?;
        let words: Vec<&str> = rest.split(' ').collect();
        match (what, words.as_slice()) {
            ("with", _) => rest.clone_into(&mut self.with),
            ("controller", [subject, level, size @ ..]) => {
                let size = match size {
                    ["none"] => Size::None,
                    [states, waiting] => {
                        Size::Of { states: states.parse().ok()?, waiting: waiting.parse().ok()? }
                    }
                    _ => return None,
                };
                self.controllers.insert(((*subject).to_owned(), (*level).to_owned()), size);
            }
            ("instructions", [family, number, count, name @ ..]) => {
                let counts = self.instructions.entry(Member::called(family, number)?).or_default();
                counts.push((name.join(" "), count.parse().ok()?));
            }
            ("stopped", [family, number, version, seconds]) => {
                let key = (Member::called(family, number)?, Version::called(version)?);
                self.runs.insert(key, Outcome::Stopped(seconds.parse().ok()?));
            }
            ("ended", [family, number, version, code]) => {
                let key = (Member::called(family, number)?, Version::called(version)?);
                self.runs.insert(key, Outcome::Ended(code.parse().ok()?));
            }
            ("untried", [family, number, version]) => {
                let key = (Member::called(family, number)?, Version::called(version)?);
                self.runs.insert(key, Outcome::Untried);
            }
            ("stage", [family, number, version, figures @ ..]) => {
                let key = (Member::called(family, number)?, Version::called(version)?);
                let stage = stage(figures)?;
                match self.runs.entry(key).or_insert(Outcome::Measured(Vec::new())) {
                    Outcome::Measured(stages) => stages.push(stage),
                    _ => return None,
                }
            }
            _ => return None,
        }
        Some(())
    }

    pub(super) fn print(&self) -> String {
        let mut text = format!("with {}\n", self.with);
        for ((member, version), outcome) in &self.runs {
            let of = format!("{member} {}", version.name());
            let _ = match outcome {
                Outcome::Stopped(seconds) => writeln!(text, "stopped {of} {seconds}"),
                Outcome::Ended(code) => writeln!(text, "ended {of} {code}"),
                Outcome::Untried => writeln!(text, "untried {of}"),
                Outcome::Measured(stages) => stages.iter().try_for_each(|stage| {
                    let Stage { name, micros, peak, states, transitions, of_states, of_transitions } = stage;
                    writeln!(
                        text,
                        "stage {of} us {micros} peak {peak} states {states} of {of_states} \
                         transitions {transitions} of {of_transitions} {name}"
                    )
                }),
            };
        }
        for (member, counts) in &self.instructions {
            for (name, count) in counts {
                let _ = writeln!(text, "instructions {member} {count} {name}");
            }
        }
        for ((subject, level), size) in &self.controllers {
            let _ = match size {
                Size::None => writeln!(text, "controller {subject} {level} none"),
                Size::Of { states, waiting } => {
                    writeln!(text, "controller {subject} {level} {states} {waiting}")
                }
            };
        }
        text
    }
}

fn stage(words: &[&str]) -> Option<Stage> {
    let number = |word: &str| word.parse().ok();
    let [
        "us",
        micros,
        "peak",
        peak,
        "states",
        states,
        "of",
        of_states,
        "transitions",
        transitions,
        "of",
        of_transitions,
        name @ ..,
    ] = words
    else {
        return None;
    };
    Some(Stage {
        name: name.join(" "),
        micros: number(micros)?,
        peak: number(peak)?,
        states: number(states)?,
        transitions: number(transitions)?,
        of_states: number(of_states)?,
        of_transitions: number(of_transitions)?,
    })
}

#[cfg(test)]
mod tests {
    use super::{Member, Outcome, Report, Version};

    #[test]
    fn what_is_written_is_read() {
        let text = "with rustc 1.96.0, 2 cores\n\
                    stage line 2 now us 30 peak 1000 states 10 of 80 transitions 20 of 160 explore\n\
                    stage line 2 now us 12 peak 2000 states 0 of 0 transitions 0 of 0 verify unminimised\n\
                    stopped lift 15 before 60\n\
                    ended arbiter 15 one-thread 3\n\
                    untried arbiter 17 one-thread\n\
                    instructions line 2 123 verify unminimised\n\
                    controller production-cell exact 200 96\n\
                    controller production-cell ordered none\n";
        let report = Report::parse(text).unwrap();
        assert_eq!(report.print(), text);
        let outcome = &report.runs[&(Member::called("line", "2").unwrap(), Version::Now)];
        assert_eq!((outcome.total(), outcome.peak()), (Some(42), Some(2000)));
        assert_eq!(outcome.explored().unwrap().transitions, 20);
        assert_eq!(outcome.stage("verify unminimised").unwrap().micros, 12);
        let lift = &report.runs[&(Member::called("lift", "15").unwrap(), Version::Before)];
        assert_eq!((lift, lift.total()), (&Outcome::Stopped(60), None));
        for wrong in ["stage line 2 now us 30 explore", "stopped line 2 now", "stopped row 2 now 1", "what 1"]
        {
            assert_eq!(Report::parse(wrong), Err(wrong.to_owned()));
        }
    }
}

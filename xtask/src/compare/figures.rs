//! What was measured, in a file of lines `transitions machine figures`, from which the page and the plots are made.

use super::machines::{self, Machine};
use crate::failure::{At, Failure, Result};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

/// How much more a machine of this project may take than is written, in percent.
const TOLERANCE: u64 = 10;

/// What one machine takes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Figures {
    /// Bytes of code and tables.
    pub(crate) flash: u64,
    /// Bytes of the value, and of everything else in RAM.
    pub(crate) ram: u64,
    /// Instructions of a step.
    pub(crate) least: u64,
    pub(crate) mean: u64,
    pub(crate) most: u64,
    /// User CPU time of the compiler in milliseconds, over that for an empty crate.
    pub(crate) compile: u64,
}

/// What came of a machine.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Outcome {
    Measured(Figures),
    /// The compiler was stopped after so many seconds of CPU time.
    TooSlow(u64),
}

impl Outcome {
    pub(crate) fn figures(self) -> Option<Figures> {
        match self {
            Outcome::Measured(figures) => Some(figures),
            Outcome::TooSlow(_) => None,
        }
    }
}

/// All outcomes, and what they were measured with.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub(crate) struct Report {
    /// Compiler and crates with their versions.
    pub(crate) versions: String,
    /// By transitions and place in [`machines::ALL`].
    outcomes: BTreeMap<(u32, usize), Outcome>,
}

const VERSIONS: &str = "with ";

impl Report {
    /// What is written; nothing if there is no file.
    pub(crate) fn read(path: &Path) -> Result<Report> {
        match fs::read_to_string(path) {
            Ok(text) => Report::parse(&text).map_err(|line| Failure::new(format!("cannot read `{line}`"))),
            Err(_) => Ok(Report::default()),
        }
    }

    /// Writes it.
    pub(crate) fn write(&self, path: &Path) -> Result<()> {
        fs::write(path, self.print()).doing(format_args!("write `{}`", path.display()))
    }

    fn parse(text: &str) -> std::result::Result<Report, String> {
        let mut report = Report::default();
        for line in text.lines() {
            match line.strip_prefix(VERSIONS) {
                Some(versions) => versions.clone_into(&mut report.versions),
                None => {
                    let (transitions, machine, outcome) = parse_line(line).ok_or(line)?;
                    report.set(transitions, machine, outcome);
                }
            }
        }
        Ok(report)
    }

    fn print(&self) -> String {
        let mut text = format!("{VERSIONS}{}\n", self.versions);
        for (&(transitions, machine), outcome) in &self.outcomes {
            let name = machines::ALL[machine].name();
            let _ = match outcome {
                Outcome::Measured(Figures { flash, ram, least, mean, most, compile }) => writeln!(
                    text,
                    "{transitions} {name} flash {flash} ram {ram} min {least} mean {mean} max {most} compile {compile}"
                ),
                Outcome::TooSlow(seconds) => writeln!(text, "{transitions} {name} stopped {seconds}"),
            };
        }
        text
    }

    pub(crate) fn set(&mut self, transitions: u32, machine: Machine, outcome: Outcome) {
        let place = machines::ALL.iter().position(|other| *other == machine).unwrap_or_default();
        self.outcomes.insert((transitions, place), outcome);
    }

    pub(crate) fn get(&self, transitions: u32, machine: Machine) -> Option<Outcome> {
        let place = machines::ALL.iter().position(|other| *other == machine)?;
        self.outcomes.get(&(transitions, place)).copied()
    }

    /// Sizes, ascending.
    pub(crate) fn sizes(&self) -> Vec<u32> {
        let mut sizes: Vec<u32> = self.outcomes.keys().map(|(transitions, _)| *transitions).collect();
        sizes.dedup();
        sizes
    }

    /// Machines of one size.
    pub(crate) fn of_size(&self, transitions: u32) -> impl Iterator<Item = (Machine, Outcome)> {
        let range = (transitions, 0)..=(transitions, usize::MAX);
        self.outcomes.range(range).map(|(&(_, machine), &outcome)| (machines::ALL[machine], outcome))
    }
}

fn parse_line(line: &str) -> Option<(u32, Machine, Outcome)> {
    let words: Vec<&str> = line.split(' ').collect();
    let machine = machines::by_name(words.get(1)?).ok()?;
    let number = |word: &str| word.parse().ok();
    let outcome = match words[2..] {
        ["flash", flash, "ram", ram, "min", least, "mean", mean, "max", most, "compile", compile] => {
            Outcome::Measured(Figures {
                flash: number(flash)?,
                ram: number(ram)?,
                least: number(least)?,
                mean: number(mean)?,
                most: number(most)?,
                compile: number(compile)?,
            })
        }
        ["stopped", seconds] => Outcome::TooSlow(number(seconds)?),
        _ => return None,
    };
    Some((words[0].parse().ok()?, machine, outcome))
}

/// Whether a machine takes no more than is written, but for some percent. Compile time depends on the computer.
pub(crate) fn compare(written: Option<Outcome>, now: Outcome) -> std::result::Result<(), String> {
    let (Some(Outcome::Measured(written)), Outcome::Measured(now)) = (written, now) else {
        return Err("it has no figures to compare".to_owned());
    };
    let figures = [
        ("bytes of flash", written.flash, now.flash),
        ("bytes of RAM", written.ram, now.ram),
        ("instructions at least", written.least, now.least),
        ("instructions on average", written.mean, now.mean),
        ("instructions at most", written.most, now.most),
    ];
    match figures.into_iter().find(|(_, written, now)| now * 100 > written * (100 + TOLERANCE)) {
        Some((what, written, now)) => {
            Err(format!("{now} {what} are more than {TOLERANCE} percent above {written}"))
        }
        None => Ok(()),
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::{Figures, Outcome, Report, compare};

    pub(in super::super) fn report(lines: &str) -> Report {
        Report::parse(lines).unwrap()
    }

    #[test]
    fn what_is_written_is_read() {
        let text = "with rustc 1.96.0, smlang 0.8.0\n\
                    50 comb flash 300 ram 4 min 8 mean 20 max 40 compile 12\n\
                    50 match flash 400 ram 1 min 8 mean 20 max 40 compile 12\n\
                    500 smlang stopped 120\n";
        let report = report(text);
        assert_eq!(report.print(), text);
        assert_eq!(report.sizes(), [50, 500]);
        assert_eq!(report.of_size(500).map(|(machine, _)| machine.name()).collect::<Vec<_>>(), ["smlang"]);
        assert_eq!(Report::parse("50 comb flash\n"), Err("50 comb flash".to_owned()));
        assert_eq!(Report::parse("50\n"), Err("50".to_owned()));
    }

    #[test]
    fn figures_are_near() {
        let figures = |flash| {
            Outcome::Measured(Figures { flash, ram: 2, least: 5, mean: 10, most: 20, compile: flash * 100 })
        };
        assert_eq!(compare(Some(figures(100)), figures(110)), Ok(()));
        let why = "111 bytes of flash are more than 10 percent above 100";
        assert_eq!(compare(Some(figures(100)), figures(111)), Err(why.to_owned()));
        assert!(compare(None, figures(1)).is_err());
        assert!(compare(Some(figures(100)), Outcome::TooSlow(1)).is_err());
    }
}

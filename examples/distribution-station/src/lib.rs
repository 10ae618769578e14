//! The distribution station at work: a program without a state of its own drives a simulated station, scan by scan as on a
//! PLC, while a monitor that knows only what is asked of the station in words watches.
//!
//! [`run`] takes any program that does a scan: the generated [`scan`](distribution_station::scan), and the same in another
//! language, if something runs it.
//!
//! `no_std` with `alloc`, so that the whole station also runs on a microcontroller.
#![no_std]

extern crate alloc;

pub mod monitor;
pub mod random;
pub mod station;

include!(concat!(env!("OUT_DIR"), "/distribution_station.rs"));

use crate::distribution_station::{Inputs, Outputs};
use alloc::{borrow::ToOwned, format, string::String, vec::Vec};
use monitor::{Command, Monitor};
use random::Random;
use station::Station;

/// Workpieces whose story is told in full.
const TOLD: u64 = 3;

/// A station that delivers nothing in so many scans has come to a halt.
const PATIENCE: u64 = 2000;

/// A program: reads inputs, and outputs as it left them, and writes outputs.
pub type Scan<'p> = &'p mut dyn FnMut(&Inputs, &mut Outputs);

/// What happened.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Report {
    /// Workpieces at the testing station.
    pub workpieces: u64,
    /// Scans of the program.
    pub scans: u64,
    /// Commands that it has given.
    pub commands: u64,
    /// Scans in which injector or boom was between its switches.
    pub between: u64,
    /// Scans in which several sensors had changed at once.
    pub together: u64,
    /// What the monitor found, and what the station took badly.
    pub violations: Vec<String>,
}

impl core::fmt::Display for Report {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let Report { workpieces, scans, commands, between, together, violations } = self;
        writeln!(
            f,
            "{workpieces} workpieces brought to the testing station in {scans} scans, {commands} commands"
        )?;
        writeln!(f, "{between} scans with injector or boom between two switches")?;
        writeln!(f, "{together} scans in which several sensors had changed at once")?;
        match violations.as_slice() {
            [] => write!(f, "all that is asked of the station held throughout"),
            broken => write!(f, "VIOLATED:\n  {}", broken.join("\n  ")),
        }
    }
}

/// Runs until so many `workpieces` are delivered or something is violated; the first are told of.
pub fn run(program: Scan<'_>, workpieces: u64, random: Random, tell: &mut dyn FnMut(String)) -> Report {
    let mut station = Station::new(random);
    let mut monitor = Monitor::default();
    let mut report = Report::default();
    let mut outputs = Outputs::default();
    let mut seen = station.sensors();
    let mut last_delivery = 0;
    while station.delivered() < workpieces && monitor.violations.is_empty() {
        report.scans += 1;
        let inputs = station.sensors();
        let before = outputs;
        program(&inputs, &mut outputs);
        let changes = changes(&seen, &inputs);
        let commands: Vec<Command> = Command::given(&before, &outputs).collect();
        if station.delivered() < TOLD {
            tell_scan(report.scans, &changes, &commands, tell);
        }
        report.commands += commands.len() as u64;
        report.between += u64::from(station.is_between());
        report.together += u64::from(changes.len() > 1);
        for command in commands {
            monitor.command(&station, &outputs, command);
        }
        seen = inputs;
        let delivered = station.delivered();
        station.advance(&outputs);
        monitor.violations.append(&mut station.accidents());
        if station.delivered() > delivered {
            last_delivery = report.scans;
        } else if report.scans - last_delivery > PATIENCE {
            monitor.violations.push("the station has come to a halt".to_owned());
        }
    }
    report.workpieces = station.delivered();
    report.violations = monitor.violations;
    report
}

/// What the sensors tell that they did not tell before.
fn changes(before: &Inputs, now: &Inputs) -> Vec<&'static str> {
    let changes = [
        (before.x0, now.x0, ["injector leaves the barrel", "injector back at the barrel"]),
        (before.x1, now.x1, ["injector leaves the dock", "injector at the dock"]),
        (before.x2, now.x2, ["boom leaves the dock", "boom at the dock"]),
        (before.x3, now.x3, ["boom leaves the testing station", "boom at the testing station"]),
        (before.x5, now.x5, ["hook free", "hook holds"]),
        (before.x6, now.x6, ["barrel filled", "barrel empty"]),
    ];
    let changes = changes.into_iter().filter(|(before, now, _)| before != now);
    changes.map(|(_, now, texts)| texts[usize::from(now)]).collect()
}

fn tell_scan(scan: u64, changes: &[&str], commands: &[Command], tell: &mut dyn FnMut(String)) {
    if changes.is_empty() && commands.is_empty() {
        return;
    }
    tell(format!("scan {scan:4}  {}", changes.join(", ")));
    for command in commands {
        tell(format!("             => {command}"));
    }
}

#[cfg(test)]
mod tests {
    use super::{Random, Report, run};
    use crate::distribution_station::{Inputs, scan};

    /// The program, with inputs that are not what the sensors say.
    fn run_with(seed: u64, workpieces: u64, mislead: fn(Inputs) -> Inputs) -> Report {
        let mut program = |inputs: &Inputs, outputs: &mut _| {
            scan(&mislead(*inputs), outputs);
        };
        run(&mut program, workpieces, Random::new(seed), &mut |_| {})
    }

    #[test]
    fn requirements_hold_for_many_stations() {
        for seed in 0..20 {
            let report = run_with(seed, 200, |inputs| inputs);
            assert!(report.violations.is_empty(), "seed {seed}: {:?}", report.violations);
            assert_eq!(report.workpieces, 200);
            assert!(report.together > 50, "seed {seed}: the station must try the program");
            assert!(report.between > 1000, "seed {seed}: the station must try the program");
        }
    }

    #[track_caller]
    fn check(mislead: fn(Inputs) -> Inputs, expect: &str) {
        for seed in 0..5 {
            let report = run_with(seed, 100, mislead);
            assert!(report.violations.iter().any(|violation| violation == expect), "{report}");
        }
    }

    #[test]
    fn a_program_that_takes_the_barrel_for_full_is_noticed() {
        check(
            |inputs| Inputs { x6: false, ..inputs },
            "swing the boom to the testing station: the barrel is empty, there is no need to make room",
        );
    }

    #[test]
    fn a_program_that_takes_the_boom_for_gone_is_noticed() {
        check(|inputs| Inputs { x3: !inputs.x2, ..inputs }, "push a workpiece out: the boom is in the way");
    }

    #[test]
    fn a_program_that_takes_the_way_for_the_end_is_noticed() {
        check(
            |inputs| Inputs { x1: !inputs.x0, ..inputs },
            "swing the boom to the dock: a workpiece is on its way to the dock",
        );
    }

    #[test]
    fn a_program_that_sees_no_vacuum_is_noticed() {
        check(|inputs| Inputs { x5: false, ..inputs }, "the station has come to a halt");
    }
}

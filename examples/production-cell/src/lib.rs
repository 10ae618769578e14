//! The production cell at work: a controller drives a simulated plant, cycle by cycle as on a PLC, while a monitor
//! that knows only the informal requirements watches.
//!
//! [`run`] takes anything that [`Controls`] the cell. The generated [`Controller`] does, and
//! so does the same controller in another language, if a program runs it.
//!
//! `no_std` with `alloc`, so that the whole cell also runs on a microcontroller.
#![no_std]

extern crate alloc;

pub mod monitor;
pub mod plant;
pub mod random;

include!(concat!(env!("OUT_DIR"), "/production_cell.rs"));

use crate::production_cell::{Commands, Controller, DepositArmCommand, Event, FeedArmCommand, PressCommand};
use alloc::{borrow::ToOwned, format, string::String, vec::Vec};
use controller_template::Observer;
use monitor::Monitor;
use plant::Plant;
use random::Random;

/// Items whose story is told in full.
const TOLD: u64 = 3;

/// A controller of the cell.
pub trait Controls {
    /// A sensor has changed. `false` if its event was pending already.
    fn raise(&mut self, event: Event) -> bool;

    /// One cycle, of which the observer is told every transition.
    fn cycle<O: Observer<Event, Commands>>(&mut self, observer: &mut O) -> Commands;
}

impl Controls for Controller {
    fn raise(&mut self, event: Event) -> bool {
        Controller::raise(self, event)
    }

    fn cycle<O: Observer<Event, Commands>>(&mut self, observer: &mut O) -> Commands {
        self.cycle_observed(observer)
    }
}

/// What happened.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Report {
    /// Items on the deposit belt.
    pub items: u64,
    /// Cycles of the controller.
    pub cycles: u64,
    /// Events that it has consumed.
    pub events: u64,
    /// Commands that it has issued.
    pub commands: u64,
    /// Cycles in which several sensors changed at once.
    pub together: u64,
    /// What the monitor found, and what the plant took badly.
    pub violations: Vec<String>,
}

impl core::fmt::Display for Report {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let Report { items, cycles, events, commands, together, violations } = self;
        writeln!(f, "{items} items pressed and delivered in {cycles} cycles")?;
        writeln!(f, "{events} events consumed, {commands} commands issued")?;
        writeln!(f, "{together} cycles in which several sensors changed at once")?;
        match violations.as_slice() {
            [] => write!(f, "G1 to G5 held throughout"),
            broken => write!(f, "VIOLATED:\n  {}", broken.join("\n  ")),
        }
    }
}

/// Runs until `items` are delivered or something is violated; the first cycles are told.
pub fn run(
    controller: &mut impl Controls,
    items: u64,
    random: Random,
    tell: &mut dyn FnMut(String),
) -> Report {
    let mut plant = Plant::new(random);
    let mut monitor = Monitor::default();
    let mut report = Report::default();
    while plant.delivered() < items && monitor.violations.is_empty() {
        report.cycles += 1;
        let sensors = plant.advance();
        report.together += u64::from(sensors.len() > 1);
        for event in sensors {
            if !controller.raise(event) {
                monitor.violations.push(format!("`{}` was raised while it was pending", event.text()));
            }
        }
        let mut log = Log { monitor: &mut monitor, consumed: Vec::new() };
        let commands = controller.cycle(&mut log);
        let consumed = log.consumed;
        report.events += consumed.len() as u64;
        if plant.delivered() < TOLD {
            tell_cycle(report.cycles, &consumed, commands, tell);
        }
        report.commands += count(commands);
        commands.dispatch(&mut plant.deposit_arm, &mut plant.feed_arm, &mut plant.press);
        monitor.violations.append(&mut plant.accidents());
        if report.cycles > items.saturating_mul(1000).saturating_add(1000) {
            monitor.violations.push("the cell has come to a halt".to_owned());
        }
    }
    report.items = plant.delivered();
    report.violations = monitor.violations;
    report
}

/// Passes on to the monitor what the controller really did, in order.
struct Log<'m> {
    monitor: &'m mut Monitor,
    consumed: Vec<Event>,
}

impl Observer<Event, Commands> for Log<'_> {
    fn consumed(&mut self, event: Event, _: u32, _: u32) {
        self.monitor.event(event);
        self.consumed.push(event);
    }

    fn stepped(&mut self, commands: Commands, _: u32, _: u32) {
        self.monitor.commands(commands);
    }
}

fn count(commands: Commands) -> u64 {
    let Commands { deposit_arm, feed_arm, press } = commands;
    u64::from(deposit_arm.is_some()) + u64::from(feed_arm.is_some()) + u64::from(press.is_some())
}

fn tell_cycle(cycle: u64, consumed: &[Event], commands: Commands, tell: &mut dyn FnMut(String)) {
    if consumed.is_empty() && commands.is_empty() {
        return;
    }
    let events: Vec<&str> = consumed.iter().map(|event| event.text()).collect();
    let mut issued: Vec<&str> = Vec::new();
    issued.extend(commands.deposit_arm.map(DepositArmCommand::text));
    issued.extend(commands.feed_arm.map(FeedArmCommand::text));
    issued.extend(commands.press.map(PressCommand::text));
    tell(format!("cycle {cycle:4}  {}", events.join(", ")));
    for command in issued {
        tell(format!("              => {command}"));
    }
}

#[cfg(test)]
mod tests {
    use super::{Controller, Random, run};

    #[test]
    fn requirements_hold_for_many_plants() {
        for seed in 0..20 {
            let report = run(&mut Controller::new(), 300, Random::new(seed), &mut |_| {});
            assert!(report.violations.is_empty(), "seed {seed}: {:?}", report.violations);
            assert_eq!(report.items, 300);
            assert!(report.together > 100, "seed {seed}: the plant must try the controller");
        }
    }
}

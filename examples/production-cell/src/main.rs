//! The production cell at work: the generated controller drives a simulated plant, cycle by cycle as on a PLC, while
//! a monitor that knows only the informal requirements watches.
//!
//! `cargo run -p production-cell [-- ITEMS [SEED]]`

mod monitor;
mod plant;
mod random;

include!(concat!(env!("OUT_DIR"), "/production_cell.rs"));

use controller_template::Observer;
use monitor::Monitor;
use plant::Plant;
use production_cell::{Commands, Controller, Event};
use random::Random;
use std::process::ExitCode;

/// Items whose story is told in full.
const TOLD: u64 = 3;

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1).map(|argument| argument.parse::<u64>());
    let (Ok(items), Ok(seed)) = (arguments.next().unwrap_or(Ok(5000)), arguments.next().unwrap_or(Ok(1)))
    else {
        eprintln!("usage: production-cell [ITEMS [SEED]]: both are whole numbers");
        return ExitCode::from(2);
    };
    let report = run(items, Random::new(seed), &mut |line| println!("{line}"));
    println!("\n{report}");
    if report.violations.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// What happened.
struct Report {
    items: u64,
    cycles: u64,
    events: u64,
    commands: u64,
    together: u64,
    violations: Vec<String>,
}

impl std::fmt::Display for Report {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
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

/// Runs until `items` are delivered or something is violated.
fn run(items: u64, random: Random, tell: &mut dyn FnMut(String)) -> Report {
    let mut plant = Plant::new(random);
    let mut controller = Controller::new();
    let mut monitor = Monitor::default();
    let mut report =
        Report { items: 0, cycles: 0, events: 0, commands: 0, together: 0, violations: Vec::new() };
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
        let commands = controller.cycle_observed(&mut log);
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
    issued.extend(commands.deposit_arm.map(production_cell::DepositArmCommand::text));
    issued.extend(commands.feed_arm.map(production_cell::FeedArmCommand::text));
    issued.extend(commands.press.map(production_cell::PressCommand::text));
    tell(format!("cycle {cycle:4}  {}", events.join(", ")));
    for command in issued {
        tell(format!("              => {command}"));
    }
}

#[cfg(test)]
mod tests {
    use super::{Random, run};

    #[test]
    fn requirements_hold_for_many_plants() {
        for seed in 0..20 {
            let report = run(300, Random::new(seed), &mut |_| {});
            assert!(report.violations.is_empty(), "seed {seed}: {:?}", report.violations);
            assert_eq!(report.items, 300);
            assert!(report.together > 100, "seed {seed}: the plant must try the controller");
        }
    }
}

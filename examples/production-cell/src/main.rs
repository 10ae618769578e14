//! Runs the generated controller of the production cell on the simulated plant.
//!
//! `cargo run -p production-cell [-- ITEMS [SEED]]`

use production_cell::production_cell::Controller;
use production_cell::random::Random;
use production_cell::run;
use std::process::ExitCode;

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1).map(|argument| argument.parse::<u64>());
    let (Ok(items), Ok(seed)) = (arguments.next().unwrap_or(Ok(5000)), arguments.next().unwrap_or(Ok(1)))
    else {
        eprintln!("usage: production-cell [ITEMS [SEED]]: both are whole numbers");
        return ExitCode::from(2);
    };
    let report = run(&mut Controller::new(), items, Random::new(seed), &mut |line| println!("{line}"));
    println!("\n{report}");
    if report.violations.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

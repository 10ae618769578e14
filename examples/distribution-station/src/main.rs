//! Runs the generated program of the distribution station on the simulated station.
//!
//! `cargo run -p distribution-station [-- WORKPIECES [SEED]]`

use distribution_station::distribution_station::scan;
use distribution_station::random::Random;
use distribution_station::run;
use std::process::ExitCode;

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1).map(|argument| argument.parse::<u64>());
    let (Ok(workpieces), Ok(seed)) =
        (arguments.next().unwrap_or(Ok(5000)), arguments.next().unwrap_or(Ok(1)))
    else {
        eprintln!("usage: distribution-station [WORKPIECES [SEED]]: both are whole numbers");
        return ExitCode::from(2);
    };
    let mut program = |inputs: &_, outputs: &mut _| {
        scan(inputs, outputs);
    };
    let report = run(&mut program, workpieces, Random::new(seed), &mut |line| println!("{line}"));
    println!("\n{report}");
    if report.violations.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

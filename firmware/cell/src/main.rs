//! The production cell on the chip: the generated controller, the simulated plant and the monitor of the host's
//! example, in the same words.
#![no_std]
#![no_main]

use production_cell::production_cell::Controller;
use production_cell::random::Random;
use production_cell::run;

const ITEMS: u64 = 100;

#[board::entry]
fn main() -> ! {
    rig::heap();
    let report = run(&mut Controller::new(), ITEMS, Random::new(1), &mut |line| board::println!("{line}"));
    board::println!("\n{report}");
    board::end(report.violations.is_empty())
}

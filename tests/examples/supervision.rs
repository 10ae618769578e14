//! How long synthesis takes for families of plants: transfer lines of n machines with buffers of two, n philosophers;
//! then how long it takes to find memory for constraint automata, and how many bits that are.
//!
//! `cargo run --release -p sml-tests --example supervision` prints the best of a few runs, also per edge of the product: the
//! work is linear in the edges. Without `--release` it says how long a build script without optimisation waits.

use sml_tests::plant_families::{buffer, philosophers, random_order, transfer_line};
use std::time::{Duration, Instant};
use synth_core::explore::Limits;
use synth_core::plant::remember::remember;
use synth_core::plant::{Plant, supervise};

fn main() {
    println!("{:24} {:>9} {:>10} {:>9} {:>10} {:>8}", "plant", "states", "edges", "entries", "ms", "ns/edge");
    for machines in 4..=9 {
        report(&format!("line of {machines}"), &transfer_line(machines));
    }
    for count in [4, 6, 8, 10, 12] {
        report(&format!("{count} philosophers"), &philosophers(count));
    }
    println!(
        "\n{:24} {:>9} {:>10} {:>9} {:>10} {:>8}",
        "memory", "entries", "edges", "bits", "ms", "ns/edge"
    );
    for machines in 4..=9 {
        report_memory(&format!("line of {machines}"), &transfer_line(machines));
    }
    for states in [100, 1_000, 10_000, 60_000] {
        report_memory(&format!("buffer of {states}"), &buffer(states));
    }
    for states in [100, 1_000, 10_000, 60_000] {
        report_memory(&format!("{states} states at random"), &random_order(3, states, 1));
    }
}

fn report_memory(name: &str, plant: &Plant) {
    let closed = supervise(plant, &Limits::default()).expect("a feedback");
    let start = Instant::now();
    let memory = remember(plant, &closed).expect("it can be followed");
    let time = start.elapsed().as_secs_f64();
    let (bits, edges) = (memory.iter().map(|it| it.bits).sum::<u32>(), closed.edges.len());
    let fewest = if memory.iter().all(|it| it.fewest) { "" } else { "?" };
    println!(
        "{name:24} {:>9} {edges:>10} {:>9} {:>10.2} {:>8.0}",
        closed.len(),
        format!("{fewest}{bits}"),
        time * 1e3,
        time * 1e9 / edges as f64
    );
}

fn report(name: &str, plant: &Plant) {
    let mut best = Duration::MAX;
    let mut runs = 0;
    let begin = Instant::now();
    while runs < 3 || runs < 20 && begin.elapsed() < Duration::from_secs(2) {
        let start = Instant::now();
        let closed = supervise(plant, &Limits::default());
        best = best.min(start.elapsed());
        runs += 1;
        drop(closed);
    }
    let closed = supervise(plant, &Limits::default()).expect("a feedback");
    let (states, edges) = closed.constrained;
    println!(
        "{name:24} {states:>9} {edges:>10} {:>9} {:>10.2} {:>8.0}",
        closed.len(),
        best.as_secs_f64() * 1e3,
        best.as_secs_f64() * 1e9 / edges as f64
    );
}

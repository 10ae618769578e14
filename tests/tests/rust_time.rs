//! How long `rustc` takes for generated modules of 100,000 transitions: next to nothing, because tables of that size are
//! byte strings and no code depends on their number.
//!
//! `cargo test -p sml-tests --test rust_time -- --nocapture` prints processor time over that of an empty crate. The limit is
//! relative to the empty crate's, which is measured in the same run: machines differ.
#![cfg(target_os = "linux")]

use std::fs;

use sml_tests::scratch::Scratch;
use sml_tests::tables::{self, Size};
use synth_core::emit::rust::{Engine, Options, text};

/// On a machine where an empty crate takes 0.05 s, this is 0.5 s.
const MOST_EMPTY_CRATES: f64 = 10.0;

/// Runs of each, of which the fastest counts.
const RUNS: usize = 3;

const EMPTY: &str = "//! Empty.\n#![no_std]\n";

#[test]
fn a_hundred_thousand_transitions_cost_little() {
    let scratch = Scratch::new(env!("CARGO_TARGET_TMPDIR"), "rust-time", &["names"], "").expect("written");
    let size = |states, events, rows| Size { states, events, rows, components: 3 };
    // Few events and many states, and the reverse.
    let shapes = [("10 events", size(33_000, 10, 50)), ("400 events", size(430, 400, 100))];
    for (name, size) in shapes {
        let tables = tables::random("large", size, 1);
        let rows: usize = tables.events.iter().map(|table| table.mapping.source.len()).sum();
        assert!(rows + tables.super_steps.source.len() >= 100_000, "{name}: {rows}");
        for engine in [Engine::Search, Engine::Runs, Engine::Comb] {
            let text = text(&tables, &Options { engine, ..Options::default() });
            scratch.write(&format!("src/{}_{}.rs", size.events, engine.name()), &text).expect("written");
        }
    }
    println!("{:36}{:>8}", "", "seconds over an empty crate");
    for arguments in [&["check"][..], &["build"], &["build", "--release"]] {
        // The first compiles what the crate depends on.
        time(&scratch, arguments, EMPTY);
        let empty = time(&scratch, arguments, EMPTY);
        for (name, size) in shapes {
            for engine in [Engine::Search, Engine::Runs, Engine::Comb] {
                let library = format!("{EMPTY}include!(\"{}_{}.rs\");\n", size.events, engine.name());
                let over = time(&scratch, arguments, &library) - empty;
                println!("{:16}{name:12}{:8}{over:8.2}", arguments.join(" "), engine.name());
                assert!(
                    over < MOST_EMPTY_CRATES * empty,
                    "{arguments:?} of {name}, {}: {over} s over {empty} s",
                    engine.name()
                );
            }
        }
    }
}

/// Processor time of `cargo` and all that it starts, in seconds, for a new library.
fn time(scratch: &Scratch, arguments: &[&str], library: &str) -> f64 {
    let arguments: Vec<&str> = arguments.iter().copied().chain(["--quiet"]).collect();
    let once = |run: usize| {
        // Different each time, or there would be nothing to do.
        scratch.write("src/lib.rs", &format!("{library}// {run}\n")).expect("written");
        let before = children();
        let output = scratch.cargo(&arguments, "").expect("cargo runs");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        children() - before
    };
    (0..RUNS).map(once).fold(f64::INFINITY, f64::min)
}

/// Processor time of all processes that this one has waited for, in seconds.
fn children() -> f64 {
    let stat = fs::read_to_string("/proc/self/stat").expect("Linux has it");
    // Behind the name, in parentheses: the 14th and 15th of the further fields, in hundredths of a second.
    let (_, fields) = stat.rsplit_once(')').expect("a name");
    let ticks = fields.split_whitespace().skip(13).take(2);
    ticks.map(|ticks| ticks.parse::<f64>().expect("a number")).sum::<f64>() / 100.0
}

//! Time of a step, and of a look-up by the length of its table.
//!
//! `cargo bench -p controller-template` measures time. Instructions are counted over the thousand steps of one run:
//!
//! ```text
//! cargo bench -p controller-template --no-run    # prints the program's path
//! valgrind --tool=callgrind --toggle-collect='*thousand_cycles*' PATH --test cycle
//! ```
//!
//! likewise with `thousand_drains` and `drain`, `thousand_reactions` and `react`. The controller in `step/bench.rs` is
//! generated, from tables at random; a test of the Rust back end keeps it fresh.
#![allow(missing_docs, reason = "criterion's macros have none")]

use std::hint::black_box;

use controller_template::Mappings;
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};

include!("step/bench.rs");

use bench::{Commands, Controller, Event};

/// A thousand calls: an event that fits, or none where a further super step is due.
fn script(step: fn(&mut Controller) -> Commands) -> Vec<Option<Event>> {
    use Event::{EnvCtlE0000, EnvCtlE0001, EnvCtlE0002, EnvCtlE0003, EnvCtlE0004, EnvCtlE0005, EnvCtlE0006};
    let all = [EnvCtlE0000, EnvCtlE0001, EnvCtlE0002, EnvCtlE0003, EnvCtlE0004, EnvCtlE0005, EnvCtlE0006];
    let mut controller = Controller::new();
    let mut random = 1_u32;
    let mut next = || {
        let fitting: Vec<Event> = all.into_iter().filter(|&event| controller.accepts(event)).collect();
        random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let event = fitting.get((random >> 16) as usize % fitting.len().max(1)).copied();
        event.map(|event| controller.raise(event));
        let _ = step(&mut controller);
        event
    };
    (0..1000).map(|_| next()).collect()
}

fn count(commands: Commands) -> u32 {
    u32::from(commands.c0.is_some()) + u32::from(commands.c1.is_some()) + u32::from(commands.c2.is_some())
}

#[inline(never)]
fn thousand_cycles(script: &[Option<Event>]) -> u32 {
    let mut controller = Controller::new();
    let step = |&event: &Option<Event>| {
        event.map(|event| controller.raise(event));
        count(controller.cycle())
    };
    script.iter().map(step).sum()
}

#[inline(never)]
fn thousand_drains(script: &[Option<Event>]) -> u32 {
    let mut controller = Controller::new();
    let step = |&event: &Option<Event>| {
        event.map(|event| controller.raise(event));
        count(controller.drain())
    };
    script.iter().map(step).sum()
}

#[inline(never)]
fn thousand_reactions(script: &[Option<Event>]) -> u32 {
    let mut controller = Controller::new();
    let step = |&event: &Option<Event>| match event {
        Some(event) => controller.react(event).map_or(0, count),
        None => count(controller.cycle()),
    };
    script.iter().map(step).sum()
}

fn steps(criterion: &mut Criterion) {
    type Step = fn(&[Option<Event>]) -> u32;
    let cycle: fn(&mut Controller) -> Commands = Controller::cycle;
    let all: [(&str, Step, _); 3] = [
        ("cycle", thousand_cycles, cycle),
        ("drain", thousand_drains, Controller::drain),
        ("react", thousand_reactions, cycle),
    ];
    let mut group = criterion.benchmark_group("step");
    for (name, step, by) in all {
        let script = script(by);
        group.throughput(Throughput::Elements(script.len() as u64));
        group.bench_function(name, |bencher| bencher.iter(|| step(black_box(&script))));
    }
    group.finish();
}

fn lookups(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("lookup");
    lookup::<8>(&mut group);
    lookup::<64>(&mut group);
    lookup::<1024>(&mut group);
    lookup::<4096>(&mut group);
    group.finish();
}

type Group<'a> = criterion::BenchmarkGroup<'a, criterion::measurement::WallTime>;

fn lookup<const N: usize>(group: &mut Group<'_>) {
    let mapping: Mappings<[u16; 2], [u16; N]> = Mappings {
        first: [0, N as u16],
        source: std::array::from_fn(|i| 2 * i as u16),
        target: std::array::from_fn(|i| i as u16),
    };
    let mut state = 0_u16;
    group.bench_function(BenchmarkId::from_parameter(N), |bencher| {
        bencher.iter(|| {
            state = state.wrapping_mul(25_173).wrapping_add(13_849);
            black_box(&mapping).lookup(0, black_box(state % (2 * N) as u16))
        });
    });
}

criterion_group!(benches, steps, lookups);
criterion_main!(benches);

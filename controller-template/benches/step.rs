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
//! generated, from tables at random that a test of the Rust back end names.
#![allow(missing_docs, reason = "criterion's macros have none")]

use std::hint::black_box;

use controller_template::Mapping;
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};

include!("step/bench.rs");

use bench::{Commands, Controller, Event};

/// A thousand events, each one that fits where it comes.
fn events() -> Vec<Event> {
    use Event::{EnvCtlE0000, EnvCtlE0001, EnvCtlE0002, EnvCtlE0003, EnvCtlE0004, EnvCtlE0005, EnvCtlE0006};
    let all =
        [EnvCtlE0000, EnvCtlE0001, EnvCtlE0002, EnvCtlE0003, EnvCtlE0004, EnvCtlE0005, EnvCtlE0006];
    let mut controller = Controller::new();
    let mut random = 1_u32;
    let mut events = Vec::new();
    while events.len() < 1000 {
        random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let event = all[(random >> 16) as usize % all.len()];
        if controller.accepts(event) {
            events.push(event);
            controller.raise(event);
        }
        let _ = controller.drain();
    }
    events
}

fn count(commands: Commands) -> u32 {
    u32::from(commands.c0.is_some()) + u32::from(commands.c1.is_some()) + u32::from(commands.c2.is_some())
}

#[inline(never)]
fn thousand_cycles(events: &[Event]) -> u32 {
    let mut controller = Controller::new();
    let step = |&event| {
        controller.raise(event);
        count(controller.cycle())
    };
    events.iter().map(step).sum()
}

#[inline(never)]
fn thousand_drains(events: &[Event]) -> u32 {
    let mut controller = Controller::new();
    let step = |&event| {
        controller.raise(event);
        count(controller.drain())
    };
    events.iter().map(step).sum()
}

#[inline(never)]
fn thousand_reactions(events: &[Event]) -> u32 {
    let mut controller = Controller::new();
    let step = |&event| controller.react(event).map_or(0, count);
    events.iter().map(step).sum()
}

fn steps(criterion: &mut Criterion) {
    let events = events();
    let mut group = criterion.benchmark_group("step");
    group.throughput(Throughput::Elements(events.len() as u64));
    type Step = fn(&[Event]) -> u32;
    let all: [(&str, Step); 3] =
        [("cycle", thousand_cycles), ("drain", thousand_drains), ("react", thousand_reactions)];
    for (name, step) in all {
        group.bench_function(name, |bencher| bencher.iter(|| step(black_box(&events))));
    }
    group.finish();
}

fn lookups(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("lookup");
    lookup::<8>(&mut group);
    lookup::<64>(&mut group);
    lookup::<1024>(&mut group);
    lookup::<16384>(&mut group);
    group.finish();
}

type Group<'a> = criterion::BenchmarkGroup<'a, criterion::measurement::WallTime>;

fn lookup<const N: usize>(group: &mut Group<'_>) {
    let mapping: Mapping<[u16; N]> =
        Mapping::new(std::array::from_fn(|i| 2 * i as u16), std::array::from_fn(|i| i as u16));
    let mut state = 0_u16;
    group.bench_function(BenchmarkId::from_parameter(N), |bencher| {
        bencher.iter(|| {
            state = state.wrapping_mul(25_173).wrapping_add(13_849);
            black_box(&mapping).lookup(black_box(state % (2 * N) as u16))
        });
    });
}

criterion_group!(benches, steps, lookups);
criterion_main!(benches);

//! Time of single stages: `cargo bench -p sml-tests --bench stages`, or `… -- explore` for one of them.
#![allow(missing_docs, reason = "criterion's macros have none")]

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use sml_tests::{families, fast};
use std::hint::black_box;
use synth_core::controller::{Level, minimize};
use synth_core::explore::explore;
use synth_core::game::{extract, solve};
use synth_core::model::Spec;
use synth_core::pipeline::{Options, Timings, check, specification, synthesize};

/// Names, texts and specifications.
fn subjects() -> Vec<(&'static str, String, Spec)> {
    let texts =
        [("line_2", families::line(2)), ("lift_8", families::lift(8)), ("arbiter_8", families::arbiter(8))];
    let resolved = |text: &str| fast::resolved(text).unwrap_or_else(|wrong| panic!("{wrong}"));
    texts.map(|(name, text)| (name, text.clone(), resolved(&text))).into()
}

fn stages(criterion: &mut Criterion) {
    let options = Options::default();
    for (name, text, spec) in subjects() {
        let mut solved = fast::solved(&spec, &options).expect("a game");
        let game = &solved.explored.game;
        let mut group = criterion.benchmark_group(name);
        group.sample_size(10).throughput(Throughput::Elements(game.states() as u64));
        group.bench_function("parse", |bencher| {
            bencher.iter(|| specification(&fast::loaded(black_box(&text))).expect("a specification"));
        });
        group.bench_function("explore", |bencher| {
            bencher.iter(|| explore(black_box(&spec), options.semantics, &options.limits).expect("a game"));
        });
        group.bench_function("solve", |bencher| bencher.iter(|| solve(black_box(game))));
        group.bench_function("extract", |bencher| {
            bencher.iter(|| extract(black_box(game), &solved.solution).expect("a strategy"));
        });
        let unminimized = Options { level: Level::None, ..options };
        let mut synthesized = |options: &Options| {
            synthesize(&mut solved, options, &mut Timings::default()).expect("a controller").controller
        };
        let (large, small) = (synthesized(&unminimized), synthesized(&options));
        group.bench_function("minimise", |bencher| {
            bencher.iter(|| minimize(black_box(large.clone()), Level::Exact));
        });
        group.bench_function("verify", |bencher| {
            bencher.iter(|| check(&spec, black_box(&small), &options).expect("it passes"));
        });
        group.finish();
    }
}

criterion_group!(benches, stages);
criterion_main!(benches);

//! How many bytes of flash the tables of generated Rust take, by engine.
//!
//! `cargo test -p sml-tests --test rust_size -- --nocapture` prints them.

use sml_tests::families::line;
use sml_tests::{corpus, fast, published};
use synth_core::controller::tables::{Provenance, Tables};
use synth_core::controller::{Level, number};
use synth_core::emit::rust::{Engine, Options, bytes};
use synth_core::pipeline::{self, Timings, compile};

/// Bytes per row of an environment event: its share of super steps and of all else included.
fn per_row(tables: &Tables, engine: Engine) -> f64 {
    let rows: usize = tables.events.iter().map(|table| table.mapping.source.len()).sum();
    bytes(tables, &Options { engine, ..Options::default() }) as f64 / rows as f64
}

#[test]
fn engines_keep_their_promises() {
    let of_corpus = ["production_cell", "line_2", "elevator_3"];
    let all = corpus::controllers().into_iter().filter(|(name, _)| of_corpus.contains(&name.as_str()));
    let made = [("machine".to_owned(), number(published::machine(1)))];
    let mut checked = 0;
    println!("{:18}{:>8}{:>8}{:>8}  bytes per row", "", "search", "runs", "comb");
    for (name, controller) in all.chain(made) {
        let tables = Tables::new(&name, &controller, Provenance::default());
        let [search, runs, comb] =
            [Engine::Search, Engine::Runs, Engine::Comb].map(|engine| per_row(&tables, engine));
        println!("{name:18}{search:8.2}{runs:8.2}{comb:8.2}");
        assert!(runs <= 2.5, "{name}: {runs}");
        assert!(comb <= search, "{name}: {comb}, {search}");
        let auto = per_row(&tables, Engine::Auto);
        assert!((auto - comb).abs() < f64::EPSILON, "{name}: {auto}");
        checked += 1;
    }
    assert_eq!(checked, 4);
}

/// A transition is a row of an environment event with its share of all else.
#[test]
fn the_smallest_keeps_its_promise_on_the_production_cell_family() {
    let text =
        |name: &str| corpus::all().into_iter().find(|entry| entry.name == name).expect("it is there").text;
    // Everything on a line of three presses takes long without optimisation. Its 38,016 states take 16 bits each.
    let (both, levels) = (&[false, true][..], &[Level::None, Level::Exact][..]);
    let family = [
        ("production cell", text("production_cell"), both, levels, 2.5),
        ("line, 1 press", line(1), both, levels, 2.5),
        ("line, 2 presses", line(2), both, levels, 2.5),
        ("line, 3 presses", line(3), &[false], &[Level::Exact], 2.7),
    ];
    println!("{:18}{:>10}{:>10}{:>8}  bytes per transition", "", "semantics", "minimised", "runs");
    for (name, text, semantics, levels, most) in family {
        for (classic, level) in semantics.iter().flat_map(|&s| levels.iter().map(move |&level| (s, level))) {
            let options = pipeline::Options { level, ..fast::options(classic, 100_000) };
            let tables = compile(&fast::loaded(&text), &options, &mut Timings::default());
            let tables = tables.unwrap_or_else(|failure| panic!("{name}, classic {classic}: {failure:?}"));
            let runs = per_row(&tables, Engine::Runs);
            let semantics = if classic { "classic" } else { "default" };
            let level = if level == Level::None { "none" } else { "exact" };
            println!("{name:18}{semantics:>10}{level:>10}{runs:8.2}");
            assert!(runs <= most, "{name}, {semantics}, {level}: {runs}");
        }
    }
}

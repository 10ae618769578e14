//! How many bytes of flash the tables of generated Rust take, by engine.
//!
//! `cargo test -p sml-tests --test rust_size -- --nocapture` prints them.

use sml_tests::{corpus, published};
use synth_core::controller::number;
use synth_core::controller::tables::{Provenance, Tables};
use synth_core::emit::rust::{Engine, Options, bytes};

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

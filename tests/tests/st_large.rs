//! Structured Text of real sizes compiles and runs in every call as the interpreter of controllers does: the published
//! size, and tables of more than 30,000 entries.

use sml_tests::beside::difference;
use sml_tests::published;
use sml_tests::tables::{self, Size};
use synth_core::controller::tables::{Provenance, Tables};
use synth_core::controller::{Controller, number};
use synth_core::emit::st::{self, Encoding, Options, Target};

#[track_caller]
fn check(tables: &Tables, controller: &Controller, calls: usize) {
    let rows = [(Target::Iec, Encoding::Rows), (Target::Codesys, Encoding::Rows)];
    for (target, encoding) in Target::ALL.map(|target| (target, Encoding::Runs)).into_iter().chain(rows) {
        let options = Options { target, encoding, ..Options::default() };
        let text = st::text(tables, &options).expect("it fits");
        assert_eq!(difference(&text, tables, controller, options, calls), None, "{options:?}");
    }
}

#[test]
fn of_the_published_size() {
    for controller in [published::machine(1), published::random(1)] {
        let controller = number(controller);
        let tables = Tables::new("Published", &controller, Provenance::default());
        check(&tables, &controller, 1000);
    }
}

#[test]
fn tables_of_thirty_thousand_rows() {
    let size = Size { states: 56_000, events: 2, rows: 90, components: 2 };
    let tables = tables::random("Large", size, 1);
    assert!(tables.events[0].mapping.source.len() > 30_000);
    let controller = tables::controller(&tables);
    check(&tables, &controller, 100);
}

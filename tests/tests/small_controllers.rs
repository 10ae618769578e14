//! The table of `docs/minimize.md`.

use sml_tests::smallest::mealy_states;
use sml_tests::{corpus, families, fast};
use std::fs;
use std::path::Path;
use synth_core::controller::{Controller, Level, never_fewer};
use synth_core::model::Spec;
use synth_core::pipeline::{Timings, synthesize};

/// A row: what it is about, and its text.
struct Subject {
    title: &'static str,
    text: fn() -> String,
    /// Whether it takes less than seconds without optimisation.
    is_quick: bool,
}

fn production_cell() -> String {
    let entry = corpus::all().into_iter().find(|entry| entry.name == "production_cell");
    entry.expect("the corpus has it").text
}

static SUBJECTS: [Subject; 9] = [
    Subject { title: "production cell", text: production_cell, is_quick: true },
    Subject { title: "line of two presses", text: || families::line(2), is_quick: false },
    Subject { title: "line of three presses", text: || families::line(3), is_quick: false },
    Subject { title: "line of four presses", text: || families::line(4), is_quick: false },
    Subject { title: "lift with 3 floors", text: || families::lift(3), is_quick: true },
    Subject { title: "lift with 8 floors", text: || families::lift(8), is_quick: false },
    Subject { title: "arbiter with 2 clients", text: || families::arbiter(2), is_quick: true },
    Subject { title: "arbiter with 8 clients", text: || families::arbiter(8), is_quick: false },
    Subject { title: "arbiter with 12 clients", text: || families::arbiter(12), is_quick: false },
];

const HEADING: &str = "| Specification | `exact`: Mealy | tables | rows | `ordered`: Mealy | tables | rows | no fewer than |\n|---|---|---|---|---|---|---|---|\n";

fn controller(spec: &Spec, level: Level) -> Controller {
    let options = synth_core::pipeline::Options { level, ..fast::options(false, 10_000_000) };
    let mut solved = fast::solved(spec, &options).expect("families are right");
    synthesize(&mut solved, &options, &mut Timings::default()).expect("families are realizable").controller
}

/// `1,234,567`
fn grouped(number: usize) -> String {
    match number {
        0..1000 => number.to_string(),
        _ => format!("{},{:03}", grouped(number / 1000), number % 1000),
    }
}

fn sizes(controller: &Controller) -> String {
    let rows = controller.environment.iter().map(Vec::len).sum();
    [mealy_states(controller), controller.states as usize, rows].map(grouped).join(" | ")
}

fn row(subject: &Subject) -> String {
    let spec = fast::resolved(&(subject.text)()).expect("families are right");
    let exact = controller(&spec, Level::Exact);
    let ordered = controller(&spec, Level::Ordered);
    // A bound from the nearest states says little.
    let waiting = mealy_states(&exact);
    let least =
        if waiting > 1 << 14 { String::new() } else { grouped(never_fewer(&exact).expect("it is no plant")) };
    format!("| {} | {} | {} | {least} |\n", subject.title, sizes(&exact), sizes(&ordered))
}

/// With `SML_BLESS` the table is written anew, in a release build; others check the small ones.
#[test]
fn the_page_has_these_sizes() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/minimize.md");
    let page = fs::read_to_string(&path).expect("the page");
    let start = page.find("| Specification |").expect("the page has the table");
    let end = start + page[start..].find("\n\n").expect("text follows the table") + 1;
    let measured = SUBJECTS.iter().filter(|subject| subject.is_quick || !cfg!(debug_assertions));
    let rows: Vec<String> = measured.map(row).collect();
    if std::env::var_os("SML_BLESS").is_some() && !cfg!(debug_assertions) {
        let table = HEADING.to_owned() + &rows.concat();
        fs::write(&path, format!("{}{table}{}", &page[..start], &page[end..])).expect("written");
        return;
    }
    for row in rows {
        assert!(
            page[start..end].contains(&row),
            "{row}SML_BLESS=1 cargo test --release -p sml-tests --test small_controllers"
        );
    }
}

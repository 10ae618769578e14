//! How large the Structured Text of a controller is, what a call of it costs at most, and how long writing it takes.
//!
//! `cargo test --release -p sml-tests --test st_size -- --nocapture` prints the tables; the README has the sizes in short.

use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use sml_tests::tables::{self, Size};
use sml_tests::{corpus, fast, published};
use synth_core::controller::tables::{Provenance, Tables};
use synth_core::controller::{Controller, Level, minimize, number};
use synth_core::emit::rust;
use synth_core::emit::st::{self, Cost, Encoding, Options, Target};
use synth_core::pipeline::{Timings, synthesize};

/// Lines and bytes of a text.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Extent {
    lines: usize,
    bytes: usize,
}

fn extent(text: &str) -> Extent {
    Extent { lines: text.lines().count(), bytes: text.len() }
}

/// What Gritzner and Greenyer (2018, section 4) report: `CASE`, standard-compliant and for CODESYS. Their primary state
/// machine alone, without events as outputs, `reset`, `unexpected` or a program.
const PUBLISHED: [(&str, Extent); 3] = [
    ("case", Extent { lines: 21_978, bytes: 792_128 }),
    ("iec", Extent { lines: 789, bytes: 97_669 }),
    ("codesys", Extent { lines: 135, bytes: 87_627 }),
];

/// Every way to write a controller, with its name in the table.
fn ways() -> Vec<(String, Options)> {
    let of_target = |target: Target| {
        let rows = (target != Target::Case).then_some((" rows", Encoding::Rows));
        let encodings = [("", Encoding::Runs)].into_iter().chain(rows);
        encodings.map(move |(name, encoding)| {
            (format!("{}{name}", target.name()), Options { target, encoding, ..Options::default() })
        })
    };
    Target::ALL.into_iter().flat_map(of_target).collect()
}

/// The verified controller of a specification of the corpus, not minimised.
fn synthesized(name: &str) -> Controller {
    let entry = corpus::all().into_iter().find(|entry| entry.name == name).expect("it is in the corpus");
    let spec = fast::resolved(&entry.text).expect("the corpus is right");
    let mut options = fast::options(false, 20_000);
    options.level = Level::None;
    let mut solved = fast::solved(&spec, &options).expect("it is small enough");
    synthesize(&mut solved, &options, &mut Timings::default()).expect("it is realizable").controller
}

/// The controllers in the tables, not minimised.
fn controllers() -> [(&'static str, Controller); 4] {
    [
        ("published size, structure of a machine", published::machine(1)),
        ("published size, at random", published::random(1)),
        ("line of two presses", synthesized("line_2")),
        ("production cell", synthesized("production_cell")),
    ]
}

fn laid_out(controller: Controller) -> Tables {
    Tables::new("Published", &number(controller), Provenance::default())
}

fn transitions(tables: &Tables) -> usize {
    tables.events.iter().map(|table| table.mapping.source.len()).sum::<usize>()
        + tables.super_steps.source.len()
}

fn cost(tables: &Tables, options: Options, drain: bool) -> String {
    match st::bound(tables, &Options { drain, ..options }) {
        Ok(Cost { statements, iterations, probes }) => format!("{statements:7} {iterations:7} {probes:6}"),
        Err(why) => why.to_string(),
    }
}

#[test]
fn report() {
    for (name, controller) in controllers() {
        let minimized = minimize(controller.clone(), Level::Exact);
        report_of(name, &laid_out(controller));
        report_of(&format!("{name}, minimised"), &laid_out(minimized));
    }
}

fn report_of(name: &str, tables: &Tables) {
    println!("\n{name}: {} states, {} transitions", tables.states, transitions(tables));
    println!("                               bytes per  a cycle at most:      a drain at most:");
    println!("target          lines   bytes transition  statem. iterat. probes  the same");
    for (way, options) in ways() {
        let Extent { lines, bytes } = extent(&st::text(tables, &options).expect("it fits"));
        let each = bytes as f64 / transitions(tables) as f64;
        let [cycle, drain] = [false, true].map(|drain| cost(tables, options, drain));
        println!("{way:14} {lines:6} {bytes:7}     {each:6.1}  {cycle}  {drain}");
    }
    if name.starts_with("published") {
        for (way, Extent { lines, bytes }) in PUBLISHED {
            let each = bytes as f64 / f64::from(published::TRANSITIONS);
            println!("{way:14} {lines:6} {bytes:7}     {each:6.1}  as published");
        }
    }
}

const HEADING: &str =
    "| target | published | line of robots | at random | line with 2 presses | production cell |";

/// The sizes as the README has them, a row for every target, and the published encoding for `iec`.
fn table() -> String {
    let [machine, random, line, cell] = controllers().map(|(_, controller)| laid_out(controller));
    let mut table = format!("{HEADING}\n|---|---|---|---|---|---|\n");
    let is_in_it = |options: &Options| options.encoding != Encoding::Rows || options.target == Target::Iec;
    for (way, options) in ways().into_iter().filter(|(_, options)| is_in_it(options)) {
        let way = way.replace(" rows", " --encoding rows");
        let published = PUBLISHED.iter().find(|(target, _)| *target == way).map(|(_, extent)| *extent);
        let sizes = [&machine, &random, &line, &cell]
            .map(|tables| extent(&st::text(tables, &options).expect("it fits")));
        let cells = std::iter::once(published).chain(sizes.map(Some)).map(|extent| {
            extent.map_or_else(
                || " ".to_owned(),
                |Extent { lines, bytes }| format!(" {}, {} ", grouped(lines), grouped(bytes)),
            )
        });
        table += &format!("| `{way}` |{}|\n", cells.collect::<Vec<_>>().join("|"));
    }
    table
}

/// `1,234,567`
fn grouped(number: usize) -> String {
    match number {
        0..1000 => number.to_string(),
        _ => format!("{},{:03}", grouped(number / 1000), number % 1000),
    }
}

/// With `SML_BLESS` the README's table is written anew.
#[test]
fn the_readme_has_these_sizes() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../README.md");
    let readme = fs::read_to_string(&path).expect("the README");
    let table = table();
    let start = readme.find(HEADING).expect("the README has the table");
    let end = start + readme[start..].find("\n\n").expect("text follows the table") + 1;
    if std::env::var_os("SML_BLESS").is_some() {
        fs::write(&path, format!("{}{table}{}", &readme[..start], &readme[end..])).expect("written");
    } else {
        assert_eq!(readme[start..end], table, "SML_BLESS=1 cargo test -p sml-tests --test st_size");
    }
}

/// The most lines and bytes of each target at the published size: with the structure of a machine, and without any. That
/// of `iec` is half of what was published.
const LIMITS: [(Target, [(usize, usize); 2]); 5] = [
    (Target::Iec, [(370, 41_500), (789 / 2, 97_669 / 2)]),
    (Target::Codesys, [(380, 42_000), (400, 49_500)]),
    (Target::Twincat, [(380, 42_000), (400, 49_500)]),
    (Target::Siemens, [(460, 42_600), (500, 50_500)]),
    (Target::Case, [(22_300, 575_000), (22_600, 590_000)]),
];

#[test]
fn texts_of_the_published_size_do_not_grow() {
    for (make, controller) in [published::machine(1), published::random(1)].into_iter().enumerate() {
        let tables = laid_out(controller);
        for (target, limits) in LIMITS {
            let text = st::text(&tables, &Options { target, ..Options::default() }).expect("it fits");
            let Extent { lines, bytes } = extent(&text);
            let (most_lines, most_bytes) = limits[make];
            assert!(lines <= most_lines && bytes <= most_bytes, "{}: {lines}, {bytes}", target.name());
        }
    }
}

/// The fastest of three.
fn time<T>(work: impl Fn() -> T) -> Duration {
    let one = || {
        let start = Instant::now();
        let result = work();
        let took = start.elapsed();
        drop(result);
        took
    };
    (0..3).map(|_| one()).min().expect("three")
}

/// Unoptimised code may take ten times as long.
#[test]
fn a_hundred_thousand_transitions_take_less_than_a_second() {
    let limit = Duration::from_secs(if cfg!(debug_assertions) { 10 } else { 1 });
    let tables = tables::random("Large", Size { states: 50_000, events: 6, rows: 45, components: 3 }, 1);
    assert!(transitions(&tables) > 100_000, "only {}", transitions(&tables));
    let writers = ways().into_iter().map(|(way, options)| {
        let tables = &tables;
        (way, Box::new(move || st::text(tables, &options).expect("it fits")) as Box<dyn Fn() -> String>)
    });
    let in_rust = || rust::text(&tables, &rust::Options::default());
    for (way, writer) in writers.chain([("rust".to_owned(), Box::new(in_rust) as Box<dyn Fn() -> String>)]) {
        let took = time(&writer);
        println!("{way:14} {} transitions in {took:?}", transitions(&tables));
        assert!(took < limit, "{way} takes {took:?}");
    }
}

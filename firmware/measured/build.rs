//! Turns the specifications into `$OUT_DIR/production_cell.rs` and `$OUT_DIR/spec.rs`; and by every engine, one that has
//! 300 rows and the production cell into `rows_search.rs`, `cell_search.rs` and so on.

use std::path::Path;
use std::{env, fs};

use synth_core::build::{Build, compile};
use synth_core::controller::Event;
use synth_core::controller::tables::{EventTable, Mapping, Provenance, Tables};
use synth_core::emit::rust::{Engine, Options, bytes, text};
use synth_core::pipeline::{self, Timings};
use synth_core::syntax::load;

const CELL: &str = "../../examples/production-cell/specs/production_cell.sml";

fn main() {
    compile(CELL);
    // The assumption that the controller does not need stays as a description.
    Build::new().allow("SML0099").compile("../../tests/specs/line_2/spec.sml");
    println!("cargo::rerun-if-changed=build.rs");
    for (name, tables) in [("rows", rows()), ("cell", cell())] {
        for engine in [Engine::Search, Engine::Runs, Engine::Comb] {
            write(&format!("{name}_{}", engine.name()), &tables, &Options { engine, ..Options::default() });
        }
    }
}

/// The module, and a constant with the bytes of its tables.
fn write(name: &str, tables: &Tables, options: &Options) {
    let out = env::var("OUT_DIR").expect("cargo sets OUT_DIR");
    let write = |file: String, text: String| {
        fs::write(Path::new(&out).join(file), text).expect("OUT_DIR can be written");
    };
    write(format!("{name}.rs"), text(tables, options));
    let bytes = bytes(tables, options);
    write(format!("{name}_bytes.rs"), format!("pub(super) const TABLES: usize = {bytes};\n"));
}

fn cell() -> Tables {
    let text = fs::read(CELL).expect("the specification is there");
    let loaded = load(CELL, &text, &mut |path| Err(format!("{path}: it imports nothing")));
    match pipeline::compile(&loaded, &pipeline::Options::default(), &mut Timings::default()) {
        Ok(tables) => tables,
        Err(failure) => panic!("the production cell has a controller: {failure:?}"),
    }
}

/// States of [`rows`]: more than a byte holds.
const STATES: u32 = 260;

/// 300 rows of ten events: from every state one to the next, and 40 more at random; no super steps.
fn rows() -> Tables {
    let mut random = 1_u32;
    let mut below = |bound: u32| {
        random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        ((random >> 16) * bound) >> 16
    };
    let mut rows = vec![Vec::new(); 10];
    for state in 0..STATES {
        rows[below(10) as usize].push((state, (state + 1) % STATES));
    }
    for _ in 0..40 {
        let (state, target) = (below(STATES), below(STATES));
        let free = |rows: &Vec<(u32, u32)>| rows.iter().all(|row| row.0 != state);
        let event = (below(10)..10).chain(0..10).find(|&event| free(&rows[event as usize]));
        rows[event.expect("no state has ten rows") as usize].push((state, target));
    }
    let events = rows.into_iter().enumerate().map(|(event, mut rows)| {
        rows.sort_unstable();
        let (source, target) = rows.into_iter().unzip();
        EventTable { event: report(event), mapping: Mapping { source, target } }
    });
    Tables {
        specification: "Rows".to_owned(),
        states: STATES,
        initial: 0,
        events: events.collect(),
        super_steps: Mapping::default(),
        components: Vec::new(),
        owed: vec![Vec::new(); STATES as usize],
        provenance: Provenance::default(),
    }
}

fn report(number: usize) -> Event {
    Event {
        text: format!("plant -> controller.reported({number})"),
        sender: "plant".to_owned(),
        receiver: "controller".to_owned(),
        operation: "reported".to_owned(),
        arguments: vec![number.to_string()],
    }
}

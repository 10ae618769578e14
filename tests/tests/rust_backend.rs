//! Generated modules compiled as in a user's crate: free of warnings, and the same as the contract and as Structured
//! Text, step for step.

use std::fmt::Write as _;

use sml_tests::beside::{Inputs, Model, Running, compiled, stimuli};
use sml_tests::corpus;
use sml_tests::reference::Reference;
use sml_tests::scratch::Scratch;
use sml_tests::tables::{self, Random, Size};
use synth_core::controller::cycle::Machine;
use synth_core::controller::tables::{Provenance, Tables};
use synth_core::controller::{Controller, Level, json};
use synth_core::emit::rust::{Engine, Options, module, name_map, templates, text};
use synth_core::emit::st;
use synth_core::explore::Limits;
use synth_core::pipeline::Timings;
use synth_core::plant::pipeline::follow;
use synth_core::plant::read;
use synth_core::syntax::FileId;

/// A module, the tables it is of, how they are searched, and the fields of its `Commands`.
struct Case {
    module: String,
    tables: Tables,
    engine: Engine,
    /// Whether it runs beside Structured Text, which takes long: once for the same tables.
    beside_text: bool,
    fields: Vec<String>,
}

impl Case {
    fn new(module: &str, tables: Tables, fields: &[&str]) -> Self {
        let fields = fields.iter().map(|&field| field.to_owned()).collect();
        Case { module: module.to_owned(), tables, engine: Engine::Auto, beside_text: true, fields }
    }

    fn random(module: &str, size: Size, seed: u64) -> Self {
        let tables = tables::random(module, size, seed);
        let fields = tables.components.iter().map(|component| component.object.clone()).collect();
        Case { module: module.to_owned(), tables, engine: Engine::Auto, beside_text: true, fields }
    }

    /// The same once per engine.
    fn with_engines(self) -> impl Iterator<Item = Case> {
        [Engine::Search, Engine::Runs, Engine::Comb].into_iter().map(move |engine| {
            let module = format!("{}_{}", self.module, engine.name());
            let tables = Tables { specification: module.clone(), ..self.tables.clone() };
            let beside_text = engine == Engine::Comb;
            Case { module, tables, engine, beside_text, fields: self.fields.clone() }
        })
    }
}

fn cases() -> Vec<Case> {
    single_cases().into_iter().flat_map(Case::with_engines).collect()
}

fn single_cases() -> Vec<Case> {
    let size = |states, events, rows, components| Size { states, events, rows, components };
    vec![
        Case::new("small_cell", tables::cell(), &["arm", "press"]),
        Case::new("empty", tables::empty(), &[]),
        Case::new("inner", tables::inner(), &[]),
        Case::random("dense", size(12, 6, 40, 3), 1),
        Case::random("sparse", size(40, 5, 15, 2), 2),
        Case::random("alone", size(9, 4, 50, 0), 3),
        Case::random("wide", size(30, 70, 10, 4), 4),
        Case::random("bytes", size(256, 3, 30, 1), 5),
        Case::random("words", size(257, 3, 30, 1), 6),
        Case::random("many_events", size(20, 300, 5, 1), 7),
        Case::random("packed", size(6000, 8, 40, 2), 8),
        Case::random("packed_words", size(70_000, 2, 20, 1), 9),
    ]
}

/// The tables of the corpus, each named after its folder; engines in turn.
fn corpus_cases() -> Vec<Case> {
    let case = |((name, controller), &engine): ((String, Controller), &Engine)| {
        let tables = Tables::new(&name, &controller, Provenance::default());
        let fields = tables.components.iter().map(|component| snake_case(&component.object)).collect();
        Case { module: name, tables, engine, beside_text: true, fields }
    };
    corpus::controllers().into_iter().zip(Engine::ALL.iter().cycle()).map(case).collect()
}

/// Controllers that follow the events of plants: states with rows of events and a super step.
fn followed_cases() -> Vec<Case> {
    let names = ["cat_and_mouse", "distribution_station", "tank", "transfer_line"];
    let case = |(name, &engine): (&str, &Engine)| {
        let path = format!("{}/plants/{name}.plant", env!("CARGO_MANIFEST_DIR"));
        let text = std::fs::read_to_string(path).expect("the corpus is readable");
        let (plant, _) = read(&text, FileId(0)).expect("a plant");
        let followed = follow(&plant, &Limits::default(), Level::Exact, &mut Timings::default());
        let module = format!("{name}_followed");
        let controller = followed.expect("a feedback").controller;
        let tables = Tables::new(&module, &controller, Provenance::default());
        let names = name_map(&tables);
        let fields = names.components.into_iter().map(|component| component.output).collect();
        Case { module, tables, engine, beside_text: true, fields }
    };
    names.into_iter().zip(Engine::ALL.iter().cycle()).map(case).collect()
}

/// `feed_arm` for `feedArm`.
fn snake_case(name: &str) -> String {
    let mut snake = String::new();
    for letter in name.chars() {
        if letter.is_ascii_uppercase() {
            snake.push('_');
        }
        snake.push(letter.to_ascii_lowercase());
    }
    snake
}

const ORDERED: Options = Options { ordered: true, engine: Engine::Auto };

/// Modules that are compiled only.
fn compiled_only() -> Vec<(String, Options)> {
    let mut ordered = tables::cell();
    ordered.specification = "Ordered".to_owned();
    let default = Options::default();
    vec![(text(&tables::names(), &default), default), (text(&ordered, &ORDERED), ORDERED)]
}

/// What to do with a controller: several events raised at once, then one step, now and then a reaction, a reset,
/// or a new controller that goes on from what the old one saved.
fn script(tables: &Tables, seed: u64, random: &mut Random) -> Vec<(&'static str, Option<usize>)> {
    let events = tables.events.len() as u32;
    let mut script = vec![("texts", None), ("foreign", None)];
    for round in 0..60 + seed % 2 {
        if events > 0 {
            for _ in 0..random.below(4) {
                script.push(("raise", Some(random.below(events) as usize)));
            }
            for _ in 0..random.below(3) {
                script.push(("react", Some(random.below(events) as usize)));
            }
        }
        script.push((if random.below(3) == 0 { "drain" } else { "cycle" }, None));
        if random.below(4) == 0 {
            script.push(("reload", None));
        }
        // Pending events that fit nowhere keep `react` refused.
        if round % 8 == 7 {
            script.push(("reset", None));
            if events > 0 {
                script.extend((0..6).map(|_| ("react", Some(random.below(events) as usize))));
            }
        }
    }
    script
}

/// What the driver is to print for one action.
fn expected<'a>(
    reference: &mut Reference<'a>,
    tables: &'a Tables,
    action: &str,
    event: Option<usize>,
) -> String {
    reference.log.clear();
    let result = match (action, event) {
        ("texts", None) => {
            let texts: Vec<_> = tables.events.iter().map(|e| &e.event.text).collect();
            format!("{texts:?} {}", tables.version())
        }
        ("reload" | "foreign", None) => String::new(),
        ("raise", Some(event)) => reference.raise(event).to_string(),
        ("cycle", None) => format!("{:?}", reference.cycle()),
        ("drain", None) => format!("{:?}", reference.drain()),
        ("react", Some(event)) => format!("{:?}", reference.react(event)),
        _ => {
            *reference = Reference::new(tables);
            String::new()
        }
    };
    let pending: Vec<usize> = reference.pending.iter().copied().collect();
    let accepted: Vec<usize> = (0..tables.events.len()).filter(|&e| reference.accepts(e).is_some()).collect();
    let owed = &tables.owed[reference.state as usize];
    format!("{result} {:?} {} {pending:?} {accepted:?} {owed:?}", reference.log, reference.state)
}

fn write_crate(cases: &[Case]) -> std::io::Result<Scratch> {
    let scratch = Scratch::new(env!("CARGO_TARGET_TMPDIR"), "rust-backend", &["names"], "")?;
    let mut library = String::from(
        "//! Generated modules.\n#![no_std]\n#![forbid(unsafe_code)]\n\
         #![warn(clippy::all, clippy::pedantic, clippy::nursery)]\n\
         #![warn(missing_docs, missing_debug_implementations, unreachable_pub, unused, rust_2018_idioms)]\n\n",
    );
    let mut private = library.replace("#![no_std]\n", "");
    let mut driver = String::from(include_str!("rust_backend/drive.rs"));
    let mut insert = String::new();
    for (i, Case { module, tables, engine, fields, .. }) in cases.iter().enumerate() {
        let options = Options { engine: *engine, ..Options::default() };
        scratch.write(&format!("src/{module}.rs"), &text(tables, &options))?;
        let _ = writeln!(library, "include!(\"{module}.rs\");");
        let _ = writeln!(private, "mod m{i} {{\n    include!(\"../{module}.rs\");\n}}");
        let fields = fields.join(", ");
        let _ = write!(
            driver,
            "\nmod m{i} {{\n    use super::*;\n    use rust_backend::{module};\n    drive!({module}, {fields});\n}}\n"
        );
        let _ = writeln!(
            insert,
            "    controllers.insert({module:?}, Box::new(rust_backend::{module}::Controller::new()));"
        );
    }
    for (i, (text, _)) in compiled_only().iter().enumerate() {
        scratch.write(&format!("src/compiled_{i}.rs"), text)?;
        let _ = writeln!(library, "include!(\"compiled_{i}.rs\");");
        let _ = writeln!(private, "mod c{i} {{\n    include!(\"../compiled_{i}.rs\");\n}}");
    }
    // Templates are to be changed, so they need not please the strictest.
    for Case { module, tables, .. } in cases.iter().filter(|case| case.tables.states < 100) {
        for template in templates(tables) {
            scratch.write(&format!("src/{module}_{}", template.file), &template.text)?;
            let name = template.file.trim_end_matches(".rs");
            let allowed = "clippy::nursery, clippy::pedantic, dead_code, unreachable_pub";
            let _ = writeln!(library, "#[allow({allowed})]\nmod {module}_{name};");
        }
    }
    private.push_str("\nfn main() {}\n");
    let _ =
        write!(driver, "\nfn insert_all(controllers: &mut BTreeMap<&str, Box<dyn Drive>>) {{\n{insert}}}\n");
    scratch.write("src/lib.rs", &library)?;
    scratch.write("src/bin/private.rs", &private)?;
    scratch.write("src/bin/drive.rs", &driver)?;
    Ok(scratch)
}

#[test]
fn modules_have_no_warnings_and_step_as_the_contract_says() {
    let cases: Vec<Case> = cases().into_iter().chain(corpus_cases()).chain(followed_cases()).collect();
    let scratch = write_crate(&cases).expect("the crate is written");

    let lints =
        ["clippy", "--quiet", "--lib", "--bin", "private", "--config", "build.rustflags=['-Dwarnings']"];
    let clippy = scratch.cargo(&lints, "").expect("cargo runs");
    assert!(clippy.status.success(), "{}", String::from_utf8_lossy(&clippy.stderr));

    let mut input = String::new();
    let mut lines = Vec::new();
    for (seed, case) in cases.iter().enumerate() {
        let mut reference = Reference::new(&case.tables);
        for (action, event) in script(&case.tables, seed as u64, &mut Random::new(seed as u64)) {
            let event_word = event.map(|event| format!(" {event}")).unwrap_or_default();
            let line = format!("{} {action}{event_word}", case.module);
            let _ = writeln!(input, "{line}");
            lines.push((line, expected(&mut reference, &case.tables, action, event)));
        }
    }
    let printed = drive(&scratch, &input);
    assert_eq!(printed.lines().count(), lines.len());
    for (number, (printed, (line, expected))) in printed.lines().zip(&lines).enumerate() {
        assert_eq!(printed, expected, "at `{line}`, line {number}");
    }
    let cases: Vec<&Case> = cases.iter().filter(|case| case.beside_text).collect();
    let scans: Vec<Vec<Inputs>> = cases.iter().copied().map(scans).collect();
    let actions = cases.iter().zip(&scans).map(|(case, scans)| actions(&case.module, scans));
    let printed = drive(&scratch, &actions.collect::<String>());
    let mut printed = printed.lines();
    for (case, scans) in cases.iter().zip(&scans) {
        structured_text_does_the_same(case, scans, &mut printed);
    }
    assert_eq!(printed.next(), None);
}

/// What the generated controllers print.
fn drive(scratch: &Scratch, input: &str) -> String {
    let run = scratch.cargo(&["run", "--quiet", "--bin", "drive"], input).expect("cargo runs");
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    String::from_utf8(run.stdout).expect("text")
}

/// Every input that is TRUE raises its event.
fn st_options(target: st::Target) -> st::Options {
    st::Options { target, trigger: st::Trigger::Level, ..st::Options::default() }
}

/// Random inputs of a function block.
fn scans(case: &Case) -> Vec<Inputs> {
    let controller = tables::controller(&case.tables);
    let model = Model::new(&case.tables, &controller, st_options(st::Target::Iec));
    stimuli(model).take(1000).map(|(inputs, _)| inputs).collect()
}

/// The same for the generated Rust, which begins anew: nothing in a pause, else something that ends with `reset` or
/// `cycle`.
fn actions(module: &str, scans: &[Inputs]) -> String {
    let mut actions = format!("{module} reset\n");
    for Inputs { enable, reset, events } in scans {
        if *reset {
            let _ = writeln!(actions, "{module} reset");
        } else if *enable {
            for event in (0..events.len()).filter(|&event| events[event]) {
                let _ = writeln!(actions, "{module} raise {event}");
            }
            let _ = writeln!(actions, "{module} cycle");
        }
    }
    actions
}

/// The text of every target outputs in every call what the generated Rust has printed.
fn structured_text_does_the_same<'p>(
    case: &Case,
    scans: &[Inputs],
    printed: &mut impl Iterator<Item = &'p str>,
) {
    let Case { module, tables, .. } = case;
    let texts = st::Target::ALL.map(|target| {
        let options = st_options(target);
        (options, compiled(&st::text(tables, &options).expect("it fits"), target))
    });
    let mut running =
        texts.each_ref().map(|(options, unit)| (options.target, Running::new(unit, tables, options)));
    printed.next().expect("a reset");
    for (number, inputs) in scans.iter().enumerate() {
        let mut overrun = false;
        let mut said = None;
        if inputs.reset {
            said = printed.next();
        } else if inputs.enable {
            for _ in inputs.events.iter().filter(|event| **event) {
                overrun |= printed.next().is_some_and(|line| line.starts_with("false "));
            }
            said = printed.next();
        }
        for (target, running) in &mut running {
            let outputs = running.call(inputs).expect("it runs");
            let pending: Vec<usize> =
                (0..inputs.events.len()).filter(|&event| outputs.pending[event]).collect();
            let place = format!("{module}, {}, scan {number}", target.name());
            assert_eq!(outputs.overrun, overrun, "{place}");
            let Some(line) = said else { continue };
            let commands = if inputs.reset { String::new() } else { format!("{:?}", outputs.commands) };
            let state = format!("] {} {pending:?} [", outputs.state);
            assert!(line.starts_with(&format!("{commands} [")) && line.contains(&state), "{place}: {line}");
        }
    }
}

/// What the reference says of tables, `sml cycle` says of the controller that was written as JSON and read again; so
/// all three agree.
#[test]
fn the_interpreter_of_json_steps_as_the_tables_say() {
    let mut commands = 0;
    for (seed, (name, original)) in corpus::controllers().into_iter().enumerate() {
        let controller = json::from_json(&json::to_json(&original)).expect("its own JSON");
        let tables = Tables::new(&name, &original, Provenance::default());
        let mut reference = Reference::new(&tables);
        let mut machine = Machine::new(&controller);
        for (action, event) in script(&tables, seed as u64, &mut Random::new(100 + seed as u64)) {
            let place = format!("{name}: {action} {event:?} in {}", reference.state);
            let expected = match (action, event) {
                ("texts", None) => continue,
                ("raise", Some(event)) => {
                    assert_eq!(machine.raise(event as u32), reference.raise(event), "{place}");
                    None
                }
                ("cycle", None) => Some((Some(machine.cycle()), Some(reference.cycle()))),
                ("drain", None) => Some((Some(machine.drain()), Some(reference.drain()))),
                ("react", Some(event)) => Some((machine.react(event as u32), reference.react(event))),
                _ => {
                    machine.reset();
                    reference = Reference::new(&tables);
                    None
                }
            };
            if let Some((mine, theirs)) = expected {
                commands += theirs.iter().flatten().filter(|&&code| code != 0).count();
                assert_eq!(mine.map(|commands| commands.codes), theirs, "{place}");
            }
            assert_eq!(machine.state(), reference.state, "{place}");
            for event in 0..tables.events.len() {
                let pending = reference.pending.contains(&event);
                assert_eq!(machine.is_pending(event as u32), pending, "{place}: event {event}");
            }
        }
    }
    assert!(commands > 200, "only {commands} commands were compared");
}

#[test]
fn text_is_the_module_and_its_origin() {
    let cell = tables::cell();
    let options = Options { engine: Engine::Search, ..Options::default() };
    let text = text(&cell, &options);
    for part in [
        "// Generated by `sml` ",
        " from `specs/smallcell.sml` (input 00000000000000ff, table format 1).\n",
        "/// - `Cell.Deliver` (guarantee, line 12): Every \\<blank\\> \\[1\\] is \\*pressed\\*, see \
         http://example.org/blank\\_press.\n",
        "/// ```mermaid\n",
        "///     4 --> 5 : / ctl -> arm.moveTo(-1), ctl -> press.press()\n",
        "pub mod small_cell {\n",
        "    /// `belt -> ctl.blankArrived()`\n            BeltCtlBlankArrived,\n",
        "ArmCtlArrivedM1,\n",
        "fn move_to_m1(&mut self);\n",
        "static ARM_TARGET: [u8; 3] = [1, 2, 3];\n",
        "    ::controller_template::names! {\n        impl Event {\n",
    ] {
        assert!(text.contains(part), "no {part:?} in\n{text}");
    }
    assert!(!text.contains("ARM_CTL_ARRIVED_1"), "a table without rows");
    assert_eq!(text, synth_core::emit::rust::text(&cell, &options));
    let tokens = module(&cell, &options).to_string();
    assert!(tokens.contains(":: controller_template :: names ! {"), "{tokens}");
}

#[test]
fn one_event_at_a_time_needs_no_pending_events() {
    let text = text(&tables::cell(), &ORDERED);
    assert!(text.contains("pub fn react(") && text.contains("pub fn cycle("));
    assert!(!text.contains("fn raise(") && !text.contains("fn drain(") && !text.contains("fn pending("));
}

#[test]
fn small_tables_are_arrays_and_large_ones_bytes() {
    let size = Size { states: 300, events: 2, rows: 50, components: 1 };
    let options = Options { engine: Engine::Search, ..Options::default() };
    let small = text(&tables::random("small", size, 1), &options);
    assert!(small.contains("Mappings<[u16; 4], [u16; ") && !small.contains("Packed"), "{small}");
    let large = text(&tables::random("large", Size { states: 30_000, ..size }, 1), &options);
    assert!(large.contains("Packed<u16, ") && !large.contains("; 1]"), "arrays beside byte strings");
    for text in [small, large] {
        let long =
            text.lines().filter(|line| line.len() > 110 && !line.trim_start().starts_with("//")).count();
        assert_eq!(long, 0, "{text}");
    }
}

/// The controller of the runtime's benchmark is what would be generated today; with `SML_BLESS` it is written anew.
#[test]
fn the_benchmark_is_fresh() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../controller-template/benches/step/bench.rs");
    let size = Size { states: 150, events: 7, rows: 60, components: 3 };
    let options = Options { engine: Engine::Comb, ..Options::default() };
    let text = text(&tables::random("bench", size, 1), &options);
    let (_, module) = text.split_once("\n\n").expect("a header");
    let fresh = format!("// From tables at random, written by the tests of the Rust back end.\n\n{module}");
    if std::env::var_os("SML_BLESS").is_some() {
        std::fs::write(path, &fresh).expect("written");
    }
    assert_eq!(std::fs::read_to_string(path).expect("read"), fresh);
}

//! Whatever a program of rungs is written as does the same as the program: Structured Text in its evaluator, Rust compiled as in
//! a user's crate, instruction lists in an interpreter, ladder diagrams, drawn with characters or as XML, read back.

mod scan_backends {
    pub(crate) mod diagram;
    pub(crate) mod ladder;
    pub(crate) mod list;
}

use std::collections::BTreeMap;
use std::fmt::Write as _;

use self::scan_backends::{diagram, ladder, list};
use sml_tests::scan::{self, Plan, Size, State, is_external, is_kept};
use sml_tests::scratch::Scratch;
use sml_tests::tables::Random;
use st_evaluator::{Dialect, Unit};
use synth_core::emit::automata;
use synth_core::emit::scan as back_ends;
use synth_core::emit::st::{self, Target, plcopen};
use synth_core::emit::{rust, scan::NameMap};
use synth_core::explore::Limits;
use synth_core::plant::{Use, supervise};

/// Programs of all sizes, and those of plants that need memory.
fn plans() -> Vec<Plan> {
    let sizes = [
        ([3, 2, 0, 0, 0], 3, 2),
        ([4, 3, 2, 2, 0], 6, 3),
        ([2, 2, 1, 1, 3], 5, 3),
        ([6, 5, 0, 0, 1], 8, 4),
        ([12, 6, 3, 3, 2], 12, 4),
        ([0, 1, 0, 0, 0], 2, 1),
        ([1, 0, 1, 2, 1], 4, 2),
        ([2, 0, 0, 0, 0], 0, 0),
        ([20, 12, 8, 6, 4], 40, 3),
    ];
    let plan = |(number, (variables, rungs, depth)): (u64, ([u32; 5], u32, u32))| {
        scan::random(&format!("Plant{number}"), Size { variables, rungs, depth }, number)
    };
    let random = (0..).zip(sizes.into_iter().cycle().take(2 * sizes.len())).map(plan);
    random.chain(scan::with_memory()).collect()
}

/// Whether kept variables and, if asked for, events are as they should be after every scan.
#[track_caller]
fn check(plan: &Plan, what: &str, mut run: impl FnMut(&State) -> Vec<bool>) {
    let mut random = Random::new(7);
    for (number, before) in plan.scans(&mut random, 1000).into_iter().enumerate() {
        let mut after = before.clone();
        after.scan(&plan.program);
        let expected: Vec<bool> = plan.variables(is_kept).map(|variable| after.values[variable]).collect();
        let name = &plan.program.name;
        assert_eq!(run(&before), expected, "{name} as {what}, scan {number} from {before:?}");
    }
}

/// Values by name.
type Maps = (BTreeMap<String, bool>, BTreeMap<String, i64>);

fn maps(state: &State, variables: &[String], analogues: &[String]) -> Maps {
    let bits = variables.iter().cloned().zip(state.values.iter().copied()).collect();
    let numbers = analogues.iter().cloned().zip(state.analogues.iter().copied()).collect();
    (bits, numbers)
}

fn kept(plan: &Plan, bits: &BTreeMap<String, bool>, variables: &[String]) -> Vec<bool> {
    plan.variables(is_kept).map(|variable| bits[&variables[variable]]).collect()
}

fn written(plan: &Plan) -> Vec<String> {
    plan.program.variables.iter().map(|variable| variable.name.clone()).collect()
}

#[test]
fn ladders_in_text() {
    for plan in plans() {
        let text = back_ends::ladder::text(&plan.source());
        assert!(text.lines().all(|line| line.chars().count() <= 120), "{text}");
        let networks = ladder::read(&text);
        let coils = plan.program.rungs.iter().filter(|rung| !rung.coils.is_empty()).count();
        let ranges = plan.program.variables.iter().filter(|it| matches!(it.usage, Use::Range(..))).count();
        assert_eq!(networks.len(), coils + ranges, "{text}");
        let names = written(&plan);
        check(&plan, &text, |state| {
            let (mut bits, numbers) = maps(state, &names, &plan.program.analogues);
            ladder::run(&networks, &mut bits, &numbers);
            kept(&plan, &bits, &names)
        });
    }
}

#[test]
fn instruction_lists() {
    for plan in plans() {
        let text = back_ends::list::text(&plan.source());
        let cost = back_ends::list::cost(&plan.source());
        // The only name of the random programs that is an instruction.
        let renamed = |name: String| match name.as_str() {
            "STR" | "not" => format!("{name}_2"),
            _ => name,
        };
        let names: Vec<String> = written(&plan).into_iter().map(renamed).collect();
        check(&plan, &text, |state| {
            let (mut bits, numbers) = maps(state, &names, &plan.program.analogues);
            let done = list::run(&text, &mut bits, &numbers);
            assert_eq!(done, (cost.instructions, cost.depth));
            kept(&plan, &bits, &names)
        });
        assert_eq!(cost.words.values().sum::<usize>(), cost.instructions);
        assert!(text.contains(&format!("{} instructions", cost.instructions)));
    }
}

#[test]
fn ladders_in_xml() {
    for plan in plans() {
        for dialect in [plcopen::Dialect::Iec, plcopen::Dialect::Codesys] {
            let xml = plcopen::ladder::document(&plan.source(), dialect);
            let diagram = diagram::read(&xml);
            let NameMap { variables, analogues, .. } = st::scan::names(&plan.source(), dialect.target());
            for once in [false, true] {
                check(&plan, "LD", |state| {
                    let (mut bits, numbers) = maps(state, &variables, &analogues);
                    // Those of the diagram.
                    for name in diagram.driven() {
                        bits.entry(name.to_owned()).or_default();
                    }
                    diagram.run(&mut bits, &numbers, once);
                    kept(&plan, &bits, &variables)
                });
            }
        }
    }
}

fn dialect(target: Target) -> Dialect {
    match target {
        Target::Iec | Target::Case => Dialect::Edition2,
        Target::Codesys => Dialect::Codesys,
        Target::Twincat => Dialect::TwinCat,
        Target::Siemens => Dialect::Siemens,
    }
}

#[test]
fn structured_text() {
    for plan in plans() {
        for target in Target::ALL {
            let source = plan.source();
            let text = st::scan::text(&source, target);
            assert!(text.lines().all(|line| line.chars().count() <= 120), "{text}");
            let unit =
                Unit::parse(&text, dialect(target)).unwrap_or_else(|errors| panic!("{errors:?}\n{text}"));
            let NameMap { function_block, variables, analogues, .. } = st::scan::names(&source, target);
            let mut block = unit.instance(&function_block).expect("it is there");
            // Before the first call, all is as it should be initially.
            let initial = plan.initial();
            for variable in plan.variables(is_kept) {
                assert_eq!(block.bool(&variables[variable]), Ok(initial.values[variable]));
            }
            check(&plan, &text, |state| {
                for variable in plan.variables(is_external) {
                    block.set(&variables[variable], state.values[variable]).expect("a variable");
                }
                for (name, &value) in analogues.iter().zip(&state.analogues) {
                    block.set(name, value).expect("an input");
                }
                block.set("enable", false).expect("an input");
                block.call().expect("it runs");
                let unchanged =
                    plan.variables(is_kept).all(|v| block.bool(&variables[v]) == Ok(state.values[v]));
                assert!(unchanged, "nothing is done while disabled");
                block.set("enable", true).expect("an input");
                block.call().expect("it runs");
                plan.variables(is_kept).map(|v| block.bool(&variables[v]).expect("a variable")).collect()
            });
        }
    }
}

/// A function that does a scan with values in the order of inputs, analogue inputs, outputs and memory, and writes kept
/// variables and events.
fn driver(plan: &Plan) -> String {
    let source = plan.source();
    let NameMap { program: module, variables, analogues, events, .. } = rust::scan::names(&source);
    let mut body = String::new();
    let path = |variable: usize| match plan.program.variables[variable].usage {
        Use::Input => format!("inputs.{}", variables[variable]),
        Use::Memory(_) => format!("outputs.memory.{}", variables[variable]),
        _ => format!("outputs.{}", variables[variable]),
    };
    for variable in plan.variables(is_external) {
        let _ = writeln!(body, "    {} = next() != 0;", path(variable));
    }
    for name in &analogues {
        let _ = writeln!(body, "    inputs.{name} = next().try_into().expect(\"it fits\");");
    }
    let kept: String = plan.variables(is_kept).map(|variable| format!("{}, ", path(variable))).collect();
    let events: String = events.iter().map(|event| format!("Event::{event}, ")).collect();
    format!(
        "pub fn {module}(mut next: impl FnMut() -> i64) -> String {{
    use scans::{module}::{{Event, Inputs, Outputs, scan}};
    let mut inputs = Inputs::default();
    let mut outputs = Outputs::default();
    let initial: Vec<bool> = vec![{kept}];
{body}    let caused = scan(&inputs, &mut outputs);
    let kept: Vec<bool> = vec![{kept}];
    let all: Vec<Event> = vec![{events}];
    assert_eq!(all, Event::ALL);
    assert_eq!(caused.iter().collect::<Vec<_>>(), all.iter().copied().filter(|&e| caused.contains(e)).collect::<Vec<_>>());
    assert_eq!(caused.is_empty(), caused.iter().next().is_none());
    let events: Vec<&str> = caused.iter().map(Event::name).collect();
    format!(\"{{initial:?}} {{kept:?}} {{events:?}}\")
}}
"
    )
}

#[test]
fn rust_modules() {
    let plans = plans();
    let scratch = Scratch::new(env!("CARGO_TARGET_TMPDIR"), "scans", &[], "").expect("the crate is written");
    let mut library = String::from(
        "//! Generated modules.\n#![no_std]\n#![forbid(unsafe_code)]\n\
         #![warn(clippy::all, clippy::pedantic, clippy::nursery)]\n\
         #![warn(missing_docs, missing_debug_implementations, unreachable_pub, unused, rust_2018_idioms)]\n\n",
    );
    let mut private = library.replace("#![no_std]\n", "");
    let mut main = String::from("//! Runs scans.\n#![allow(unused)]\n\n");
    let mut arms = String::new();
    for plan in &plans {
        let module = rust::scan::names(&plan.source()).program;
        scratch.write(&format!("src/{module}.rs"), &rust::scan::text(&plan.source())).expect("it is written");
        let _ = writeln!(library, "include!(\"{module}.rs\");");
        let _ = writeln!(private, "mod inside_{module} {{\n    include!(\"../{module}.rs\");\n}}");
        main += &driver(plan);
        let _ = writeln!(arms, "            {module:?} => {module}(next),");
    }
    let _ = write!(
        main,
        "\nfn main() {{
    for line in std::io::stdin().lines() {{
        let line = line.expect(\"text\");
        let mut words = line.split(' ');
        let module = words.next().expect(\"a module\");
        let next = || words.next().expect(\"a number\").parse::<i64>().expect(\"a number\");
        println!(\"{{}}\", match module {{\n{arms}            _ => unreachable!(),\n        }});
    }}
}}
"
    );
    private += "\nfn main() {}\n";
    for (path, text) in [("src/lib.rs", library), ("src/bin/private.rs", private), ("src/bin/drive.rs", main)]
    {
        scratch.write(path, &text).expect("it is written");
    }
    let lints =
        ["clippy", "--quiet", "--lib", "--bin", "private", "--config", "build.rustflags=['-Dwarnings']"];
    let clippy = scratch.cargo(&lints, "").expect("cargo runs");
    assert!(clippy.status.success(), "{}", String::from_utf8_lossy(&clippy.stderr));

    let (mut input, mut expected) = (String::new(), Vec::new());
    for plan in &plans {
        let module = rust::scan::names(&plan.source()).program;
        for before in plan.scans(&mut Random::new(7), 1000) {
            let bits = plan.variables(is_external).map(|variable| i64::from(before.values[variable]));
            let numbers: Vec<String> =
                bits.chain(before.analogues.iter().copied()).map(|n| n.to_string()).collect();
            let _ =
                writeln!(input, "{}", [std::slice::from_ref(&module), numbers.as_slice()].concat().join(" "));
            let mut after = before.clone();
            let events = after.scan(&plan.program);
            let names: Vec<&str> =
                events.iter().map(|&event| plan.events[event as usize].name.as_str()).collect();
            let kept =
                |state: &State| plan.variables(is_kept).map(|v| state.values[v]).collect::<Vec<bool>>();
            expected.push(format!("{:?} {:?} {names:?}", kept(&plan.initial()), kept(&after)));
        }
    }
    let run = scratch.cargo(&["run", "--quiet", "--bin", "drive"], &input).expect("cargo runs");
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    let printed = String::from_utf8(run.stdout).expect("text");
    assert_eq!(printed.lines().count(), expected.len());
    for ((printed, expected), input) in printed.lines().zip(&expected).zip(input.lines()) {
        assert_eq!(printed, expected, "{input}");
    }
}

/// Texts of the distribution station, but for versions. `SML_BLESS=1` writes them anew.
#[test]
fn texts_of_the_station() {
    let plan = scan::station();
    let source = plan.source();
    let plant = scan::plant();
    let ladder_xml = plcopen::ladder::document(&source, plcopen::Dialect::Iec);
    let texts = [
        ("ladder.txt", back_ends::ladder::text(&source)),
        ("ladder.svg", back_ends::ladder::drawing(&source)),
        ("ladder.xml", ladder_xml),
        ("list.txt", back_ends::list::text(&source)),
        ("iec.st", st::scan::text(&source, Target::Iec)),
        ("siemens.scl", st::scan::text(&source, Target::Siemens)),
        ("module.rs", rust::scan::text(&source)),
        ("automata.dot", automata::dot(&plant, None)),
        ("automata.mmd", automata::mermaid(&plant, None)),
        ("automata.svg", automata::svg(&plant, None)),
    ];
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/scan_backends/snapshots");
    for (file, text) in texts {
        let text = text.replace(env!("CARGO_PKG_VERSION"), "VERSION");
        let path = folder.join(file);
        if std::env::var_os("SML_BLESS").is_some() {
            std::fs::write(&path, &text).expect("it is written");
        }
        let snapshot = std::fs::read_to_string(&path).expect("a snapshot");
        assert!(text == snapshot, "{file}: SML_BLESS=1 cargo test -p sml-tests --test scan_backends");
    }
}

/// A closed loop is drawn if it is small, every state and arrow once.
#[test]
fn closed_loops_are_drawn() {
    let plant = scan::plant();
    let closed = supervise(&plant, &Limits::default()).unwrap_or_else(|_| panic!("a feedback"));
    let arrows: usize = (0..closed.len()).map(|entry| closed.edges(entry).len()).sum();
    let (with, without) = (automata::dot(&plant, Some(&closed)), automata::dot(&plant, None));
    let count = |what: &str| with.matches(what).count() - without.matches(what).count();
    assert_eq!(count("subgraph"), 1);
    assert_eq!(count("-> a4_s"), arrows + 1);
    for drawing in
        [automata::svg(&plant, Some(&closed)), back_ends::ladder::drawing(&scan::station().source())]
    {
        roxmltree::Document::parse(&drawing).expect("XML");
    }
    let svg = automata::svg(&plant, Some(&closed));
    assert_eq!(svg.matches("rx=\"8\"").count(), closed.len() + 14);
}

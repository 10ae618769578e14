//! Whatever a program of rungs is written as does the same as the program: Structured Text in its evaluator, Rust compiled as in
//! a user's crate, instruction lists in an interpreter, ladder diagrams, drawn with characters or as XML, read back.

mod scan_backends {
    pub(crate) mod diagram;
    pub(crate) mod ladder;
    pub(crate) mod list;
}

use std::collections::BTreeMap;
use std::fmt::Write as _;

use scan_backends::{diagram, ladder, list};
use sml_tests::scan::{self, Plan, Size, State, is_external, is_kept};
use sml_tests::scratch::Scratch;
use sml_tests::tables::Random;
use st_evaluator::{Dialect, Unit};
use synth_core::emit::scan as back_ends;
use synth_core::emit::st::{self, Target, plcopen};
use synth_core::emit::{rust, scan::NameMap};
use synth_core::plant::Use;

/// Programs of all sizes.
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
    (0..).zip(sizes.into_iter().cycle().take(4 * sizes.len())).map(plan).collect()
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

//! The Structured Text runs, and does in every call what the interpreter of controllers does.
//!
//! `SML_CYCLES` asks for more than 1000 calls of each text.

mod st_runs {
    mod plcopen;
}

use sml_tests::beside::{Model, Running, compiled, difference, first_difference};
use sml_tests::corpus;
use sml_tests::tables::{self, Size};
use st_evaluator::Task;
use std::time::Duration;
use synth_core::controller::Controller;
use synth_core::controller::tables::{Mapping, Provenance, Tables};
use synth_core::emit::st::{self, Cost, Encoding, Integers, Options, Target, Trigger, Unexpected};

const CALLS: usize = 1000;

fn calls() -> usize {
    std::env::var("SML_CYCLES").ok().and_then(|text| text.parse().ok()).unwrap_or(CALLS)
}

#[track_caller]
fn check(name: &str, tables: &Tables, controller: &Controller, options: Options, calls: usize) {
    let text = st::text(tables, &options).expect("it fits");
    let difference = difference(&text, tables, controller, options, calls);
    assert_eq!(difference, None, "{name} with {options:?}");
}

/// The defaults for every target and, where it has tables, every encoding of them.
fn all_targets() -> Vec<Options> {
    let of_target = |target| {
        let rows = (target != Target::Case).then_some(Encoding::Rows);
        let encodings = [Encoding::Runs].into_iter().chain(rows);
        encodings.map(move |encoding| Options { target, encoding, ..Options::default() })
    };
    Target::ALL.into_iter().flat_map(of_target).collect()
}

/// All that the command line can ask for, beside the target.
fn all_options() -> Vec<Options> {
    let mut all = Vec::new();
    for trigger in [Trigger::Edge, Trigger::Level] {
        for integers in [Integers::Unsigned, Integers::Signed] {
            for drain in [false, true] {
                for unexpected in [Unexpected::Keep, Unexpected::Drop, Unexpected::Fault] {
                    // What these two add knows little of the others.
                    let (owed, retain) = (all.len() % 2 == 0, all.len() % 5 < 3);
                    let options = Options { owed, retain, ..Options::default() };
                    all.push(Options { trigger, integers, drain, unexpected, ..options });
                }
            }
        }
    }
    all
}

/// All that the command line can ask for.
fn everything() -> Vec<Options> {
    let with_all = |Options { target, encoding, .. }| {
        all_options().into_iter().map(move |options| Options { target, encoding, ..options })
    };
    all_targets().into_iter().flat_map(with_all).collect()
}

#[test]
fn corpus() {
    for (name, controller) in corpus::controllers() {
        let tables = Tables::new(&name, &controller, Provenance::default());
        for options in all_targets() {
            check(&name, &tables, &controller, options, calls());
        }
    }
}

/// Every specification with every option, and the targets in turn.
#[test]
fn corpus_with_all_options() {
    let targets = all_targets();
    for (first, (name, controller)) in corpus::controllers().into_iter().enumerate() {
        let tables = Tables::new(&name, &controller, Provenance::default());
        for (turn, options) in all_options().into_iter().enumerate() {
            let Options { target, encoding, .. } = targets[(first + turn) % targets.len()];
            check(&name, &tables, &controller, Options { target, encoding, ..options }, calls() / 20);
        }
    }
}

#[test]
fn at_random() {
    let size = |states, events, rows, components| Size { states, events, rows, components };
    let sizes = [
        size(12, 6, 40, 3),
        size(40, 5, 15, 2),
        size(9, 4, 50, 0),
        size(30, 70, 10, 4),
        size(256, 3, 30, 1),
        size(257, 3, 30, 1),
        size(3017, 5, 40, 3),
    ];
    for (seed, size) in (1..).zip(sizes) {
        let tables = tables::random("Random", size, seed);
        let controller = tables::controller(&tables);
        for options in all_targets() {
            check(&format!("{size:?}"), &tables, &controller, options, calls());
        }
    }
}

#[test]
fn at_random_with_all_options() {
    for seed in 0..4 {
        let size = Size { states: 20, events: 5, rows: 40, components: 2 };
        let tables = tables::random("Random", size, 100 + seed);
        let controller = tables::controller(&tables);
        for options in everything() {
            check(&format!("seed {seed}"), &tables, &controller, options, calls() / 4);
        }
    }
}

#[test]
fn made_by_hand() {
    for tables in [tables::cell(), tables::empty(), tables::inner(), tables::names()] {
        let controller = tables::controller(&tables);
        for options in everything() {
            check(&tables.specification, &tables, &controller, options, calls() / 4);
        }
    }
}

/// The program passes everything through, and what the text says runs it: a task of 10 ms, or an organization block.
#[test]
fn programs_of_the_corpus() {
    for (name, controller) in corpus::controllers() {
        let tables = Tables::new(&name, &controller, Provenance::default());
        for target in Target::ALL {
            let options = Options { target, ..Options::default() };
            let text = st::text(&tables, &options).expect("it fits");
            let unit = compiled(&text, target);
            let running = Running::program(&unit, &tables, &options);
            let model = Model::new(&tables, &controller, options);
            assert_eq!(first_difference(running, model, calls() / 5), None, "{name} with {options:?}");
            if target != Target::Siemens {
                let task = Task {
                    name: "Cyclic".to_owned(),
                    interval: Some(Duration::from_millis(10)),
                    priority: 1,
                    programs: vec!["Main0".to_owned()],
                };
                assert_eq!(unit.tasks(), [task]);
            }
        }
    }
}

/// Events that come in the order opposite to that of the tables, so that every round consumes one; each has four rows far
/// apart, so that every search takes two halvings, and one row below, so that no search ends early.
fn slowest(events: u32) -> Tables {
    let mut tables = tables::cell();
    let chain = 2..events + 2;
    tables.states = chain.end + 5;
    tables.initial = chain.start;
    tables.owed = vec![Vec::new(); tables.states as usize];
    let last = tables.events[0].clone();
    tables.events = (0..events)
        .zip(chain.clone().rev())
        .map(|(event, state)| {
            let mut table = last.clone();
            table.event = tables::event(&format!("sensor{event:02} -> ctl.seen()"));
            // In the end, the last state waits for the event that came first.
            let beyond = if state == chain.start { chain.end } else { chain.end + 2 };
            let source = vec![0, state, beyond, beyond + 2];
            table.mapping =
                Mapping { target: source.iter().map(|s| (s + 1).min(chain.end)).collect(), source };
            table
        })
        .collect();
    tables.super_steps = Mapping::default();
    for component in &mut tables.components {
        component.codes.clear();
    }
    tables
}

/// The bound is no estimate: there are controllers that reach it.
#[test]
fn bounds_are_reached() {
    let mut tables = slowest(7);
    tables.owed.fill((0..7).collect());
    let asked = |options| Options { owed: true, retain: true, ..options };
    for options in all_targets().into_iter().chain(all_targets().into_iter().map(asked)) {
        let text = st::text(&tables, &options).expect("it fits");
        let names = st::names(&tables, &options);
        let unit = compiled(&text, options.target);
        let mut block = unit.instance(&names.function_block).expect("it is there");
        for (_, input) in &names.events {
            block.set(input, true).expect("an input");
        }
        let stats = block.call().expect("it runs");
        let bound = st::bound(&tables, &options).expect("it fits");
        // `CASE` compares with no entry of a table; its probes are the conditions of a branch.
        let compared = if options.target == Target::Case { bound.probes } else { stats.compared };
        let found = Cost { statements: stats.statements, iterations: stats.iterations, probes: compared };
        assert_eq!(found, bound, "{options:?}");
    }
}

/// The text with each number that `is_entry` takes for one of the controller's replaced, one at a time.
fn mutations(text: &str, is_entry: impl Fn(&str) -> bool) -> Vec<String> {
    let mut mutations = Vec::new();
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        if is_entry(line.trim()) {
            let mut at = 0;
            for part in line.split_inclusive(|c: char| !c.is_ascii_alphanumeric() && c != '_') {
                let digits = part.trim_end_matches(|c: char| !c.is_ascii_alphanumeric());
                if let Ok(number) = digits.parse::<u32>() {
                    let (from, other) = (start + at, u32::from(number == 0));
                    mutations.push(format!("{}{other}{}", &text[..from], &text[from + digits.len()..]));
                }
                at += part.len();
            }
        }
        start += line.len();
    }
    mutations
}

/// What a target's text says of the controller itself: lines of numbers, or the assignments in branches.
fn entries(target: Target, text: &str) -> Vec<String> {
    let numbers = |line: &str| line.starts_with(|c: char| c.is_ascii_digit()) && !line.ends_with(':');
    let steps = ["state := ", "event := ", "arm_cmd := ", "press_cmd := "];
    match target {
        Target::Case => {
            let machine = text.find("CASE").expect("there are branches");
            let end = text.find("IF NOT due").expect("there are super steps");
            mutations(&text[machine..end], |line| steps.iter().any(|step| line.starts_with(step)))
                .into_iter()
                .map(|mutated| format!("{}{mutated}{}", &text[..machine], &text[end..]))
                .collect()
        }
        _ => mutations(text, numbers),
    }
}

/// Faults of an emitter, each in one place of the text; `#` marks local names, where the target wants it.
fn faults(Options { target, encoding, .. }: Options, text: &str) -> Vec<(&'static str, String)> {
    let of_all = [
        ("a missing latch", "#pending[#index] := TRUE;", "#pending[#index] := FALSE;"),
        ("an input of another event", "#raised[0] := ", "#raised[1] := "),
        ("no edge", " AND NOT #previous[#index]", ""),
        ("no overrun", "#overrun := #overrun OR #pending[#index];", ";"),
        ("a command that stays", "#arm_cmd := 0;", ";"),
        ("a state that is not output", "#state_no := USINT_TO_UDINT(#state);", ";"),
    ];
    let of_runs = [
        ("an event that is not consumed", "#pending[#event] := FALSE;\n", "\n"),
        ("another event", "IF #pending[#event]", "IF #pending[0]"),
        ("a search that ends early", "#first := #middle;", "#first := #middle; #last := #middle;"),
        ("a run that is too long", "#row < #run_row", "#row <= #run_row"),
        ("a run that begins too late", "IF #run_state[#first] <= ", "IF #run_state[#first] < "),
    ];
    let of_rows = [
        ("an event that is not consumed", "#pending[0] := FALSE;\n", "\n"),
        ("another event", "IF #pending[2] THEN", "IF #pending[0] THEN"),
        ("a search that ends early", "#first := #middle;", "#first := #middle; #last := #middle;"),
    ];
    let of_case = [
        ("an event that is not consumed", "pending[event] := FALSE;", ""),
        ("another event", "IF pending[2] AND", "IF pending[0] AND"),
    ];
    let others = match (target, encoding) {
        (Target::Case, _) => &of_case[..],
        (_, Encoding::Runs) => &of_runs,
        (_, Encoding::Rows) => &of_rows,
    };
    of_all
        .iter()
        .chain(others)
        .map(|&(what, from, to)| {
            let spelled =
                |code: &str| if target == Target::Siemens { code.into() } else { code.replace('#', "") };
            let (from, to) = (spelled(from), spelled(to));
            assert!(text.contains(&from), "{from}\n{text}");
            (what, text.replace(&from, &to))
        })
        .collect()
}

#[test]
fn faults_are_noticed() {
    let tables = tables::cell();
    let controller = tables::controller(&tables);
    // What is added to the targets of an event without rows means nothing.
    let without_rows = tables.events.iter().filter(|table| table.mapping.source.is_empty()).count();
    for options in all_targets() {
        let text = st::text(&tables, &options).expect("it fits");
        let unnoticed = |faulty: &String| {
            assert_ne!(*faulty, text);
            difference(faulty, &tables, &controller, options, CALLS).is_none()
        };
        for (what, faulty) in faults(options, &text) {
            assert!(!unnoticed(&faulty), "{what} goes unnoticed:\n{faulty}");
        }
        let entries = entries(options.target, &text);
        assert!(entries.len() > 15, "only {} of {}", entries.len(), options.target.name());
        let by_runs = options.target != Target::Case && options.encoding == Encoding::Runs;
        let meaningless = if by_runs { without_rows } else { 0 };
        let unnoticed: Vec<String> = entries.into_iter().filter(unnoticed).collect();
        assert_eq!(unnoticed.len(), meaningless, "{}", unnoticed.concat());
    }
}

/// One event too many or too few among those that a state owes.
#[test]
fn wrong_debts_are_noticed() {
    let tables = tables::cell();
    let controller = tables::controller(&tables);
    for target in Target::ALL {
        let options = Options { target, owed: true, ..Options::default() };
        // A call never ends in states 1 and 4, because a super step follows.
        for state in [0, 2, 3, 5, 6] {
            for event in 0..4 {
                let mut wrong = tables.clone();
                let owed = &mut wrong.owed[state];
                match owed.binary_search(&event) {
                    Ok(at) => _ = owed.remove(at),
                    Err(at) => owed.insert(at, event),
                }
                let text = st::text(&wrong, &options).expect("it fits");
                let found = difference(&text, &tables, &controller, options, CALLS);
                assert!(found.is_some(), "{event} in {state}, {options:?}");
            }
        }
    }
}

/// Branches that do not look back at earlier events.
#[test]
fn a_round_that_is_not_started_again_is_noticed() {
    let tables = slowest(3);
    let controller = tables::controller(&tables);
    let options = Options { target: Target::Case, ..Options::default() };
    let text = st::text(&tables, &options).expect("it fits");
    let faulty = text.replacen("ELSIF next > 0 THEN", "ELSIF next > 9 THEN", 1);
    assert_ne!(faulty, text);
    assert!(difference(&faulty, &tables, &controller, options, CALLS).is_some());
}

/// Two targets of a table that are swapped.
#[test]
fn swapped_entries_are_noticed() {
    for (name, controller) in corpus::controllers() {
        let tables = Tables::new(&name, &controller, Provenance::default());
        let mut swapped = tables.clone();
        let targets = &mut swapped.super_steps.target;
        let Some(other) = targets.iter().position(|target| *target != targets[0]) else { continue };
        targets.swap(0, other);
        for options in all_targets() {
            let text = st::text(&swapped, &options).expect("it fits");
            let found = difference(&text, &tables, &controller, options, CALLS);
            assert!(found.is_some(), "{name} with {options:?}");
        }
    }
}

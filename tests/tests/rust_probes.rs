//! The bounds that generated modules state, `CYCLE_PROBES` and the like, beside the probes that calls really make: the
//! runtime is compiled so that it counts them where it makes them.

use std::fmt::Write as _;

use sml_tests::corpus;
use sml_tests::scratch::Scratch;
use sml_tests::tables::{self, Size};
use synth_core::controller::tables::{ComponentTable, EventTable, Mapping, Provenance, Tables};
use synth_core::emit::rust::{Engine, Options, text};

const ENGINES: [Engine; 3] = [Engine::Search, Engine::Runs, Engine::Comb];

/// Events of the worst controller.
const EVENTS: u32 = 5;

/// In which a call comes to its bound. From state 10 on two super steps, each commanding another component; then states 20
/// to 24, which all but the last event of those that are left keep waiting; then a super step for the first component again.
/// Every event has a row in each of three other states, and so do the super steps, so that there is something to search.
fn worst(initial: u32) -> Tables {
    let mapping = |rows: Vec<(u32, u32)>| {
        let (source, target) = rows.into_iter().unzip();
        Mapping { source, target }
    };
    let event = |index: u32| EventTable {
        event: tables::event(&format!("env -> ctl.e{index}()")),
        mapping: mapping(vec![(0, 25), (2, 25), (3, 25), (24 - index, 25 - index)]),
    };
    let component = |index: u32, codes: [u32; 6]| ComponentTable {
        object: format!("c{index}"),
        commands: vec![tables::event(&format!("ctl -> c{index}.go()"))],
        codes: codes.to_vec(),
    };
    Tables {
        states: 27,
        initial,
        events: (0..EVENTS).map(event).collect(),
        super_steps: mapping(vec![(1, 26), (5, 26), (7, 26), (10, 11), (11, 20), (25, 26)]),
        components: vec![component(0, [1, 1, 1, 1, 0, 1]), component(1, [0, 0, 0, 0, 1, 0])],
        owed: vec![Vec::new(); 27],
        ..tables::empty()
    }
}

/// A module's name, tables and engine.
type Case = (String, Tables, Engine);

fn cases() -> Vec<Case> {
    let size = |states, events, rows, components| Size { states, events, rows, components };
    let random = [size(12, 6, 40, 3), size(40, 5, 15, 2), size(30, 70, 10, 4), size(6000, 8, 40, 2)];
    let random =
        (1..).zip(random).map(|(seed, size)| (format!("random_{seed}"), tables::random("r", size, seed)));
    let all = random.chain([("cell".to_owned(), tables::cell()), ("inner".to_owned(), tables::inner())]);
    let worst = [("worst_cycle".to_owned(), worst(20)), ("worst_drain".to_owned(), worst(10))];
    let mut cases = Vec::new();
    for (name, tables) in all.chain(worst) {
        cases.extend(ENGINES.map(|engine| (format!("{name}_{}", engine.name()), tables.clone(), engine)));
    }
    for ((name, controller), engine) in corpus::controllers().into_iter().zip(ENGINES.into_iter().cycle()) {
        cases.push((name.clone(), Tables::new(&name, &controller, Provenance::default()), engine));
    }
    for (name, tables, _) in &mut cases {
        tables.specification.clone_from(name);
    }
    cases
}

/// What the program prints: per module the most probes of `accepts`, `react`, `cycle` and `drain`, and their bounds.
fn measured(cases: &[Case], folder: &str, flags: &str) -> String {
    let scratch = Scratch::new(env!("CARGO_TARGET_TMPDIR"), folder, &["names"], "").expect("written");
    let mut program = String::from(include_str!("rust_probes/measure.rs"));
    program.push_str("\nfn main() {\n");
    let mut modules = String::new();
    for (name, tables, engine) in cases {
        let options = Options { engine: *engine, ..Options::default() };
        scratch.write(&format!("src/{name}.rs"), &text(tables, &options)).expect("written");
        let _ = writeln!(modules, "include!(\"{name}.rs\");\nmeasure!({name});");
        let _ = writeln!(program, "    print::<{name}::Controller>({name:?});");
    }
    program.push_str("}\n\n");
    program.push_str(&modules);
    scratch.write("src/main.rs", &program).expect("written");
    let flags = format!("build.rustflags=[{flags}]");
    let run = scratch.cargo(&["run", "--quiet", "--config", &flags], "").expect("cargo runs");
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    String::from_utf8(run.stdout).expect("text")
}

/// What was found, and the bounds that it must not exceed.
#[track_caller]
fn within_bounds(line: &str) -> [[u32; 4]; 2] {
    let numbers: Vec<u32> = line.split(' ').skip(1).map(|number| number.parse().expect(line)).collect();
    let halves = [0, 4].map(|first| std::array::from_fn(|i| numbers[first + i]));
    let [found, bounds]: [[u32; 4]; 2] = halves;
    assert!(found.iter().zip(&bounds).all(|(found, bound)| found <= bound), "{line}");
    halves
}

/// The searches for processors of 32 bits, which other machines do not take otherwise.
#[test]
fn searches_of_small_processors_do_not_exceed_it_either() {
    let cases = cases();
    let flags = "'--cfg=count_probes', '--cfg=count_probes=\"small\"'";
    let printed = measured(&cases, "rust-probes-small", flags);
    assert_eq!(printed.lines().count(), cases.len());
    printed
        .lines()
        .for_each(|line| assert!(within_bounds(line)[0] != [0; 4] || line.starts_with("inner"), "{line}"));
}

#[test]
fn no_call_exceeds_its_bound_and_the_worst_reach_it() {
    let cases = cases();
    let printed = measured(&cases, "rust-probes", "'--cfg=count_probes'");
    assert_eq!(printed.lines().count(), cases.len());
    for (line, (name, ..)) in printed.lines().zip(&cases) {
        let [[accepts, react, cycle, drain], bounds] = within_bounds(line);
        if name.starts_with("worst_cycle") {
            assert_eq!([accepts, react, cycle], bounds[..3], "{line}");
        }
        if name.starts_with("worst_drain") {
            assert_eq!(drain, bounds[3], "{line}");
        }
    }
    // Ten look-ups beside the super steps, then fifteen of five events, four rows each; three of six super steps.
    let search = printed.lines().find(|line| line.starts_with("worst_drain_search ")).expect("measured");
    assert!(search.ends_with(&format!(" {}", (2 * 5 + 15) * 3 + 3 * 4)), "{search}");
}

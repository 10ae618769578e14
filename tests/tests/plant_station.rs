//! The distribution station's program in every language, on the simulated station and before the monitor of the example: neither
//! knows a formula. Beside each text runs the generated Rust, which must leave the same outputs in every scan.

mod scan_backends {
    pub(crate) mod list;
}

use std::collections::BTreeMap;

use self::scan_backends::list;
use distribution_station::distribution_station::{Inputs, Outputs, scan};
use distribution_station::random::Random;
use distribution_station::{Report, Scan, run};
use sml_tests::scan::{Plan, is_external};
use st_evaluator::{Dialect, Unit};
use synth_core::emit::scan as back_ends;
use synth_core::emit::st::{self, Target};
use synth_core::explore::Limits;
use synth_core::logic::{Expr, Literal};
use synth_core::pipeline::Timings;
use synth_core::plant::{DontCare, Options, Plant, pipeline, supervise};
use synth_core::{plant, syntax::FileId};

const PLANT: &str = include_str!("../../examples/distribution-station/specs/distribution_station.plant");

fn plan(options: Options) -> Plan {
    let (plant, warnings) = plant::read(PLANT, FileId(0)).expect("a plant");
    assert_eq!(warnings, []);
    let supervised = pipeline::control(&plant, &Limits::default(), options, &mut Timings::default());
    Plan::new(supervised.expect("a controller").feedback.program, plant.events)
}

/// The example says more in words, and the same otherwise.
#[test]
fn the_plant_is_that_of_the_corpus() {
    let read = |text| plant::read(text, FileId(0)).expect("a plant").0;
    let [example, corpus] = [PLANT, include_str!("../plants/distribution_station.plant")].map(read);
    let closed = |plant| supervise(plant, &Limits::default()).expect("a feedback");
    assert_eq!(closed(&example), closed(&corpus));
    let names = |plant: &Plant| plant.signals.iter().map(|signal| signal.name.clone()).collect::<Vec<_>>();
    assert_eq!(names(&example), names(&corpus));
}

/// What is known before a scan, by the names of the plant.
fn values(inputs: &Inputs, outputs: &Outputs) -> [(&'static str, bool); 11] {
    let Inputs { x0, x1, x2, x3, x5, x6 } = *inputs;
    let Outputs { y0, y1, y2, y3, y4 } = *outputs;
    let inputs = [("X0", x0), ("X1", x1), ("X2", x2), ("X3", x3), ("X5", x5), ("X6", x6)];
    let outputs = [("Y0", y0), ("Y1", y1), ("Y2", y2), ("Y3", y3), ("Y4", y4)];
    std::array::from_fn(|at| if at < 6 { inputs[at] } else { outputs[at - 6] })
}

/// What a scan leaves.
fn outputs(value: impl Fn(&str) -> bool) -> Outputs {
    Outputs { y0: value("Y0"), y1: value("Y1"), y2: value("Y2"), y3: value("Y3"), y4: value("Y4") }
}

fn report(program: Scan<'_>, workpieces: u64, seed: u64) -> Report {
    run(program, workpieces, Random::new(seed), &mut |_| {})
}

/// As it must be, and beside the generated Rust.
#[track_caller]
fn check(mut program: impl FnMut(&Inputs, &Outputs) -> Outputs) {
    let mut beside = |inputs: &Inputs, outputs: &mut Outputs| {
        let done = program(inputs, outputs);
        scan(inputs, outputs);
        assert_eq!(done, *outputs, "with {inputs:?}");
    };
    let report = report(&mut beside, 500, 7);
    assert_eq!(report.violations, Vec::<String>::new());
    assert_eq!(report.workpieces, 500);
    assert!(report.together > 100 && report.between > 1000, "the station must try the program: {report}");
}

#[track_caller]
fn check_st(target: Target, dialect: Dialect) {
    let plan = plan(Options::default());
    let text = st::scan::text(&plan.source(), target);
    let unit = Unit::parse(&text, dialect).unwrap_or_else(|errors| panic!("{errors:?}\n{text}"));
    let names = st::scan::names(&plan.source(), target);
    let mut block = unit.instance(&names.function_block).expect("the function block");
    check(|inputs, before| {
        for (name, value) in &values(inputs, before)[..6] {
            block.set(name, *value).expect("an input");
        }
        block.call().expect("it runs");
        outputs(|name| block.bool(name).expect("an output"))
    });
}

#[test]
fn iec() {
    check_st(Target::Iec, Dialect::Edition2);
}

#[test]
fn codesys() {
    check_st(Target::Codesys, Dialect::Codesys);
}

#[test]
fn twincat() {
    check_st(Target::Twincat, Dialect::TwinCat);
}

#[test]
fn siemens() {
    check_st(Target::Siemens, Dialect::Siemens);
}

#[test]
fn instruction_list() {
    let text = back_ends::list::text(&plan(Options::default()).source());
    check(|inputs, before| {
        let mut bits = values(inputs, before).map(|(name, value)| (name.to_owned(), value)).into();
        list::run(&text, &mut bits, &BTreeMap::new());
        outputs(|name| bits[name])
    });
}

/// What the station makes of a program, interpreted, that is told by `sensors` what the inputs are.
fn interpreted(plan: &Plan, workpieces: u64, sensors: impl Fn(Inputs) -> Inputs) -> Report {
    let mut state = plan.initial();
    let mut program = |inputs: &Inputs, kept: &mut Outputs| {
        let values = BTreeMap::from(values(&sensors(*inputs), kept));
        for variable in plan.variables(is_external) {
            state.values[variable] = values[plan.program.variables[variable].name.as_str()];
        }
        state.scan(&plan.program);
        let at = |name: &str| plan.program.variables.iter().position(|variable| variable.name == name);
        *kept = outputs(|name| state.values[at(name).expect("an output")]);
    };
    report(&mut program, workpieces, 3)
}

/// With every policy, one event a scan or several: what sensors say of a station that is whole is the same.
#[test]
fn all_options() {
    for dont_care in [DontCare::None, DontCare::Decodable, DontCare::All] {
        for extract in [false, true] {
            let options = Options { dont_care, extract, ..Options::default() };
            let report = interpreted(&plan(options), 200, |inputs| inputs);
            assert_eq!((report.workpieces, report.violations.as_slice()), (200, &[][..]), "{options:?}");
        }
    }
}

/// An expression in which one literal, by its number from the left, is changed; `None` if there are not so many.
fn changed(expr: &Expr, which: &mut usize, change: fn(Literal) -> Expr) -> Option<Expr> {
    let within = |parts: &[Expr], which: &mut usize| {
        let found = parts.iter().enumerate().find_map(|(at, part)| Some((at, changed(part, which, change)?)));
        found.map(|(at, part)| {
            let mut parts = parts.to_vec();
            parts[at] = part;
            parts
        })
    };
    match expr {
        Expr::Constant(_) => None,
        Expr::Literal(literal) if *which == 0 => Some(change(*literal)),
        Expr::Literal(_) => {
            *which -= 1;
            None
        }
        Expr::And(parts) => within(parts, which).map(Expr::And),
        Expr::Or(parts) => within(parts, which).map(Expr::Or),
    }
}

/// How many programs with one changed contact are noticed, and how many there are.
fn noticed(change: fn(Literal) -> Expr) -> (usize, usize) {
    let mut plan = plan(Options::default());
    let (mut noticed, mut all) = (0, 0);
    for rung in 0..plan.program.rungs.len() {
        let right = plan.program.rungs[rung].condition.clone();
        for wrong in (0..).map_while(|mut contact| changed(&right, &mut contact, change)) {
            plan.program.rungs[rung].condition = wrong;
            all += 1;
            noticed += usize::from(!interpreted(&plan, 50, |inputs| inputs).violations.is_empty());
        }
        plan.program.rungs[rung].condition = right;
    }
    (noticed, all)
}

/// But for a few that keep the program from something that it does in another way.
#[test]
fn a_contact_of_the_other_kind_is_noticed() {
    let (noticed, all) = noticed(|literal| Expr::Literal(Literal { negated: !literal.negated, ..literal }));
    assert!(10 * noticed > 8 * all, "{noticed} of {all}");
}

/// Most contacts are there for what cannot be while the station is whole.
#[test]
fn a_bridged_contact_is_noticed() {
    let (noticed, all) = noticed(|_| Expr::Constant(true));
    assert!(10 * noticed > 2 * all, "{noticed} of {all}");
}

/// What comes of each switch that sticks, closed, and of both switches of a way in parallel; without repetitions.
fn stuck(dont_care: DontCare) -> Vec<String> {
    let faults: [fn(Inputs) -> Inputs; 7] = [
        |inputs| Inputs { x0: true, ..inputs },
        |inputs| Inputs { x1: true, ..inputs },
        |inputs| Inputs { x2: true, ..inputs },
        |inputs| Inputs { x3: true, ..inputs },
        |inputs| Inputs { x5: true, ..inputs },
        |inputs| Inputs { x0: inputs.x0 || inputs.x1, x1: inputs.x0 || inputs.x1, ..inputs },
        |inputs| Inputs { x2: inputs.x2 || inputs.x3, x3: inputs.x2 || inputs.x3, ..inputs },
    ];
    let plan = plan(Options { dont_care, ..Options::default() });
    let mut found: Vec<String> =
        faults.into_iter().flat_map(|fault| interpreted(&plan, 100, fault).violations).collect();
    found.sort_unstable();
    found.dedup();
    found
}

#[test]
fn a_switch_that_sticks_stops_the_station() {
    let halt = "the station has come to a halt";
    assert_eq!(stuck(DontCare::None), [halt]);
    assert_eq!(stuck(DontCare::Decodable), [halt]);
    // Formulas that do not look at the other switch any more.
    let crash = "vacuum on: the hook is not at the dock";
    let found = stuck(DontCare::All);
    assert!(found.iter().any(|found| found == crash), "{found:?}");
}

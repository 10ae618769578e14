//! The verifier refuses what it must: every change of one table entry is caught, or the naive implementation agrees
//! that the changed controller still wins. And controllers that pass win, by the naive word too.

use sml_tests::families::arbiter::arbiter;
use sml_tests::families::lift::lift;
use sml_tests::random::{Options as RandomOptions, Random, specification};
use sml_tests::{corpus, fast, naive};
use synth_core::controller::{Controller, Level};
use synth_core::model::Spec;
use synth_core::pipeline::{Failure, Options, Timings, synthesize};
use synth_core::verify::{Refutation, VerifyError, verify};

fn controller(spec: &Spec, options: &Options) -> Option<Controller> {
    let mut solved = fast::solved(spec, options).ok()?;
    match synthesize(&mut solved, options, &mut Timings::default()) {
        Ok(verified) => Some(verified.controller),
        Err(Failure::Unrealizable(_)) => None,
        Err(failure) if fast::is_endless(&failure) => None,
        // Several events a scan make more states, and may meet mistakes that the game does not.
        Err(Failure::Limit(_) | Failure::Wrong(_)) if options.level == Level::Assume => None,
        Err(failure) => panic!("{failure:?}"),
    }
}

fn unminimized(most: usize) -> Options {
    Options { level: Level::None, ..fast::options(false, most) }
}

fn verified(spec: &Spec, controller: &Controller, threads: usize) -> Result<usize, VerifyError> {
    verify(spec, Options::default().semantics, controller, 100_000, threads)
}

fn refutation(spec: &Spec, controller: &Controller) -> Option<Refutation> {
    match verified(spec, controller, 1) {
        Ok(_) => None,
        Err(VerifyError::Refuted(refutation)) => Some(refutation),
        Err(other) => panic!("{other:?}"),
    }
}

/// Calls `visit` with every controller that differs in one entry: targets and sources of both kinds of rows become
/// another state, each event of a super step another one of the same component.
fn for_each_mutant(original: &Controller, random: &mut Random, visit: &mut dyn FnMut(&Controller, String)) {
    let other = |random: &mut Random, state: u32| {
        let shift = 1 + random.below(original.states as usize - 1) as u32;
        (state + shift) % original.states
    };
    let mut mutant = original.clone();
    for event in 0..original.environment.len() {
        let text = &original.events[event].text;
        for row in 0..original.environment[event].len() {
            let (source, target) = original.environment[event][row];
            mutant.environment[event][row].1 = other(random, target);
            visit(&mutant, format!("`{text}` leads from {source} elsewhere than to {target}"));
            mutant.environment[event][row].1 = target;
            let moved = other(random, source);
            if original.environment[event].iter().all(|row| row.0 != moved) {
                mutant.environment[event][row].0 = moved;
                mutant.environment[event].sort_unstable();
                visit(&mutant, format!("`{text}` leads from {moved} instead of {source}"));
                mutant.environment[event].clone_from(&original.environment[event]);
            }
        }
    }
    for row in 0..original.super_steps.len() {
        let step = original.super_steps.row(row);
        mutant.super_steps.target[row] = other(random, step.target);
        visit(&mutant, format!("the super step in {} leads elsewhere", step.source));
        mutant.super_steps.target[row] = step.target;
        for (place, &event) in step.events.iter().enumerate() {
            let receiver = &original.commands[event as usize].receiver;
            for (other, command) in original.commands.iter().enumerate() {
                if command.receiver == *receiver && other != event as usize {
                    let mut events = step.events.to_vec();
                    events[place] = other as u32;
                    mutant.super_steps.events.set(row, &events);
                    visit(&mutant, format!("the super step in {} sends `{}`", step.source, command.text));
                }
            }
            mutant.super_steps.events.set(row, step.events);
        }
    }
}

#[test]
fn every_change_of_the_production_cell_is_caught() {
    let entry = corpus::all().into_iter().find(|entry| entry.name == "production_cell");
    let spec = fast::resolved(&entry.expect("the corpus has it").text).expect("it is right");
    let original = controller(&spec, &unminimized(1000)).expect("it is realizable");
    let mut mutants = 0;
    for_each_mutant(&original, &mut Random::new(1), &mut |mutant, what| {
        mutants += 1;
        let Some(refutation) = refutation(&spec, mutant) else { panic!("survives: {what}") };
        assert!(!refutation.play.is_empty(), "{what}: {refutation:?}");
    });
    assert!(mutants > 800, "{mutants}");
}

#[test]
fn elsewhere_the_naive_implementation_judges_survivors() {
    let (mut caught, mut survivors) = (0, 0);
    for entry in corpus::all() {
        let spec = fast::resolved(&entry.text).expect("the corpus is right");
        let Some(original) = controller(&spec, &unminimized(20_000)) else { continue };
        if original.states > 60 || original.states < 2 {
            continue;
        }
        let graph = naive_graph(&entry.text, 20_000);
        for_each_mutant(&original, &mut Random::new(2), &mut |mutant, what| {
            let refuted = refutation(&spec, mutant);
            let wins = naive::product::wins(&graph, mutant);
            assert_eq!(refuted.is_none(), wins, "{}: {what}: {refuted:?}", entry.name);
            caught += usize::from(!wins);
            survivors += usize::from(wins);
        });
    }
    assert!(caught > 300, "{caught} caught, {survivors} still win");
}

/// The controller with one row, super step or command damaged.
fn damaged(original: &Controller, random: &mut Random) -> Controller {
    let mut controller = original.clone();
    let state = random.below(original.states as usize) as u32;
    if random.chance(50) {
        let event = random.below(controller.environment.len());
        let rows = &mut controller.environment[event];
        let row = random.below(rows.len());
        rows[row].1 = state;
    } else {
        let row = random.below(controller.super_steps.len());
        match random.below(3) {
            0 => controller.super_steps.target[row] = state,
            1 => {
                let others = original.super_steps.iter().enumerate().filter(|(other, _)| *other != row);
                controller.super_steps = others.map(|(_, step)| step).collect();
            }
            _ => {
                let command = random.below(controller.commands.len()) as u32;
                let mut events = original.super_steps.events[row].to_vec();
                events[0] = command;
                controller.super_steps.events.set(row, &events);
            }
        }
    }
    controller
}

/// The batches of nodes are large enough for several threads here, and so are the searches for cycles.
#[test]
fn threads_find_the_same_first_fault() {
    let spec = fast::resolved(&arbiter(9)).expect("it is right");
    let original = controller(&spec, &fast::options(false, 20_000)).expect("it is realizable");
    assert!(original.states > 2000, "{}", original.states);
    let random = &mut Random::new(3);
    let (mut plays, mut cycles) = (0, 0);
    for controller in (0..16).map(|_| damaged(&original, random)).chain([original.clone()]) {
        let one = verified(&spec, &controller, 1);
        for threads in [2, 8] {
            assert_eq!(verified(&spec, &controller, threads), one, "{threads} threads");
        }
        match one {
            Err(VerifyError::Refuted(found)) if found.reason.contains("is never met") => cycles += 1,
            Err(VerifyError::Refuted(_)) => plays += 1,
            other => assert!(controller == original || other.is_ok(), "{other:?}"),
        }
    }
    assert!(verified(&spec, &original, 8).is_ok());
    assert!(plays > 2 && cycles > 0, "{plays} plays, {cycles} cycles");
}

/// What is open here is learned in the middle of batches, with sets of keys that other nodes of the batch have, too.
#[test]
fn controllers_of_lifts_win() {
    for floors in 2..6 {
        let spec = fast::resolved(&lift(floors)).expect("it is right");
        let controller = controller(&spec, &fast::options(false, 20_000)).expect("it is realizable");
        let nodes = verified(&spec, &controller, 1);
        assert!(
            nodes.as_ref().is_ok_and(|&nodes| nodes >= controller.states as usize),
            "{floors}: {nodes:?}"
        );
        assert_eq!(verified(&spec, &controller, 8), nodes, "{floors} floors");
    }
}

#[test]
fn controllers_of_random_specifications_win() {
    let mut won = 0;
    for seed in 5000..5200 {
        let text = specification(seed, RandomOptions::default());
        let spec = fast::resolved(&text).unwrap_or_else(|error| panic!("{error}"));
        let graph = naive_graph(&text, 300);
        for level in [Level::None, Level::Exact, Level::Assume, Level::Ordered] {
            let Some(controller) = controller(&spec, &Options { level, ..unminimized(300) }) else {
                continue;
            };
            assert!(naive::product::wins(&graph, &controller), "seed {seed}, {level:?}\n{text}");
            won += 1;
        }
    }
    assert!(won > 100, "{won}");
}

/// The naive game; an empty one where it has too many states, and then there is no controller either.
fn naive_graph(text: &str, most: usize) -> naive::Graph {
    let file = corpus::parse(text).expect("it was read before");
    let spec = naive::Spec::new(&file).expect("it was resolved before");
    naive::explore(&spec, naive::Semantics::Default, most).unwrap_or(naive::Graph {
        nodes: Vec::new(),
        edges: Vec::new(),
        keys: Vec::new(),
    })
}

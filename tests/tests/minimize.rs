//! The levels of minimisation: what they keep, and how far they get.

use sml_tests::random::{Options as RandomOptions, Random, specification};
use sml_tests::smallest::{mealy_states, smallest};
use sml_tests::{corpus, fast};
use std::collections::BTreeMap;
use synth_core::controller::cycle::Machine;
use synth_core::controller::{Controller, Level, minimize};
use synth_core::diagnostic::Code;
use synth_core::model::Spec;
use synth_core::pipeline::{Failure, Options, Timings, synthesize};
use synth_core::playout::{Config, Playout, Step};
use synth_core::verify::{VerifyError, batches};

/// The verified controller; `None` if there is none, or if events in another order than that of the game meet a mistake of the
/// specification.
fn controller(spec: &Spec, level: Level, most: usize) -> Option<Controller> {
    let options = Options { level, ..fast::options(false, most) };
    let mut solved = fast::solved(spec, &options).ok()?;
    match synthesize(&mut solved, &options, &mut Timings::default()) {
        Ok(verified) => Some(verified.controller),
        Err(Failure::Unrealizable(_) | Failure::Wrong(_) | Failure::Limit(_)) => None,
        Err(failure) => panic!("{failure:?}"),
    }
}

fn spec(name: &str) -> Spec {
    let entry = corpus::all().into_iter().find(|entry| entry.name == name).expect("the corpus has it");
    fast::resolved(&entry.text).expect("the corpus is right")
}

/// Waiting states of the Mealy machine and states of the tables.
#[track_caller]
fn check(name: &str, level: Level, mealy: usize, states: u32) {
    let controller = controller(&spec(name), level, 20_000).expect("it is realizable");
    assert_eq!((mealy_states(&controller), controller.states), (mealy, states), "{name}, {}", level.name());
}

#[test]
fn figures_of_the_production_cell() {
    check("production_cell", Level::Exact, 96, 200);
    check("production_cell", Level::Ordered, 8, 48);
}

#[test]
fn figures_of_the_line() {
    check("line_2", Level::Exact, 1152, 2784);
    check("line_2", Level::Ordered, 32, 256);
}

/// The exhaustive search never finds more; in the corpus it finds no fewer either.
#[test]
fn how_far_from_the_smallest() {
    let (mut compared, mut gap) = (0, Vec::new());
    for entry in corpus::all() {
        let spec = fast::resolved(&entry.text).expect("the corpus is right");
        let Some(exact) = controller(&spec, Level::Exact, 20_000) else { continue };
        if mealy_states(&exact) > 100 {
            continue;
        }
        let found = mealy_states(&minimize(exact.clone(), Level::Ordered));
        let (least, clique) = smallest(&exact, 20_000);
        assert!(clique <= found, "{}: {clique} states cannot be merged, but there are {found}", entry.name);
        let least = least.unwrap_or_else(|| panic!("{}: not found", entry.name));
        assert!(least <= found, "{}: {found} found, {least} claimed to be least", entry.name);
        compared += 1;
        if least < found {
            gap.push((entry.name, least, found));
        }
    }
    assert!(compared > 30, "{compared}");
    assert_eq!(gap, []);
}

/// What the environment does between two calls, at random: as many events as it likes, in any order that the assumptions allow,
/// on what has really happened so far.
struct Plant<'s> {
    playout: Playout<'s>,
    real: Config,
    step: Step,
}

impl Plant<'_> {
    /// The events that are sent.
    fn sends(&mut self, random: &mut Random, most: usize) -> Option<Vec<String>> {
        let mut sent = Vec::new();
        for _ in 0..random.below(most + 1) {
            let sendable = self.playout.sendable(&self.real).ok()?;
            if sendable.is_empty() {
                break;
            }
            let (event, config) = sendable[random.below(sendable.len())].clone();
            sent.push(self.playout.text(Some(event)).to_owned());
            self.real = config;
        }
        Some(sent)
    }

    fn commanded(&mut self, text: &str) -> Option<()> {
        if let Some(event) = self.playout.find_event(text) {
            self.playout.step(&self.real, event, &mut self.step);
            if self.step.error.is_some() {
                return None;
            }
            std::mem::swap(&mut self.real, &mut self.step.config);
        }
        Some(())
    }
}

/// Plays both side by side; `None` if the specification has a mistake that only such plays reach.
fn run(plant: &mut Plant<'_>, left: &Controller, right: &Controller, random: &mut Random) -> Option<()> {
    let index: BTreeMap<&str, u32> = left.events.iter().map(|event| event.text.as_str()).zip(0..).collect();
    let (mut left_machine, mut right_machine) = (Machine::new(left), Machine::new(right));
    let mut sent = Vec::new();
    for _ in 0..60 {
        let now = plant.sends(random, 3)?;
        for event in now.iter().filter_map(|text| index.get(text.as_str())) {
            assert_eq!(left_machine.raise(*event), right_machine.raise(*event));
        }
        sent.extend(now);
        let (before, after) = if random.chance(70) {
            (left_machine.cycle(), right_machine.cycle())
        } else {
            (left_machine.drain(), right_machine.drain())
        };
        assert_eq!(before, after, "after {sent:?}");
        // Behind a super step nothing has been looked up yet, and a don't-care may look accepted.
        if before.events.is_empty() {
            assert_eq!(left_machine.unexpected(), right_machine.unexpected(), "after {sent:?}");
        }
        for command in before.events {
            let text = &left.commands[command as usize].text;
            sent.push(text.clone());
            plant.commanded(text)?;
        }
        for event in 0..left.events.len() as u32 {
            assert_eq!(left_machine.is_pending(event), right_machine.is_pending(event), "after {sent:?}");
        }
    }
    Some(())
}

/// Cycles and drains with batches at random, beside the unminimised controller. Returns whether it is smaller than `exact` makes it.
fn side_by_side(spec: &Spec, seed: u64) -> Option<bool> {
    let options = fast::options(false, 20_000);
    let left = controller(spec, Level::None, 20_000)?;
    let right = controller(spec, Level::Assume, 200_000)?;
    for seed in seed..seed + 20 {
        // An exploration meets all events of the system, so that they can be found by their texts.
        let solved = fast::solved(spec, &options).ok()?;
        let mut playout = solved.explored.playout;
        let real = playout.initial().ok()?;
        run(&mut Plant { playout, real, step: Step::default() }, &left, &right, &mut Random::new(seed))?;
    }
    Some(right.states < controller(spec, Level::Exact, 20_000)?.states)
}

#[test]
fn batches_make_no_difference_in_the_corpus() {
    let (mut compared, mut smaller) = (0, 0);
    for entry in corpus::all().into_iter().filter(|entry| entry.name != "line_2") {
        let spec = fast::resolved(&entry.text).expect("the corpus is right");
        if let Some(is_smaller) = side_by_side(&spec, 1) {
            compared += 1;
            smaller += usize::from(is_smaller);
        }
    }
    assert!(compared > 30 && smaller > 3, "{compared} compared, {smaller} of them smaller");
}

#[test]
fn batches_make_no_difference_at_random() {
    let (mut compared, mut smaller) = (0, 0);
    for seed in 7000..7100 {
        let spec = fast::resolved(&specification(seed, RandomOptions::default())).expect("it is right");
        if let Some(is_smaller) = side_by_side(&spec, seed) {
            compared += 1;
            smaller += usize::from(is_smaller);
        }
    }
    assert!(compared > 30 && smaller > 3, "{compared} compared, {smaller} of them smaller");
}

/// The production cell with a belt whose event comes first in the tables.
fn blanks_first() -> Spec {
    let entry = corpus::all().into_iter().find(|entry| entry.name == "production_cell");
    let text = entry.expect("the corpus has it").text.replace("feedBelt", "belt");
    fast::resolved(&text).expect("names do not matter")
}

/// With plain don't-cares the cell takes a blank before the item of the same scan is picked up.
#[test]
fn one_event_at_a_time_is_not_enough_for_a_scan() {
    let spec = blanks_first();
    let options = fast::options(false, 20_000);
    let raw = controller(&spec, Level::None, 20_000).expect("it is realizable");
    let ordered = minimize(raw.clone(), Level::Ordered);
    let mut solved = fast::solved(&spec, &options).expect("it is small");
    match batches::agree(&mut solved.explored.playout, &raw, &ordered, 1_000_000) {
        Err(VerifyError::Refuted(refutation)) => {
            assert!(refutation.reason.contains("one scan"), "{}", refutation.reason);
            assert!(refutation.play.iter().any(|event| event.contains("blankArrived")), "{refutation:?}");
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn what_may_come_in_one_scan_costs_states() {
    let spec = blanks_first();
    let waiting = |level| mealy_states(&controller(&spec, level, 20_000).expect("it is realizable"));
    let (ordered, assume, exact) = (waiting(Level::Ordered), waiting(Level::Assume), waiting(Level::Exact));
    assert!(ordered < assume && assume < exact, "{ordered}, {assume}, {exact}");
}

/// Nothing is claimed that was not explored.
#[test]
fn too_many_batches_are_a_limit() {
    let spec = spec("production_cell");
    let options = Options { level: Level::Assume, ..fast::options(false, 400) };
    let mut solved = fast::solved(&spec, &options).expect("the game has fewer states");
    let failure =
        synthesize(&mut solved, &options, &mut Timings::default()).expect_err("there are more batches");
    assert_eq!(failure.diagnostics()[0].code, Code::LimitReached);
}

/// Where a controller comes to rest.
fn rest(controller: &Controller, mut state: u32) -> u32 {
    while let Some(step) = controller.super_steps.due(state) {
        state = step.target;
    }
    state
}

/// The state in which a controller waits after an event; `None` if it refuses it.
fn after(controller: &Controller, state: u32, event: usize) -> Option<u32> {
    let rows = &controller.environment[event];
    let row = rows.binary_search_by_key(&state, |row| row.0).ok()?;
    Some(rest(controller, rows[row].1))
}

/// The monitor refuses just what the strategy refuses, event by event; returns in how many places the ordered controller would have
/// taken what it refuses.
fn watches(spec: &Spec, random: &mut Random) -> Option<usize> {
    let of_strategy = controller(spec, Level::None, 2_000)?;
    let ordered = controller(spec, Level::Ordered, 2_000)?;
    let options = Options { monitor: true, ..fast::options(false, 2_000) };
    let mut solved = fast::solved(spec, &options).expect("it has a controller");
    let monitor = synthesize(&mut solved, &options, &mut Timings::default()).expect("the same").controller;
    assert!(monitor.super_steps.is_empty() && monitor.components.is_empty() && monitor.commands.is_empty());
    assert!(monitor.states as usize <= mealy_states(&of_strategy));
    let start = |controller| rest(controller, controller.initial);
    let (mut at, mut watching, mut small) = (start(&of_strategy), start(&monitor), start(&ordered));
    let mut given_back = 0;
    for _ in 0..100 {
        let mut fitting = Vec::new();
        for event in 0..of_strategy.events.len() {
            let (taken, expected) = (after(&of_strategy, at, event), after(&monitor, watching, event));
            assert_eq!(taken.is_some(), expected.is_some(), "`{}`", of_strategy.events[event].text);
            given_back += usize::from(expected.is_none() && after(&ordered, small, event).is_some());
            fitting.extend(taken.zip(expected).map(|(taken, expected)| (event, taken, expected)));
        }
        if fitting.is_empty() {
            break;
        }
        let (event, taken, expected) = fitting[random.below(fitting.len())];
        (at, watching) = (taken, expected);
        small = after(&ordered, small, event).expect("the ordered controller takes what can happen");
    }
    Some(given_back)
}

#[test]
fn a_monitor_recognises_what_small_controllers_do_not() {
    let mut random = Random::new(7);
    let (mut watched, mut given_back) = (0, 0);
    for entry in corpus::all() {
        let spec = fast::resolved(&entry.text).expect("the corpus is right");
        let found = watches(&spec, &mut random);
        watched += usize::from(found.is_some());
        given_back += found.unwrap_or(0);
    }
    for seed in 0..150 {
        let spec = fast::resolved(&specification(seed, RandomOptions::default())).expect("it is right");
        given_back += watches(&spec, &mut random).unwrap_or(0);
    }
    assert!(watched > 30 && given_back > 1000, "{watched} in the corpus, {given_back} events");
}

#[test]
fn figures_of_monitors() {
    for (name, states) in [("production_cell", 96), ("line_2", 1152), ("arbiter_2", 5), ("elevator_3", 28)] {
        let options = Options { monitor: true, ..fast::options(false, 20_000) };
        let spec = spec(name);
        let mut solved = fast::solved(&spec, &options).expect("it is right");
        let monitor = synthesize(&mut solved, &options, &mut Timings::default()).expect("it is realizable");
        assert_eq!(monitor.controller.states, states, "{name}");
    }
}

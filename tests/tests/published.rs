//! The controllers of the published size are of that size, and controllers.

use sml_tests::published::{self, LARGEST, STATES, SUPER_STEPS, TRANSITIONS};
use synth_core::controller::Controller;

#[track_caller]
fn check(controller: &Controller) {
    assert_eq!(controller.states, STATES);
    assert_eq!(controller.super_steps.len(), SUPER_STEPS as usize);
    let rows: Vec<usize> = controller.environment.iter().map(Vec::len).collect();
    assert_eq!(rows.iter().sum::<usize>() + controller.super_steps.len(), TRANSITIONS as usize);
    assert_eq!(rows.iter().max(), Some(&(LARGEST as usize)));
    assert_eq!(controller.components.len(), 3);
    assert!(controller.events.is_sorted() && controller.commands.is_sorted());
    assert!(rows.iter().all(|&rows| rows > 0), "{rows:?}");
    is_a_controller(controller);
    assert_eq!(reachable(controller), STATES as usize);
}

/// Sources ascend, waiting states have no super step, every super step commands, and at most one thing a robot.
#[track_caller]
fn is_a_controller(controller: &Controller) {
    let ascends = |sources: &mut dyn Iterator<Item = u32>| sources.is_sorted_by(|a, b| a < b);
    assert!(controller.environment.iter().all(|rows| ascends(&mut rows.iter().map(|row| row.0))));
    assert!(ascends(&mut controller.super_steps.source.iter().copied()));
    let steps = |state| controller.super_steps.due(state).is_some();
    assert!(controller.environment.iter().flatten().all(|&(source, _)| !steps(source)));
    for step in &controller.super_steps {
        let of = |c: &&synth_core::controller::Component| {
            step.events.iter().filter(|event| c.commands.contains(event)).count()
        };
        let counts: Vec<usize> = controller.components.iter().map(|component| of(&component)).collect();
        assert!(counts.iter().all(|&count| count <= 1) && counts.contains(&1), "{step:?}");
    }
    // No circle of super steps.
    for step in &controller.super_steps {
        let (mut state, mut count) = (step.target, 0);
        while let Some(step) = controller.super_steps.due(state) {
            state = step.target;
            count += 1;
            assert!(count <= SUPER_STEPS, "a circle through {state}");
        }
    }
}

fn reachable(controller: &Controller) -> usize {
    let mut successors = vec![Vec::new(); controller.states as usize];
    let steps = controller.super_steps.iter().map(|step| (step.source, step.target));
    for (source, target) in controller.environment.iter().flatten().copied().chain(steps) {
        successors[source as usize].push(target);
    }
    let mut seen = vec![false; controller.states as usize];
    seen[controller.initial as usize] = true;
    let mut stack = vec![controller.initial];
    while let Some(state) = stack.pop() {
        for &target in &successors[state as usize] {
            if !std::mem::replace(&mut seen[target as usize], true) {
                stack.push(target);
            }
        }
    }
    seen.into_iter().filter(|&seen| seen).count()
}

/// How many different sets of events are accepted.
fn kinds(controller: &Controller) -> usize {
    let mut accepted = vec![Vec::new(); controller.states as usize];
    for (event, rows) in controller.environment.iter().enumerate() {
        rows.iter().for_each(|&(source, _)| accepted[source as usize].push(event));
    }
    accepted.sort_unstable();
    accepted.dedup();
    accepted.len()
}

#[test]
fn one_with_the_structure_of_a_machine() {
    for seed in 0..3 {
        let controller = published::machine(seed);
        check(&controller);
        assert_eq!(controller, published::machine(seed));
        assert!(kinds(&controller) < 400, "{}", kinds(&controller));
    }
}

#[test]
fn one_without_structure() {
    for seed in 0..3 {
        let controller = published::random(seed);
        check(&controller);
        assert_eq!(controller, published::random(seed));
        assert!(kinds(&controller) > 800, "{}", kinds(&controller));
    }
}

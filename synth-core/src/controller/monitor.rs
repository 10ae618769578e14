//! The monitor of a controller: which events are expected, and nothing else.
//!
//! A controller that was minimised with don't-cares no longer recognises an event that the assumptions exclude
//! ([`Level::Ordered`], [`Level::Assume`]). A monitor does: it has the events of the strategy and no commands, refuses what the strategy
//! refuses, and is far smaller than a controller that does both. It is a [`Controller`] like any other, for every back end.

use super::{Controller, Level, Lists, SuperSteps, minimize};
use hashbrown::HashSet;
use rustc_hash::FxBuildHasher;

/// The monitor of a controller whose states either wait for events or have a super step, and whose super steps come to an end: the
/// fewest states that refuse what it refuses, whatever happens. Its states owe nothing; that is for a controller to say.
///
/// An event is expected as soon as the controller would take it with nothing but super steps in between.
#[must_use]
pub fn monitor(controller: &Controller) -> Controller {
    let rest = Rest::new(controller);
    let after = &rest.after;
    let environment = controller.environment.iter().map(|rows| {
        let waiting = rows.iter().filter(|(source, _)| after[*source as usize].is_none());
        waiting.map(|&(source, target)| (source, rest.of(target))).collect()
    });
    let events_only = Controller {
        states: controller.states,
        initial: rest.of(controller.initial),
        events: controller.events.clone(),
        commands: Vec::new(),
        components: Vec::new(),
        environment: environment.collect(),
        super_steps: SuperSteps::default(),
        owed: Lists::empty(controller.states as usize),
    };
    minimize(events_only, Level::Exact)
}

/// Whether a monitor expects just the events that the controller takes, on every way that leads from the initial states: by walking
/// both together, one step of the controller at a time.
#[must_use]
pub fn agrees(monitor: &Controller, controller: &Controller) -> bool {
    let (expected, taken) = (ByState::new(monitor), ByState::new(controller));
    let steps = Rest::new(controller).after;
    let start = (monitor.initial, controller.initial);
    let mut known: HashSet<(u32, u32), FxBuildHasher> = HashSet::default();
    known.insert(start);
    let mut pending = vec![start];
    while let Some((watching, at)) = pending.pop() {
        let mut go = |node| {
            if known.insert(node) {
                pending.push(node);
            }
        };
        if let Some(target) = steps[at as usize] {
            go((watching, target));
            continue;
        }
        let (expected, taken) = (expected.of(watching), taken.of(at));
        if !expected.iter().map(|row| row.0).eq(taken.iter().map(|row| row.0)) {
            return false;
        }
        expected.iter().zip(taken).for_each(|(a, b)| go((a.1, b.1)));
    }
    monitor.super_steps.is_empty()
}

/// Where a controller comes to rest.
struct Rest {
    /// Per state the one after its super step.
    after: Vec<Option<u32>>,
}

impl Rest {
    fn new(controller: &Controller) -> Self {
        let mut after = vec![None; controller.states as usize];
        for step in &controller.super_steps {
            after[step.source as usize] = Some(step.target);
        }
        Rest { after }
    }

    /// The state in which the controller waits, from `state` on.
    fn of(&self, mut state: u32) -> u32 {
        // A chain is as long as there are states at most, unless it has no end.
        for _ in 0..self.after.len() {
            match self.after[state as usize] {
                Some(target) => state = target,
                None => break,
            }
        }
        state
    }
}

/// Rows of environment events by state.
struct ByState {
    /// Per state where its rows begin; one more entry ends the last.
    first: Vec<u32>,
    /// Events, ascending in a state, and targets.
    rows: Vec<(u32, u32)>,
}

impl ByState {
    fn new(controller: &Controller) -> Self {
        let mut first = vec![0; controller.states as usize + 2];
        let all = || {
            let by_event = (0..).zip(&controller.environment);
            by_event.flat_map(|(event, rows)| rows.iter().map(move |&(from, to)| (event, from, to)))
        };
        all().for_each(|(_, from, _)| first[from as usize + 2] += 1);
        for state in 2..first.len() {
            first[state] += first[state - 1];
        }
        let mut rows = vec![(0, 0); first[first.len() - 1] as usize];
        for (event, from, to) in all() {
            let next = &mut first[from as usize + 1];
            rows[*next as usize] = (event, to);
            *next += 1;
        }
        ByState { first, rows }
    }

    fn of(&self, state: u32) -> &[(u32, u32)] {
        &self.rows[self.first[state as usize] as usize..self.first[state as usize + 1] as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::super::fixtures::controller;
    use super::*;

    #[track_caller]
    fn check(lines: &str, expected: &str) {
        let all = controller(lines);
        let monitor = monitor(&all);
        let expected = controller(expected);
        assert_eq!((monitor.states, &monitor.environment), (expected.states, &expected.environment));
        assert!(monitor.super_steps.is_empty() && monitor.components.is_empty());
        assert!(agrees(&monitor, &all));
    }

    #[test]
    fn commands_make_no_difference() {
        check("0: a 1\n1! arm.go 2\n2: b 3\n3! arm.stop 0", "0: a 1\n1: b 0");
        check("0: a 1\n1! arm.go 2\n2: a 3\n3! arm.stop 0", "0: a 0");
        // A split super step, and one before anything happens.
        check("0! arm.go 1\n1! arm.stop 2\n2: a 3, b 2\n3! arm.go 2", "0: a 0, b 0");
    }

    #[test]
    fn what_is_refused_stays_refused() {
        check("0: a 1, b 2\n1: a 0\n2: b 0", "0: a 1, b 2\n1: a 0\n2: b 0");
        check("0: a 1\n1:", "0: a 1\n1:");
    }

    #[test]
    fn another_monitor_does_not_agree() {
        let all = controller("0: a 1\n1! arm.go 2\n2: b 0");
        for other in ["0: a 1, b 0\n1: b 0", "0: a 1\n1: a 0, b 0", "0: a 0, b 0", "0: a 1\n1: b 1"] {
            assert!(!agrees(&controller(other), &all), "{other}");
        }
        assert!(!agrees(&all, &all), "commands are none of its business");
    }
}

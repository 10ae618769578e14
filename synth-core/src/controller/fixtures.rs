//! Controllers for tests, in a notation of one line a state:
//!
//! ```text
//! 0: a 1, b 2          environment events `env -> ctl.a()` and `env -> ctl.b()`
//! 1! arm.go log.x 0    super step of `ctl -> arm.go()` and `ctl -> log.x()`
//! 2:
//! ```
//!
//! State 0 is the initial one. `log` is a controllable object, every other receiver a component.

use super::{Component, Controller, Event, Lists, SuperStep, SuperSteps};
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

/// A state before events are numbered.
#[derive(Clone, Debug)]
pub(super) enum State {
    /// Event and target.
    Environment(BTreeMap<String, u32>),
    /// Commands and target.
    SuperStep(Vec<String>, u32),
}

fn event(short: &str) -> Event {
    Event::from_text(&format!("env -> ctl.{short}()")).expect("an event")
}

fn command(short: &str) -> Event {
    Event::from_text(&format!("ctl -> {short}()")).expect("a command")
}

fn parse_state(line: &str) -> State {
    let number = |text: &str| text.parse().expect("a state");
    if let Some((_, row)) = line.split_once('!') {
        let mut words: Vec<String> = row.split_whitespace().map(str::to_owned).collect();
        let target = number(&words.pop().expect("a target"));
        return State::SuperStep(words, target);
    }
    let (_, rows) = line.split_once(':').expect("a colon or an exclamation mark");
    let rows = rows.split(',').filter_map(|row| row.trim().split_once(' '));
    State::Environment(rows.map(|(event, target)| (event.to_owned(), number(target))).collect())
}

/// The controller in the notation above; its events are those that occur.
pub(super) fn controller(lines: &str) -> Controller {
    let states =
        lines.lines().map(str::trim).filter(|line| !line.is_empty()).map(parse_state).collect::<Vec<_>>();
    build(&states)
}

/// Numbers everything.
pub(super) fn build(states: &[State]) -> Controller {
    let (mut events, mut commands) = (BTreeSet::new(), BTreeSet::new());
    for state in states {
        match state {
            State::Environment(rows) => events.extend(rows.keys().map(|short| event(short))),
            State::SuperStep(list, _) => commands.extend(list.iter().map(|short| command(short))),
        }
    }
    let events: Vec<Event> = events.into_iter().collect();
    let commands: Vec<Event> = commands.into_iter().collect();
    let index = |list: &[Event], event: &Event| list.binary_search(event).expect("it was collected") as u32;
    let mut objects: BTreeMap<&str, Vec<u32>> = BTreeMap::new();
    for (i, command) in (0..).zip(&commands).filter(|(_, command)| command.receiver != "log") {
        objects.entry(&command.receiver).or_default().push(i);
    }
    let components = objects
        .into_iter()
        .map(|(object, commands)| Component { object: object.to_owned(), commands })
        .collect();
    let mut environment = vec![Vec::new(); events.len()];
    let mut super_steps = SuperSteps::default();
    for (source, state) in (0..).zip(states) {
        match state {
            State::Environment(rows) => {
                for (short, &target) in rows {
                    environment[index(&events, &event(short)) as usize].push((source, target));
                }
            }
            State::SuperStep(list, target) => {
                let events: Vec<u32> = list.iter().map(|short| index(&commands, &command(short))).collect();
                super_steps.push(SuperStep { source, target: *target, events: &events });
            }
        }
    }
    let owed = Lists::empty(states.len());
    let states = states.len() as u32;
    Controller { states, initial: 0, events, commands, components, environment, super_steps, owed }
}

/// The notation of a controller.
pub(super) fn show(controller: &Controller) -> String {
    let mut text = String::new();
    for state in 0..controller.states {
        if let Some(step) = controller.super_steps.due(state) {
            let _ = write!(text, "{state}!");
            for &event in step.events {
                let event = &controller.commands[event as usize];
                let _ = write!(text, " {}.{}", event.receiver, event.operation);
            }
            let _ = writeln!(text, " {}", step.target);
            continue;
        }
        let mut rows = Vec::new();
        for (event, table) in controller.events.iter().zip(&controller.environment) {
            rows.extend(
                table
                    .iter()
                    .filter(|row| row.0 == state)
                    .map(|row| format!(" {} {}", event.operation, row.1)),
            );
        }
        let _ = writeln!(text, "{state}:{}", rows.join(","));
    }
    text
}

/// The notation without indentation and blank lines.
pub(super) fn trim(lines: &str) -> String {
    lines.lines().map(str::trim).filter(|line| !line.is_empty()).map(|line| format!("{line}\n")).collect()
}

/// Index of an environment event.
pub(super) fn event_index(controller: &Controller, short: &str) -> u32 {
    let event = event(short);
    controller.events.iter().position(|other| *other == event).expect("an event of the controller") as u32
}

/// States with few labels, so that many of them are alike; all targets in range.
pub(super) fn states(max: u32) -> impl Strategy<Value = Vec<State>> {
    (1..=max).prop_flat_map(|count| {
        let environment =
            prop::collection::btree_map(prop::sample::select(vec!["a", "b", "c"]), 0..count, 0..=3).prop_map(
                |rows| State::Environment(rows.into_iter().map(|(e, t)| (e.to_owned(), t)).collect()),
            );
        let lists =
            vec!["arm.go", "arm.stop", "arm.go press.go", "press.go arm.go", "log.x", "log.x arm.go log.x"];
        let super_step = (prop::sample::select(lists), 0..count).prop_map(|(list, target)| {
            State::SuperStep(list.split(' ').map(str::to_owned).collect(), target)
        });
        prop::collection::vec(prop_oneof![2 => environment, 1 => super_step], count as usize)
    })
}

/// Controllers with something owed in every other state.
pub(super) fn controllers(max: u32) -> impl Strategy<Value = Controller> {
    states(max).prop_map(|states| {
        let mut controller = build(&states);
        let events = controller.events.len() as u32;
        for state in (0..controller.owed.len()).step_by(2) {
            let owed: Vec<u32> =
                (0..events).filter(|event| (state as u32 + event).is_multiple_of(3)).collect();
            controller.owed.set(state, &owed);
        }
        controller
    })
}

//! Enumerations and `match`, as one writes by hand: a function for each state, which matches the event. Of the forms that
//! were tried (also one `match` over pairs, and one inside the other) it is the smallest, and compiles several times
//! faster.

use super::super::subject::Subject;
use super::items::{commands, items, states};
use std::fmt::Write as _;

pub(super) fn source(subject: &Subject) -> String {
    let mut text = items(subject, "Clone, Copy");
    let _ = writeln!(text, "#[derive(Clone, Copy)]\npub enum State {{ {} }}", states(subject));
    let mut arms = String::new();
    for state in 0..subject.states {
        let _ = writeln!(arms, "        State::S{state} => s{state}(event),");
        let _ = writeln!(
            text,
            "fn s{state}(event: Event) -> Option<(State, Commands)> {{\n    Some(match event {{"
        );
        for row in subject.rows_of(state) {
            let (event, target, commands) = (row.event, row.target, commands(&subject.codes(row)));
            let _ = writeln!(text, "        Event::E{event} => (State::S{target}, {commands}),");
        }
        if subject.rows_of(state).len() < subject.events.len() {
            text.push_str("        _ => return None,\n");
        }
        text.push_str("    })\n}\n");
    }
    let _ = writeln!(
        text,
        "fn next(state: State, event: Event) -> Option<(State, Commands)> {{\n    match state {{\n{arms}    }}\n}}"
    );
    text.push_str(
        "pub struct Machine { state: State }
pub fn new() -> Machine { Machine { state: State::S0 } }
#[inline(never)]
pub fn step(machine: &mut Machine, event: Event) -> Option<Commands> {
    let (state, commands) = next(machine.state, event)?;
    machine.state = state;
    Some(commands)
}
",
    );
    text
}

//! The crate `statig`: a method for each state, by its attribute. Commands are given through the context; a machine that
//! is initialised beforehand need not ask whether it is.

use super::super::subject::Subject;
use super::items::{commands, items};
use std::fmt::Write as _;

pub(super) fn source(subject: &Subject) -> String {
    let mut states = String::new();
    for state in 0..subject.states {
        let _ = writeln!(
            states,
            "    #[state]
    fn s{state}(context: &mut Option<Commands>, event: &Event) -> Outcome<State> {{
        match event {{"
        );
        for row in subject.rows_of(state) {
            let (event, target, commands) = (row.event, row.target, commands(&subject.codes(row)));
            let _ = writeln!(
                states,
                "            Event::E{event} => {{
                *context = Some({commands});
                Transition(State::s{target}())
            }}"
            );
        }
        if subject.rows_of(state).len() < subject.events.len() {
            states.push_str("            _ => Super,\n");
        }
        states.push_str("        }\n    }\n");
    }
    format!(
        "{}
use statig::blocking::InitializedStateMachine;
use statig::prelude::*;
pub struct Line;
#[state_machine(initial = \"State::s0()\")]
impl Line {{
{states}}}
pub type Machine = InitializedStateMachine<Line>;
pub fn new() -> Machine {{ Line.uninitialized_state_machine().init_with_context(&mut None) }}
#[inline(never)]
pub fn step(machine: &mut Machine, event: Event) -> Option<Commands> {{
    let mut answer = None;
    machine.handle_with_context(&event, &mut answer);
    answer
}}
",
        items(subject, "Clone, Copy")
    )
}

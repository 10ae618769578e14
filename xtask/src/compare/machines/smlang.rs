//! The crate `smlang`: its table of transitions. Commands are given by actions, into the temporary context, so that a
//! machine has nothing but its state.

use super::super::subject::Subject;
use super::items::{after_events, commands};
use std::collections::BTreeMap;
use std::fmt::Write as _;

pub(super) fn source(subject: &Subject) -> String {
    let mut actions = BTreeMap::new();
    let mut transitions = String::new();
    for row in &subject.rows {
        let start = if row.source == 0 && transitions.is_empty() { "*" } else { "" };
        let _ = write!(transitions, "        {start}S{} + E{}", row.source, row.event);
        let codes = subject.codes(row);
        if row.step.is_some() {
            let next = actions.len();
            let action = actions.entry(codes).or_insert(next);
            let _ = write!(transitions, " / command{action}");
        }
        let _ = writeln!(transitions, " = S{},", row.target);
    }
    let mut methods = String::new();
    for (codes, action) in &actions {
        let commands = commands(codes);
        let _ = writeln!(
            methods,
            "    fn command{action}(&mut self, commands: &mut Commands) -> Result<(), ()> {{
        *commands = {commands};
        Ok(())
    }}"
        );
    }
    format!(
        "smlang::statemachine! {{
    temporary_context: &mut Commands,
    derive_states: [Clone, Copy],
    derive_events: [Clone, Copy],
    transitions: {{
{transitions}    }}
}}
pub use Events as Event;
{}
pub struct Context;
impl StateMachineContext for Context {{
{methods}}}
pub type Machine = StateMachine<Context>;
pub fn new() -> Machine {{ StateMachine::new(Context) }}
#[inline(never)]
pub fn step(machine: &mut Machine, event: Event) -> Option<Commands> {{
    let mut commands = NONE;
    machine.process_event(&mut commands, event).ok()?;
    Some(commands)
}}
",
        after_events(subject)
    )
}

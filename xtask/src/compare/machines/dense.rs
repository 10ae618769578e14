//! `[[u16; E]; S]`: an entry for every state and event, 65,535 where it is refused. Entries from the number of states on
//! are super steps, which have their target and commands in a second array.

use super::super::subject::Subject;
use super::items::{commands, items};
use std::fmt::Write as _;

const REFUSED: u16 = u16::MAX;

pub(super) fn source(subject: &Subject) -> String {
    let (states, events) = (subject.states, subject.events.len());
    let mut text = items(subject, "Clone, Copy");
    let _ = writeln!(text, "static NEXT: [[u16; {events}]; {states}] = [");
    for state in 0..states {
        let mut entries = vec![REFUSED; events];
        for row in subject.rows_of(state) {
            entries[row.event as usize] = row.step.map_or(row.target, |step| states + step) as u16;
        }
        let _ = writeln!(text, "    {entries:?},");
    }
    let _ = writeln!(text, "];\nstatic STEPS: [(u16, Commands); {}] = [", subject.steps.len());
    for step in &subject.steps {
        let _ = writeln!(text, "    ({}, {}),", step.target, commands(&step.codes));
    }
    let _ = writeln!(
        text,
        "];
pub struct Machine {{ state: u16 }}
pub fn new() -> Machine {{ Machine {{ state: 0 }} }}
#[inline(never)]
pub fn step(machine: &mut Machine, event: Event) -> Option<Commands> {{
    let next = NEXT.get(usize::from(machine.state))?[event as usize];
    if next < {states} {{
        machine.state = next;
        return Some(NONE);
    }}
    let (state, commands) = STEPS.get(usize::from(next - {states}))?;
    machine.state = *state;
    Some(*commands)
}}"
    );
    text
}

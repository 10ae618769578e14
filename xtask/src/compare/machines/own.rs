//! The tables of this project, as a build script or `sml export` writes them.

use super::super::subject::Subject;
use std::fmt::Write as _;
use synth_core::controller::tables::{Provenance, Tables};
use synth_core::emit::rust::{Engine, Options, name_map, text};

/// The module is private, as in a program: the compiler need not generate what nobody calls.
pub(super) fn source(subject: &Subject, engine: Engine) -> String {
    let tables = Tables::new("Line", &subject.controller(), Provenance::default());
    let module = text(&tables, &Options { engine, ..Options::default() });
    let mut events = String::new();
    for (number, (_, variant)) in name_map(&tables).events.iter().enumerate() {
        let _ = writeln!(events, "        {number} => Event::{variant},");
    }
    format!(
        "mod tables {{
{module}
}}
pub use tables::line::{{Commands, Event}};
pub struct Machine(tables::line::Controller);
pub fn new() -> Machine {{ Machine(tables::line::Controller::new()) }}
pub fn event(number: u8) -> Option<Event> {{
    Some(match number {{
{events}        _ => return None,
    }})
}}
#[inline(never)]
pub fn step(machine: &mut Machine, event: Event) -> Option<Commands> {{ machine.0.react(event) }}
"
    )
}

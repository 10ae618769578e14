//! The tables of this project, as a build script or `sml export` writes them.

use super::super::subject::Subject;
use synth_core::controller::tables::{Provenance, Tables};
use synth_core::emit::rust::{Engine, Options, text};

pub(super) fn source(subject: &Subject, engine: Engine) -> String {
    let tables = Tables::new("Line", &subject.controller(), Provenance::default());
    let module = text(&tables, &Options { engine, ..Options::default() });
    format!(
        "{module}
pub use line::{{Commands, Event}};
pub type Machine = line::Controller;
pub fn new() -> Machine {{ Machine::new() }}
pub fn event(number: u8) -> Option<Event> {{ Event::ALL.get(usize::from(number)).copied() }}
#[inline(never)]
pub fn step(machine: &mut Machine, event: Event) -> Option<Commands> {{ machine.react(event) }}
"
    )
}

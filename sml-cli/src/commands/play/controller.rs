//! The controller as a player: it answers every event of the environment.

use synth_core::controller::Controller;
use synth_core::controller::cycle::{Commands, Machine};

/// A controller at work in a play.
pub(super) struct Controlled<'c> {
    controller: &'c Controller,
    machine: Machine<'c>,
}

impl<'c> Controlled<'c> {
    pub(super) fn new(controller: &'c Controller) -> Self {
        Controlled { controller, machine: Machine::new(controller) }
    }

    /// Starts anew: what it does before any event.
    pub(super) fn begin(&mut self) -> Vec<&'c str> {
        self.machine.reset();
        let first = self.machine.cycle();
        self.super_step(first)
    }

    /// Its system events in answer to an event of the environment.
    pub(super) fn answer(&mut self, event: &str) -> Vec<&'c str> {
        let events = &self.controller.events;
        let index = events.binary_search_by(|candidate| candidate.text.as_str().cmp(event));
        let first = index.ok().and_then(|index| self.machine.react(index as u32));
        first.map_or(Vec::new(), |first| self.super_step(first))
    }

    /// All parts of a super step, which may be split.
    fn super_step(&mut self, first: Commands) -> Vec<&'c str> {
        let mut texts = Vec::new();
        let mut part = first;
        while !part.events.is_empty() {
            texts.extend(
                part.events.iter().map(|&event| self.controller.commands[event as usize].text.as_str()),
            );
            part = self.machine.cycle();
        }
        texts
    }
}

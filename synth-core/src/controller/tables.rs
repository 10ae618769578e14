//! The tables that every back end emits (controller contract, section 2): one mapping function per environment
//! event, one for the super steps with a command code per component.

use super::{Component, Controller, Event, Level};
use crate::fnv::Fnv;

/// Bumped whenever the meaning of emitted tables changes; part of every output.
pub const FORMAT_VERSION: u32 = 1;

/// Two arrays of equal length: `source` ascending, `target`.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Mapping {
    /// States in which the mapping is defined, ascending.
    pub source: Vec<u32>,
    /// Where it leads from each.
    pub target: Vec<u32>,
}

/// The mapping function of one environment event.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct EventTable {
    /// The event.
    pub event: Event,
    /// Its rows; may be empty.
    pub mapping: Mapping,
}

/// The codes that super steps command to one component.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ComponentTable {
    /// The component's object.
    pub object: String,
    /// Its commands; `commands[i]` has the code `i + 1`.
    pub commands: Vec<Event>,
    /// Per row of the super steps: a code, 0 for none.
    pub codes: Vec<u32>,
}

/// A scenario's or constraint's name and requirement, for comments.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Requirement {
    /// `Collaboration.Scenario`, or the name of a constraint.
    pub scenario: String,
    /// `assumption`, `guarantee` or `existential`; `constraint` of a plant.
    pub kind: &'static str,
    /// Its `///` lines.
    pub text: Vec<String>,
    /// The file that it stands in, as the user named it.
    pub file: String,
    /// Line of its name there; 0 if it is not told.
    pub line: u32,
}

/// What generated files say of their origin.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Provenance {
    /// The specification's file as the user named it, or `sml!`.
    pub file: String,
    /// FNV-1a of all input text, 16 hex digits.
    pub hash: String,
    /// Options beside those of the target, as in a command line, each with a space in front: those that made another
    /// controller of it than the defaults would, and where templates went.
    pub options: String,
    /// How the controller was minimised.
    pub level: Level,
    /// It is no controller but a [monitor](mod@super::monitor).
    pub monitor: bool,
    /// Every scenario in textual order.
    pub requirements: Vec<Requirement>,
}

/// Everything a back end needs, and nothing else.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Tables {
    /// The specification's name as written.
    pub specification: String,
    /// Number of states.
    pub states: u32,
    /// The initial state.
    pub initial: u32,
    /// In table order.
    pub events: Vec<EventTable>,
    /// The super steps.
    pub super_steps: Mapping,
    /// In order of the objects' names.
    pub components: Vec<ComponentTable>,
    /// Per state: indices of the events that the environment owes there, ascending.
    pub owed: Vec<Vec<u32>>,
    /// For comments.
    pub provenance: Provenance,
}

impl Tables {
    /// Lays out a controller.
    #[must_use]
    pub fn new(specification: &str, controller: &Controller, provenance: Provenance) -> Self {
        let events = controller
            .events
            .iter()
            .zip(&controller.environment)
            .map(|(event, rows)| {
                let (source, target) = rows.iter().copied().unzip();
                EventTable { event: event.clone(), mapping: Mapping { source, target } }
            })
            .collect();
        let steps = &controller.super_steps;
        let super_steps = Mapping { source: steps.source.clone(), target: steps.target.clone() };
        Tables {
            specification: specification.to_owned(),
            states: controller.states,
            initial: controller.initial,
            events,
            super_steps,
            components: component_tables(controller),
            owed: controller.owed.iter().map(<[u32]>::to_vec).collect(),
            provenance,
        }
    }

    /// What a saved state means: two controllers have the same version if states, events and commands are the same in
    /// both, and don't-cares were used alike, whatever language or engine they are in; what is owed does not count. Not 0, which memory holds that has
    /// never been written, and within all integer types of 32 bits.
    #[must_use]
    pub fn version(&self) -> u32 {
        let mut hash = Fnv::new();
        hash.numbers(&[FORMAT_VERSION, self.states, self.initial]);
        hash.text(&self.specification);
        // Who saved what was pending, or saw every event of a scan, may have been in a state that means something else here.
        if matches!(self.provenance.level, Level::Assume | Level::Ordered) {
            hash.text(self.provenance.level.name());
        }
        for table in &self.events {
            hash.text(&table.event.text);
            hash.numbers(&table.mapping.source);
            hash.numbers(&table.mapping.target);
        }
        hash.numbers(&self.super_steps.source);
        hash.numbers(&self.super_steps.target);
        for component in &self.components {
            hash.text(&component.object);
            component.commands.iter().for_each(|command| hash.text(&command.text));
            hash.numbers(&component.codes);
        }
        let folded = hash.finish() ^ (hash.finish() >> 32);
        (folded as u32 & i32::MAX as u32).max(1)
    }
}

fn component_tables(controller: &Controller) -> Vec<ComponentTable> {
    let steps = controller.super_steps.len();
    // Per command: its component and its code there.
    let mut place = vec![None; controller.commands.len()];
    let mut tables = Vec::with_capacity(controller.components.len());
    for (component, Component { object, commands }) in controller.components.iter().enumerate() {
        for (&command, code) in commands.iter().zip(1..) {
            place[command as usize] = Some((component, code));
        }
        tables.push(ComponentTable {
            object: object.clone(),
            commands: commands.iter().map(|&command| controller.commands[command as usize].clone()).collect(),
            codes: vec![0; steps],
        });
    }
    for (row, step) in controller.super_steps.iter().enumerate() {
        for (component, code) in step.events.iter().filter_map(|&command| place[command as usize]) {
            tables[component].codes[row] = code;
        }
    }
    tables
}

#[cfg(test)]
mod tests {
    use super::super::fixtures::controller;
    use super::*;

    #[test]
    fn every_component_has_a_code_per_super_step() {
        let lines = "0! arm.go log.x 1 \n 1! press.go arm.stop 2 \n 2! log.x 3 \n 3! press.go 0";
        let tables = Tables::new("S", &controller(lines), Provenance::default());
        let codes: Vec<_> = tables.components.iter().map(|c| (c.object.as_str(), &c.codes[..])).collect();
        assert_eq!(codes, [("arm", &[1, 2, 0, 0][..]), ("press", &[0, 1, 0, 1][..])]);
    }
}

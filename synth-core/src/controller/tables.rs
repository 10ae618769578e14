//! The tables that every back end emits (controller contract, section 2): one mapping function per environment
//! event, one for the super steps with a command code per component.

use super::{Controller, Event};

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

/// A scenario's name and requirement, for comments.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Requirement {
    /// `Collaboration.Scenario`.
    pub scenario: String,
    /// `assumption`, `guarantee` or `existential`.
    pub kind: &'static str,
    /// Its `///` lines.
    pub text: Vec<String>,
    /// Line of its name in the specification.
    pub line: u32,
}

/// What generated files say of their origin.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Provenance {
    /// The specification's file as the user named it, or `sml!`.
    pub file: String,
    /// FNV-1a of all input text, 16 hex digits.
    pub hash: String,
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
        let super_steps = Mapping {
            source: steps.iter().map(|step| step.source).collect(),
            target: steps.iter().map(|step| step.target).collect(),
        };
        Tables {
            specification: specification.to_owned(),
            states: controller.states,
            initial: controller.initial,
            events,
            super_steps,
            components: component_tables(controller),
            owed: controller.owed.clone(),
            provenance,
        }
    }
}

fn component_tables(controller: &Controller) -> Vec<ComponentTable> {
    let code_in = |commands: &[u32], step: &[u32]| {
        step.iter().find_map(|event| commands.iter().position(|c| c == event)).map_or(0, |i| i as u32 + 1)
    };
    controller
        .components
        .iter()
        .map(|component| ComponentTable {
            object: component.object.clone(),
            commands: component.commands.iter().map(|&c| controller.commands[c as usize].clone()).collect(),
            codes: controller.super_steps.iter().map(|s| code_in(&component.commands, &s.events)).collect(),
        })
        .collect()
}

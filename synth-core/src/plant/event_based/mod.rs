//! The controller that follows events: a closed loop as tables, for plants whose state cannot be read.
//!
//! Its states are the entries of the closed loop. An uncontrollable event is an environment event, a controllable one the
//! command of a super step; so every back end of controllers writes it. Other than the controllers of scenarios, it has
//! states with rows of events *and* a super step: events that are pending go first, and the command is given for the state
//! after all of them. So a command never answers a state that the inputs of the same scan have left.
//!
//! Where several commands are possible, exactly one is chosen ([`choose`]); batches of events that leave in doubt what
//! happened are found by [`races`].

mod choice;
mod never_given;
mod races;

pub use choice::choose;
pub use never_given::never_given;
pub use races::{Race, Races, races};

use super::{ClosedLoop, EventId, Plant};
use crate::controller::tables::{Provenance, Requirement, Tables};
use crate::controller::{
    Component, Controller, Event, Level, Lists, SuperStep, SuperSteps, minimize, number,
};
use crate::syntax::Span;
use std::collections::BTreeMap;

/// The party opposite the automata in event texts.
const CONTROLLER: &str = "controller";

/// The closed loop with the chosen commands. State `i` is entry `i`, whether it can be reached or not.
///
/// The texts are `Barrel -> controller.filled()` for an uncontrollable event and `controller -> Boom.right()` for a command,
/// with the first component that names the event. One that no component names never happens and has no text.
#[must_use]
pub fn controller(plant: &Plant, closed: &ClosedLoop) -> Controller {
    let vocabulary = Vocabulary::new(plant);
    let index = |event: EventId| vocabulary.index[event as usize];
    let mut controller = vocabulary.interface();
    for ((source, chosen), entry) in (0..).zip(choose(plant, closed)).zip(0..closed.len()) {
        for &(event, target) in closed.edges(entry) {
            if !plant.events[event as usize].controllable {
                controller.environment[index(event) as usize].push((source, target));
            }
        }
        if let Some((event, target)) = chosen {
            controller.super_steps.push(SuperStep { source, target, events: &[index(event)] });
        }
    }
    let (states, initial) = (closed.len() as u32, closed.initial);
    Controller { states, initial, owed: Lists::empty(closed.len()), ..controller }
}

/// The events, commands and components of [`controller`] in one that does nothing: what names are made of, whether there is
/// a feedback or not.
#[must_use]
pub fn interface(plant: &Plant) -> Controller {
    Vocabulary::new(plant).interface()
}

/// What outputs say of their origin, with the constraints as requirements, in textual order.
#[must_use]
pub fn provenance(plant: &Plant, provenance: Provenance) -> Provenance {
    let conditions = plant.constraints.iter().map(|one| (&one.name, &one.doc, one.span));
    let automata = plant.automata[plant.components..].iter().map(|one| (&one.name, &one.doc, one.span));
    let mut all: Vec<_> = conditions.chain(automata).collect();
    all.sort_by_key(|(.., span)| span.start);
    let requirement = |(name, doc, span): (&String, &Vec<String>, Span)| Requirement {
        scenario: name.clone(),
        kind: "constraint",
        text: doc.clone(),
        file: provenance.file.clone(),
        line: span.start.line,
    };
    let requirements = all.into_iter().map(requirement).collect();
    Provenance { requirements, ..provenance }
}

/// The tables of [`controller`], minimised as `level` says and numbered.
#[must_use]
pub fn tables(plant: &Plant, closed: &ClosedLoop, level: Level, provenance: Provenance) -> Tables {
    let controller = number(minimize(controller(plant, closed), level));
    Tables::new(&plant.name, &controller, provenance)
}

/// The events that components name, in table order.
struct Vocabulary {
    events: Vec<Event>,
    commands: Vec<Event>,
    /// By event of the plant, its place in one of both; [`NONE`] if no component names it.
    index: Vec<u32>,
}

const NONE: u32 = u32::MAX;

impl Vocabulary {
    fn new(plant: &Plant) -> Self {
        let mut all: Vec<(Event, EventId)> =
            (0..plant.events.len() as EventId).filter_map(|id| Some((text(plant, id)?, id))).collect();
        all.sort_unstable_by(|a, b| a.0.text.cmp(&b.0.text));
        let mut vocabulary =
            Vocabulary { events: Vec::new(), commands: Vec::new(), index: vec![NONE; plant.events.len()] };
        for (event, id) in all {
            let controllable = plant.events[id as usize].controllable;
            let side = if controllable { &mut vocabulary.commands } else { &mut vocabulary.events };
            vocabulary.index[id as usize] = side.len() as u32;
            side.push(event);
        }
        vocabulary
    }

    fn interface(&self) -> Controller {
        let mut by_object: BTreeMap<&str, Vec<u32>> = BTreeMap::new();
        for (place, command) in (0..).zip(&self.commands) {
            by_object.entry(&command.receiver).or_default().push(place);
        }
        let components = by_object
            .into_iter()
            .map(|(object, commands)| Component { object: object.to_owned(), commands })
            .collect();
        Controller {
            states: 1,
            initial: 0,
            environment: vec![Vec::new(); self.events.len()],
            super_steps: SuperSteps::default(),
            owed: Lists::empty(1),
            events: self.events.clone(),
            commands: self.commands.clone(),
            components,
        }
    }
}

/// An event as back ends name it; `None` if no component names it.
fn text(plant: &Plant, id: EventId) -> Option<Event> {
    let automaton = plant.automata[..plant.components]
        .iter()
        .find(|automaton| automaton.alphabet.binary_search(&id).is_ok())?;
    let event = &plant.events[id as usize];
    let (sender, receiver) =
        if event.controllable { (CONTROLLER, &*automaton.name) } else { (&*automaton.name, CONTROLLER) };
    Some(Event {
        text: format!("{sender} -> {receiver}.{}()", event.name),
        sender: sender.to_owned(),
        receiver: receiver.to_owned(),
        operation: event.name.clone(),
        arguments: Vec::new(),
    })
}

//! The controller: a deterministic machine over environment events and super steps, and what is made of it.

mod alphabet;
mod bisimulation;
pub(crate) mod calls;
pub mod comb;
pub mod cycle;
mod event_text;
#[cfg(test)]
mod fixtures;
#[cfg(feature = "json")]
pub mod json;
mod kinds;
mod lists;
pub mod minimize;
pub mod monitor;
pub mod number;
pub(crate) mod partition;
mod reduce;
pub mod runs;
mod step_table;
pub mod stimulus;
pub mod super_steps;
pub mod tables;

pub use alphabet::{Alphabet, Letter};
pub use lists::Lists;
pub use minimize::{Level, minimize, minimize_assuming, minimize_on, never_fewer};
pub use monitor::monitor;
pub use number::{number, number_on};
pub use step_table::{SuperStep, SuperSteps};
pub use super_steps::{EndlessSuperStep, interface, merge};

/// An event of the controlled system, taken apart.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Event {
    /// `sender -> receiver.operation(a, b)`; the order of tables is the byte order of these texts.
    pub text: String,
    /// Sending object.
    pub sender: String,
    /// Receiving object.
    pub receiver: String,
    /// Operation.
    pub operation: String,
    /// Arguments as they stand in the text.
    pub arguments: Vec<String>,
}

/// A component: an object that is not controllable and receives system events.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Component {
    /// The object's name.
    pub object: String,
    /// Its commands, as indices into [`Controller::commands`], in table order; code `i + 1` is `commands[i]`.
    pub commands: Vec<u32>,
}

/// A controller, already split (at most one command per component in a super step).
///
/// In a state with environment rows and a super step, events that are pending go first. Only controllers of plants have such
/// states ([`crate::plant::event_based`]): of a scenario, a state has one or the other, an extra state between two parts
/// of a split super step has only the super step, and verification refuses a controller that was read if it is otherwise
/// in a state that can be reached.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Controller {
    /// States are `0..states`.
    pub states: u32,
    /// The initial one.
    pub initial: u32,
    /// Environment events of the whole explored graph, in table order.
    pub events: Vec<Event>,
    /// System events of the whole explored graph, in table order, those between controllable objects too.
    pub commands: Vec<Event>,
    /// Components in order of their names.
    pub components: Vec<Component>,
    /// Per environment event its rows `(source, target)`, sources ascending.
    pub environment: Vec<Vec<(u32, u32)>>,
    /// In ascending order of their sources.
    pub super_steps: SuperSteps,
    /// Per state: the environment events (indices, ascending) that assumptions promise there.
    pub owed: Lists,
}

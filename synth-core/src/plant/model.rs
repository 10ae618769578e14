//! A plant whose names are resolved: signals, events, components and constraints.

use super::Condition;
use crate::syntax::Span;

/// Position among [`Plant::signals`].
pub type SignalId = u32;
/// Position among [`Plant::events`].
pub type EventId = u32;
/// Position among [`Plant::automata`].
pub type AutomatonId = u32;

/// A whole plant. Everything is in textual order, except that components stand before constraint automata.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Plant {
    /// Its name as written.
    pub name: String,
    /// Its `///` lines.
    pub doc: Vec<String>,
    /// Inputs, outputs, memory bits and ranges: all Booleans that formulas are about.
    pub signals: Vec<Signal>,
    /// Digitised analogue inputs that ranges refer to; none of them is a Boolean.
    pub analogues: Vec<String>,
    /// Controllable and uncontrollable events.
    pub events: Vec<Event>,
    /// Components, then constraint automata.
    pub automata: Vec<Automaton>,
    /// How many of the automata are components.
    pub components: usize,
    /// Constraints that are conditions.
    pub constraints: Vec<Constraint>,
}

impl Plant {
    /// What the states of all automata are called, `Door.Shut` and so on.
    #[must_use]
    pub fn state_names(&self, states: &[u16]) -> Vec<String> {
        let each = self.automata.iter().zip(states);
        each.map(|(automaton, &state)| {
            format!("{}.{}", automaton.name, automaton.states[state as usize].name)
        })
        .collect()
    }
}

/// A Boolean that the controller reads, and perhaps writes.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Signal {
    /// As written.
    pub name: String,
    /// Where its value comes from.
    pub kind: SignalKind,
    /// Its `///` lines.
    pub doc: Vec<String>,
    /// Its name.
    pub span: Span,
}

/// Where the value of a signal comes from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SignalKind {
    /// A sensor.
    Input,
    /// An actuator: set and reset by events, read as it was last written.
    Output,
    /// A relay of the controller: as an output, but not connected.
    Memory,
    /// An analogue input lies in a range, both ends included.
    Range {
        /// Position among [`Plant::analogues`].
        analogue: u32,
        /// Least value.
        low: i64,
        /// Greatest value.
        high: i64,
    },
}

/// Something that happens in the plant.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Event {
    /// As written.
    pub name: String,
    /// The controller causes it, by its commands; else it happens by itself.
    pub controllable: bool,
    /// What the controller does to cause it; empty for an uncontrollable one.
    pub commands: Vec<Command>,
    /// Its `///` lines.
    pub doc: Vec<String>,
    /// Its name.
    pub span: Span,
}

/// An output or memory bit is set or reset.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Command {
    /// Which.
    pub signal: SignalId,
    /// `set`, else `reset`.
    pub set: bool,
}

/// A deterministic automaton: a component of the plant, or a constraint on the events that it names.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Automaton {
    /// As written.
    pub name: String,
    /// In textual order.
    pub states: Vec<State>,
    /// Where it starts.
    pub initial: u32,
    /// The events that it names, ascending: it takes part in each of them.
    pub alphabet: Vec<EventId>,
    /// Its `///` lines.
    pub doc: Vec<String>,
    /// Its name.
    pub span: Span,
}

/// A state of an automaton.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct State {
    /// As written.
    pub name: String,
    /// A task is complete here. Where no state of an automaton is written so, all are.
    pub marked: bool,
    /// What the inputs and outputs are in this state; `None` if nothing is written.
    pub formula: Option<Condition<SignalId>>,
    /// By event, ascending; at most one an event.
    pub edges: Vec<Edge>,
    /// Its `///` lines.
    pub doc: Vec<String>,
    /// Its name.
    pub span: Span,
}

/// What an event does in a state.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Edge {
    /// The event.
    pub event: EventId,
    /// The next state.
    pub target: u32,
    /// `event -> target`.
    pub span: Span,
}

/// A state of some automaton, as constraints name it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct StateRef {
    /// The automaton.
    pub automaton: AutomatonId,
    /// Its state.
    pub state: u32,
}

/// A condition on what may happen.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Constraint {
    /// As written.
    pub name: String,
    /// What it says.
    pub rule: Rule,
    /// Its `///` lines.
    pub doc: Vec<String>,
    /// Its name.
    pub span: Span,
}

/// The kinds of conditions.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Rule {
    /// `e only when c`, and `e not when c` with the condition negated: where the condition does not hold, the event must not
    /// happen.
    Only {
        /// The event.
        event: EventId,
        /// Where it may happen.
        when: Condition<StateRef>,
    },
    /// `never c`: a state in which it holds is bad.
    Never(Condition<StateRef>),
}

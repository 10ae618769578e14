//! The syntax tree of a plant, as written: names are not resolved.

use super::{Condition, SignalKind};
use crate::syntax::Span;
use crate::syntax::ast::{Name, Path};

/// One file: `plant ID { … }`.
#[derive(Clone, PartialEq, Debug)]
pub struct File {
    /// The `///` lines above it.
    pub doc: Vec<String>,
    /// The plant's name.
    pub name: Name,
    /// In textual order.
    pub items: Vec<Item>,
    /// Whether everything that declares a name was read: mistakes, if any, cost only conditions, edges and commands.
    pub declares_all: bool,
}

/// What stands in a plant.
#[derive(Clone, PartialEq, Debug)]
pub enum Item {
    /// `input …`, `output …`, `memory …`.
    Signals(Signals),
    /// `range A = B in 0..=9`.
    Range(Range),
    /// `controllable …`, `uncontrollable …`.
    Event(Event),
    /// `automaton …`: a component.
    Component(Automaton),
    /// `constraint automaton …`.
    ConstraintAutomaton(Automaton),
    /// `constraint A: …`.
    Constraint(Constraint),
}

/// Inputs, outputs or memory bits, one or several.
#[derive(Clone, PartialEq, Debug)]
pub struct Signals {
    /// The `///` lines above all of them.
    pub doc: Vec<String>,
    /// Never [`SignalKind::Range`].
    pub kind: SignalKind,
    /// Each with the `///` lines above it alone.
    pub names: Vec<(Vec<String>, Name)>,
}

/// `range NAME = ANALOGUE in LOW..=HIGH`.
#[derive(Clone, PartialEq, Debug)]
pub struct Range {
    /// The `///` lines above it.
    pub doc: Vec<String>,
    /// The Boolean.
    pub name: Name,
    /// The analogue input.
    pub analogue: Name,
    /// Least value.
    pub low: i64,
    /// Greatest value.
    pub high: i64,
    /// `LOW..=HIGH`.
    pub span: Span,
}

/// `controllable NAME { set A reset B }`.
#[derive(Clone, PartialEq, Debug)]
pub struct Event {
    /// The `///` lines above it.
    pub doc: Vec<String>,
    /// Else uncontrollable.
    pub controllable: bool,
    /// Its name.
    pub name: Name,
    /// In textual order.
    pub commands: Vec<Command>,
}

/// `set NAME` or `reset NAME`.
#[derive(Clone, PartialEq, Debug)]
pub struct Command {
    /// `set`, else `reset`.
    pub set: bool,
    /// What is set or reset.
    pub signal: Name,
    /// All of it.
    pub span: Span,
}

/// `automaton NAME { state* }`.
#[derive(Clone, PartialEq, Debug)]
pub struct Automaton {
    /// The `///` lines above it.
    pub doc: Vec<String>,
    /// Its name.
    pub name: Name,
    /// In textual order.
    pub states: Vec<State>,
}

/// `initial marked state NAME [formula] { edge* }`.
#[derive(Clone, PartialEq, Debug)]
pub struct State {
    /// The `///` lines above it.
    pub doc: Vec<String>,
    /// The word `initial`, if it stands there.
    pub initial: Option<Span>,
    /// Whether `marked` stands there.
    pub marked: bool,
    /// Its name.
    pub name: Name,
    /// What is in brackets.
    pub formula: Option<Condition<Path>>,
    /// In textual order.
    pub edges: Vec<Edge>,
}

/// `event -> state`.
#[derive(Clone, PartialEq, Debug)]
pub struct Edge {
    /// The event.
    pub event: Name,
    /// The next state.
    pub target: Name,
}

impl Edge {
    /// All of it.
    #[must_use]
    pub fn span(&self) -> Span {
        self.event.span.to(self.target.span)
    }
}

/// `constraint NAME: rule`.
#[derive(Clone, PartialEq, Debug)]
pub struct Constraint {
    /// The `///` lines above it.
    pub doc: Vec<String>,
    /// Its name.
    pub name: Name,
    /// What it says.
    pub rule: Rule,
}

/// What a constraint says.
#[derive(Clone, PartialEq, Debug)]
pub enum Rule {
    /// `EVENT only when …`.
    Only(Name, Condition<Path>),
    /// `EVENT not when …`.
    Not(Name, Condition<Path>),
    /// `never …`.
    Never(Condition<Path>),
}

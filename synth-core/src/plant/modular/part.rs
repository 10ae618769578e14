//! A part of a plant as a plant of its own.

use super::super::{
    AutomatonId, Command, Condition, Constraint, Edge, EventId, Plant, Rule, SignalId, SignalKind, StateRef,
};
use super::scope::{Scope, place};
use std::collections::BTreeSet;

/// Some automata with the events and signals that they name, and some constraints, all with numbers of their own.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Part {
    /// As a plant.
    pub plant: Plant,
    /// What the whole calls its automata, ascending: components, then constraint automata.
    pub automata: Vec<AutomatonId>,
    /// What the whole calls its events, ascending.
    pub events: Vec<EventId>,
    /// What the whole calls its signals, ascending.
    pub signals: Vec<SignalId>,
}

impl Part {
    /// The part of a plant that a scope is about.
    pub(super) fn new(whole: &Plant, scope: &Scope) -> Self {
        let automata: Vec<AutomatonId> = scope.automata.iter().copied().collect();
        let events = events(whole, scope);
        let signals = signals(whole, &automata, &events);
        let mut analogues: Vec<u32> = signals
            .iter()
            .filter_map(|&signal| match whole.signals[signal as usize].kind {
                SignalKind::Range { analogue, .. } => Some(analogue),
                _ => None,
            })
            .collect();
        analogues.sort_unstable();
        analogues.dedup();
        let numbers = Numbers { automata: &automata, events: &events, signals: &signals };
        let plant = Plant {
            name: whole.name.clone(),
            doc: Vec::new(),
            signals: signals
                .iter()
                .map(|&id| {
                    let mut signal = whole.signals[id as usize].clone();
                    if let SignalKind::Range { analogue, .. } = &mut signal.kind {
                        *analogue = place(&analogues, *analogue).unwrap_or_default();
                    }
                    signal
                })
                .collect(),
            analogues: analogues.iter().map(|&id| whole.analogues[id as usize].clone()).collect(),
            events: events.iter().map(|&id| numbers.event(whole, id)).collect(),
            automata: automata.iter().map(|&id| numbers.automaton(whole, id)).collect(),
            components: automata.partition_point(|&id| (id as usize) < whole.components),
            constraints: scope
                .constraints
                .iter()
                .filter_map(|&id| numbers.constraint(&whole.constraints[id as usize]))
                .collect(),
        };
        Part { plant, automata, events, signals }
    }
}

/// The events that automata of the scope name, or its conditions.
fn events(whole: &Plant, scope: &Scope) -> Vec<EventId> {
    let named = scope.automata.iter().flat_map(|&id| whole.automata[id as usize].alphabet.iter().copied());
    let restrained = scope.constraints.iter().filter_map(|&id| match whole.constraints[id as usize].rule {
        Rule::Only { event, .. } => Some(event),
        Rule::Never(_) => None,
    });
    let all: BTreeSet<EventId> = named.chain(restrained).collect();
    all.into_iter().collect()
}

/// The signals that show the automata or are commanded by the events.
fn signals(whole: &Plant, automata: &[AutomatonId], events: &[EventId]) -> Vec<SignalId> {
    let mut all = BTreeSet::new();
    for &automaton in automata {
        for formula in
            whole.automata[automaton as usize].states.iter().filter_map(|state| state.formula.as_ref())
        {
            formula.atoms(&mut |&signal| {
                all.insert(signal);
            });
        }
    }
    for &event in events {
        all.extend(whole.events[event as usize].commands.iter().map(|command| command.signal));
    }
    all.into_iter().collect()
}

struct Numbers<'n> {
    automata: &'n [AutomatonId],
    events: &'n [EventId],
    signals: &'n [SignalId],
}

impl Numbers<'_> {
    fn event(&self, whole: &Plant, id: EventId) -> super::super::Event {
        let mut event = whole.events[id as usize].clone();
        event.commands = event
            .commands
            .iter()
            .filter_map(|command| Some(Command { signal: place(self.signals, command.signal)?, ..*command }))
            .collect();
        event
    }

    fn automaton(&self, whole: &Plant, id: AutomatonId) -> super::super::Automaton {
        let mut automaton = whole.automata[id as usize].clone();
        let event = |event: EventId| place(self.events, event);
        automaton.alphabet = automaton.alphabet.iter().filter_map(|&id| event(id)).collect();
        for state in &mut automaton.states {
            state.edges = state
                .edges
                .iter()
                .filter_map(|edge| Some(Edge { event: event(edge.event)?, ..*edge }))
                .collect();
            let formula = state.formula.take();
            state.formula =
                formula.and_then(|formula| formula.resolved(&mut |&signal| place(self.signals, signal)));
        }
        automaton
    }

    fn constraint(&self, constraint: &Constraint) -> Option<Constraint> {
        let there = |condition: &Condition<StateRef>| {
            condition.resolved(&mut |atom: &StateRef| {
                Some(StateRef { automaton: place(self.automata, atom.automaton)?, state: atom.state })
            })
        };
        let rule = match &constraint.rule {
            Rule::Only { event, when } => {
                Rule::Only { event: place(self.events, *event)?, when: there(when)? }
            }
            Rule::Never(condition) => Rule::Never(there(condition)?),
        };
        Some(Constraint { rule, ..constraint.clone() })
    }
}

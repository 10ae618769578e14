//! From the tree of a plant to the resolved [`Plant`]: everything that can be refused before a product is built.
//!
//! One pass per kind of declaration, in the order in which they need each other. A pass that finds a mistake records
//! it and goes on with what it has, so that one run shows as many mistakes as possible.

mod automata;
mod conditions;
mod signals;
mod warnings;

use std::collections::BTreeMap;

use super::ast::{self, Item};
use super::{AutomatonId, EventId, Plant, Signal, SignalId};
use crate::diagnostic::{Code, Diagnostic};
use crate::suggest::nearest;
use crate::syntax::Span;
use crate::syntax::ast::Name;

/// Resolves a plant.
///
/// The plant is present only if there is no error; then the diagnostics are warnings. They come in the order of their
/// places. A tree that does not declare all (see [`ast::File::declares_all`]) has errors that are none.
#[must_use]
pub fn resolve(file: &ast::File) -> (Option<Plant>, Vec<Diagnostic>) {
    let mut resolver = Resolver::default();
    resolver.signals(file);
    let events = resolver.events(file);
    let (automata, components) = resolver.automata(file);
    let constraints = resolver.constraints(file);
    let Resolver { signals, analogues, mut diagnostics, mut odd, .. } = resolver;
    if !diagnostics.is_empty() {
        diagnostics.sort_by_key(|d| d.span.start);
        return (None, diagnostics);
    }
    let plant = Plant {
        name: file.name.text.clone(),
        doc: file.doc.clone(),
        signals,
        analogues: analogues.into_iter().map(str::to_owned).collect(),
        events,
        automata,
        components,
        constraints,
    };
    odd.extend(warnings::warnings(&plant));
    odd.sort_by_key(|d| d.span.start);
    (Some(plant), odd)
}

/// So many other places of one mistake are shown.
const MOST_LABELS: usize = 3;

/// What the name of a signal stands for.
#[derive(Clone, Copy, Debug)]
enum Meaning {
    Signal(SignalId),
    Analogue,
}

/// The state of the passes.
#[derive(Default)]
struct Resolver<'a> {
    signals: Vec<Signal>,
    analogues: Vec<&'a str>,
    signal_names: BTreeMap<&'a str, (Meaning, Span)>,
    event_names: BTreeMap<&'a str, (EventId, Span)>,
    /// Automata and constraints share one name space.
    automaton_names: BTreeMap<&'a str, (Option<AutomatonId>, Span)>,
    /// By automaton.
    state_names: Vec<BTreeMap<&'a str, (u32, Span)>>,
    /// The error about each unknown name, apart for each kind of thing.
    unknown: BTreeMap<(String, &'a str), usize>,
    /// Errors.
    diagnostics: Vec<Diagnostic>,
    /// Warnings.
    odd: Vec<Diagnostic>,
}

/// The automata of a file, components first, with their position.
fn automata(file: &ast::File) -> impl Iterator<Item = &ast::Automaton> {
    let components = file.items.iter().filter_map(|item| match item {
        Item::Component(automaton) => Some(automaton),
        _ => None,
    });
    let constraints = file.items.iter().filter_map(|item| match item {
        Item::ConstraintAutomaton(automaton) => Some(automaton),
        _ => None,
    });
    components.chain(constraints)
}

impl<'a> Resolver<'a> {
    fn error(&mut self, error: Diagnostic) {
        self.diagnostics.push(error);
    }

    /// Enters a name; reports it if it is taken.
    fn declare<T>(
        &mut self,
        what: &str,
        names: impl FnOnce(&mut Self) -> &mut BTreeMap<&'a str, (T, Span)>,
        name: &'a Name,
        meaning: T,
    ) {
        let names = names(self);
        if let Some(&(_, first)) = names.get(name.text.as_str()) {
            let message = format!("{what} `{}` is declared a second time", name.text);
            let error = Diagnostic::error(Code::DuplicateName, name.span, message);
            self.error(error.also(first, "first declared here").help("rename one of the two"));
        } else {
            names.insert(&name.text, (meaning, name.span));
        }
    }

    /// Reports a name that means nothing. A name that was unknown before becomes a label of the error about the first.
    fn unknown(&mut self, what: &str, name: &'a Name, help: Option<String>, known: &[&str]) {
        let key = (what.to_owned(), name.text.as_str());
        if let Some(&first) = self.unknown.get(&key) {
            let labels = &mut self.diagnostics[first].labels;
            if labels.len() < MOST_LABELS {
                labels.push((name.span, "and here".to_owned()));
            }
            return;
        }
        self.unknown.insert(key, self.diagnostics.len());
        let help = help.unwrap_or_else(|| match nearest(&name.text, known.iter().copied()) {
            Some(near) => format!("write `{near}`, which is declared"),
            None => format!("declare `{}`, or write a name that is declared", name.text),
        });
        let message = format!("unknown {what} `{}`", name.text);
        self.error(Diagnostic::error(Code::UnknownName, name.span, message).help(help));
    }

    fn event(&mut self, name: &'a Name) -> Option<EventId> {
        if let Some(&(event, _)) = self.event_names.get(name.text.as_str()) {
            return Some(event);
        }
        let known: Vec<&str> = self.event_names.keys().copied().collect();
        self.unknown("event", name, None, &known);
        None
    }
}

/// Names, of which each is unique, that differ from an earlier one by case only: the earlier and the later one.
fn same_but_case<'a>(names: impl Iterator<Item = (&'a str, Span)>) -> Vec<[(&'a str, Span); 2]> {
    let mut by_lower: BTreeMap<String, (&str, Span)> = BTreeMap::new();
    let mut pairs = Vec::new();
    for (name, span) in names {
        match by_lower.get(&name.to_ascii_lowercase()) {
            Some(&first) if first.0 != name => pairs.push([first, (name, span)]),
            Some(_) => {}
            None => _ = by_lower.insert(name.to_ascii_lowercase(), (name, span)),
        }
    }
    pairs
}

//! Components and constraint automata.

use std::collections::BTreeMap;

use super::{Resolver, automata};
use crate::diagnostic::{Code, Diagnostic};
use crate::plant::ast::{self, Item};
use crate::plant::{Automaton, AutomatonId, Edge, EventId, State};
use crate::syntax::Span;

/// An automaton can have this many states, so that a state fits into 16 bits.
const MAX_STATES: usize = 1 << 16;

impl<'a> Resolver<'a> {
    /// All automata, components first, and how many components there are.
    pub(super) fn automata(&mut self, file: &'a ast::File) -> (Vec<Automaton>, usize) {
        let trees: Vec<&ast::Automaton> = automata(file).collect();
        let components = file.items.iter().filter(|item| matches!(item, Item::Component(_))).count();
        if components == 0 {
            let message = format!("the plant `{}` has no component", file.name.text);
            let error = Diagnostic::error(Code::NoStates, file.name.span, message);
            self.error(error.help("add a component: `automaton Name { … }`"));
        }
        for (id, tree) in trees.iter().enumerate() {
            let what = if id < components { "automaton" } else { "constraint" };
            let id = Some(id as AutomatonId);
            self.declare(what, |this| &mut this.automaton_names, &tree.name, id);
            self.declare_states(tree);
        }
        for item in &file.items {
            if let Item::Constraint(constraint) = item {
                self.declare("constraint", |this| &mut this.automaton_names, &constraint.name, None);
            }
        }
        let resolved = (0..).zip(trees).map(|(id, tree)| self.automaton(id, tree)).collect();
        (resolved, components)
    }

    fn declare_states(&mut self, tree: &'a ast::Automaton) {
        self.state_names.push(BTreeMap::new());
        let last = self.state_names.len() - 1;
        for (index, state) in (0..).zip(&tree.states) {
            self.declare("state", |this| &mut this.state_names[last], &state.name, index);
        }
    }

    fn automaton(&mut self, id: usize, tree: &'a ast::Automaton) -> Automaton {
        let all_marked = tree.states.iter().all(|state| !state.marked);
        let initial = self.initial(tree);
        let states: Vec<State> = tree
            .states
            .iter()
            .map(|state| State {
                name: state.name.text.clone(),
                marked: all_marked || state.marked,
                formula: state.formula.as_ref().and_then(|formula| self.formula(formula)),
                edges: self.edges(id, &tree.name.text, state),
                doc: state.doc.clone(),
                span: state.name.span,
            })
            .collect();
        let mut alphabet: Vec<EventId> =
            states.iter().flat_map(|state| &state.edges).map(|edge| edge.event).collect();
        alphabet.sort_unstable();
        alphabet.dedup();
        let (name, doc, span) = (tree.name.text.clone(), tree.doc.clone(), tree.name.span);
        Automaton { name, states, initial, alphabet, doc, span }
    }

    fn initial(&mut self, tree: &ast::Automaton) -> u32 {
        let name = &tree.name;
        if tree.states.is_empty() {
            let message = format!("the automaton `{}` has no states", name.text);
            let error = Diagnostic::error(Code::NoStates, name.span, message);
            self.error(error.help("add its states, or remove it"));
            return 0;
        }
        if let Some(state) = tree.states.get(MAX_STATES) {
            let message = format!("the automaton `{}` has more than {MAX_STATES} states", name.text);
            let error = Diagnostic::error(Code::AutomatonTooLarge, state.name.span, message);
            self.error(error.help("split it into several automata"));
        }
        let mut initial =
            (0..).zip(&tree.states).filter_map(|(index, state)| Some((index, state.initial?, &state.name)));
        let Some((first, first_word, first_name)) = initial.next() else {
            let message = format!("the automaton `{}` has no initial state", name.text);
            let error = Diagnostic::error(Code::InitialState, name.span, message);
            let candidate = &tree.states[0].name.text;
            self.error(error.help(format!("write `initial state {candidate}`, or another one")));
            return 0;
        };
        if let Some((_, word, second)) = initial.next() {
            let message =
                format!("the automaton `{}` has a second initial state `{}`", name.text, second.text);
            let error = Diagnostic::error(Code::InitialState, word, message);
            let error = error.also(first_word, format!("the first is `{}`", first_name.text));
            self.error(error.help("remove one of the two words `initial`"));
        }
        first
    }

    fn edges(&mut self, id: usize, automaton: &str, state: &'a ast::State) -> Vec<Edge> {
        let mut edges: BTreeMap<EventId, (Edge, Span)> = BTreeMap::new();
        for edge in &state.edges {
            let event = self.event(&edge.event);
            let target = self.state_names[id].get(edge.target.text.as_str()).map(|&(target, _)| target);
            if target.is_none() {
                let known: Vec<&str> = self.state_names[id].keys().copied().collect();
                let what = format!("state of `{automaton}`:");
                let elsewhere =
                    self.state_names.iter().any(|states| states.contains_key(edge.target.text.as_str()));
                let help = elsewhere
                    .then(|| format!("write a state of `{automaton}`: an edge stays in its automaton"));
                self.unknown(&what, &edge.target, help, &known);
            }
            let (Some(event), Some(target)) = (event, target) else { continue };
            if let Some((_, earlier)) = edges.get(&event) {
                let (event, state) = (&edge.event.text, &state.name.text);
                let message = format!("`{event}` leads out of `{state}` a second time");
                let error = Diagnostic::error(Code::Nondeterministic, edge.span(), message);
                let error = error.also(*earlier, "the first time");
                self.error(error.help("remove one of the two, or give them events of their own"));
                continue;
            }
            edges.insert(event, (Edge { event, target, span: edge.span() }, edge.span()));
        }
        edges.into_values().map(|(edge, _)| edge).collect()
    }
}

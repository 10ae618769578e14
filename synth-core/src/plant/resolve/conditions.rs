//! Formulas of states, and constraints that are conditions.

use super::{Meaning, Resolver};
use crate::diagnostic::{Code, Diagnostic};
use crate::plant::ast::{self, Item};
use crate::plant::{Condition, Constraint, Rule, SignalId, StateRef};
use crate::syntax::ast::{Name, Path};

impl<'a> Resolver<'a> {
    /// The formula of a state.
    pub(super) fn formula(&mut self, formula: &'a Condition<Path>) -> Option<Condition<SignalId>> {
        formula.resolved(&mut |path| self.signal(path))
    }

    fn signal(&mut self, path: &'a Path) -> Option<SignalId> {
        let [name] = path.names.as_slice() else {
            let message = "the formula of a state is about inputs and outputs, not about states";
            let error = Diagnostic::error(Code::WrongKind, path.span, message);
            self.error(
                error.help("write what the inputs and outputs are in that state, or use a constraint"),
            );
            return None;
        };
        match self.meaning("input or output", name)? {
            Meaning::Signal(signal) => Some(signal),
            Meaning::Analogue => {
                let declared = self.signal_names[name.text.as_str()].1;
                let message = format!("`{}` is an analogue input, not a Boolean", name.text);
                let error = Diagnostic::error(Code::NotBoolean, name.span, message);
                let error = error.also(declared, "declared here");
                self.error(error.help("write the name of one of its ranges"));
                None
            }
        }
    }

    /// All constraints that are conditions.
    pub(super) fn constraints(&mut self, file: &'a ast::File) -> Vec<Constraint> {
        let mut constraints = Vec::new();
        for item in &file.items {
            let Item::Constraint(tree) = item else { continue };
            let rule = self.rule(&tree.rule);
            constraints.extend(rule.map(|rule| Constraint {
                name: tree.name.text.clone(),
                rule,
                doc: tree.doc.clone(),
                span: tree.name.span,
            }));
        }
        constraints
    }

    fn rule(&mut self, rule: &'a ast::Rule) -> Option<Rule> {
        match rule {
            ast::Rule::Never(condition) => self.states(condition).map(Rule::Never),
            ast::Rule::Only(event, when) => {
                let (event, when) = (self.event(event), self.states(when));
                Some(Rule::Only { event: event?, when: when? })
            }
            ast::Rule::Not(event, when) => {
                let (event, when) = (self.event(event), self.states(when));
                Some(Rule::Only { event: event?, when: Condition::Not(Box::new(when?)) })
            }
        }
    }

    fn states(&mut self, condition: &'a Condition<Path>) -> Option<Condition<StateRef>> {
        condition.resolved(&mut |path| match path.names.as_slice() {
            [automaton, state] => self.state(automaton, state),
            [bare, ..] => {
                self.bare(bare);
                None
            }
            [] => None,
        })
    }

    fn state(&mut self, automaton: &'a Name, state: &'a Name) -> Option<StateRef> {
        let Some(&(Some(id), _)) = self.automaton_names.get(automaton.text.as_str()) else {
            let named = self.automaton_names.iter().filter(|(_, (id, _))| id.is_some());
            let known: Vec<&str> = named.map(|(&name, _)| name).collect();
            let is_condition = self.automaton_names.contains_key(automaton.text.as_str());
            let help = is_condition
                .then(|| format!("write the name of an automaton: `{}` is a condition", automaton.text));
            self.unknown("automaton", automaton, help, &known);
            return None;
        };
        let states = &self.state_names[id as usize];
        if let Some(&(index, _)) = states.get(state.text.as_str()) {
            return Some(StateRef { automaton: id, state: index });
        }
        let known: Vec<&str> = states.keys().copied().collect();
        self.unknown(&format!("state of `{}`:", automaton.text), state, None, &known);
        None
    }

    /// Reports a name without that of its automaton.
    fn bare(&mut self, name: &'a Name) {
        let text = name.text.as_str();
        let mut owners: Vec<(u32, &str)> = self
            .automaton_names
            .iter()
            .filter_map(|(&automaton, &(id, _))| Some((id?, automaton)))
            .filter(|&(id, _)| self.state_names[id as usize].contains_key(text))
            .collect();
        owners.sort_unstable();
        let message = format!("`{text}` is not a state with the name of its automaton");
        let error = Diagnostic::error(Code::WrongKind, name.span, message);
        let help = match owners.as_slice() {
            [] if self.signal_names.contains_key(text) => {
                "write the state in which it is so: `Automaton.State`".to_owned()
            }
            [] if self.automaton_names.contains_key(text) => {
                format!("write which of its states: `{text}.State`")
            }
            [] => "write `Automaton.State`".to_owned(),
            owners => {
                let choices: Vec<String> =
                    owners.iter().take(3).map(|(_, automaton)| format!("`{automaton}.{text}`")).collect();
                format!("write {}", choices.join(" or "))
            }
        };
        self.error(error.help(help));
    }
}

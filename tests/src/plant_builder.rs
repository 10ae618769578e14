//! Plants written in few characters, for tests and for families with parameters.

use synth_core::plant::{
    Automaton, Condition, Constraint, Edge, Event, EventId, Plant, Rule, State, StateRef,
};
use synth_core::syntax::Span;

/// A plant that grows.
///
/// ```
/// use sml_tests::plant_builder::PlantBuilder;
///
/// let plant = PlantBuilder::new()
///     .controllable("start")
///     .uncontrollable("done")
///     .component("Machine", "Idle* start Busy, Busy done Idle")
///     .never("Rest", "Machine.Busy")
///     .build();
/// assert_eq!(plant.automata[0].states.len(), 2);
/// ```
#[derive(Clone, Debug)]
pub struct PlantBuilder {
    plant: Plant,
}

impl Default for PlantBuilder {
    fn default() -> Self {
        PlantBuilder::new()
    }
}

impl PlantBuilder {
    /// Without anything.
    #[must_use]
    pub fn new() -> Self {
        PlantBuilder {
            plant: Plant {
                name: "Test".to_owned(),
                doc: Vec::new(),
                signals: Vec::new(),
                analogues: Vec::new(),
                events: Vec::new(),
                automata: Vec::new(),
                components: 0,
                constraints: Vec::new(),
            },
        }
    }

    /// Events of the controller, by names between spaces.
    #[must_use]
    pub fn controllable(self, names: &str) -> Self {
        self.events(names, true)
    }

    /// Events of the plant, by names between spaces.
    #[must_use]
    pub fn uncontrollable(self, names: &str) -> Self {
        self.events(names, false)
    }

    fn events(mut self, names: &str, controllable: bool) -> Self {
        self.plant.events.extend(names.split_whitespace().map(|name| Event {
            name: name.to_owned(),
            controllable,
            commands: Vec::new(),
            doc: Vec::new(),
            span: Span::default(),
        }));
        self
    }

    /// A component: `source event target` between commas. The first state is the initial one, states are in order of their
    /// first mention, `*` behind the first mention of a state marks it; a source alone is a state without edges.
    #[must_use]
    pub fn component(mut self, name: &str, edges: &str) -> Self {
        assert_eq!(self.plant.components, self.plant.automata.len(), "components come first");
        self.plant.components += 1;
        self.automaton(name, edges)
    }

    /// A constraint automaton, written likewise.
    #[must_use]
    pub fn constraint(self, name: &str, edges: &str) -> Self {
        self.automaton(name, edges)
    }

    fn automaton(mut self, name: &str, edges: &str) -> Self {
        let mut states: Vec<State> = Vec::new();
        let mut alphabet = Vec::new();
        for edge in edges.split(',') {
            let words: Vec<&str> = edge.split_whitespace().collect();
            let source = state(&mut states, words[0]);
            let &[_, event, target] = words.as_slice() else { continue };
            let target = state(&mut states, target);
            let event = self.event(event);
            alphabet.push(event);
            states[source as usize].edges.push(Edge { event, target, span: Span::default() });
        }
        if states.iter().all(|state| !state.marked) {
            states.iter_mut().for_each(|state| state.marked = true);
        }
        states.iter_mut().for_each(|state| state.edges.sort_unstable_by_key(|edge| edge.event));
        alphabet.sort_unstable();
        alphabet.dedup();
        self.plant.automata.push(Automaton {
            name: name.to_owned(),
            states,
            initial: 0,
            alphabet,
            doc: Vec::new(),
            span: Span::default(),
        });
        self
    }

    /// The last automaton names these events, too, although no edge has them.
    #[must_use]
    pub fn naming(mut self, events: &str) -> Self {
        let events: Vec<EventId> = events.split_whitespace().map(|event| self.event(event)).collect();
        let alphabet = &mut self.plant.automata.last_mut().expect("an automaton").alphabet;
        alphabet.extend(events);
        alphabet.sort_unstable();
        alphabet.dedup();
        self
    }

    /// An event may happen only where a condition holds, written as in the language.
    #[must_use]
    pub fn only(mut self, event: &str, when: &str) -> Self {
        let rule = Rule::Only { event: self.event(event), when: self.condition(when) };
        self.rule(&format!("Only{}", self.plant.constraints.len()), rule);
        self
    }

    /// What must never hold.
    #[must_use]
    pub fn never(mut self, name: &str, condition: &str) -> Self {
        let rule = Rule::Never(self.condition(condition));
        self.rule(name, rule);
        self
    }

    /// A rule as a value.
    pub fn rule(&mut self, name: &str, rule: Rule) {
        let name = name.to_owned();
        self.plant.constraints.push(Constraint { name, rule, doc: Vec::new(), span: Span::default() });
    }

    /// The plant.
    #[must_use]
    pub fn build(self) -> Plant {
        self.plant
    }

    fn event(&self, name: &str) -> EventId {
        event(&self.plant, name)
    }

    fn condition(&self, text: &str) -> Condition<StateRef> {
        let spaced = ["(", ")", "!", "&&", "||"]
            .iter()
            .fold(text.to_owned(), |text, token| text.replace(token, &format!(" {token} ")));
        let tokens: Vec<&str> = spaced.split_whitespace().collect();
        let mut rest = tokens.as_slice();
        let condition = self.any(&mut rest);
        assert!(rest.is_empty(), "{text}");
        condition
    }

    fn any(&self, rest: &mut &[&str]) -> Condition<StateRef> {
        let mut parts = vec![self.all(rest)];
        while take(rest, "||") {
            parts.push(self.all(rest));
        }
        if parts.len() == 1 { parts.remove(0) } else { Condition::Or(parts) }
    }

    fn all(&self, rest: &mut &[&str]) -> Condition<StateRef> {
        let mut parts = vec![self.one(rest)];
        while take(rest, "&&") {
            parts.push(self.one(rest));
        }
        if parts.len() == 1 { parts.remove(0) } else { Condition::And(parts) }
    }

    fn one(&self, rest: &mut &[&str]) -> Condition<StateRef> {
        if take(rest, "!") {
            return Condition::Not(Box::new(self.one(rest)));
        }
        if take(rest, "(") {
            let inner = self.any(rest);
            assert!(take(rest, ")"), "`)` before {rest:?}");
            return inner;
        }
        let (automaton, state) = rest[0].split_once('.').expect("Component.State");
        *rest = &rest[1..];
        Condition::Atom(place(&self.plant, automaton, state))
    }
}

fn take(rest: &mut &[&str], token: &str) -> bool {
    let found = rest.first() == Some(&token);
    if found {
        *rest = &rest[1..];
    }
    found
}

/// The position of a state, which is new if it was not mentioned.
fn state(states: &mut Vec<State>, mention: &str) -> u32 {
    let name = mention.trim_end_matches('*');
    let position = states.iter().position(|state| state.name == name).unwrap_or_else(|| {
        states.push(State {
            name: name.to_owned(),
            marked: false,
            formula: None,
            edges: Vec::new(),
            doc: Vec::new(),
            span: Span::default(),
        });
        states.len() - 1
    });
    states[position].marked |= mention.ends_with('*');
    position as u32
}

/// The event of this name.
///
/// # Panics
/// If there is none.
#[must_use]
pub fn event(plant: &Plant, name: &str) -> EventId {
    plant.events.iter().position(|event| event.name == name).unwrap_or_else(|| panic!("event {name}")) as u32
}

/// The state of this name.
///
/// # Panics
/// If there is none.
#[must_use]
pub fn place(plant: &Plant, automaton: &str, state: &str) -> StateRef {
    let found = plant.automata.iter().position(|one| one.name == automaton);
    let automaton = found.unwrap_or_else(|| panic!("automaton {automaton}"));
    let found = plant.automata[automaton].states.iter().position(|one| one.name == state);
    let state = found.unwrap_or_else(|| panic!("state {state}")) as u32;
    StateRef { automaton: automaton as u32, state }
}

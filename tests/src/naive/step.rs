//! One step (section 3).

use super::eval::{EvalError, Names, Scope};
use super::progress::{Reaction, initial_messages};
use super::settle::{SettleError, Settled};
use super::spec::Spec;
use super::state::{Attributes, Copy, Key, Roles, State, Variables};
use super::value::{Event, Value};
use std::collections::{BTreeMap, BTreeSet};
use synth_core::syntax::ast::ScenarioKind;

/// What a step leads to.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Step {
    /// The next state; violated copies are gone.
    pub state: State,
    /// Kinds of the scenarios that were violated.
    pub violated: BTreeSet<ScenarioKind>,
    /// Kinds of the scenarios that were violated, had they not been relaxed.
    pub excused: BTreeSet<ScenarioKind>,
    /// Keys of the obligations that were met.
    pub discharged: BTreeSet<Key>,
}

/// A step that cannot be made, because the specification is wrong.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct PlayError {
    /// The first error.
    pub cause: SettleError,
    /// Kinds of the scenarios that are violated all the same.
    pub violated: BTreeSet<ScenarioKind>,
}

impl Spec {
    /// The initial state.
    ///
    /// # Errors
    /// A scenario that starts at once and is violated at once, or does not settle.
    pub fn initial(&self) -> Result<State, String> {
        let mut copies = BTreeSet::new();
        for (index, scenario) in self.scenarios.iter().enumerate() {
            if scenario.kind == ScenarioKind::Existential || initial_messages(&scenario.body).is_some() {
                continue;
            }
            let copy = Copy {
                scenario: index,
                roles: Roles::new(),
                variables: Variables::new(),
                cut: super::cut::Cut::default(),
            };
            let describe = |error| format!("{} at the start: {error:?}", scenario.name);
            let bound = self.bind_roles(copy, &self.attributes).map_err(|error| describe(error.into()))?;
            let Some(copy) = bound else { continue };
            match self.settle(&self.attributes, copy, &mut BTreeSet::new()).map_err(describe)? {
                Settled::Active(copy) => {
                    copies.insert(copy);
                }
                Settled::Ended => {}
                Settled::Violated if self.relaxed.contains(&index) => {}
                Settled::Violated => return Err(format!("{} is violated at the start", scenario.name)),
            }
        }
        Ok(State { attributes: self.attributes.clone(), copies, yielded: false })
    }

    /// What the event does to the state.
    ///
    /// # Errors
    /// An attribute or variable out of its range, a path through `null`, a loop that does not settle.
    pub fn step(&self, state: &State, event: &Event) -> Result<Step, PlayError> {
        let before = &state.attributes;
        let mut broken = BTreeSet::new();
        let mut discharged = BTreeSet::new();
        let mut errors: Vec<SettleError> = Vec::new();

        // 1. Effects.
        let after = self.effects(before, event).unwrap_or_else(|error| {
            errors.push(error.into());
            before.clone()
        });

        // 2. Progress, which looks at the state before the effects.
        let mut unsettled = Vec::new();
        for copy in &state.copies {
            // What a copy owes in this state is discharged when it passes it now; what it comes to and passes within
            // the step was never open.
            let mut owed = self.obligations(copy);
            match self.progress(before, copy, event) {
                Ok(Reaction::Stays) => unsettled.push((copy.clone(), owed)),
                Ok(Reaction::Moves { copy, message }) => {
                    discharged.extend(owed.remove(&message));
                    unsettled.push((copy, owed));
                }
                Ok(Reaction::Ends) => {}
                Ok(Reaction::Violates) => {
                    broken.insert(copy.scenario);
                }
                Err(error) => errors.push(error.into()),
            }
        }

        // 3. Activation.
        if errors.is_empty() {
            match self.activate(before, &after, event) {
                Ok(started) => {
                    unsettled.extend(started.into_iter().map(|copy| (copy, BTreeMap::new())));
                }
                Err(error) => errors.push(error.into()),
            }
        }

        // 4. Settling.
        let mut copies = BTreeSet::new();
        if errors.is_empty() {
            for (copy, mut owed) in unsettled {
                let scenario = copy.scenario;
                let mut passed_waits = BTreeSet::new();
                let settled = self.settle(&after, copy, &mut passed_waits);
                discharged.extend(passed_waits.iter().filter_map(|wait| owed.remove(wait)));
                match settled {
                    Ok(Settled::Active(copy)) => {
                        copies.insert(copy);
                    }
                    Ok(Settled::Ended) => {}
                    Ok(Settled::Violated) => {
                        broken.insert(scenario);
                    }
                    Err(error) => errors.push(error),
                }
            }
        }

        // What is relaxed does not count.
        let kind = |scenario: &usize| self.scenarios[*scenario].kind;
        let violated = broken.difference(&self.relaxed).map(kind).collect();
        let excused = broken.intersection(&self.relaxed).map(kind).collect();
        discharged.retain(|key: &Key| !self.relaxed.contains(&key.scenario));

        // 5. The yield is over.
        match errors.into_iter().next() {
            Some(cause) => Err(PlayError { cause, violated }),
            None => {
                let state = State { attributes: after, copies, yielded: false };
                Ok(Step { state, violated, excused, discharged })
            }
        }
    }

    /// The attributes after every effect that matches, in textual order, and then the implicit `setX`.
    fn effects(&self, before: &Attributes, event: &Event) -> Result<Attributes, EvalError> {
        let mut attributes = before.clone();
        let matching = self.effects.iter().filter(|effect| {
            effect.operation.text == event.operation
                && effect.parameters.len() == event.arguments.len()
                && self.is_endpoint(&event.sender, &effect.sender.text)
                && self.is_endpoint(&event.receiver, &effect.receiver.text)
        });
        for effect in matching {
            let mut names: BTreeMap<String, Value> = BTreeMap::new();
            names.insert("sender".into(), Value::Object(event.sender.clone()));
            names.insert("receiver".into(), Value::Object(event.receiver.clone()));
            let parameters = effect.parameters.iter().map(|name| name.text.clone());
            names.extend(parameters.zip(event.arguments.iter().cloned()));
            for (path, expr) in &effect.assignments {
                let scope = Scope { spec: self, attributes: &attributes, names: Names::Effect(&names) };
                let Some((attribute, owner)) = path.names.split_last() else { continue };
                let owner = synth_core::syntax::ast::Path { names: owner.to_vec(), span: path.span };
                let object = match scope.path(&owner)? {
                    Value::Object(object) => object,
                    Value::Null => return Err(EvalError::Null(attribute.text.clone())),
                    other => return Err(EvalError::Malformed(format!("`{other}` has no attributes"))),
                };
                let ty = self.attribute_type(&object, &attribute.text);
                let ty =
                    ty.ok_or_else(|| EvalError::Malformed(format!("no attribute `{}`", attribute.text)))?;
                let value = scope.value_of_type(expr, &ty)?;
                attributes.insert((object, attribute.text.clone()), value);
            }
        }
        if let Some(attribute) = self.set_attribute(&event.receiver, &event.operation)
            && let [value] = event.arguments.as_slice()
        {
            attributes.insert((event.receiver.clone(), attribute), value.clone());
        }
        Ok(attributes)
    }
}

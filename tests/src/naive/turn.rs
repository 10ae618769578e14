//! Whose turn, and which events (section 4).

use super::cut::{causing_modality, messages};
use super::eval::{EvalError, is_constant};
use super::matching::Context;
use super::settle::SettleError;
use super::spec::Spec;
use super::state::{Copy, Roles, State, Variables};
use super::step::{PlayError, Step};
use super::value::{Event, Value};
use std::collections::{BTreeMap, BTreeSet};
use synth_core::syntax::ast::{
    Argument, ArgumentKind, Fragment, FragmentKind, Message, Modality, ScenarioKind, TypeKind,
};

/// What happens when the system breaks an assumption, and when the environment may be silent.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Semantics {
    /// The system may not break an assumption; the environment may be silent whenever it has the free turn.
    Default,
    /// The system wins by breaking an assumption; the environment is silent only where it has no event.
    Classic,
}

/// Who chooses, numbered as in the language reference.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Case {
    /// 1: the system, among `committed` events.
    SystemCommitted = 1,
    /// 2: the environment, among `committed` events.
    EnvironmentCommitted = 2,
    /// 3: the system, among `urgent` and `requested` events.
    SystemUrgent = 3,
    /// 4: the environment, among `urgent` and `requested` events.
    EnvironmentUrgent = 4,
    /// 5: the system, among `eventually` events, or it yields.
    SystemEventually = 5,
    /// 6: the environment, among all its events, or it is silent.
    EnvironmentAny = 6,
}

impl Case {
    /// The system chooses.
    #[must_use]
    pub fn is_system(self) -> bool {
        matches!(self, Case::SystemCommitted | Case::SystemUrgent | Case::SystemEventually)
    }
}

/// The executable events among which a state's owner chooses.
#[derive(Clone, Debug)]
pub struct Turn {
    /// Who.
    pub case: Case,
    /// Executable events with their steps, ordered by their text.
    pub events: Vec<(Event, Step)>,
}

/// An event that really can happen, and for which there is no step.
#[derive(Clone, Debug)]
pub struct TurnError {
    /// The event, or the message whose arguments have no value.
    pub event: String,
    /// What is wrong.
    pub cause: SettleError,
}

/// How urgent an event is.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Urgency {
    Committed,
    Urgent,
    Eventually,
}

impl Urgency {
    fn of(modality: Modality) -> Urgency {
        match modality {
            Modality::Committed => Urgency::Committed,
            Modality::Urgent | Modality::Requested => Urgency::Urgent,
            Modality::Eventually => Urgency::Eventually,
        }
    }
}

impl Spec {
    /// Every environment event that some message of an assumption or guarantee can be, whatever the state.
    #[must_use]
    pub fn environment_alphabet(&self) -> BTreeSet<Event> {
        let (roles, variables) = (Roles::new(), Variables::new());
        let mut alphabet = BTreeSet::new();
        for scenario in self.scenarios.iter().filter(|scenario| scenario.kind != ScenarioKind::Existential) {
            let context = Context {
                spec: self,
                attributes: &self.attributes,
                scenario,
                roles: &roles,
                variables: &variables,
            };
            for (body, message) in messages(&scenario.body, true) {
                for mut event in self.endpoints(&context, message) {
                    if self.is_controllable(&event.sender) {
                        continue;
                    }
                    let values = |argument: &Argument, name: &str, all: Vec<Value>| match &argument.kind {
                        ArgumentKind::Value(expr) if is_constant(expr, scenario, &body) => {
                            let constant = context.scope(&body).value(expr).into_iter();
                            constant
                                .filter(|value| {
                                    !self.is_outside_range(&event.receiver, &event.operation, name, value)
                                })
                                .collect()
                        }
                        _ => all,
                    };
                    for arguments in product(self.argument_values(&event, message, values)) {
                        event.arguments = arguments;
                        alphabet.insert(event.clone());
                    }
                }
            }
        }
        alphabet
    }

    /// One event without arguments for each sender and receiver that a message can have.
    fn endpoints(&self, context: &Context<'_>, message: &Message) -> Vec<Event> {
        let candidates = |role: &str| match (context.scenario.roles.get(role), context.roles.get(role)) {
            (Some(_), Some(object)) => vec![object.clone()],
            (Some(class), None) => self.objects_of(class),
            (None, _) => vec![role.to_owned()],
        };
        let mut events = Vec::new();
        for sender in candidates(&message.sender.text) {
            for receiver in candidates(&message.receiver.text) {
                if message.sender.text != message.receiver.text || sender == receiver {
                    let operation = message.operation.text.clone();
                    events.push(Event { sender: sender.clone(), receiver, operation, arguments: Vec::new() });
                }
            }
        }
        events
    }

    /// The values of each argument: what `values` makes of it, given the parameter's name and all of its values.
    fn argument_values(
        &self,
        event: &Event,
        message: &Message,
        values: impl Fn(&Argument, &str, Vec<Value>) -> Vec<Value>,
    ) -> Vec<Vec<Value>> {
        let parameters = self.parameters(&event.receiver, &event.operation).unwrap_or_default();
        let of = |(argument, (name, ty)): (&Argument, &(String, _))| {
            let all = self.range(&event.receiver, &event.operation, name, ty);
            let mut values = values(argument, name, all);
            values.retain(|value| self.fits(value, ty));
            values
        };
        message.arguments.iter().zip(&parameters).map(of).collect()
    }

    /// The environment's candidates in a state, all of them.
    fn environment_candidates(&self, alphabet: &BTreeSet<Event>, state: &State) -> Vec<Event> {
        let candidates = alphabet.iter().filter(|event| {
            self.has_channel(&state.attributes, event)
                && (!self.is_non_spontaneous(event)
                    || self.enabled(state, event, |fragment| match &fragment.kind {
                        FragmentKind::Message(modifier, _) => modifier.modality,
                        _ => None,
                    }) != BTreeSet::new())
        });
        candidates.cloned().collect()
    }

    /// The urgencies with which messages of assumption copies enable an event, as far as `modality` gives one.
    fn enabled(
        &self,
        state: &State,
        event: &Event,
        modality: impl Fn(&Fragment) -> Option<Modality>,
    ) -> BTreeSet<Urgency> {
        let mut found = BTreeSet::new();
        for (copy, path, fragment) in self.at_cuts(state, ScenarioKind::Assumption) {
            let FragmentKind::Message(_, message) = &fragment.kind else { continue };
            let context = Context::of(self, &state.attributes, copy);
            let matched = context.matches(&path[..path.len() - 1], message, event);
            if let (Ok(Some(_)), Some(modality)) = (matched, modality(fragment)) {
                found.insert(Urgency::of(modality));
            }
        }
        found
    }

    /// The fragments at the cuts of the copies of one kind of scenario.
    fn at_cuts<'a>(
        &'a self,
        state: &'a State,
        kind: ScenarioKind,
    ) -> impl Iterator<Item = (&'a Copy, Vec<usize>, &'a Fragment)> {
        let copies = state.copies.iter().filter(move |copy| self.scenarios[copy.scenario].kind == kind);
        copies.flat_map(|copy| {
            let fragments = copy.cut.fragments(&self.scenarios[copy.scenario].body);
            fragments.into_iter().map(move |(path, fragment)| (copy, path, fragment))
        })
    }

    /// The system's candidates, each with whether a guarantee that is not relaxed asks for it, and the messages at cuts
    /// whose arguments have no value.
    #[expect(clippy::type_complexity, reason = "read once, right below")]
    fn system_candidates(
        &self,
        state: &State,
    ) -> (BTreeMap<(Urgency, Event), bool>, Vec<(Urgency, String, EvalError)>) {
        let (mut candidates, mut errors) = (BTreeMap::new(), Vec::new());
        for (copy, path, fragment) in self.at_cuts(state, ScenarioKind::Guarantee) {
            let FragmentKind::Message(_, message) = &fragment.kind else { continue };
            let Some(modality) = causing_modality(fragment) else { continue };
            let urgency = Urgency::of(modality);
            let context = Context::of(self, &state.attributes, copy);
            for event in self.endpoints(&context, message) {
                if !self.is_controllable(&event.sender) || !self.has_channel(&state.attributes, &event) {
                    continue;
                }
                match self.system_events(&context, &path[..path.len() - 1], message, &event) {
                    Ok(events) => {
                        for event in events {
                            *candidates.entry((urgency, event)).or_default() |=
                                !self.relaxed.contains(&copy.scenario);
                        }
                    }
                    Err(error) => errors.push((urgency, event.to_string(), error)),
                }
            }
        }
        (candidates, errors)
    }

    /// The events that a message of the system stands for; evaluated arguments are not cut by ranges.
    fn system_events(
        &self,
        context: &Context<'_>,
        body: &[usize],
        message: &Message,
        event: &Event,
    ) -> Result<Vec<Event>, EvalError> {
        let parameters = self.parameters(&event.receiver, &event.operation).unwrap_or_default();
        for (argument, (_, ty)) in message.arguments.iter().zip(&parameters) {
            let ArgumentKind::Value(expr) = &argument.kind else { continue };
            match context.scope(body).value(expr) {
                // An object of a class beside the parameter's is no error: the message matches only what fits.
                Ok(Value::Object(_)) | Err(EvalError::Unset(_)) => {}
                Ok(value) if self.fits(&value, ty) => {}
                Ok(value) => return Err(EvalError::Range(value.to_string())),
                Err(error) => return Err(error),
            }
        }
        let values = |argument: &Argument, _: &str, all| match &argument.kind {
            ArgumentKind::Value(expr) => match context.scope(body).value(expr) {
                Ok(value) => vec![value],
                Err(_) => all,
            },
            // What a variable of a subclass does not take is not this message.
            ArgumentKind::Bind(name) => match context.scenario.variable(body, &name.text) {
                Some((_, ty)) if matches!(ty.kind, TypeKind::Named(_)) => {
                    all.into_iter().filter(|value| self.fits(value, ty)).collect()
                }
                _ => all,
            },
            ArgumentKind::Any => all,
        };
        let arguments = product(self.argument_values(event, message, values));
        Ok(arguments.into_iter().map(|arguments| Event { arguments, ..event.clone() }).collect())
    }

    /// The step of an event: `None` when it is not executable.
    fn executable(
        &self,
        state: &State,
        event: &Event,
        semantics: Semantics,
    ) -> Option<Result<Step, PlayError>> {
        let outcome = self.step(state, event);
        let violated = match &outcome {
            Ok(step) => &step.violated,
            Err(error) => &error.violated,
        };
        let forbidden = self.not_to_violate(event, semantics);
        (!forbidden.iter().any(|kind| violated.contains(kind))).then_some(outcome)
    }

    /// The kinds of scenarios that an event must not violate to be executable.
    fn not_to_violate(&self, event: &Event, semantics: Semantics) -> &'static [ScenarioKind] {
        match (self.is_controllable(&event.sender), semantics) {
            (true, Semantics::Default) => &[ScenarioKind::Guarantee, ScenarioKind::Assumption],
            (true, Semantics::Classic) => &[ScenarioKind::Guarantee],
            (false, _) => &[ScenarioKind::Assumption],
        }
    }

    /// Whose turn it is, and what can be chosen.
    ///
    /// # Errors
    /// An event of the turn for which there is no step.
    pub fn turn(
        &self,
        alphabet: &BTreeSet<Event>,
        state: &State,
        semantics: Semantics,
    ) -> Result<Turn, TurnError> {
        let (system, errors) = self.system_candidates(state);
        let environment: Vec<(Event, BTreeSet<Urgency>)> = self
            .environment_candidates(alphabet, state)
            .into_iter()
            .map(|event| {
                let urgencies = self.enabled(state, &event, causing_modality);
                (event, urgencies)
            })
            .collect();

        let would_be_executable = |(event, step): &(Event, Step)| {
            !self.not_to_violate(event, semantics).iter().any(|kind| step.excused.contains(kind))
        };
        // The executable events of the system in two parts: those that force the turn, and those that it may choose
        // because something is relaxed: what asks for them, or what forbids them.
        let of_system = |urgency| -> Result<[Vec<(Event, Step)>; 2], TurnError> {
            if let Some((_, event, error)) = errors.iter().find(|(each, ..)| *each == urgency) {
                return Err(TurnError { event: event.clone(), cause: SettleError::Eval(error.clone()) });
            }
            let of_urgency = system.keys().filter(|(each, _)| *each == urgency);
            let events = self.executable_events(state, semantics, of_urgency.map(|(_, event)| event))?;
            let (must, may) = events
                .into_iter()
                .partition(|choice| system[&(urgency, choice.0.clone())] && would_be_executable(choice));
            Ok([must, may])
        };
        // Those of the environment, if one of them forces the turn.
        let of_environment = |urgency| -> Result<Vec<(Event, Step)>, TurnError> {
            let events = environment.iter().filter(|(_, urgencies)| urgencies.contains(&urgency));
            let events = self.executable_events(state, semantics, events.map(|(event, _)| event))?;
            Ok(if events.iter().any(would_be_executable) { events } else { Vec::new() })
        };

        // What the system may do here, though nothing in force makes it.
        let mut choices = Vec::new();
        for (urgency, of_the_system, of_the_environment) in [
            (Urgency::Committed, Case::SystemCommitted, Case::EnvironmentCommitted),
            (Urgency::Urgent, Case::SystemUrgent, Case::EnvironmentUrgent),
        ] {
            let [must, may] = of_system(urgency)?;
            let forced = !must.is_empty();
            choices.extend([must, may].concat());
            if forced {
                return Ok(Turn { case: of_the_system, events: by_text(choices) });
            }
            let events = of_environment(urgency)?;
            if !events.is_empty() {
                let passes = state.yielded || choices.is_empty();
                return Ok(if passes {
                    Turn { case: of_the_environment, events }
                } else {
                    Turn { case: Case::SystemEventually, events: by_text(choices) }
                });
            }
        }
        if !state.yielded {
            choices.extend(of_system(Urgency::Eventually)?.concat());
            if !choices.is_empty() {
                return Ok(Turn { case: Case::SystemEventually, events: by_text(choices) });
            }
        }
        let events = self.executable_events(state, semantics, environment.iter().map(|(event, _)| event))?;
        Ok(Turn { case: Case::EnvironmentAny, events })
    }

    fn executable_events<'a>(
        &self,
        state: &State,
        semantics: Semantics,
        events: impl Iterator<Item = &'a Event>,
    ) -> Result<Vec<(Event, Step)>, TurnError> {
        let mut executable = Vec::new();
        for event in events {
            match self.executable(state, event, semantics) {
                Some(Ok(step)) => executable.push((event.clone(), step)),
                Some(Err(error)) => {
                    return Err(TurnError { event: event.to_string(), cause: error.cause });
                }
                None => {}
            }
        }
        Ok(by_text(executable))
    }

    /// Whether the environment may be silent.
    #[must_use]
    pub fn is_silent(turn: &Turn, semantics: Semantics) -> bool {
        turn.case == Case::EnvironmentAny && (semantics == Semantics::Default || turn.events.is_empty())
    }
}

/// Ordered by the events' texts, each once.
fn by_text(events: Vec<(Event, Step)>) -> Vec<(Event, Step)> {
    let by_text: BTreeMap<String, (Event, Step)> =
        events.into_iter().map(|(event, step)| (event.to_string(), (event, step))).collect();
    by_text.into_values().collect()
}

/// All ways to choose one of each.
fn product(choices: Vec<Vec<Value>>) -> Vec<Vec<Value>> {
    choices.into_iter().fold(vec![Vec::new()], |chosen, choices| {
        let extended = chosen.iter().flat_map(|chosen| {
            choices.iter().map(move |choice| [chosen.as_slice(), std::slice::from_ref(choice)].concat())
        });
        extended.collect()
    })
}

//! Events: interned, and the universe of what the environment could ever send.

use super::PlayError;
use crate::diagnostic::Code;
use crate::intern::Indexed;
use crate::model::{Argument, Kind, Message, ObjectId, OperationId, RoleRef, Scenario, SlotId, Spec, Value};

/// Index of an event. Environment events come first, in the order of their texts.
pub type EventId = u32;

/// More different environment events than this are refused.
const MOST_EVENTS: usize = 1 << 20;

/// What makes an event.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub(super) struct Signature {
    pub(super) sender: ObjectId,
    pub(super) receiver: ObjectId,
    pub(super) operation: OperationId,
    pub(super) arguments: Box<[Value]>,
}

/// An event with what can be said of it once for all.
#[derive(Clone, Debug)]
pub struct Event {
    /// Sending object.
    pub sender: ObjectId,
    /// Receiving object.
    pub receiver: ObjectId,
    /// Operation.
    pub operation: OperationId,
    /// One value per parameter.
    pub arguments: Box<[Value]>,
    /// `sender -> receiver.operation(a, b)`.
    pub text: String,
    /// Sent by the system.
    pub controllable: bool,
    /// An environment event that needs no assumption to cause it.
    pub spontaneous: bool,
    /// Slots of which one must hold the receiver, if there is a rule about channels.
    pub(super) links: Option<Box<[SlotId]>>,
}

/// All events met so far.
#[derive(Debug)]
pub(super) struct Events {
    signatures: Indexed<Signature>,
    events: Vec<Event>,
    /// Environment events that some scenario mentions are `0..universe`.
    universe: u32,
}

impl Events {
    pub(super) fn new(spec: &Spec) -> Result<Self, PlayError> {
        let mut signatures = Vec::new();
        for scenario in spec.scenarios.iter().filter(|scenario| scenario.kind != Kind::Existential) {
            for message in scenario.messages().chain(scenario.constraints().map(|c| &c.message)) {
                expand(spec, scenario, message, &mut signatures)?;
            }
        }
        let mut texts: Vec<(String, Signature)> =
            signatures.into_iter().map(|signature| (text(spec, &signature), signature)).collect();
        texts.sort_by(|a, b| a.0.cmp(&b.0));
        texts.dedup_by(|a, b| a.1 == b.1);
        let mut events =
            Events { signatures: Indexed::default(), events: Vec::new(), universe: texts.len() as u32 };
        for (_, signature) in texts {
            events.intern(spec, signature);
        }
        Ok(events)
    }

    pub(super) fn len(&self) -> usize {
        self.events.len()
    }

    pub(super) fn get(&self, event: EventId) -> &Event {
        &self.events[event as usize]
    }

    pub(super) fn find_text(&self, text: &str) -> Option<EventId> {
        let (universe, others) = self.events.split_at(self.universe as usize);
        let in_universe = universe.binary_search_by(|event| event.text.as_str().cmp(text)).ok();
        let elsewhere = || Some(universe.len() + others.iter().position(|event| event.text == text)?);
        in_universe.or_else(elsewhere).map(|event| event as EventId)
    }

    /// The environment events that some scenario mentions, in the order of their texts.
    pub(super) fn universe(&self) -> std::ops::Range<EventId> {
        0..self.universe
    }

    pub(super) fn intern(&mut self, spec: &Spec, signature: Signature) -> EventId {
        let (id, new) = self.signatures.intern(signature);
        if new {
            self.events.push(describe(spec, self.signatures.get(id)));
        }
        id
    }
}

fn describe(spec: &Spec, signature: &Signature) -> Event {
    let Signature { sender, receiver, operation, ref arguments } = *signature;
    let controllable = spec.controllable[sender];
    let caused = spec.non_spontaneous.iter().any(|&event| spec.refers(event, receiver, operation));
    Event {
        sender,
        receiver,
        operation,
        arguments: arguments.clone(),
        text: text(spec, signature),
        controllable,
        spontaneous: !controllable && !caused,
        links: links(spec, sender, receiver, operation),
    }
}

/// The sender's references of which one must hold the receiver; `None` if no rule concerns the operation there.
pub(super) fn links(
    spec: &Spec,
    sender: ObjectId,
    receiver: ObjectId,
    operation: OperationId,
) -> Option<Box<[SlotId]>> {
    let rules = spec.channels.iter().filter(|channel| spec.refers(channel.event, receiver, operation));
    rules.clone().next()?;
    let class = spec.domain.objects[sender].class;
    let links = rules.filter(|channel| spec.domain.is_a(class, channel.class));
    Some(links.map(|channel| spec.domain.slot(sender, channel.reference)).collect())
}

fn text(spec: &Spec, signature: &Signature) -> String {
    let domain = &spec.domain;
    let operation = &domain.operations[signature.operation];
    let arguments: Vec<String> = signature
        .arguments
        .iter()
        .zip(&operation.parameters)
        .map(|(&value, (_, ty))| domain.show(value, *ty))
        .collect();
    let (sender, receiver) = (&domain.objects[signature.sender], &domain.objects[signature.receiver]);
    format!("{} -> {}.{}({})", sender.name, receiver.name, operation.name, arguments.join(", "))
}

/// The values over which a parameter is expanded where it is not bound: its range, or the whole type.
///
/// # Errors
/// They are too many.
pub(super) fn parameter_values(
    spec: &Spec,
    receiver: ObjectId,
    message: &Message,
    parameter: usize,
) -> Result<Vec<Value>, PlayError> {
    if let Some(values) = range(spec, receiver, message.operation, parameter) {
        return Ok(values);
    }
    let ty = spec.domain.operations[message.operation].parameters[parameter].1;
    if spec.domain.cardinality(ty) > MOST_EVENTS as u64 {
        return Err(too_many(message));
    }
    Ok(spec.domain.values(ty).collect())
}

/// The declared range of a parameter.
fn range(spec: &Spec, receiver: ObjectId, operation: OperationId, parameter: usize) -> Option<Vec<Value>> {
    let ranges = spec
        .ranges
        .iter()
        .filter(|range| range.parameter == parameter && spec.refers(range.event, receiver, operation));
    ranges.clone().next()?;
    let mut values: Vec<Value> = ranges.flat_map(|range| range.values.iter().copied()).collect();
    values.sort_unstable();
    values.dedup();
    Some(values)
}

/// Refuses more combinations of values than there may be events.
pub(super) fn check_count(
    choices: &[Vec<Value>],
    message: &Message,
    already: usize,
) -> Result<(), PlayError> {
    let count = choices.iter().fold(1_usize, |n, values| n.saturating_mul(values.len()));
    if count.saturating_add(already) > MOST_EVENTS { Err(too_many(message)) } else { Ok(()) }
}

fn too_many(message: &Message) -> PlayError {
    PlayError {
        code: Code::LimitReached,
        span: message.span,
        message: format!("this message stands for more than {MOST_EVENTS} different events"),
    }
}

/// Every environment event that matches the message with all roles and variables unbound.
fn expand(
    spec: &Spec,
    scenario: &Scenario,
    message: &Message,
    all: &mut Vec<Signature>,
) -> Result<(), PlayError> {
    for sender in players(spec, scenario, message.sender) {
        if spec.controllable[sender] {
            continue;
        }
        for receiver in players(spec, scenario, message.receiver) {
            if message.sender == message.receiver && sender != receiver {
                continue;
            }
            let mut choices = Vec::new();
            for (parameter, argument) in message.arguments.iter().enumerate() {
                let constant = match argument {
                    Argument::Value(value) => value.constant(),
                    Argument::Any | Argument::Bind(_) => None,
                };
                choices.push(match constant {
                    None => parameter_values(spec, receiver, message, parameter)?,
                    Some(constant) => {
                        // `null` is no value that is expanded, but can be named.
                        let ty = spec.domain.operations[message.operation].parameters[parameter].1;
                        let allowed = range(spec, receiver, message.operation, parameter).map_or_else(
                            || spec.domain.fits(constant, ty),
                            |values| values.contains(&constant),
                        );
                        if allowed { vec![constant] } else { Vec::new() }
                    }
                });
            }
            check_count(&choices, message, all.len())?;
            for_each_combination(&choices, &mut |arguments| {
                let arguments = arguments.into();
                all.push(Signature { sender, receiver, operation: message.operation, arguments });
            });
        }
    }
    Ok(())
}

/// The objects that can play a role.
pub(super) fn players(spec: &Spec, scenario: &Scenario, role: RoleRef) -> Vec<ObjectId> {
    match role {
        RoleRef::Object(object) => vec![object],
        RoleRef::Dynamic(role) => {
            let class = scenario.roles[role].class;
            let objects = 0..spec.domain.objects.len();
            objects.filter(|&object| spec.domain.is_a(spec.domain.objects[object].class, class)).collect()
        }
    }
}

/// Calls `visit` with every choice of one value from each list.
pub(super) fn for_each_combination(choices: &[Vec<Value>], visit: &mut dyn FnMut(&[Value])) {
    fn go(choices: &[Vec<Value>], chosen: &mut Vec<Value>, visit: &mut dyn FnMut(&[Value])) {
        match choices.get(chosen.len()) {
            None => visit(chosen),
            Some(values) => {
                for &value in values {
                    chosen.push(value);
                    go(choices, chosen, visit);
                    chosen.pop();
                }
            }
        }
    }
    go(choices, &mut Vec::with_capacity(choices.len()), visit);
}

//! Events: interned, and the universe of what the environment could ever send.

use super::PlayError;
use super::indexed::Indexed;
use crate::diagnostic::Code;
use crate::model::{
    Argument, ConstraintKind, Kind, Message, ObjectId, OperationId, RoleRef, Scenario, SlotId, Spec, Value,
};
use crate::syntax::Span;

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
        self.events.iter().position(|event| event.text == text).map(|event| event as EventId)
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

/// The values over which a parameter is expanded where it is not bound: its range, or the whole type; of a type with
/// more than [`MOST_EVENTS`] values only one more than that, so that the limit is noticed without listing 2^32 values.
pub(super) fn parameter_values(
    spec: &Spec,
    receiver: ObjectId,
    operation: OperationId,
    parameter: usize,
) -> Vec<Value> {
    let mut ranges = spec
        .ranges
        .iter()
        .filter(|range| range.parameter == parameter && spec.refers(range.event, receiver, operation))
        .peekable();
    let ty = spec.domain.operations[operation].parameters[parameter].1;
    if ranges.peek().is_none() {
        return spec.domain.values(ty).take(MOST_EVENTS + 1).collect();
    }
    let mut values: Vec<Value> = ranges.flat_map(|range| range.values.iter().copied()).collect();
    values.sort_unstable();
    values.dedup();
    values
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
                let mut values = parameter_values(spec, receiver, message.operation, parameter);
                if let Argument::Value(value) = argument
                    && let Some(constant) = value.constant()
                {
                    // `null` is no value that is expanded, but can be named.
                    let ranged = has_range(spec, receiver, message.operation, parameter);
                    let ty = spec.domain.operations[message.operation].parameters[parameter].1;
                    let allowed =
                        if ranged { values.contains(&constant) } else { spec.domain.fits(constant, ty) };
                    values = if allowed { vec![constant] } else { Vec::new() };
                }
                choices.push(values);
            }
            within_limit(&choices, all.len(), message.span)?;
            for_each_combination(&choices, &mut |arguments| {
                let arguments = arguments.into();
                all.push(Signature { sender, receiver, operation: message.operation, arguments });
            });
        }
    }
    Ok(())
}

/// Refuses choices of more than [`MOST_EVENTS`] events together with the `known` ones.
pub(super) fn within_limit(choices: &[Vec<Value>], known: usize, span: Span) -> Result<(), PlayError> {
    let count = choices.iter().try_fold(1_usize, |n, values| n.checked_mul(values.len()));
    if count.and_then(|count| count.checked_add(known)).is_some_and(|count| count <= MOST_EVENTS) {
        return Ok(());
    }
    Err(PlayError {
        code: Code::LimitReached,
        span,
        message: format!("this message stands for more than {MOST_EVENTS} different events"),
    })
}

fn has_range(spec: &Spec, receiver: ObjectId, operation: OperationId, parameter: usize) -> bool {
    let mut ranges = spec.ranges.iter();
    ranges.any(|range| range.parameter == parameter && spec.refers(range.event, receiver, operation))
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

/// The order of the rows in the reaction table below `ignore`: which constraint kinds decide first.
pub(super) const ROWS: [ConstraintKind; 4] =
    [ConstraintKind::Ignore, ConstraintKind::Forbidden, ConstraintKind::Interrupt, ConstraintKind::Consider];

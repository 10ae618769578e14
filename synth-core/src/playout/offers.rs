//! What a copy wants: the events that messages with a modality at its cut ask for.

use super::copies::{Copies, CopyId};
use super::events::{
    EventId, Events, Signature, check_count, for_each_combination, links, parameter_values, players,
};
use super::memo::Memo;
use super::pattern::{Matcher, can_hold};
use super::{PlayError, ValuationId, play_error};
use crate::diagnostic::Code;
use crate::model::{
    Argument, Kind, Message, Modality, Moment, NodeKind, ObjectId, OperationId, RoleRef, Scenario, Scope,
    Snapshot, Spec, Type, UNSET, Value,
};

/// An event that is asked for, or the mistake of a message whose arguments have no value.
pub(crate) type Wanted = Result<EventId, PlayError>;

/// The offers of one copy.
#[derive(Clone, Debug, Default)]
pub(crate) struct Offers {
    /// Guarantees: what the system is asked to send, and how urgently.
    pub(crate) system: Vec<(Modality, Wanted)>,
    /// Assumptions: what the environment is said to send; `None` for a monitored message.
    pub(crate) environment: Vec<(Option<Modality>, EventId)>,
}

/// The offers of copies, as far as anybody asked.
#[derive(Debug, Default)]
pub(super) struct OfferTable(Memo<CopyId, Offers>);

impl OfferTable {
    /// The offers of a copy under a valuation, whose values are given.
    pub(super) fn of(
        &mut self,
        spec: &Spec,
        events: &mut Events,
        copies: &Copies,
        copy: CopyId,
        (valuation, values): (ValuationId, &[Value]),
    ) -> &Offers {
        self.0.get(copy, valuation, |reads| {
            collect(spec, events, copies, copy, Snapshot { values, moment: Moment::Before, reads })
        })
    }

    /// Bytes held, about.
    pub(super) fn memory(&self) -> usize {
        self.0.memory(size_of::<(Modality, Wanted)>())
    }
}

pub(super) fn collect(
    spec: &Spec,
    events: &mut Events,
    copies: &Copies,
    id: CopyId,
    attributes: Snapshot<'_>,
) -> Offers {
    let copy = copies.get(id);
    let scenario = &spec.scenarios[copy.scenario];
    let scope = Scope {
        domain: &spec.domain,
        attributes,
        roles: &copy.roles,
        variables: &copy.variables,
        event: (UNSET, UNSET, &[]),
    };
    let mut offers = Offers::default();
    for &node in &copy.cut {
        let NodeKind::Message { monitored, modality: Some(modality), message, .. } =
            &scenario.nodes[usize::from(node)].kind
        else {
            continue;
        };
        let cause = (!monitored).then_some(*modality);
        match (scenario.kind, cause) {
            (Kind::Assumption, cause) => {
                for event in matching(spec, events, scenario, message, &scope) {
                    offers.environment.push((cause, event));
                }
            }
            (Kind::Guarantee, Some(modality)) => {
                for wanted in to_send(spec, events, scenario, message, &scope) {
                    offers.system.push((modality, wanted));
                }
            }
            (Kind::Guarantee, None) | (Kind::Existential, _) => {}
        }
    }
    offers
}

/// The environment's events that are this message, given what is bound.
fn matching(
    spec: &Spec,
    events: &Events,
    scenario: &Scenario,
    message: &Message,
    scope: &Scope<'_>,
) -> Vec<EventId> {
    let matches = |&id: &EventId| {
        let matcher = Matcher {
            spec,
            event: events.get(id),
            attributes: scope.attributes,
            scenario,
            roles: scope.roles,
            variables: scope.variables,
        };
        // An argument without a value is reported when its event happens; until then it asks for none.
        matcher.is_message(message).unwrap_or(false)
    };
    events.universe().filter(matches).collect()
}

/// The events that the system is asked to send by this message; unbound arguments are expanded.
fn to_send(
    spec: &Spec,
    events: &mut Events,
    scenario: &Scenario,
    message: &Message,
    scope: &Scope<'_>,
) -> Vec<Wanted> {
    let bound = |role: RoleRef| match role {
        RoleRef::Dynamic(r) if scope.roles[r] != UNSET => vec![scope.roles[r] as usize],
        role => players(spec, scenario, role),
    };
    let mut wanted = Vec::new();
    for sender in bound(message.sender).into_iter().filter(|&sender| spec.controllable[sender]) {
        for receiver in bound(message.receiver) {
            if message.sender == message.receiver && sender != receiver {
                continue;
            }
            // Without a link the message is no candidate, whatever its arguments.
            if !is_linked(spec, scope, sender, receiver, message.operation) {
                continue;
            }
            let mut choices = Vec::new();
            for index in 0..message.arguments.len() {
                match argument_values(spec, scenario, message, index, receiver, scope) {
                    Ok(values) => choices.push(values),
                    Err(mistake) => return vec![Err(mistake)],
                }
            }
            if let Err(mistake) = check_count(&choices, message, 0) {
                return vec![Err(mistake)];
            }
            for_each_combination(&choices, &mut |arguments| {
                let operation = message.operation;
                let signature = Signature { sender, receiver, operation, arguments: arguments.into() };
                wanted.push(Ok(events.intern(spec, signature)));
            });
        }
    }
    wanted
}

fn is_linked(
    spec: &Spec,
    scope: &Scope<'_>,
    sender: ObjectId,
    receiver: ObjectId,
    operation: OperationId,
) -> bool {
    links(spec, sender, receiver, operation).is_none_or(|links| {
        links.iter().any(|&slot| scope.attributes.read(&spec.domain, slot) == receiver as Value)
    })
}

/// The values of one argument of a message that is sent to `receiver`; an unbound one is expanded.
fn argument_values(
    spec: &Spec,
    scenario: &Scenario,
    message: &Message,
    index: usize,
    receiver: ObjectId,
    scope: &Scope<'_>,
) -> Result<Vec<Value>, PlayError> {
    match &message.arguments[index] {
        Argument::Any => parameter_values(spec, receiver, message, index),
        Argument::Bind(variable) => {
            let ty = scenario.variables[*variable].ty;
            let mut values = parameter_values(spec, receiver, message, index)?;
            values.retain(|&value| can_hold(spec, ty, value));
            Ok(values)
        }
        Argument::Value(value) => {
            let value = scope.eval(value).map_err(|failure| play_error(failure, message.span))?;
            let parameter = &spec.domain.operations[message.operation].parameters[index];
            check_argument(spec, message, parameter, value)
        }
    }
}

/// The value of an evaluated argument: an object of the wrong class fits nothing, an integer out of range is a
/// mistake.
fn check_argument(
    spec: &Spec,
    message: &Message,
    (name, ty): &(String, Type),
    value: Value,
) -> Result<Vec<Value>, PlayError> {
    match ty {
        _ if spec.domain.fits(value, *ty) => Ok(vec![value]),
        Type::Class(_) => Ok(Vec::new()),
        _ => Err(PlayError {
            code: Code::PlayOutRange,
            span: message.span,
            message: format!(
                "argument `{name}` would be `{value}`, which is not in `{}`",
                spec.domain.show_type(*ty)
            ),
        }),
    }
}

//! Whether an event is the message that a pattern describes.

use super::events::Event;
use super::{PlayError, play_error};
use crate::model::{
    Argument, Constraint, ConstraintKind, Failure, Message, NodeId, NodeKind, RoleRef, Scenario, Scope,
    Snapshot, Spec, Type, UNSET, Value,
};

/// One event and one copy, or one that is about to start.
pub(super) struct Matcher<'a> {
    pub(super) spec: &'a Spec,
    pub(super) event: &'a Event,
    /// Attributes before the event.
    pub(super) attributes: Snapshot<'a>,
    pub(super) scenario: &'a Scenario,
    pub(super) roles: &'a [Value],
    pub(super) variables: &'a [Value],
}

impl Matcher<'_> {
    fn scope(&self) -> Scope<'_> {
        Scope {
            domain: &self.spec.domain,
            attributes: self.attributes,
            roles: self.roles,
            variables: self.variables,
            event: (UNSET, UNSET, &[]),
        }
    }

    fn role(&self, role: RoleRef, object: usize) -> bool {
        match role {
            RoleRef::Object(o) => o == object,
            RoleRef::Dynamic(r) if self.roles[r] == UNSET => {
                let class = self.scenario.roles[r].class;
                self.spec.domain.is_instance(object as Value, class)
            }
            RoleRef::Dynamic(r) => self.roles[r] == object as Value,
        }
    }

    /// Whether operation, sender and receiver fit.
    pub(super) fn ends(&self, message: &Message) -> bool {
        let event = self.event;
        message.operation == event.operation
            && self.role(message.sender, event.sender)
            && self.role(message.receiver, event.receiver)
            && (message.sender != message.receiver || event.sender == event.receiver)
    }

    /// Whether the event is the message, which is enabled at the cut.
    pub(super) fn is_message(&self, message: &Message) -> Result<bool, PlayError> {
        if !self.ends(message) {
            return Ok(false);
        }
        for (argument, &given) in message.arguments.iter().zip(&self.event.arguments) {
            let matches = match argument {
                Argument::Any => true,
                Argument::Bind(variable) => can_hold(self.spec, self.scenario.variables[*variable].ty, given),
                Argument::Value(value) => {
                    self.scope().eval(value).map_err(|failure| play_error(failure, message.span))? == given
                }
            };
            if !matches {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Whether the event matches a pattern that is not enabled: what is not set yet matches anything, a path through
    /// `null` nothing.
    pub(super) fn is_like(&self, message: &Message) -> bool {
        self.ends(message)
            && message.arguments.iter().zip(&self.event.arguments).all(|(argument, &given)| match argument {
                Argument::Any | Argument::Bind(_) => true,
                Argument::Value(value) => match self.scope().eval(value) {
                    Ok(value) => value == given,
                    Err(Failure::Unset) => true,
                    Err(Failure::Null(_) | Failure::Overflow(_)) => false,
                },
            })
    }

    /// The first constraint of this kind that is in force at the cut and matches.
    pub(super) fn constraint(&self, cut: &[NodeId], kind: ConstraintKind) -> Option<&Constraint> {
        let mut bodies: Vec<NodeId> = Vec::new();
        for &leaf in cut {
            let mut node = leaf;
            while node != 0 {
                node = self.scenario.nodes[usize::from(node)].parent;
                bodies.push(node);
            }
        }
        bodies.sort_unstable();
        bodies.dedup();
        bodies.iter().find_map(|&body| match &self.scenario.nodes[usize::from(body)].kind {
            NodeKind::Body { constraints, .. } => {
                constraints.iter().find(|c| c.kind == kind && self.is_like(&c.message))
            }
            _ => None,
        })
    }
}

/// Whether a message with this value can be bound to a variable of type `ty`: one of a subclass only takes what fits;
/// integers are checked when they are stored.
pub(super) fn can_hold(spec: &Spec, ty: Type, value: Value) -> bool {
    !matches!(ty, Type::Class(_)) || spec.domain.fits(value, ty)
}

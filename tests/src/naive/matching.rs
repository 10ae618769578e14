//! Whether an event is the one a message describes.

use super::eval::{EvalError, Names, Scope};
use super::spec::{Scenario, Spec};
use super::state::{Attributes, Copy, Roles, Variables};
use super::value::{Event, Value};
use synth_core::syntax::ast::{Argument, ArgumentKind, Message};

/// What a copy, or one that is about to start, brings to a match.
#[derive(Clone, Copy, Debug)]
pub struct Context<'a> {
    /// Classes and objects.
    pub spec: &'a Spec,
    /// Values of attributes.
    pub attributes: &'a Attributes,
    /// The scenario.
    pub scenario: &'a Scenario,
    /// Roles bound so far.
    pub roles: &'a Roles,
    /// Variables set so far.
    pub variables: &'a Variables,
}

impl<'a> Context<'a> {
    /// That of a copy.
    #[must_use]
    pub fn of(spec: &'a Spec, attributes: &'a Attributes, copy: &'a Copy) -> Self {
        let scenario = &spec.scenarios[copy.scenario];
        Context { spec, attributes, scenario, roles: &copy.roles, variables: &copy.variables }
    }

    /// For expressions in the body at a path.
    #[must_use]
    pub fn scope(&self, body: &'a [usize]) -> Scope<'a> {
        let Context { scenario, roles, variables, .. } = *self;
        Scope {
            spec: self.spec,
            attributes: self.attributes,
            names: Names::Copy { scenario, roles, variables, body },
        }
    }

    /// The event is the message that stands in the body at a path: roles and variables after it.
    ///
    /// Roles and arguments that are bound must match, unbound ones match anything of their type and become bound.
    /// `bind v` matches any value, also when `v` is already set, and sets it anew. An argument
    /// that has no value because it is out of the range of integers matches nothing.
    ///
    /// # Errors
    /// A path through `null` in an argument, or an integer that the variable that is bound to it does not take.
    pub fn matches(
        &self,
        body: &[usize],
        message: &Message,
        event: &Event,
    ) -> Result<Option<(Roles, Variables)>, EvalError> {
        let Some(roles) = self.endpoints_match(message, event) else { return Ok(None) };
        let mut variables = self.variables.clone();
        for (argument, value) in message.arguments.iter().zip(&event.arguments) {
            let matched = match &argument.kind {
                ArgumentKind::Any => true,
                ArgumentKind::Bind(name) => {
                    let declaration = self.scenario.variable(body, &name.text);
                    let (declared, ty) = declaration.ok_or(EvalError::Malformed(name.text.clone()))?;
                    // A variable of a subclass takes only what fits; an integer out of its range is an error.
                    let fits = self.spec.fits(value, ty);
                    if !fits && matches!(value, Value::Int(_)) {
                        return Err(EvalError::Range(value.to_string()));
                    }
                    variables.insert((declared, name.text.clone()), value.clone());
                    fits
                }
                ArgumentKind::Value(expr) => match self.scope(body).value(expr) {
                    Ok(expected) => expected == *value,
                    Err(EvalError::Unset(_)) => true,
                    Err(EvalError::Range(_)) => false,
                    Err(error) => return Err(error),
                },
            };
            if !matched {
                return Ok(None);
            }
        }
        Ok(Some((roles, variables)))
    }

    /// The event is like a message that is not enabled, or like that of a constraint, which bind nothing: a path
    /// through `null` matches nothing, and no error of values is one here.
    ///
    /// # Errors
    /// The specification is not well formed.
    pub fn is_like(&self, body: &[usize], message: &Message, event: &Event) -> Result<bool, EvalError> {
        let without_binding = |argument: &Argument| Argument {
            kind: match &argument.kind {
                ArgumentKind::Any | ArgumentKind::Bind(_) => ArgumentKind::Any,
                ArgumentKind::Value(expr) => ArgumentKind::Value(expr.clone()),
            },
            span: argument.span,
        };
        let arguments = message.arguments.iter().map(without_binding).collect();
        match self.matches(body, &Message { arguments, ..message.clone() }, event) {
            Ok(matched) => Ok(matched.is_some()),
            Err(EvalError::Null(_)) => Ok(false),
            Err(error) => Err(error),
        }
    }

    /// Sender, receiver and operation are the message's: the roles after it.
    #[must_use]
    pub fn endpoints_match(&self, message: &Message, event: &Event) -> Option<Roles> {
        if message.operation.text != event.operation || message.arguments.len() != event.arguments.len() {
            return None;
        }
        let mut roles = self.roles.clone();
        for (role, object) in
            [(&message.sender.text, &event.sender), (&message.receiver.text, &event.receiver)]
        {
            let class = self.scenario.roles.get(role);
            let matched = match (class, roles.get(role)) {
                (Some(_), Some(bound)) => bound == object,
                (Some(class), None) => self.spec.is_instance(object, class),
                (None, _) => role == object,
            };
            if !matched {
                return None;
            }
            if class.is_some() {
                roles.insert(role.clone(), object.clone());
            }
        }
        Some(roles)
    }
}

//! Which parts of a specification read and name what.

use crate::model::{
    Argument, ClassId, Effect, Endpoint, Expr, Message, NodeKind, ObjectId, RoleRef, Scenario, Spec, Type,
    Value,
};
use crate::playout::Event;

/// Where an expression stands: it decides what variables, roles and parameters are.
#[derive(Clone, Copy)]
pub(super) enum Place<'a> {
    Scenario(&'a Scenario),
    Effect(&'a Effect),
}

/// Calls `visit` with the class of the owner and the position of every attribute that the expression reads.
pub(super) fn attributes(spec: &Spec, place: Place<'_>, expr: &Expr, visit: &mut dyn FnMut(ClassId, usize)) {
    expr.walk(&mut |part| {
        if let Expr::Attribute(owner, attribute, _) = part
            && let Some(class) = class_of(spec, place, owner)
        {
            visit(class, *attribute);
        }
    });
}

/// The static class of an expression that gives an object.
fn class_of(spec: &Spec, place: Place<'_>, expr: &Expr) -> Option<ClassId> {
    let of_object = |object: ObjectId| spec.domain.objects.get(object).map(|object| object.class);
    let of_type = |ty: Type| if let Type::Class(class) = ty { Some(class) } else { None };
    let of_endpoint = |endpoint: Endpoint| match endpoint {
        Endpoint::Object(object) => of_object(object),
        Endpoint::Class(class) => Some(class),
    };
    match (expr, place) {
        (Expr::Const(object), _) => of_object(usize::try_from(*object).ok()?),
        (Expr::Attribute(owner, attribute, _), _) => {
            let owner = class_of(spec, place, owner)?;
            of_type(spec.domain.classes[owner].attributes[*attribute].ty)
        }
        (Expr::Variable(variable), Place::Scenario(scenario)) => of_type(scenario.variables[*variable].ty),
        (Expr::Role(role), Place::Scenario(scenario)) => Some(scenario.roles[*role].class),
        (Expr::Sender, Place::Effect(effect)) => of_endpoint(effect.sender),
        (Expr::Receiver, Place::Effect(effect)) => of_endpoint(effect.receiver),
        (Expr::Parameter(parameter), Place::Effect(effect)) => {
            of_type(spec.domain.operations[effect.operation].parameters[*parameter].1)
        }
        _ => None,
    }
}

/// Calls `visit` for every expression of a scenario.
pub(super) fn expressions(scenario: &Scenario, visit: &mut dyn FnMut(&Expr)) {
    for (_, value, _) in &scenario.bindings {
        visit(value);
    }
    for message in patterns(scenario) {
        for argument in &message.arguments {
            if let Argument::Value(value) = argument {
                visit(value);
            }
        }
    }
    for node in &scenario.nodes {
        match &node.kind {
            NodeKind::Alternative(cases) => {
                cases.iter().filter_map(|case| case.condition.as_ref()).for_each(&mut *visit);
            }
            NodeKind::While(Some(e), _)
            | NodeKind::Wait { condition: e, .. }
            | NodeKind::Interrupt(e)
            | NodeKind::Violation(e)
            | NodeKind::Assign(_, Some(e)) => visit(e),
            NodeKind::Body { .. }
            | NodeKind::Message { .. }
            | NodeKind::Parallel(_)
            | NodeKind::While(None, _)
            | NodeKind::Assign(_, None) => {}
        }
    }
}

/// The messages of a scenario's bodies and constraints.
pub(super) fn patterns(scenario: &Scenario) -> impl Iterator<Item = &Message> {
    scenario.messages().chain(scenario.constraints().map(|constraint| &constraint.message))
}

/// The objects that can play a role.
pub(super) fn players<'a>(
    spec: &'a Spec,
    scenario: &'a Scenario,
    role: RoleRef,
) -> impl Iterator<Item = ObjectId> + 'a {
    (0..spec.domain.objects.len()).filter(move |&object| match role {
        RoleRef::Object(only) => object == only,
        RoleRef::Dynamic(role) => {
            spec.domain.is_a(spec.domain.objects[object].class, scenario.roles[role].class)
        }
    })
}

/// Whether an object is at this end of an effect.
pub(super) fn is_at(spec: &Spec, endpoint: Endpoint, object: ObjectId) -> bool {
    match endpoint {
        Endpoint::Object(only) => object == only,
        Endpoint::Class(class) => spec.domain.is_a(spec.domain.objects[object].class, class),
    }
}

/// Whether some event can be this message and have this effect.
pub(super) fn has_effect(spec: &Spec, scenario: &Scenario, message: &Message, effect: &Effect) -> bool {
    message.operation == effect.operation
        && players(spec, scenario, message.sender).any(|object| is_at(spec, effect.sender, object))
        && players(spec, scenario, message.receiver).any(|object| is_at(spec, effect.receiver, object))
}

/// Whether the event can be this message, if arguments that are not constant fit.
pub(super) fn could_be(spec: &Spec, scenario: &Scenario, message: &Message, event: &Event) -> bool {
    let fits = |(argument, given): (&Argument, &Value)| match argument {
        Argument::Value(value) => value.constant().is_none_or(|constant| constant == *given),
        Argument::Any | Argument::Bind(_) => true,
    };
    message.operation == event.operation
        && players(spec, scenario, message.sender).any(|object| object == event.sender)
        && players(spec, scenario, message.receiver).any(|object| object == event.receiver)
        && message.arguments.iter().zip(&event.arguments).all(fits)
}

//! The resolved specification: every name is an index, every expression has a type, scenarios are node trees.
//!
//! Built by [`resolve`]; nothing behind this stage knows the syntax tree.

mod domain;
mod expr;
mod permutation;
mod scenario;

pub mod resolve;

pub use domain::{
    Attribute, Class, ClassId, Domain, Enumeration, Object, ObjectId, Operation, OperationId, SlotId, Type,
};
pub use expr::{BinaryOp, Expr, Failure, Moment, Reads, Scope, Snapshot, UNSET, Value};
pub use permutation::Permutation;
pub use scenario::{
    Argument, Case, Constraint, ConstraintKind, Kind, Message, Modality, Node, NodeId, NodeKind, Role,
    RoleRef, Scenario, Variable,
};

use crate::syntax::Span;

/// A whole specification, ready to be played out.
#[derive(Clone, Debug)]
pub struct Spec {
    /// Its name as written.
    pub name: String,
    /// Classes, enums, objects, attributes, operations.
    pub domain: Domain,
    /// In textual order.
    pub effects: Vec<Effect>,
    /// Per object: it belongs to the system.
    pub controllable: Vec<bool>,
    /// Events that happen only when an assumption causes them.
    pub non_spontaneous: Vec<EventRef>,
    /// Values over which unbound arguments are expanded.
    pub ranges: Vec<ParameterRange>,
    /// Links without which an event is dropped.
    pub channels: Vec<Channel>,
    /// In textual order.
    pub scenarios: Vec<Scenario>,
}

/// An operation of receivers of one class (or its subclasses).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct EventRef {
    /// The receiver is of this class.
    pub class: ClassId,
    /// The operation.
    pub operation: OperationId,
}

/// The values over which one parameter is expanded.
#[derive(Clone, Debug)]
pub struct ParameterRange {
    /// Of which events.
    pub event: EventRef,
    /// Index of the parameter.
    pub parameter: usize,
    /// Ascending, without duplicates.
    pub values: Vec<Value>,
}

/// An event needs `sender.reference == receiver`.
#[derive(Clone, Copy, Debug)]
pub struct Channel {
    /// Of which events.
    pub event: EventRef,
    /// Class of the senders.
    pub class: ClassId,
    /// Position of the reference among the class's attributes.
    pub reference: usize,
}

/// One end of an effect.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Endpoint {
    /// This object.
    Object(ObjectId),
    /// Any object of this class or a subclass.
    Class(ClassId),
}

/// What an event does to attributes.
#[derive(Clone, Debug)]
pub struct Effect {
    /// Sender of the event.
    pub sender: Endpoint,
    /// Receiver of the event.
    pub receiver: Endpoint,
    /// The operation.
    pub operation: OperationId,
    /// In textual order.
    pub assignments: Vec<EffectAssignment>,
}

/// `owner.attribute = value` in an effect.
#[derive(Clone, Debug)]
pub struct EffectAssignment {
    /// The object whose attribute changes.
    pub owner: Expr,
    /// The static class of the owner.
    pub owner_class: ClassId,
    /// Position among the attributes of the owner's class.
    pub attribute: usize,
    /// Type of the attribute.
    pub ty: Type,
    /// The new value.
    pub value: Expr,
    /// The assignment.
    pub span: Span,
}

impl Spec {
    /// Whether an event of `operation` at `receiver` is one that `event` refers to.
    #[must_use]
    pub fn refers(&self, event: EventRef, receiver: ObjectId, operation: OperationId) -> bool {
        event.operation == operation && self.domain.is_a(self.domain.objects[receiver].class, event.class)
    }
}

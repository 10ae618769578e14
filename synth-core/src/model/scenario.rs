//! Scenarios as trees of nodes, numbered in textual order.

use super::{ClassId, Expr, ObjectId, OperationId, Type};
use crate::syntax::Span;

pub use crate::syntax::ast::{ConstraintKind, Modality, ScenarioKind as Kind};

/// Index into [`Scenario::nodes`]; textual order.
pub type NodeId = u16;

/// A scenario.
#[derive(Clone, Debug)]
pub struct Scenario {
    /// `Collaboration.Scenario`.
    pub name: String,
    /// Assumption, guarantee or existential.
    pub kind: Kind,
    /// Place of its name.
    pub span: Span,
    /// Its `///` lines.
    pub requirement: Vec<String>,
    /// The dynamic roles that it mentions.
    pub roles: Vec<Role>,
    /// All its variables.
    pub variables: Vec<Variable>,
    /// Roles bound when a copy starts, with the place of each.
    pub bindings: Vec<(usize, Expr, Span)>,
    /// Node 0 is the whole body.
    pub nodes: Vec<Node>,
    /// Messages with which a copy starts, in textual order; empty if the scenario starts at once.
    pub initial: Vec<NodeId>,
}

/// A dynamic role.
#[derive(Clone, Debug)]
pub struct Role {
    /// Its name.
    pub name: String,
    /// Objects of this class or a subclass can play it.
    pub class: ClassId,
}

/// A variable.
#[derive(Clone, Debug)]
pub struct Variable {
    /// Its name.
    pub name: String,
    /// Its type.
    pub ty: Type,
}

/// A node of the tree.
#[derive(Clone, Debug)]
pub struct Node {
    /// The enclosing node; node 0 is its own parent.
    pub parent: NodeId,
    /// What it is.
    pub kind: NodeKind,
    /// Its place.
    pub span: Span,
}

impl Node {
    /// A `strict` message or `wait`: another message of the scenario violates a copy that stands here.
    #[must_use]
    pub fn is_strict(&self) -> bool {
        matches!(self.kind, NodeKind::Message { strict: true, .. } | NodeKind::Wait { strict: true, .. })
    }
}

/// The kinds of node.
#[derive(Clone, Debug)]
pub enum NodeKind {
    /// A body: fragments one after another.
    Body {
        /// Its fragments.
        children: Vec<NodeId>,
        /// Variables that live in it.
        variables: Vec<usize>,
        /// In force inside.
        constraints: Vec<Constraint>,
    },
    /// A message.
    Message {
        /// A message out of order violates.
        strict: bool,
        /// An obligation, but not a cause.
        monitored: bool,
        /// `None`: only waited for.
        modality: Option<Modality>,
        /// The pattern.
        message: Message,
    },
    /// `alternative`.
    Alternative(Vec<Case>),
    /// `parallel`: bodies.
    Parallel(Vec<NodeId>),
    /// `while`: condition and body.
    While(Option<Expr>, NodeId),
    /// `wait`.
    Wait {
        /// A message out of order violates.
        strict: bool,
        /// Passing is an obligation.
        eventually: bool,
        /// What is waited for.
        condition: Expr,
    },
    /// `interrupt`.
    Interrupt(Expr),
    /// `violation`.
    Violation(Expr),
    /// A declaration or an assignment; without an expression the variable becomes unset.
    Assign(usize, Option<Expr>),
}

/// A case of an `alternative`.
#[derive(Clone, Debug)]
pub struct Case {
    /// Offered only if it holds.
    pub condition: Option<Expr>,
    /// A body.
    pub body: NodeId,
}

/// A constraint in force in a body.
#[derive(Clone, Debug)]
pub struct Constraint {
    /// Which.
    pub kind: ConstraintKind,
    /// The pattern.
    pub message: Message,
}

/// A role in a message.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RoleRef {
    /// An object (a static role).
    Object(ObjectId),
    /// Index into [`Scenario::roles`].
    Dynamic(usize),
}

/// A message pattern.
#[derive(Clone, Debug)]
pub struct Message {
    /// Who sends.
    pub sender: RoleRef,
    /// Who receives.
    pub receiver: RoleRef,
    /// The operation.
    pub operation: OperationId,
    /// One for each parameter.
    pub arguments: Vec<Argument>,
    /// Its place.
    pub span: Span,
}

/// An argument of a message pattern.
#[derive(Clone, Debug)]
pub enum Argument {
    /// `*`.
    Any,
    /// `bind v`.
    Bind(usize),
    /// A value.
    Value(Expr),
}

impl Scenario {
    /// The message of a node; `None` for other kinds.
    #[must_use]
    pub fn message(&self, node: NodeId) -> Option<&Message> {
        match &self.nodes[usize::from(node)].kind {
            NodeKind::Message { message, .. } => Some(message),
            _ => None,
        }
    }

    /// All messages of its bodies, in textual order.
    pub fn messages(&self) -> impl Iterator<Item = &Message> {
        (0..self.nodes.len()).filter_map(|node| self.message(node as NodeId))
    }

    /// All constraints of its bodies.
    pub fn constraints(&self) -> impl Iterator<Item = &Constraint> {
        self.nodes.iter().flat_map(|node| match &node.kind {
            NodeKind::Body { constraints, .. } => constraints.as_slice(),
            _ => &[],
        })
    }
}

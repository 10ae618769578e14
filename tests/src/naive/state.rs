//! States and scenario copies (language reference, section 2).

use super::cut::{BodyPath, Cut};
use super::value::Value;
use std::collections::{BTreeMap, BTreeSet};

/// Values of (object, attribute).
pub type Attributes = BTreeMap<(String, String), Value>;
/// Objects that play the dynamic roles; an unbound role is absent.
pub type Roles = BTreeMap<String, String>;
/// Values of variables, each known by the body that declares it and its name; an unset one is absent.
pub type Variables = BTreeMap<(BodyPath, String), Value>;

/// A state: attributes, the set of active copies, and whether the system has yielded.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct State {
    /// The value of every attribute of every object.
    pub attributes: Attributes,
    /// Active copies; equal ones are one.
    pub copies: BTreeSet<Copy>,
    /// The system has passed the turn on.
    pub yielded: bool,
}

/// An active copy of a scenario.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Copy {
    /// Index into [`super::Spec::scenarios`].
    pub scenario: usize,
    /// Dynamic roles that are bound.
    pub roles: Roles,
    /// Variables that are set.
    pub variables: Variables,
    /// Where it stands.
    pub cut: Cut,
}

/// Identity of an obligation (language reference, section 5).
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Key {
    /// Index into [`super::Spec::scenarios`].
    pub scenario: usize,
    /// Dynamic roles that are bound.
    pub roles: Roles,
    /// The message or `wait`.
    pub fragment: Vec<usize>,
    /// The variables that the fragment reads; `None` when unset.
    pub values: Vec<(String, Option<Value>)>,
}

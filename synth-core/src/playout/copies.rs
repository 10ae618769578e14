//! Scenario copies, interned, with what can be said of each once for all.

use super::keys::{Key, KeyId, Keys};
use crate::intern::Indexed;
use crate::model::{Argument, Expr, NodeId, NodeKind, Scenario, Spec, Value};

/// Index of a copy, in order of discovery.
pub type CopyId = u32;

/// What makes a copy: equal in all four, they are one.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub(super) struct Identity {
    pub(super) scenario: usize,
    pub(super) roles: Box<[Value]>,
    pub(super) variables: Box<[Value]>,
    pub(super) cut: Box<[NodeId]>,
}

/// An active copy of a scenario.
#[derive(Clone, Debug)]
pub struct Copy {
    /// Index of the scenario.
    pub scenario: usize,
    /// Per role of the scenario: its object, or [`crate::model::UNSET`].
    pub roles: Box<[Value]>,
    /// Per variable: its value, or [`crate::model::UNSET`].
    pub variables: Box<[Value]>,
    /// Where it stands: leaf nodes, ascending. Two of them lie in different branches of a `parallel` or in
    /// different cases of an undecided `alternative`.
    pub cut: Box<[NodeId]>,
    /// The obligations at its cut: node and key.
    pub obligations: Box<[(NodeId, KeyId)]>,
    /// A message or `wait` at its cut is strict.
    pub strict: bool,
}

/// All copies met so far.
#[derive(Debug)]
pub(super) struct Copies {
    identities: Indexed<Identity>,
    copies: Vec<Copy>,
}

impl Copies {
    pub(super) fn new() -> Self {
        Copies { identities: Indexed::default(), copies: Vec::new() }
    }

    pub(super) fn len(&self) -> usize {
        self.copies.len()
    }

    pub(super) fn get(&self, copy: CopyId) -> &Copy {
        &self.copies[copy as usize]
    }

    pub(super) fn intern(&mut self, spec: &Spec, keys: &mut Keys, identity: Identity) -> CopyId {
        let (id, new) = self.identities.intern(identity);
        if new {
            let copy = describe(spec, keys, self.identities.get(id));
            self.copies.push(copy);
        }
        id
    }

    /// An estimate: copies are few beside states.
    pub(super) fn memory(&self) -> usize {
        self.copies.capacity() * (2 * size_of::<Copy>() + 64)
    }
}

fn describe(spec: &Spec, keys: &mut Keys, identity: &Identity) -> Copy {
    let scenario = &spec.scenarios[identity.scenario];
    let mut obligations = Vec::new();
    let mut strict_cut = false;
    for &node in &identity.cut {
        let (strict, obliges) = match &scenario.nodes[usize::from(node)].kind {
            NodeKind::Message { strict, modality, .. } => (*strict, modality.is_some()),
            NodeKind::Wait { strict, eventually, .. } => (*strict, *eventually),
            _ => (false, false),
        };
        strict_cut |= strict;
        if obliges {
            let variables = variables_read(scenario, node);
            let values = variables.iter().map(|&v| identity.variables[v]).collect();
            let roles = identity.roles.clone();
            let (key, _) = keys.intern(Key { scenario: identity.scenario, roles, node, values });
            obligations.push((node, key));
        }
    }
    Copy {
        scenario: identity.scenario,
        roles: identity.roles.clone(),
        variables: identity.variables.clone(),
        cut: identity.cut.clone(),
        obligations: obligations.into(),
        strict: strict_cut,
    }
}

/// The variables that a fragment reads, ascending.
pub(crate) fn variables_read(scenario: &Scenario, node: NodeId) -> Vec<usize> {
    let mut variables = Vec::new();
    let mut collect = |part: &Expr| {
        if let Expr::Variable(variable) = part {
            variables.push(*variable);
        }
    };
    match &scenario.nodes[usize::from(node)].kind {
        NodeKind::Message { message, .. } => {
            for argument in &message.arguments {
                if let Argument::Value(value) = argument {
                    value.walk(&mut collect);
                }
            }
        }
        NodeKind::Wait { condition, .. } => condition.walk(&mut collect),
        _ => {}
    }
    variables.sort_unstable();
    variables.dedup();
    variables
}

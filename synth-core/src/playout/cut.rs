//! Walking a copy's cut through its scenario.
//!
//! A cut is a set of leaf nodes. Two leaves in different branches of a `parallel` are both waited for; two in
//! different cases of an `alternative` mean that it is not decided yet: when one of them moves, every leaf whose
//! lowest common ancestor with it is an `alternative` is dropped.

use super::{PlayError, play_error};
use crate::diagnostic::Code;
use crate::model::{Case, Expr, Node, NodeId, NodeKind, Scenario, Scope, Snapshot, Spec, UNSET, Value};
use crate::syntax::Span;

/// A copy on its way.
pub(super) struct Walker<'a> {
    pub(super) spec: &'a Spec,
    pub(super) scenario: &'a Scenario,
    /// After the event's effects.
    pub(super) attributes: Snapshot<'a>,
    pub(super) roles: Vec<Value>,
    pub(super) variables: Vec<Value>,
    /// Ascending.
    pub(super) cut: Vec<NodeId>,
    /// `wait`s that were passed.
    pub(super) passed: Vec<NodeId>,
    /// The first mistake met.
    pub(super) error: Option<PlayError>,
}

/// How a walk ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Rest {
    /// The copy waits at its cut.
    Waits,
    /// It is at its end or was interrupted.
    Ended,
    /// It is violated, by this `violation`.
    Violated(NodeId),
}

impl Walker<'_> {
    fn kind(&self, node: NodeId) -> &NodeKind {
        &self.scenario.nodes[usize::from(node)].kind
    }

    fn parent(&self, node: NodeId) -> NodeId {
        self.scenario.nodes[usize::from(node)].parent
    }

    /// The value of an expression; a failure is kept as the walk's mistake.
    pub(super) fn value(&mut self, expr: &Expr, span: Span) -> Option<Value> {
        let scope = Scope {
            domain: &self.spec.domain,
            attributes: self.attributes,
            roles: &self.roles,
            variables: &self.variables,
            event: (UNSET, UNSET, &[]),
        };
        match scope.eval(expr) {
            Ok(value) => Some(value),
            Err(failure) => {
                self.error.get_or_insert_with(|| play_error(failure, span));
                None
            }
        }
    }

    /// The truth of a condition; one that has no value counts as false, and the mistake is kept.
    fn holds(&mut self, condition: &Expr, span: Span) -> bool {
        self.value(condition, span).is_some_and(|value| value != 0)
    }

    /// Gives a variable a value.
    pub(super) fn assign(&mut self, variable: usize, value: Value, span: Span) {
        let declared = &self.scenario.variables[variable];
        let ty = declared.ty;
        if self.spec.domain.fits(value, ty) {
            self.variables[variable] = value;
        } else {
            self.error.get_or_insert_with(|| PlayError {
                code: Code::PlayOutRange,
                span,
                message: format!(
                    "variable `{}` would become `{value}`, which is not in `{}`",
                    declared.name,
                    self.spec.domain.show_type(ty)
                ),
            });
            self.variables[variable] = self.spec.domain.lowest(ty);
        }
    }

    /// Whether a case is offered.
    pub(super) fn is_offered(&mut self, case: &Case) -> bool {
        let span = self.scenario.nodes[usize::from(case.body)].span;
        case.condition.as_ref().is_none_or(|condition| self.holds(condition, span))
    }

    /// Runs the declaration at `node`.
    pub(super) fn run_declaration(&mut self, node: NodeId) {
        let scenario = self.scenario;
        let Node { kind, span, .. } = &scenario.nodes[usize::from(node)];
        if let NodeKind::Assign(variable, value) = kind {
            match value {
                None => self.variables[*variable] = UNSET,
                Some(value) => {
                    let value = self.value(value, *span);
                    let lowest = self.spec.domain.lowest(scenario.variables[*variable].ty);
                    self.assign(*variable, value.unwrap_or(lowest), *span);
                }
            }
        }
    }

    /// The cut reaches `node`. Returns whether it stays somewhere inside; otherwise the node is passed.
    pub(super) fn enter(&mut self, node: NodeId) -> bool {
        let scenario = self.scenario;
        let span = scenario.nodes[usize::from(node)].span;
        match &scenario.nodes[usize::from(node)].kind {
            NodeKind::Body { .. } => self.enter_from(node, 0),
            NodeKind::Parallel(branches) => {
                // Every branch is entered, whatever the others do.
                branches.iter().fold(false, |stays, &branch| self.enter(branch) | stays)
            }
            NodeKind::While(condition, body) => {
                condition.as_ref().is_none_or(|c| self.holds(c, span)) && self.enter(*body)
            }
            NodeKind::Alternative(cases) => {
                let offered: Vec<NodeId> =
                    cases.iter().filter(|case| self.is_offered(case)).map(|case| case.body).collect();
                self.offer(&offered)
            }
            _ => {
                self.insert(node);
                true
            }
        }
    }

    /// Enters the offered cases of an `alternative`. One that has nothing to wait for is decided at once.
    fn offer(&mut self, offered: &[NodeId]) -> bool {
        let before = self.cut.clone();
        let variables = self.variables.clone();
        for &case in offered {
            if !self.enter(case) {
                self.cut = before;
                self.variables = variables;
                return false;
            }
        }
        !offered.is_empty()
    }

    fn insert(&mut self, node: NodeId) {
        if let Err(place) = self.cut.binary_search(&node) {
            self.cut.insert(place, node);
        }
    }

    /// Enters the fragments of a body from the given one on, until the cut stays in one.
    fn enter_from(&mut self, body: NodeId, from: usize) -> bool {
        let scenario = self.scenario;
        let NodeKind::Body { children, variables, .. } = &scenario.nodes[usize::from(body)].kind else {
            return false;
        };
        if children[from..].iter().any(|&child| self.enter(child)) {
            return true;
        }
        for &variable in variables {
            self.variables[variable] = UNSET;
        }
        false
    }

    /// The leaf `node` of the cut is done: the cut moves past it.
    pub(super) fn move_past(&mut self, node: NodeId) {
        self.decide(node);
        self.cut.retain(|&leaf| leaf != node);
        self.complete(node);
    }

    /// Moves on behind `node`, which is done.
    fn complete(&mut self, mut node: NodeId) {
        while node != 0 {
            let parent = self.parent(node);
            let scenario = self.scenario;
            match &scenario.nodes[usize::from(parent)].kind {
                NodeKind::Body { children, .. } => {
                    let next =
                        children.iter().position(|&child| child == node).map_or(children.len(), |i| i + 1);
                    if self.enter_from(parent, next) {
                        return;
                    }
                }
                NodeKind::Parallel(_) if self.cut.iter().any(|&leaf| self.is_inside(leaf, parent)) => return,
                NodeKind::While(..) if self.enter(parent) => return,
                _ => {}
            }
            node = parent;
        }
    }

    fn is_inside(&self, leaf: NodeId, ancestor: NodeId) -> bool {
        let mut node = leaf;
        while node > ancestor {
            node = self.parent(node);
        }
        node == ancestor
    }

    /// Decides every undecided `alternative` around `node` for the case in which it lies.
    fn decide(&mut self, node: NodeId) {
        if self.cut.len() > 1 {
            let cut = std::mem::take(&mut self.cut);
            self.cut =
                cut.into_iter().filter(|&leaf| leaf == node || !self.are_alternatives(leaf, node)).collect();
        }
    }

    /// Whether the lowest common ancestor of two leaves is an `alternative`.
    fn are_alternatives(&self, mut a: NodeId, mut b: NodeId) -> bool {
        // Nodes are numbered in textual order, so an ancestor has a smaller number.
        while a != b {
            if a > b {
                a = self.parent(a);
            } else {
                b = self.parent(b);
            }
        }
        matches!(self.kind(a), NodeKind::Alternative(_))
    }

    /// Whether the walk came to the end of the scenario, rather than being broken off.
    pub(super) fn is_completed(&self, rest: Rest) -> bool {
        rest == Rest::Ended && self.cut.is_empty()
    }

    /// Silent moves, the textually first one first, until nothing changes.
    pub(super) fn settle(&mut self) -> Rest {
        // A silent move depends on cut and variables alone. What comes round to itself comes round to one of the
        // places remembered, which lie ever further apart (Brent's algorithm).
        let mut remembered = (Vec::new(), Vec::new());
        let (mut moves, mut next) = (0_usize, 1);
        loop {
            if self.cut.is_empty() {
                return Rest::Ended;
            }
            if remembered.0 == self.cut && remembered.1 == self.variables {
                let span = self.scenario.nodes[usize::from(self.cut[0])].span;
                self.error.get_or_insert_with(|| PlayError {
                    code: Code::PlayOutLoop,
                    span,
                    message: "this loop never settles".to_owned(),
                });
                return Rest::Ended;
            }
            if moves == next {
                remembered = (self.cut.clone(), self.variables.clone());
                next *= 2;
            }
            match self.silent_move() {
                Some(Rest::Waits) => moves += 1,
                Some(rest) => return rest,
                None => return Rest::Waits,
            }
        }
    }

    /// Does the first silent move; `None` if there is none.
    fn silent_move(&mut self) -> Option<Rest> {
        let scenario = self.scenario;
        for index in 0..self.cut.len() {
            let node = self.cut[index];
            let span = scenario.nodes[usize::from(node)].span;
            match &scenario.nodes[usize::from(node)].kind {
                NodeKind::Wait { condition, .. } => {
                    if !self.holds(condition, span) {
                        continue;
                    }
                    self.passed.push(node);
                }
                NodeKind::Interrupt(condition) => {
                    if self.holds(condition, span) {
                        return Some(Rest::Ended);
                    }
                }
                NodeKind::Violation(condition) => {
                    if self.holds(condition, span) {
                        return Some(Rest::Violated(node));
                    }
                }
                NodeKind::Assign(..) => self.run_declaration(node),
                _ => continue,
            }
            self.move_past(node);
            return Some(Rest::Waits);
        }
        None
    }
}

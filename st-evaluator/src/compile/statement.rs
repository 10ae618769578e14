//! Statements.

use tree_sitter::Node;

use super::{Body, Operand};
use crate::code::{Action, Case, Expr, For, Step};
use crate::kind::Kind;
use crate::tree::{children, field, part, position};
use crate::types::{Type, TypeId};

/// Statements that end in an `END_…`, behind which the standard wants a semicolon like behind any other.
fn is_compound(kind: &str) -> bool {
    matches!(
        kind,
        "if_statement" | "case_statement" | "for_statement" | "while_statement" | "repeat_statement"
    )
}

impl<'t> Body<'_, 't> {
    /// A list of statements.
    pub(super) fn block(&mut self, nodes: &[Node<'t>]) -> Vec<Step> {
        let mut steps = Vec::with_capacity(nodes.len());
        for (index, &node) in nodes.iter().enumerate() {
            let closed = nodes.get(index + 1).is_some_and(|next| next.kind() == "empty_statement");
            if is_compound(node.kind()) && !closed && !self.unit.source.dialect.leaves_out_semicolons() {
                self.unit.error_at(end_of(node), "`;` is missing behind the statement");
            }
            if let Some(action) = self.statement(node) {
                steps.push(Step { at: position(node), action });
            }
        }
        steps
    }

    /// The statements within another one; the standard wants one at least, be it empty.
    fn inner(&mut self, node: Node<'t>, name: &str) -> Vec<Step> {
        let nodes = field(node, name);
        if nodes.is_empty() && self.is_strict() {
            self.error(node, "there are no statements in it");
        }
        self.block(&nodes)
    }

    fn statement(&mut self, node: Node<'t>) -> Option<Action> {
        match node.kind() {
            "assignment_statement" => self.assignment(node),
            "invocation_statement" => {
                let call = children(node).into_iter().next()?;
                self.call_statement(call)
            }
            "if_statement" => self.if_statement(node),
            "case_statement" => self.case_statement(node),
            "for_statement" => self.for_statement(node),
            "while_statement" => {
                let condition = part(node, "condition").and_then(|condition| self.truth(condition));
                let body = self.loop_body(node);
                Some(Action::While(condition?, body))
            }
            "repeat_statement" => {
                let body = self.loop_body(node);
                let condition = self.truth(part(node, "condition")?)?;
                Some(Action::Repeat(body, condition))
            }
            "exit_statement" => self.in_loop(node, "EXIT", Action::Exit),
            "continue_statement" => {
                if self.is_strict() {
                    self.error(node, "`CONTINUE` is not in the second edition");
                }
                self.in_loop(node, "CONTINUE", Action::Continue)
            }
            "return_statement" => {
                if let Some(value) = part(node, "value") {
                    self.error(value, "`RETURN` takes no value");
                }
                Some(Action::Return)
            }
            "empty_statement" => None,
            other => {
                self.error(node, format!("`{other}` is not supported"));
                None
            }
        }
    }

    fn in_loop(&mut self, node: Node<'t>, name: &str, action: Action) -> Option<Action> {
        if self.loops == 0 {
            self.error(node, format!("`{name}` outside of a loop"));
        }
        Some(action)
    }

    fn loop_body(&mut self, node: Node<'t>) -> Vec<Step> {
        self.loops += 1;
        let body = self.inner(node, "body");
        self.loops -= 1;
        body
    }

    fn assignment(&mut self, node: Node<'t>) -> Option<Action> {
        let (left, right) = (part(node, "left")?, part(node, "right")?);
        let Some(to) = self.target(left) else {
            // What is wrong on the right is worth knowing, too.
            self.operand(right, None);
            return None;
        };
        match *self.unit.types.get(to.ty) {
            Type::Text { capacity } => {
                let text = self.text(right)?;
                Some(Action::SetText { to: to.place, capacity, text })
            }
            Type::Block { .. } => {
                self.error(left, "instances of function blocks are not assigned");
                None
            }
            _ if self.unit.types.is_scalar(to.ty) => {
                let (value, _) = self.scalar(right, to.ty)?;
                Some(Action::Assign(to.place, value))
            }
            _ => {
                let from = self.place(right)?;
                self.require_same(node, from.ty, to.ty)?;
                Some(Action::Copy { to: to.place, from: from.place, size: self.unit.types.size(to.ty) })
            }
        }
    }

    fn if_statement(&mut self, node: Node<'t>) -> Option<Action> {
        let mut branches = Vec::new();
        let mut otherwise = Vec::new();
        let first = part(node, "condition").and_then(|condition| self.truth(condition));
        let body = self.inner(node, "consequence");
        branches.extend(first.map(|first| (first, body)));
        for child in children(node) {
            match child.kind() {
                "elsif_clause" => {
                    let condition = part(child, "condition").and_then(|condition| self.truth(condition));
                    let body = self.inner(child, "body");
                    branches.extend(condition.map(|condition| (condition, body)));
                }
                "else_clause" => otherwise = self.inner(child, "body"),
                _ => {}
            }
        }
        Some(Action::If { branches, otherwise })
    }

    fn case_statement(&mut self, node: Node<'t>) -> Option<Action> {
        let subject = part(node, "subject")?;
        let operand = self.operand(subject, None)?;
        if let Operand::Integer(_) = operand {
            self.error(subject, "a literal needs no `CASE`");
            return None;
        }
        let (ty, selector, _) = self.cell(subject, operand)?;
        let ty = match self.unit.types.kind(ty) {
            Some(kind) => self.elementary(kind),
            None => ty,
        };
        let is_enumeration = matches!(self.unit.types.get(ty), Type::Enumeration { .. });
        let bits = self.unit.source.dialect.mixes_integers_and_bit_strings();
        let kind = self.unit.types.kind(ty);
        let fits = kind.is_some_and(|k| k.is_integer() || bits && k.is_bit_string() && k != Kind::Bool);
        if !is_enumeration && !fits {
            self.error(subject, "`CASE` is one of integers and enumerations");
            return None;
        }
        let mut labels = Vec::new();
        let mut branches = Vec::new();
        let mut otherwise = Vec::new();
        for child in children(node) {
            match child.kind() {
                "case_clause" => {
                    for value in children(child).into_iter().filter(|value| value.kind() == "case_value") {
                        if let Some((low, high)) = self.label(value, ty) {
                            labels.push((low, high, branches.len() as u32, value));
                        }
                    }
                    branches.push(self.inner(child, "body"));
                }
                "else_clause" => otherwise = self.inner(child, "body"),
                _ => {}
            }
        }
        labels.sort_by_key(|(low, high, ..)| (*low, *high));
        for pair in labels.windows(2) {
            if pair[1].0 <= pair[0].1 {
                let value = pair[1].0;
                self.error(pair[1].3, format!("{value} is a label twice"));
            }
        }
        let labels = labels.into_iter().map(|(low, high, branch, _)| (low, high, branch)).collect();
        Some(Action::Case(Box::new(Case { selector, labels, branches, otherwise })))
    }

    /// First and last value of a label.
    fn label(&mut self, node: Node<'t>, ty: TypeId) -> Option<(i64, i64)> {
        let value = children(node).into_iter().next()?;
        if value.kind() != "subrange" {
            let label = self.unit.constant(value, ty, self.scope)?;
            return Some((label, label));
        }
        if matches!(self.unit.types.get(ty), Type::Enumeration { .. }) {
            self.error(value, "enumerations have no ranges");
            return None;
        }
        let low = self.unit.constant(part(value, "lower")?, ty, self.scope)?;
        let high = self.unit.constant(part(value, "upper")?, ty, self.scope)?;
        if low > high {
            self.error(value, "the range is empty");
        }
        Some((low, high))
    }

    fn for_statement(&mut self, node: Node<'t>) -> Option<Action> {
        let (control_node, start, end) = (part(node, "control")?, part(node, "start")?, part(node, "end")?);
        let control = self.target(control_node)?;
        let kind = self.unit.types.kind(control.ty).filter(|kind| kind.is_integer());
        let Some(kind) = kind else {
            self.error(control_node, "the control variable is an integer");
            return None;
        };
        let ty = control.ty;
        let start = self.scalar(start, ty).map(|(expr, _)| expr);
        let end = self.scalar(end, ty).map(|(expr, _)| expr);
        let step = match part(node, "step") {
            Some(step_node) => {
                let step = self.scalar(step_node, ty);
                if step.as_ref().is_some_and(|(_, value)| *value == Some(0)) {
                    self.error(step_node, "the step is 0");
                }
                step.map(|(expr, _)| expr)
            }
            None => Some(Expr::Value(1)),
        };
        self.controls.push(self.unit.source.name(control_node));
        let body = self.loop_body(node);
        self.controls.pop();
        let (start, end, step) = (start?, end?, step?);
        Some(Action::For(Box::new(For { control: control.place, kind, start, end, step, body })))
    }
}

/// The place behind a node.
fn end_of(node: Node<'_>) -> crate::error::Position {
    let end = node.end_position();
    crate::error::Position { line: end.row as u32 + 1, column: end.column as u32 + 1 }
}

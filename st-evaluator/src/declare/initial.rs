//! Initial values and other constants.

use tree_sitter::Node;

use super::{Analysis, Scope, Section};
use crate::compile::Body;
use crate::tree::{children, part};
use crate::types::{Type, TypeId};

impl<'t> Analysis<'t> {
    /// Writes an initial value over `cells`, which are a variable of the type. The nodes are those between `:=` and
    /// the semicolon: one value, or the elements of an array.
    pub(super) fn fill(&mut self, ty: TypeId, nodes: &[Node<'t>], scope: &Scope, cells: &mut [i64]) {
        let Some(&first) = nodes.first() else { return };
        match self.types.get(ty).clone() {
            Type::Array { element, .. } => self.fill_array(element, nodes, scope, cells),
            Type::Structure { fields, .. } => {
                let part = |name: &str| {
                    fields.iter().find(|field| field.name == name).map(|field| (field.ty, field.offset))
                };
                self.fill_parts(first, scope, cells, part);
            }
            Type::Block { pou, .. } => {
                let variables = self.pous[pou].scope.clone();
                let part = |name: &str| {
                    let variable = variables.get(name)?;
                    let visible = matches!(variable.section, Section::Input | Section::Output);
                    visible.then(|| (variable.ty, variable.offset()))
                };
                self.fill_parts(first, scope, cells, part);
            }
            Type::Text { capacity } => {
                let Some(text) = Body::constant(self, scope).literal_text(first) else {
                    return self.error(first, "the initial value of a string is a literal");
                };
                if text.len() > capacity as usize {
                    return self.error(first, format!("the string has more than {capacity} characters"));
                }
                cells.fill(0);
                cells[0] = text.len() as i64;
                for (cell, byte) in cells[1..].iter_mut().zip(text) {
                    *cell = i64::from(byte);
                }
            }
            Type::Elementary(_) | Type::Subrange { .. } | Type::Enumeration { .. } | Type::Pointer(_) => {
                if let Some(value) = self.constant(first, ty, scope) {
                    cells[0] = value;
                }
            }
        }
    }

    fn fill_array(&mut self, element: TypeId, nodes: &[Node<'t>], scope: &Scope, cells: &mut [i64]) {
        let size = self.types.size(element) as usize;
        let count = cells.len() / size.max(1);
        let mut at: usize = 0;
        for &node in nodes {
            let (times, values) = match repetition(node) {
                Some((count, values)) => {
                    let Some(times) = self.constant_integer(count, scope) else { return };
                    (usize::try_from(times).unwrap_or(usize::MAX), values)
                }
                None => (1, vec![node]),
            };
            let total = at.saturating_add(times.saturating_mul(values.len()));
            if total > count {
                return self.error(node, format!("more initial values than the {count} elements"));
            }
            let start = at * size;
            for value in &values {
                self.fill(element, &[*value], scope, &mut cells[at * size..(at + 1) * size]);
                at += 1;
            }
            let once = cells[start..at * size].to_vec();
            for _ in 1..times {
                cells[at * size..at * size + once.len()].copy_from_slice(&once);
                at += values.len();
            }
            if times == 0 {
                at -= values.len();
            }
        }
    }

    /// `(name := value, …)`.
    fn fill_parts(
        &mut self,
        node: Node<'t>,
        scope: &Scope,
        cells: &mut [i64],
        part_of: impl Fn(&str) -> Option<(TypeId, u32)>,
    ) {
        if node.kind() != "structure_initializer" {
            return self.error(node, "initial values of a structure are `(name := value, …)`");
        }
        for node in children(node) {
            let (Some(name), Some(value)) = (part(node, "name"), part(node, "value")) else { continue };
            let capitals = self.source.name(name);
            match part_of(&capitals) {
                Some((ty, offset)) => {
                    let end = offset + self.types.size(ty);
                    self.fill(ty, &[value], scope, &mut cells[offset as usize..end as usize]);
                }
                None => self.error(name, format!("there is no `{capitals}` in it")),
            }
        }
    }

    /// The value of a constant expression of a type.
    pub(crate) fn constant(&mut self, node: Node<'t>, ty: TypeId, scope: &Scope) -> Option<i64> {
        self.require_literal(node);
        let (_, value) = Body::constant(self, scope).scalar(node, ty)?;
        if value.is_none() {
            self.error(node, "is no constant");
        }
        value
    }

    /// The value of a constant integer, of whatever type.
    pub(super) fn constant_integer(&mut self, node: Node<'t>, scope: &Scope) -> Option<i64> {
        self.require_literal(node);
        let value = Body::constant(self, scope).any_integer(node)?.1;
        if value.is_none() {
            self.error(node, "is no constant integer");
        }
        value
    }

    /// The second edition has no constant expressions.
    fn require_literal(&mut self, node: Node<'t>) {
        let literal = match node.kind() {
            "unary_expression" => {
                part(node, "operand").is_some_and(|operand| operand.kind() == "integer_literal")
            }
            "identifier" => self.enumerators.contains_key(&self.source.name(node)),
            // `Type#value`.
            "member_access_expression" => true,
            kind => kind.ends_with("_literal"),
        };
        if self.is_strict() && !literal {
            self.error(node, "only a literal can stand here");
        }
    }
}

/// The number and the values of `3(0)`. Where several values stand in the parentheses the grammar takes it for a call.
fn repetition(node: Node<'_>) -> Option<(Node<'_>, Vec<Node<'_>>)> {
    match node.kind() {
        "array_repetition" => {
            let count = part(node, "count")?;
            Some((count, children(node).into_iter().filter(|child| child.id() != count.id()).collect()))
        }
        "call_expression" => {
            let count = part(node, "function").filter(|function| function.kind() == "integer_literal")?;
            Some((count, children(part(node, "arguments")?)))
        }
        _ => None,
    }
}

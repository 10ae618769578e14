//! Standard functions and conversions.

use tree_sitter::Node;

use super::call::{Given, given};
use super::{Body, Operand};
use crate::code::{Expr, Operator, Text, Unary};
use crate::kind::Kind;
use crate::tree::position;
use crate::types::TypeId;

impl<'t> Body<'_, 't> {
    /// The call of a function that is not declared in the text.
    pub(super) fn standard_function(
        &mut self,
        node: Node<'t>,
        function: Node<'t>,
        hint: Option<TypeId>,
    ) -> Option<Operand> {
        let name = self.unit.source.name(function);
        let shift = match name.as_str() {
            "SHL" => Some(Operator::ShiftLeft),
            "SHR" => Some(Operator::ShiftRight),
            "ROL" => Some(Operator::RotateLeft),
            "ROR" => Some(Operator::RotateRight),
            _ => None,
        };
        if let Some(operator) = shift {
            let arguments = self.formal(node, &["IN", "N"])?;
            return self.shift(node, operator, &arguments, hint);
        }
        match name.as_str() {
            "ABS" => self.absolute(node, hint),
            "MIN" | "MAX" => {
                let arguments = self.numbered(node, "IN", 1)?;
                self.extreme(name == "MIN", &arguments, hint)
            }
            "LIMIT" => self.limit(node, hint),
            "SEL" => self.select(node, hint),
            "MUX" => self.multiplex(node, hint),
            "LEN" => {
                let arguments = self.formal(node, &["IN"])?;
                let text = self.text(arguments[0])?;
                let ty = self.elementary(Kind::Int);
                Some(Operand::Scalar { ty, expr: Expr::Length(Box::new(text)), value: None })
            }
            "LEFT" | "RIGHT" | "MID" | "CONCAT" => self.part_of_text(node, &name),
            "SIZEOF" if self.unit.source.dialect.has_pointers() => {
                let arguments = self.formal(node, &["IN"])?;
                let located = self.place(arguments[0])?;
                Some(Operand::Integer(self.unit.types.bytes(located.ty).into()))
            }
            _ => self.conversion(node, function, &name),
        }
    }

    /// The arguments in the order of the formal names.
    fn formal(&mut self, node: Node<'t>, names: &[&str]) -> Option<Vec<Node<'t>>> {
        let given = given(node);
        let found = self.ordered(&given, names);
        if found.is_none() || given.len() != names.len() {
            self.error(node, format!("the arguments are ({})", names.join(", ")));
            return None;
        }
        found
    }

    fn ordered(&self, given: &[Given<'t>], names: &[&str]) -> Option<Vec<Node<'t>>> {
        let mut found = Vec::new();
        for (index, name) in names.iter().enumerate() {
            let argument = match given.iter().find(|g| g.name.is_some()) {
                None => given.get(index),
                Some(_) => given.iter().find(|g| g.name.is_some_and(|n| self.unit.source.name(n) == *name)),
            };
            found.push(argument.filter(|argument| !argument.output)?.value);
        }
        Some(found)
    }

    /// Two or more arguments `base1`, `base2`, … or without names.
    fn numbered(&mut self, node: Node<'t>, base: &str, first: usize) -> Option<Vec<Node<'t>>> {
        let count = given(node).len();
        if count < 2 {
            self.error(node, "two arguments or more are wanted");
            return None;
        }
        let names: Vec<String> = (first..first + count).map(|number| format!("{base}{number}")).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        self.formal(node, &names)
    }

    /// All arguments as cells of one type: that of the first one that is no literal.
    fn alike(&mut self, nodes: &[Node<'t>], hint: Option<TypeId>) -> Option<(TypeId, Vec<Expr>)> {
        let mut operands = Vec::new();
        let mut ty = None;
        for &node in nodes {
            let operand = self.operand(node, ty.or(hint))?;
            if ty.is_none() && !matches!(operand, Operand::Integer(_)) {
                ty = Some(match &operand {
                    Operand::Place(located) => located.ty,
                    Operand::Scalar { ty, .. } => *ty,
                    _ => {
                        self.error(node, "a single value is wanted");
                        return None;
                    }
                });
            }
            operands.push(operand);
        }
        let ty = match ty.or(hint) {
            Some(ty) => ty,
            None => self.elementary(Kind::Dint),
        };
        let ty = match self.unit.types.kind(ty) {
            Some(kind) => self.elementary(kind),
            None => ty,
        };
        let mut cells = Vec::new();
        for (&node, operand) in nodes.iter().zip(operands) {
            cells.push(self.coerce(node, operand, ty)?.0);
        }
        Some((ty, cells))
    }

    fn ordered_kind(&mut self, node: Node<'t>, ty: TypeId) -> Option<Kind> {
        let kind = self.unit.types.kind(ty).filter(|kind| *kind != Kind::Bool);
        if kind.is_none() {
            let name = self.unit.types.name(ty);
            self.error(node, format!("values of `{name}` have no order"));
        }
        kind
    }

    fn absolute(&mut self, node: Node<'t>, hint: Option<TypeId>) -> Option<Operand> {
        let arguments = self.formal(node, &["IN"])?;
        let (ty, mut cells) = self.alike(&arguments, hint)?;
        let kind = self.unit.types.kind(ty).filter(|kind| kind.is_integer());
        let (Some(kind), Some(cell)) = (kind, cells.pop()) else {
            self.error(node, "`ABS` is one of numbers");
            return None;
        };
        let expr = Expr::Unary(Unary::Absolute, kind, Box::new(cell));
        Some(Operand::Scalar { ty, expr, value: None })
    }

    fn extreme(&mut self, least: bool, arguments: &[Node<'t>], hint: Option<TypeId>) -> Option<Operand> {
        let (ty, cells) = self.alike(arguments, hint)?;
        let kind = self.ordered_kind(arguments[0], ty)?;
        Some(Operand::Scalar { ty, expr: Expr::Extreme(least, kind, cells), value: None })
    }

    fn limit(&mut self, node: Node<'t>, hint: Option<TypeId>) -> Option<Operand> {
        let arguments = self.formal(node, &["MN", "IN", "MX"])?;
        let (ty, mut cells) = self.alike(&arguments, hint)?;
        let kind = self.ordered_kind(node, ty)?;
        let most = cells.pop()?;
        let least = Expr::Extreme(false, kind, cells);
        Some(Operand::Scalar { ty, expr: Expr::Extreme(true, kind, vec![least, most]), value: None })
    }

    fn select(&mut self, node: Node<'t>, hint: Option<TypeId>) -> Option<Operand> {
        let arguments = self.formal(node, &["G", "IN0", "IN1"])?;
        let selector = self.truth(arguments[0])?;
        let (ty, cells) = self.alike(&arguments[1..], hint)?;
        let choices = std::iter::once(selector).chain(cells).collect();
        Some(Operand::Scalar { ty, expr: Expr::Select(choices, position(node)), value: None })
    }

    fn multiplex(&mut self, node: Node<'t>, hint: Option<TypeId>) -> Option<Operand> {
        let count = given(node).len();
        if count < 3 {
            self.error(node, "three arguments or more are wanted");
            return None;
        }
        let names: Vec<String> =
            std::iter::once("K".to_owned()).chain((0..count - 1).map(|n| format!("IN{n}"))).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let arguments = self.formal(node, &names)?;
        let (selector, _) = self.any_integer(arguments[0])?;
        let (ty, cells) = self.alike(&arguments[1..], hint)?;
        let choices = std::iter::once(selector).chain(cells).collect();
        Some(Operand::Scalar { ty, expr: Expr::Select(choices, position(node)), value: None })
    }

    fn part_of_text(&mut self, node: Node<'t>, name: &str) -> Option<Operand> {
        let at = position(node);
        let text = match name {
            "CONCAT" => {
                let mut texts = Vec::new();
                for argument in self.numbered(node, "IN", 1)? {
                    texts.push(self.text(argument)?);
                }
                Text::Concat(texts)
            }
            "MID" => {
                let arguments = self.formal(node, &["IN", "L", "P"])?;
                let text = self.text(arguments[0])?;
                let (length, _) = self.any_integer(arguments[1])?;
                let (start, _) = self.any_integer(arguments[2])?;
                Text::Middle(Box::new((text, length, start)), at)
            }
            _ => {
                let arguments = self.formal(node, &["IN", "L"])?;
                let text = self.text(arguments[0])?;
                let (length, _) = self.any_integer(arguments[1])?;
                let parts = Box::new((text, length));
                if name == "LEFT" { Text::Left(parts, at) } else { Text::Right(parts, at) }
            }
        };
        Some(Operand::Text(text))
    }

    /// `X_TO_Y`, and in the dialects `TO_Y`.
    fn conversion(&mut self, node: Node<'t>, function: Node<'t>, name: &str) -> Option<Operand> {
        let (from, to) = match name.split_once("_TO_") {
            Some((from, to)) => (Some(from), Kind::named(to)),
            None if self.unit.is_strict() => (None, None),
            None => (None, name.strip_prefix("TO_").and_then(Kind::named)),
        };
        let from_kind = from.and_then(Kind::named);
        let known = from.is_none() || from_kind.is_some() || from == Some("STRING");
        let Some(to) = to.filter(|to| known && (*to != Kind::Char || !self.unit.is_strict())) else {
            let shown = self.unit.source.text(function);
            self.error(function, format!("there is no function `{shown}`"));
            return None;
        };
        let arguments = self.formal(node, &["IN"])?;
        let argument = arguments[0];
        let ty = self.elementary(to);
        if from == Some("STRING") {
            let text = self.text(argument)?;
            let expr = Expr::Number(Box::new(text), to, position(node));
            return Some(Operand::Scalar { ty, expr, value: None });
        }
        let (kind, value) = match from_kind {
            Some(kind) => {
                let wanted = self.elementary(kind);
                (kind, self.scalar(argument, wanted)?.0)
            }
            None => {
                let operand = self.operand(argument, None)?;
                let (ty, expr, _) = self.cell(argument, operand)?;
                let Some(kind) = self.unit.types.kind(ty) else {
                    self.error(argument, "an elementary value is wanted");
                    return None;
                };
                (kind, expr)
            }
        };
        let expr = Expr::Convert { from: kind, to, value: Box::new(value) };
        Some(Operand::Scalar { ty, expr, value: None })
    }
}

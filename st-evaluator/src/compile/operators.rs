//! Expressions and their operators.

use tree_sitter::Node;

use super::{Body, Operand};
use crate::arithmetic;
use crate::code::{Binary, Expr, Operator, Unary};
use crate::kind::Kind;
use crate::tree::{children, part, position};
use crate::types::{Type, TypeId};

fn operator_named(text: &str) -> Option<Operator> {
    Some(match text {
        "+" => Operator::Add,
        "-" => Operator::Subtract,
        "*" => Operator::Multiply,
        "/" => Operator::Divide,
        "MOD" => Operator::Modulo,
        "AND" | "&" => Operator::And,
        "OR" => Operator::Or,
        "XOR" => Operator::Xor,
        "=" => Operator::Equal,
        "<>" => Operator::Unequal,
        "<" => Operator::Less,
        "<=" => Operator::LessOrEqual,
        ">" => Operator::Greater,
        ">=" => Operator::GreaterOrEqual,
        _ => return None,
    })
}

impl<'t> Body<'_, 't> {
    /// Any expression. A hint is the type that is wanted, for what could have several.
    pub(super) fn operand(&mut self, node: Node<'t>, hint: Option<TypeId>) -> Option<Operand> {
        match node.kind() {
            "parenthesized_expression" => {
                let inner = children(node).into_iter().next()?;
                self.operand(inner, hint)
            }
            "identifier" => self.identifier(node, hint),
            "member_access_expression" => self.member(node),
            "index_expression" => self.indexed(node),
            "dereference_expression" => self.dereferenced(node),
            "address_of_expression" => self.address(node),
            "unary_expression" => self.unary(node, hint),
            "binary_expression" => self.binary(node, hint),
            "call_expression" => self.call_operand(node, hint),
            _ => self.literal(node),
        }
    }

    fn unary(&mut self, node: Node<'t>, hint: Option<TypeId>) -> Option<Operand> {
        let (operator, operand_node) = (part_token(node)?, part(node, "operand")?);
        let operator = self.unit.source.name(operator);
        let operand = self.operand(operand_node, hint)?;
        if let Operand::Integer(value) = operand {
            match operator.as_str() {
                "-" => return Some(Operand::Integer(-value)),
                "+" => return Some(Operand::Integer(value)),
                _ => {}
            }
        }
        let (ty, expr, value) = match (operand, hint) {
            (operand @ Operand::Integer(_), Some(hint)) => {
                let (expr, value) = self.coerce(operand_node, operand, hint)?;
                (hint, expr, value)
            }
            (operand, _) => self.cell(operand_node, operand)?,
        };
        let kind = self.unit.types.kind(ty);
        let mixes = self.unit.source.dialect.mixes_integers_and_bit_strings();
        let fits = kind.filter(|kind| match operator.as_str() {
            "NOT" => kind.is_bit_string() || mixes && kind.is_integer(),
            _ => kind.is_integer() || *kind == Kind::Time,
        });
        let Some(kind) = fits else {
            let name = self.unit.types.name(ty);
            self.error(node, format!("`{operator}` of `{name}`"));
            return None;
        };
        let ty = self.elementary(kind);
        let unary = match operator.as_str() {
            "NOT" => Unary::Complement,
            "-" => Unary::Negate,
            _ => return Some(Operand::Scalar { ty, expr, value }),
        };
        let value = value.map(|value| match unary {
            Unary::Complement => kind.wrap(!value),
            _ => kind.wrap(value.wrapping_neg()),
        });
        let expr = value.map_or_else(|| Expr::Unary(unary, kind, Box::new(expr)), Expr::Value);
        Some(Operand::Scalar { ty, expr, value })
    }

    fn binary(&mut self, node: Node<'t>, hint: Option<TypeId>) -> Option<Operand> {
        let operator_node = part_token(node)?;
        let (left_node, right_node) = (part(node, "left")?, part(node, "right")?);
        let spelled = self.unit.source.name(operator_node);
        let Some(operator) = operator_named(&spelled) else {
            self.error(operator_node, format!("`{spelled}` is not supported: it is one of `REAL`"));
            return None;
        };
        let hint = hint.filter(|_| !operator.is_comparison());
        let left = self.operand(left_node, hint);
        let left_ty = match &left {
            Some(Operand::Scalar { ty, .. }) => Some(*ty),
            Some(Operand::Place(located)) => Some(located.ty),
            _ => None,
        };
        // Both sides, so that both sides' mistakes are found.
        let right = self.operand(right_node, left_ty.or(hint));
        let (left, right) = (left?, right?);
        if let (Operand::Integer(a), Operand::Integer(b)) = (&left, &right) {
            return self.fold(node, operator, *a, *b);
        }
        if let (Some(a), Some(b)) = (self.as_text(&left), self.as_text(&right)) {
            if !operator.is_comparison() {
                self.error(node, format!("`{spelled}` of strings"));
                return None;
            }
            let ty = self.elementary(Kind::Bool);
            let expr = Expr::CompareTexts(operator, Box::new((a, b)));
            return Some(Operand::Scalar { ty, expr, value: None });
        }
        let (ty, a, b) = self.unified(node, (left_node, left), (right_node, right))?;
        let short = self.unit.source.spelled.shortcuts.contains(&operator_node.start_byte());
        self.operation(node, operator, short, ty, a, b)
    }

    /// Two integer literals.
    fn fold(&mut self, node: Node<'t>, operator: Operator, a: i128, b: i128) -> Option<Operand> {
        let truth = match operator {
            Operator::Equal => a == b,
            Operator::Unequal => a != b,
            Operator::Less => a < b,
            Operator::LessOrEqual => a <= b,
            Operator::Greater => a > b,
            Operator::GreaterOrEqual => a >= b,
            _ => {
                let value = match operator {
                    Operator::Add => a.checked_add(b),
                    Operator::Subtract => a.checked_sub(b),
                    Operator::Multiply => a.checked_mul(b),
                    Operator::Divide => a.checked_div(b),
                    Operator::Modulo => a.checked_rem(b),
                    _ => None,
                };
                if value.is_none() {
                    self.error(node, "cannot be computed");
                }
                return value.map(Operand::Integer);
            }
        };
        let ty = self.elementary(Kind::Bool);
        Some(Operand::Scalar { ty, expr: Expr::Value(i64::from(truth)), value: Some(i64::from(truth)) })
    }

    /// Both sides as cells of one type.
    fn unified(
        &mut self,
        node: Node<'t>,
        (left_node, left): (Node<'t>, Operand),
        (right_node, right): (Node<'t>, Operand),
    ) -> Option<(TypeId, Cell, Cell)> {
        if let Operand::Integer(_) = left {
            let (ty, expr, value) = self.cell(right_node, right)?;
            let left = self.coerce_base(left_node, left, ty)?;
            return Some((ty, left, (expr, value)));
        }
        let (left_ty, expr, value) = self.cell(left_node, left)?;
        let left = (expr, value);
        if let Operand::Integer(_) = right {
            let right = self.coerce_base(right_node, right, left_ty)?;
            return Some((left_ty, left, right));
        }
        let (right_ty, expr, value) = self.cell(right_node, right)?;
        let right = (expr, value);
        if self.fits(left_ty, right_ty) {
            Some((right_ty, left, right))
        } else if self.fits(right_ty, left_ty) {
            Some((left_ty, left, right))
        } else {
            let (a, b) = (self.unit.types.name(left_ty), self.unit.types.name(right_ty));
            self.error(node, format!("`{a}` and `{b}` do not go together"));
            None
        }
    }

    /// A literal beside a value of a subrange need not be in the subrange.
    fn coerce_base(&mut self, node: Node<'t>, operand: Operand, ty: TypeId) -> Option<Cell> {
        let base = match self.unit.types.kind(ty) {
            Some(kind) => self.elementary(kind),
            None => ty,
        };
        self.coerce(node, operand, base)
    }

    fn operation(
        &mut self,
        node: Node<'t>,
        operator: Operator,
        short: bool,
        ty: TypeId,
        (left, left_value): Cell,
        (right, right_value): Cell,
    ) -> Option<Operand> {
        let Some(kind) = self.operand_kind(operator, ty) else {
            let name = self.unit.types.name(ty);
            let operator = part_token(node).map(|n| self.unit.source.name(n)).unwrap_or_default();
            self.error(node, format!("`{operator}` of `{name}`"));
            return None;
        };
        if short {
            if kind != Kind::Bool {
                self.error(node, "only of `BOOL`");
                return None;
            }
            let expr = Expr::Shortcut(operator == Operator::And, Box::new((left, right)));
            return Some(Operand::Scalar { ty, expr, value: None });
        }
        let result = if operator.is_comparison() { Kind::Bool } else { kind };
        // Enumerations and pointers are compared only, so that all other results have the kind of the operands.
        let ty = self.elementary(result);
        if let (Some(a), Some(b)) = (left_value, right_value) {
            match arithmetic::binary(operator, kind, a, b) {
                Ok((value, false)) => {
                    return Some(Operand::Scalar { ty, expr: Expr::Value(value), value: Some(value) });
                }
                Ok((_, true)) => self.error(node, format!("the result is not within `{}`", kind.name())),
                Err(message) => self.error(node, message),
            }
            return None;
        }
        let at = position(node);
        let expr = Expr::Binary(Box::new(Binary { operator, kind, left, right, at }));
        Some(Operand::Scalar { ty, expr, value: None })
    }

    /// What is computed with, if the operator takes the type.
    fn operand_kind(&self, operator: Operator, ty: TypeId) -> Option<Kind> {
        let equality = matches!(operator, Operator::Equal | Operator::Unequal);
        let kind = match self.unit.types.get(ty) {
            Type::Enumeration { .. } | Type::Pointer(_) => return equality.then_some(Kind::Lint),
            _ => self.unit.types.kind(ty)?,
        };
        let mixes = self.unit.source.dialect.mixes_integers_and_bit_strings();
        let fits = match operator {
            Operator::Add | Operator::Subtract => {
                kind.is_integer() || kind == Kind::Time || mixes && kind.is_bit_string() && kind != Kind::Bool
            }
            Operator::Multiply | Operator::Divide | Operator::Modulo => {
                kind.is_integer() || mixes && kind.is_bit_string() && kind != Kind::Bool
            }
            Operator::And | Operator::Or | Operator::Xor => {
                kind.is_bit_string() || mixes && kind.is_integer()
            }
            Operator::ShiftLeft | Operator::ShiftRight | Operator::RotateLeft | Operator::RotateRight => {
                kind.is_bit_string() && kind != Kind::Bool || mixes && kind.is_integer()
            }
            Operator::Equal | Operator::Unequal => true,
            _ => kind != Kind::Bool,
        };
        fits.then_some(kind)
    }

    /// `SHL` and its like: the left side has a type, the right one is any integer.
    pub(super) fn shift(
        &mut self,
        node: Node<'t>,
        operator: Operator,
        operands: &[Node<'t>],
        hint: Option<TypeId>,
    ) -> Option<Operand> {
        let [value_node, places_node] = operands else { return None };
        let operand = self.operand(*value_node, hint)?;
        let (ty, left, _) = match (operand, hint) {
            (operand @ Operand::Integer(_), Some(hint)) => {
                let (expr, value) = self.coerce(*value_node, operand, hint)?;
                (hint, expr, value)
            }
            (operand, _) => self.cell(*value_node, operand)?,
        };
        let (right, _) = self.any_integer(*places_node)?;
        let Some(kind) = self.operand_kind(operator, ty) else {
            let name = self.unit.types.name(ty);
            self.error(*value_node, format!("`{name}` has no bits to shift"));
            return None;
        };
        let ty = self.elementary(kind);
        let at = position(node);
        let expr = Expr::Binary(Box::new(Binary { operator, kind, left, right, at }));
        Some(Operand::Scalar { ty, expr, value: None })
    }
}

/// An expression and its value, if it is constant.
pub(super) type Cell = (Expr, Option<i64>);

/// The token of the operator.
fn part_token(node: Node<'_>) -> Option<Node<'_>> {
    node.child_by_field_name("operator")
}

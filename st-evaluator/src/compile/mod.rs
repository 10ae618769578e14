//! From syntax to [`code`](crate::code): names, types, and everything that a compiler refuses.

mod call;
pub(crate) mod literal;
mod operators;
mod place;
mod standard;
mod statement;

use std::collections::BTreeSet;

use tree_sitter::Node;

use crate::code::{Expr, Place, Text, Within};
use crate::declare::{Analysis, PouKind, Scope, Section};
use crate::kind::Kind;
use crate::tree::{field, position};
use crate::types::{Type, TypeId};

/// Compiles the bodies of everything that was declared.
pub(crate) fn bodies(unit: &mut Analysis<'_>) {
    let bodies = unit.take_bodies();
    let mut calls: Vec<(usize, BTreeSet<usize>)> = Vec::new();
    for (index, node) in bodies {
        let scope = std::mem::take(&mut unit.pous[index].scope);
        let kind = unit.pous[index].kind;
        let statements = field(node, "body");
        let trusted = unit.source.is_prelude(node);
        if statements.is_empty() && unit.is_strict() {
            unit.error(node, "there are no statements");
        }
        let mut body = Body {
            unit,
            scope: &scope,
            kind: Some(kind),
            index,
            trusted,
            loops: 0,
            controls: Vec::new(),
            has_result: false,
            calls: BTreeSet::new(),
        };
        body.externals();
        let code = body.block(&statements);
        let (has_result, called) = (body.has_result, body.calls);
        if kind == PouKind::Function && !has_result && unit.pous[index].result.is_some() {
            unit.error(node, "the function does not assign its result");
        }
        calls.push((index, called));
        unit.pous[index].scope = scope;
        unit.pous[index].code = code;
        // The positions of recursive calls are those of the function.
        if reaches(&calls, index, index) {
            unit.error(node, "the function calls itself");
        }
    }
}

/// Whether calls lead from one function to another.
fn reaches(calls: &[(usize, BTreeSet<usize>)], from: usize, to: usize) -> bool {
    let mut seen = BTreeSet::new();
    let mut pending = vec![from];
    while let Some(index) = pending.pop() {
        let called = calls.iter().find(|(caller, _)| *caller == index).map(|(_, called)| called);
        for &callee in called.into_iter().flatten() {
            if callee == to {
                return true;
            }
            if seen.insert(callee) {
                pending.push(callee);
            }
        }
    }
    false
}

/// An expression, before it is known what it is wanted for.
#[derive(Clone, Debug)]
pub(crate) enum Operand {
    /// A literal integer, which takes the type that is wanted.
    Integer(i128),
    /// One cell.
    Scalar {
        ty: TypeId,
        expr: Expr,
        value: Option<i64>,
    },
    Place(Located),
    Text(Text),
    /// `ADR` of values of an elementary type.
    Address {
        expr: Expr,
        kind: Kind,
    },
}

/// A variable or a part of one.
#[derive(Clone, Debug)]
pub(crate) struct Located {
    pub(crate) ty: TypeId,
    pub(crate) place: Place,
    /// Why it cannot be written, if so.
    pub(crate) refused: Option<&'static str>,
    /// Of a constant.
    pub(crate) value: Option<i64>,
}

/// What is compiled: a body, or a constant expression among declarations.
pub(crate) struct Body<'a, 't> {
    unit: &'a mut Analysis<'t>,
    scope: &'a Scope,
    /// None for a constant expression.
    kind: Option<PouKind>,
    index: usize,
    /// The standard function blocks need not keep to the rules.
    trusted: bool,
    loops: usize,
    /// Control variables of the loops around, in capitals.
    controls: Vec<String>,
    has_result: bool,
    calls: BTreeSet<usize>,
}

impl<'a, 't> Body<'a, 't> {
    /// For constant expressions, in which the variables declared so far can occur.
    pub(crate) fn constant(unit: &'a mut Analysis<'t>, scope: &'a Scope) -> Body<'a, 't> {
        Body {
            unit,
            scope,
            kind: None,
            index: usize::MAX,
            trusted: false,
            loops: 0,
            controls: Vec::new(),
            has_result: false,
            calls: BTreeSet::new(),
        }
    }

    fn error(&mut self, node: Node<'_>, message: impl Into<String>) {
        self.unit.error(node, message);
    }

    fn is_strict(&self) -> bool {
        self.unit.is_strict() && !self.trusted
    }

    fn elementary(&mut self, kind: Kind) -> TypeId {
        self.unit.types.elementary(kind)
    }

    /// Every external variable is a global one, of the same type.
    fn externals(&mut self) {
        for variable in self.scope.variables.iter().filter(|v| v.section == Section::External) {
            let name = variable.name.to_ascii_uppercase();
            let message = match self.unit.globals.get(&name) {
                None => Some(format!("there is no global variable `{}`", variable.name)),
                Some(global) if !self.unit.types.same_shape(global.ty, variable.ty) => {
                    Some(format!("the global variable `{}` has another type", variable.name))
                }
                Some(global) if global.constant && !variable.constant => {
                    Some(format!("the global variable `{}` is constant", variable.name))
                }
                Some(_) => None,
            };
            if let Some(message) = message {
                self.unit.error_at(variable.at, message);
            }
        }
    }

    /// An expression as a cell of a type, and its value if it is constant.
    pub(crate) fn scalar(&mut self, node: Node<'t>, ty: TypeId) -> Option<(Expr, Option<i64>)> {
        let operand = self.operand(node, Some(ty))?;
        self.coerce(node, operand, ty)
    }

    /// A condition.
    fn truth(&mut self, node: Node<'t>) -> Option<Expr> {
        let ty = self.elementary(Kind::Bool);
        self.scalar(node, ty).map(|(expr, _)| expr)
    }

    /// An integer of whatever type, such as an index.
    pub(crate) fn any_integer(&mut self, node: Node<'t>) -> Option<(Expr, Option<i64>)> {
        match self.operand(node, None)? {
            Operand::Integer(value) => {
                let value = i64::try_from(value).ok();
                if value.is_none() {
                    self.error(node, "the number is too large");
                }
                value.map(|value| (Expr::Value(value), Some(value)))
            }
            operand => {
                let (ty, expr, value) = self.cell(node, operand)?;
                let bits = self.unit.source.dialect.mixes_integers_and_bit_strings();
                let kind = self.unit.types.kind(ty);
                let fits =
                    kind.is_some_and(|k| k.is_integer() || bits && k.is_bit_string() && k != Kind::Bool);
                if !fits {
                    let name = self.unit.types.name(ty);
                    self.error(node, format!("an integer is wanted, not `{name}`"));
                    return None;
                }
                Some((expr, value))
            }
        }
    }

    /// The one cell of an operand that has a type of its own.
    fn cell(&mut self, node: Node<'t>, operand: Operand) -> Option<(TypeId, Expr, Option<i64>)> {
        match operand {
            Operand::Scalar { ty, expr, value } => Some((ty, expr, value)),
            Operand::Place(located) if self.unit.types.is_scalar(located.ty) => {
                let expr = located.value.map_or_else(|| Expr::Load(located.place), Expr::Value);
                Some((located.ty, expr, located.value))
            }
            Operand::Integer(value) => {
                let ty = self.elementary(Kind::Dint);
                let (expr, value) = self.coerce(node, Operand::Integer(value), ty)?;
                Some((ty, expr, value))
            }
            Operand::Place(located) => {
                let name = self.unit.types.name(located.ty);
                self.error(node, format!("a single value is wanted, not `{name}`"));
                None
            }
            Operand::Text(_) => {
                self.error(node, "a single value is wanted, not a string");
                None
            }
            Operand::Address { .. } => {
                self.error(node, "an address can only be assigned to a pointer");
                None
            }
        }
    }

    /// An operand as a cell of the type that is wanted.
    fn coerce(&mut self, node: Node<'t>, operand: Operand, ty: TypeId) -> Option<(Expr, Option<i64>)> {
        match operand {
            Operand::Integer(value) => self.coerce_integer(node, value, ty),
            Operand::Address { expr, kind } => {
                let fits = match self.unit.types.get(ty) {
                    Type::Pointer(target) => self.unit.types.uniform(*target) == Some(kind),
                    _ => false,
                };
                if !fits {
                    let name = self.unit.types.name(ty);
                    self.error(node, format!("the address of `{}` is no `{name}`", kind.name()));
                    return None;
                }
                Some((expr, None))
            }
            operand => {
                let (from, expr, value) = self.cell(node, operand)?;
                if !self.fits(from, ty) {
                    let (from, to) = (self.unit.types.name(from), self.unit.types.name(ty));
                    self.error(node, format!("`{from}` where `{to}` is wanted"));
                    return None;
                }
                self.within(node, from, ty, expr, value)
            }
        }
    }

    /// An integer literal as a cell.
    fn coerce_integer(&mut self, node: Node<'t>, value: i128, ty: TypeId) -> Option<(Expr, Option<i64>)> {
        let name = self.unit.types.name(ty);
        let range = match self.unit.types.get(ty) {
            Type::Subrange { low, high, .. } => Some((i128::from(*low), i128::from(*high))),
            Type::Elementary(kind) if kind.is_integer() || kind.is_bit_string() && *kind != Kind::Bool => {
                Some(kind.range())
            }
            Type::Pointer(_) => Some((0, 0)),
            _ => None,
        };
        let Some((low, high)) = range else {
            self.error(node, format!("an integer where `{name}` is wanted"));
            return None;
        };
        if value < low || value > high {
            self.error(node, format!("{value} is not within `{name}`"));
            return None;
        }
        let cell = value as i64;
        Some((Expr::Value(cell), Some(cell)))
    }

    /// Whether a value of one scalar type can stand where another is wanted.
    fn fits(&self, from: TypeId, to: TypeId) -> bool {
        let types = &self.unit.types;
        let mixed = self.unit.source.dialect.mixes_integers_and_bit_strings();
        match (types.kind(from), types.kind(to)) {
            (Some(a), Some(b)) => a == b || !self.unit.is_strict() && a.widens_to(b, mixed),
            (None, None) => types.same_shape(from, to),
            _ => false,
        }
    }

    /// Makes sure that a value is one of the subrange that is wanted.
    fn within(
        &mut self,
        node: Node<'t>,
        from: TypeId,
        to: TypeId,
        expr: Expr,
        value: Option<i64>,
    ) -> Option<(Expr, Option<i64>)> {
        let Type::Subrange { low, high, .. } = *self.unit.types.get(to) else { return Some((expr, value)) };
        if from == to {
            return Some((expr, value));
        }
        if value.is_some_and(|value| value < low || value > high) {
            self.error(node, format!("the value is not within {low}..{high}"));
            return None;
        }
        let within = Within { value: expr, low, high, at: position(node) };
        Some((Expr::Within(Box::new(within)), value))
    }

    /// Whether whole arrays, structures and instances can be assigned to each other, or be the same argument.
    fn is_same(&self, a: TypeId, b: TypeId) -> bool {
        let types = &self.unit.types;
        if self.unit.is_strict() {
            // Anonymous arrays have no type that another could have.
            let anonymous = matches!(types.get(a), Type::Array { named: None, .. });
            return a == b && !anonymous;
        }
        types.same_shape(a, b)
    }

    /// A string.
    fn text(&mut self, node: Node<'t>) -> Option<Text> {
        let operand = self.operand(node, None)?;
        let text = self.as_text(&operand);
        if text.is_none() {
            self.error(node, "a string is wanted");
        }
        text
    }

    fn as_text(&self, operand: &Operand) -> Option<Text> {
        match operand {
            Operand::Text(text) => Some(text.clone()),
            Operand::Place(located) => match self.unit.types.get(located.ty) {
                Type::Text { capacity } => Some(Text::Load(located.place.clone(), *capacity)),
                _ => None,
            },
            _ => None,
        }
    }
}

//! Values of expressions.

use super::spec::{Scenario, Spec};
use super::state::{Attributes, Roles, Variables};
use super::value::Value;
use std::collections::BTreeMap;
use synth_core::syntax::ast::{BinaryOp, Expr, ExprKind, Path, Type, UnaryOp};

/// Why an expression has no value.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum EvalError {
    /// A variable or role that is not set yet.
    Unset(String),
    /// A path through `null`.
    Null(String),
    /// An overflow of 64 bits, or a value that its place does not take.
    Range(String),
    /// The specification is not well formed.
    Malformed(String),
}

/// What names mean.
#[derive(Clone, Copy, Debug)]
pub enum Names<'a> {
    /// In a scenario copy, in the body at a path.
    Copy {
        /// The scenario.
        scenario: &'a Scenario,
        /// Bound roles of the copy.
        roles: &'a Roles,
        /// Set variables of the copy.
        variables: &'a Variables,
        /// Where the expression stands.
        body: &'a [usize],
    },
    /// In an effect: `sender`, `receiver` and parameters.
    Effect(&'a BTreeMap<String, Value>),
}

/// Where an expression is evaluated.
#[derive(Clone, Copy, Debug)]
pub struct Scope<'a> {
    /// Classes and objects.
    pub spec: &'a Spec,
    /// Values of attributes.
    pub attributes: &'a Attributes,
    /// Values of names.
    pub names: Names<'a>,
}

impl Scope<'_> {
    /// The value of an expression.
    ///
    /// # Errors
    /// See [`EvalError`].
    pub fn value(&self, expr: &Expr) -> Result<Value, EvalError> {
        match &expr.kind {
            ExprKind::Bool(value) => Ok(Value::Bool(*value)),
            ExprKind::Int(value) => Ok(Value::Int(*value)),
            ExprKind::Null => Ok(Value::Null),
            ExprKind::Literal(_, literal) => Ok(Value::Literal(literal.text.clone())),
            ExprKind::Path(path) => self.path(path),
            ExprKind::Unary(UnaryOp::Not, operand) => Ok(Value::Bool(!self.condition(operand)?)),
            ExprKind::Unary(UnaryOp::Neg, operand) => integer(self.integer(operand)?.checked_neg()),
            ExprKind::Binary(operator, left, right) => self.binary(*operator, left, right),
        }
    }

    fn binary(&self, operator: BinaryOp, left: &Expr, right: &Expr) -> Result<Value, EvalError> {
        let value = match operator {
            BinaryOp::Implies => !self.condition(left)? || self.condition(right)?,
            BinaryOp::Or => self.condition(left)? || self.condition(right)?,
            BinaryOp::And => self.condition(left)? && self.condition(right)?,
            BinaryOp::Eq => self.value(left)? == self.value(right)?,
            BinaryOp::Ne => self.value(left)? != self.value(right)?,
            BinaryOp::Lt => self.integer(left)? < self.integer(right)?,
            BinaryOp::Le => self.integer(left)? <= self.integer(right)?,
            BinaryOp::Gt => self.integer(left)? > self.integer(right)?,
            BinaryOp::Ge => self.integer(left)? >= self.integer(right)?,
            BinaryOp::Add => return integer(self.integer(left)?.checked_add(self.integer(right)?)),
            BinaryOp::Sub => return integer(self.integer(left)?.checked_sub(self.integer(right)?)),
            BinaryOp::Mul => return integer(self.integer(left)?.checked_mul(self.integer(right)?)),
        };
        Ok(Value::Bool(value))
    }

    /// The value of a condition.
    ///
    /// # Errors
    /// See [`EvalError`].
    pub fn condition(&self, expr: &Expr) -> Result<bool, EvalError> {
        match self.value(expr)? {
            Value::Bool(value) => Ok(value),
            other => Err(EvalError::Malformed(format!("`{other}` is not a condition"))),
        }
    }

    fn integer(&self, expr: &Expr) -> Result<i64, EvalError> {
        match self.value(expr)? {
            Value::Int(value) => Ok(value),
            other => Err(EvalError::Malformed(format!("`{other}` is not an integer"))),
        }
    }

    /// The value of a path: its first name, then attributes.
    ///
    /// # Errors
    /// See [`EvalError`].
    pub fn path(&self, path: &Path) -> Result<Value, EvalError> {
        let Some((first, attributes)) = path.names.split_first() else {
            return Err(EvalError::Malformed("an empty path".into()));
        };
        let mut value = self.name(&first.text)?;
        for attribute in attributes {
            value = match value {
                Value::Object(object) => {
                    self.attributes.get(&(object.clone(), attribute.text.clone())).cloned().ok_or_else(
                        || EvalError::Malformed(format!("`{object}` has no `{}`", attribute.text)),
                    )?
                }
                Value::Null => return Err(EvalError::Null(attribute.text.clone())),
                other => return Err(EvalError::Malformed(format!("`{other}` has no attributes"))),
            };
        }
        Ok(value)
    }

    /// The value of a name: variable or parameter, role, object, enum literal, in this order.
    fn name(&self, name: &str) -> Result<Value, EvalError> {
        match self.names {
            Names::Copy { scenario, roles, variables, body } => {
                if let Some((declared, _)) = scenario.variable(body, name) {
                    let value = variables.get(&(declared, name.to_owned())).cloned();
                    return value.ok_or_else(|| EvalError::Unset(name.into()));
                }
                if scenario.roles.contains_key(name) {
                    let object = roles.get(name).cloned();
                    return object.map(Value::Object).ok_or_else(|| EvalError::Unset(name.into()));
                }
            }
            Names::Effect(parameters) => {
                if let Some(value) = parameters.get(name) {
                    return Ok(value.clone());
                }
            }
        }
        Ok(self.spec.object_or_literal(name))
    }

    /// The value of an expression that a place of this type takes.
    ///
    /// # Errors
    /// See [`EvalError`].
    pub fn value_of_type(&self, expr: &Expr, ty: &Type) -> Result<Value, EvalError> {
        let value = self.value(expr)?;
        if self.spec.fits(&value, ty) { Ok(value) } else { Err(EvalError::Range(value.to_string())) }
    }
}

fn integer(value: Option<i64>) -> Result<Value, EvalError> {
    value.map(Value::Int).ok_or_else(|| EvalError::Range("overflow".into()))
}

/// The names with which the paths of an expression begin, in textual order.
#[must_use]
pub fn names_in(expr: &Expr) -> Vec<&str> {
    match &expr.kind {
        ExprKind::Bool(_) | ExprKind::Int(_) | ExprKind::Null | ExprKind::Literal(..) => Vec::new(),
        ExprKind::Path(path) => path.names.first().map(|name| name.text.as_str()).into_iter().collect(),
        ExprKind::Unary(_, operand) => names_in(operand),
        ExprKind::Binary(_, left, right) => [names_in(left), names_in(right)].concat(),
    }
}

/// Whether the value of an expression depends on no attribute, variable or dynamic role.
#[must_use]
pub fn is_constant(expr: &Expr, scenario: &Scenario, body: &[usize]) -> bool {
    match &expr.kind {
        ExprKind::Bool(_) | ExprKind::Int(_) | ExprKind::Null | ExprKind::Literal(..) => true,
        ExprKind::Path(path) => {
            let name = &path.names[0].text;
            path.names.len() == 1
                && scenario.variable(body, name).is_none()
                && !scenario.roles.contains_key(name)
        }
        ExprKind::Unary(_, operand) => is_constant(operand, scenario, body),
        ExprKind::Binary(_, left, right) => {
            is_constant(left, scenario, body) && is_constant(right, scenario, body)
        }
    }
}

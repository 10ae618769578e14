//! Typed expressions and their value in a scope.

use super::domain::{Domain, NULL, SlotId};
use crate::syntax::Span;
use std::cell::RefCell;

/// A value of any type; see [`super::Type`] for the encoding.
pub type Value = i64;

/// A variable or role that has no value yet.
pub const UNSET: Value = Value::MIN;

/// Strict binary operators; `&&`, `||` and `=>` have variants of their own because they stop early.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[expect(missing_docs, reason = "the operators' usual names")]
pub enum BinaryOp {
    Eq,
    Ne,
    Lt,
    Le,
    Gt,
    Ge,
    Add,
    Sub,
    Mul,
}

/// A typed expression.
#[derive(Clone, PartialEq, Debug)]
pub enum Expr {
    /// A constant.
    Const(Value),
    /// A scenario variable.
    Variable(usize),
    /// The object bound to a dynamic role.
    Role(usize),
    /// The sender of the event (in effects).
    Sender,
    /// The receiver of the event (in effects).
    Receiver,
    /// An argument of the event (in effects).
    Parameter(usize),
    /// An attribute, by position, of the object that the expression gives.
    Attribute(Box<Expr>, usize, Span),
    /// `!a`.
    Not(Box<Expr>),
    /// `-a`.
    Neg(Box<Expr>, Span),
    /// `a && b`.
    And(Box<Expr>, Box<Expr>),
    /// `a || b`.
    Or(Box<Expr>, Box<Expr>),
    /// All others.
    Binary(BinaryOp, Box<Expr>, Box<Expr>, Span),
}

/// Why an expression has no value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Failure {
    /// It reads a variable or role that is not set.
    Unset,
    /// It follows a path through `null`.
    Null(Span),
    /// 64-bit overflow.
    Overflow(Span),
}

/// When a value was seen: an event's patterns see the state before its effects, what settles sees the one after.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Moment {
    /// Before the event's effects.
    Before,
    /// After them.
    After,
}

/// A record of the attributes that were looked at, in the order of first sight, without those that no effect can
/// change. A result depends on nothing else of the valuation, and what is looked at next depends only on the values
/// seen so far.
#[derive(Clone, Default, Debug)]
pub struct Reads(RefCell<Vec<(SlotId, Moment)>>);

impl Reads {
    /// Whether nothing was looked at.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.borrow().is_empty()
    }

    /// What was looked at.
    #[must_use]
    pub fn into_list(self) -> Vec<(SlotId, Moment)> {
        self.0.into_inner()
    }

    fn note(&self, slot: SlotId, moment: Moment) {
        let mut reads = self.0.borrow_mut();
        if !reads.contains(&(slot, moment)) {
            reads.push((slot, moment));
        }
    }
}

/// The values of all attributes at one moment.
#[derive(Clone, Copy, Debug)]
pub struct Snapshot<'a> {
    /// By slot.
    pub values: &'a [Value],
    /// Which moment this is.
    pub moment: Moment,
    /// Where reading is recorded.
    pub reads: &'a Reads,
}

impl Snapshot<'_> {
    /// The value in a slot.
    #[must_use]
    pub fn read(&self, domain: &Domain, slot: SlotId) -> Value {
        if domain.mutable[slot] {
            self.reads.note(slot, self.moment);
        }
        self.values[slot]
    }
}

/// What an expression can read.
#[derive(Clone, Copy, Debug)]
pub struct Scope<'a> {
    /// For immutable attributes and slot positions.
    pub domain: &'a Domain,
    /// The attributes' values.
    pub attributes: Snapshot<'a>,
    /// Role bindings of the copy; [`UNSET`] where unbound.
    pub roles: &'a [Value],
    /// Variables of the copy; [`UNSET`] where unset.
    pub variables: &'a [Value],
    /// Sender, receiver and arguments of the event, in effects.
    pub event: (Value, Value, &'a [Value]),
}

impl Scope<'_> {
    /// The expression's value.
    ///
    /// # Errors
    /// See [`Failure`].
    pub fn eval(&self, expr: &Expr) -> Result<Value, Failure> {
        let set = |value: Value| if value == UNSET { Err(Failure::Unset) } else { Ok(value) };
        Ok(match expr {
            Expr::Const(value) => *value,
            Expr::Variable(v) => set(self.variables[*v])?,
            Expr::Role(r) => set(self.roles[*r])?,
            Expr::Sender => self.event.0,
            Expr::Receiver => self.event.1,
            Expr::Parameter(p) => self.event.2[*p],
            Expr::Attribute(owner, attribute, span) => {
                let owner = self.eval(owner)?;
                if owner == NULL {
                    return Err(Failure::Null(*span));
                }
                let slot = self.domain.slot(owner as usize, *attribute);
                self.attributes.read(self.domain, slot)
            }
            Expr::Not(a) => i64::from(self.eval(a)? == 0),
            Expr::Neg(a, span) => {
                let negated = self.eval(a)?.checked_neg();
                negated.filter(|v| *v != UNSET).ok_or(Failure::Overflow(*span))?
            }
            Expr::And(a, b) => i64::from(self.eval(a)? != 0 && self.eval(b)? != 0),
            Expr::Or(a, b) => i64::from(self.eval(a)? != 0 || self.eval(b)? != 0),
            Expr::Binary(op, a, b, span) => {
                let (a, b) = (self.eval(a)?, self.eval(b)?);
                let number = |n: Option<Value>| n.filter(|v| *v != UNSET).ok_or(Failure::Overflow(*span));
                match op {
                    BinaryOp::Eq => i64::from(a == b),
                    BinaryOp::Ne => i64::from(a != b),
                    BinaryOp::Lt => i64::from(a < b),
                    BinaryOp::Le => i64::from(a <= b),
                    BinaryOp::Gt => i64::from(a > b),
                    BinaryOp::Ge => i64::from(a >= b),
                    BinaryOp::Add => number(a.checked_add(b))?,
                    BinaryOp::Sub => number(a.checked_sub(b))?,
                    BinaryOp::Mul => number(a.checked_mul(b))?,
                }
            }
        })
    }
}

impl Expr {
    /// Calls `visit` for this expression and every part of it.
    pub fn walk(&self, visit: &mut dyn FnMut(&Expr)) {
        visit(self);
        match self {
            Expr::Attribute(a, ..) | Expr::Not(a) | Expr::Neg(a, _) => a.walk(visit),
            Expr::And(a, b) | Expr::Or(a, b) | Expr::Binary(_, a, b, _) => {
                a.walk(visit);
                b.walk(visit);
            }
            _ => {}
        }
    }

    /// The value of an expression that reads nothing: literals and operators on them.
    #[must_use]
    pub fn constant(&self) -> Option<Value> {
        let mut reads = false;
        self.walk(&mut |part| {
            reads |= !matches!(
                part,
                Expr::Const(_)
                    | Expr::Not(_)
                    | Expr::Neg(..)
                    | Expr::And(..)
                    | Expr::Or(..)
                    | Expr::Binary(..)
            );
        });
        let scope = Scope {
            domain: &Domain::default(),
            attributes: Snapshot { values: &[], moment: Moment::Before, reads: &Reads::default() },
            roles: &[],
            variables: &[],
            event: (NULL, NULL, &[]),
        };
        if reads { None } else { scope.eval(self).ok() }
    }
}

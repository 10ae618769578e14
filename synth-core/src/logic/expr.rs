//! Expressions in which only variables are negated, as contacts of a ladder are.

/// A variable by its number.
pub type Var = u32;

/// A variable or its negation.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Literal {
    /// The variable.
    pub variable: Var,
    /// Its negation is meant.
    pub negated: bool,
}

/// An expression of literals.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Expr {
    /// A constant.
    Constant(bool),
    /// A contact.
    Literal(Literal),
    /// In series; two or more, none of which is a constant or an `And`.
    And(Vec<Expr>),
    /// In parallel; two or more, none of which is a constant or an `Or`.
    Or(Vec<Expr>),
}

impl Expr {
    /// Its value where `holds` says which variables are true.
    pub fn eval(&self, holds: &impl Fn(Var) -> bool) -> bool {
        match self {
            Expr::Constant(value) => *value,
            Expr::Literal(literal) => holds(literal.variable) != literal.negated,
            Expr::And(all) => all.iter().all(|part| part.eval(holds)),
            Expr::Or(any) => any.iter().any(|part| part.eval(holds)),
        }
    }

    /// How many literals are written.
    #[must_use]
    pub fn literals(&self) -> usize {
        match self {
            Expr::Constant(_) => 0,
            Expr::Literal(_) => 1,
            Expr::And(parts) | Expr::Or(parts) => parts.iter().map(Expr::literals).sum(),
        }
    }
}

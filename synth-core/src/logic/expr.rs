//! Expressions in which only variables are negated, as contacts of a ladder are.

use super::{Bdd, Function, TooLarge};

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
    /// A variable or its negation.
    #[must_use]
    pub fn literal(variable: Var, value: bool) -> Expr {
        Expr::Literal(Literal { variable, negated: !value })
    }

    /// The conjunction of `parts`, however many they are, with conjunctions among them opened and constants gone.
    #[must_use]
    pub fn all(parts: Vec<Expr>) -> Expr {
        let mut flat = Vec::with_capacity(parts.len());
        for part in parts {
            match part {
                Expr::Constant(true) => {}
                Expr::Constant(false) => return part,
                Expr::And(inner) => flat.extend(inner),
                Expr::Literal(_) | Expr::Or(_) => flat.push(part),
            }
        }
        match flat.len() {
            0 => Expr::Constant(true),
            1 => flat.remove(0),
            _ => Expr::And(flat),
        }
    }

    /// The disjunction of `parts`, however many they are, with disjunctions among them opened and constants gone.
    #[must_use]
    pub fn any(parts: Vec<Expr>) -> Expr {
        let mut flat = Vec::with_capacity(parts.len());
        for part in parts {
            match part {
                Expr::Constant(false) => {}
                Expr::Constant(true) => return part,
                Expr::Or(inner) => flat.extend(inner),
                Expr::Literal(_) | Expr::And(_) => flat.push(part),
            }
        }
        match flat.len() {
            0 => Expr::Constant(false),
            1 => flat.remove(0),
            _ => Expr::Or(flat),
        }
    }

    /// Its negation: series becomes parallel and literals are negated.
    #[must_use]
    pub fn negated(&self) -> Expr {
        match self {
            Expr::Constant(value) => Expr::Constant(!value),
            Expr::Literal(literal) => Expr::Literal(Literal { negated: !literal.negated, ..*literal }),
            Expr::And(parts) => Expr::Or(parts.iter().map(Expr::negated).collect()),
            Expr::Or(parts) => Expr::And(parts.iter().map(Expr::negated).collect()),
        }
    }

    /// The same with other variables: `rename` says which stands for which.
    #[must_use]
    pub fn renamed(&self, rename: &impl Fn(Var) -> Var) -> Expr {
        let all = |parts: &[Expr]| parts.iter().map(|part| part.renamed(rename)).collect();
        match self {
            Expr::Constant(value) => Expr::Constant(*value),
            Expr::Literal(literal) => {
                Expr::Literal(Literal { variable: rename(literal.variable), ..*literal })
            }
            Expr::And(parts) => Expr::And(all(parts)),
            Expr::Or(parts) => Expr::Or(all(parts)),
        }
    }

    /// The same with the operands in the order in which one reads them: literals by variable, then what is compound, short
    /// before long.
    #[must_use]
    pub fn in_order(&self) -> Expr {
        let sorted = |parts: &[Expr]| {
            let mut parts: Vec<Expr> = parts.iter().map(Expr::in_order).collect();
            parts.sort_by_cached_key(|part| (part.literals(), part.clone()));
            parts
        };
        match self {
            Expr::Constant(_) | Expr::Literal(_) => self.clone(),
            Expr::And(parts) => Expr::And(sorted(parts)),
            Expr::Or(parts) => Expr::Or(sorted(parts)),
        }
    }

    /// As a function.
    pub fn function(&self, bdd: &mut Bdd) -> Result<Function, TooLarge> {
        match self {
            Expr::Constant(value) => Ok(Function::from(*value)),
            Expr::Literal(literal) => bdd.literal(literal.variable, !literal.negated),
            Expr::And(parts) => parts.iter().try_fold(Function::TRUE, |product, part| {
                let part = part.function(bdd)?;
                bdd.and(product, part)
            }),
            Expr::Or(parts) => parts.iter().try_fold(Function::FALSE, |sum, part| {
                let part = part.function(bdd)?;
                bdd.or(sum, part)
            }),
        }
    }

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

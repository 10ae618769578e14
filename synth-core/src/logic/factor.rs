//! Expressions with few instructions.
//!
//! Three ways, of which the best result is taken: [`divide`] factors disjunctions algebraically, also that of the negation;
//! [`split`] decomposes the function itself into two that share few variables, with don't-cares; [`rewrite`] goes over an
//! expression and looks for something smaller in place of every part, with all the freedom that the parts around it leave.
//! The last includes the factoring into a precondition and an enabling condition that matters only where the former holds.

mod divide;
mod rewrite;
mod split;

use super::instructions::{count, depth};
use super::{Bdd, Cover, Expr, Function, TooLarge, heuristic};

/// The stack that the smallest controllers have.
const STACK: usize = 3;

/// What makes an expression worse than another, in this order: a stack of more than three, instructions, depth of the stack,
/// literals.
pub(super) fn cost(expr: &Expr) -> (bool, usize, usize, usize) {
    let depth = depth(expr);
    (depth > STACK, count(expr), depth, expr.literals())
}

/// An expression with few instructions that holds where `lower` does and nowhere where `upper` does not.
///
/// `cover` is a disjunction that does, if there is one of reasonable size; `preconditions` are functions that `lower` implies,
/// which are tried as a factor. Not proven to be the smallest.
///
/// # Errors
/// If decision diagrams get too large.
pub fn factor(
    bdd: &mut Bdd,
    lower: Function,
    upper: Function,
    cover: Option<&Cover>,
    preconditions: &[Expr],
) -> Result<Expr, TooLarge> {
    let mut starts = vec![split::split(bdd, lower, upper)?];
    if let Some(cover) = cover {
        starts.push(divide::factor(cover));
    }
    if let Ok(negation) = heuristic::minimize(bdd, !upper, !lower) {
        starts.push(divide::factor(&negation).negated());
    }
    for precondition in preconditions {
        let f = precondition.function(bdd)?;
        let free = bdd.or(upper, !f)?;
        let enabling = split::split(bdd, lower, free)?;
        starts.push(Expr::all(vec![precondition.clone(), enabling]));
    }
    starts.sort_by_cached_key(cost);
    starts.dedup();
    let mut best: Option<Expr> = None;
    for start in starts {
        let expr = rewrite::rewrite(bdd, start, lower, upper)?;
        if best.as_ref().is_none_or(|best| cost(&expr) < cost(best)) {
            best = Some(expr);
        }
    }
    Ok(best.unwrap_or(Expr::Constant(false)).in_order())
}

#[cfg(test)]
mod tests;

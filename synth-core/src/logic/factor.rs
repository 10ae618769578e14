//! Expressions with few instructions.
//!
//! What falls into [`parts`] without a common variable is factored part by part. Then three ways, of which the best result is
//! taken: [`divide`] factors disjunctions algebraically, also that of the negation;
//! [`split`] decomposes the function itself into two that share few variables, with don't-cares; [`rewrite`] goes over an
//! expression and looks for something smaller in place of every part, with all the freedom that the parts around it leave.
//! The last includes the factoring into a precondition and an enabling condition that matters only where the former holds.

mod divide;
mod parts;
mod rewrite;
mod split;

use super::instructions::{count, depth};
use super::{Bdd, Expr, Function, TooLarge, minimize};

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
/// `preconditions` are functions that `lower` implies, which are tried as a factor. Not proven to be the smallest.
///
/// # Errors
/// If decision diagrams get too large.
pub fn factor(
    bdd: &mut Bdd,
    lower: Function,
    upper: Function,
    preconditions: &[Function],
) -> Result<Expr, TooLarge> {
    if lower == upper {
        for and in [true, false] {
            let parts = parts::parts(bdd, lower, and)?;
            if parts.len() > 1 {
                let parts = parts.into_iter().map(|part| one(bdd, part, part, preconditions));
                let parts = parts.collect::<Result<Vec<Expr>, TooLarge>>()?;
                return Ok(if and { Expr::all(parts) } else { Expr::any(parts) }.in_order());
            }
        }
    }
    Ok(one(bdd, lower, upper, preconditions)?.in_order())
}

/// A function as a whole.
fn one(
    bdd: &mut Bdd,
    lower: Function,
    upper: Function,
    preconditions: &[Function],
) -> Result<Expr, TooLarge> {
    let mut starts = Vec::new();
    for negated in [false, true] {
        let bounds = if negated { (!upper, !lower) } else { (lower, upper) };
        // What has too many terms is not worth starting from.
        if let Ok(minimal) = minimize(bdd, bounds.0, bounds.1) {
            let expr = divide::factor(&minimal.cover);
            starts.push(if negated { expr.negated() } else { expr });
        }
    }
    let mut splitter = split::Splitter::new(bdd);
    let plain = splitter.split(lower, upper)?;
    for &precondition in preconditions {
        if splitter.bdd.implies(lower, precondition)? {
            let free = splitter.bdd.or(upper, !precondition)?;
            let own = splitter.split(precondition, precondition)?;
            let enabling = splitter.split(lower, free)?;
            starts.push(Expr::all(vec![own, enabling]));
        }
    }
    // What is worse would be replaced by this as a whole.
    starts.retain(|start| cost(start) <= cost(&plain));
    starts.push(plain);
    starts.sort_by_cached_key(cost);
    starts.dedup();
    let mut best: Option<Expr> = None;
    for start in starts {
        let expr = rewrite::rewrite(&mut splitter, start, lower, upper)?;
        if best.as_ref().is_none_or(|best| cost(&expr) < cost(best)) {
            best = Some(expr);
        }
    }
    Ok(best.unwrap_or(Expr::Constant(false)))
}

#[cfg(test)]
mod tests;

//! Going over an expression: whatever is smaller and does the same in its place is put there.
//!
//! A part of a conjunction matters only where the other parts hold, one of a disjunction only where none of them does: what
//! is left between the two bounds of a part is free (the permissible functions of Muroga, Kambayashi, Lai and Culliney, "The
//! transduction method", 1989, for a tree). So are sets of parts of one operator.

use super::super::{Bdd, Expr, Function, TooLarge};
use super::cost;
use super::split::Splitter;

/// Passes over the whole expression.
const PASSES: usize = 6;
/// Operators with more parts than this are not tried in pairs.
const PAIRS: usize = 8;

/// `expr`, which lies between the bounds, or something smaller that does.
pub(super) fn rewrite(
    splitter: &mut Splitter<'_>,
    mut expr: Expr,
    lower: Function,
    upper: Function,
) -> Result<Expr, TooLarge> {
    for _ in 0..PASSES {
        let before = cost(&expr);
        expr = smaller(splitter, expr, lower, upper)?;
        if cost(&expr) >= before {
            break;
        }
    }
    Ok(expr)
}

/// One pass, from the root to the leaves.
fn smaller(
    splitter: &mut Splitter<'_>,
    expr: Expr,
    lower: Function,
    upper: Function,
) -> Result<Expr, TooLarge> {
    if splitter.is_late() {
        return Ok(expr);
    }
    let expr = replaced(splitter, expr, lower, upper)?;
    let (and, mut parts) = match expr {
        Expr::And(parts) => (true, parts),
        Expr::Or(parts) => (false, parts),
        Expr::Constant(_) | Expr::Literal(_) => return Ok(expr),
    };
    let mut position = 0;
    while position < parts.len() {
        let (low, high) = bounds(splitter.bdd, &parts, &[position], and, lower, upper)?;
        let part = smaller(splitter, parts[position].clone(), low, high)?;
        match part {
            Expr::Constant(value) if value == and => {
                parts.remove(position);
                continue;
            }
            part => parts[position] = part,
        }
        position += 1;
    }
    if parts.len() > 2 && parts.len() <= PAIRS {
        pairs(splitter, &mut parts, and, lower, upper)?;
    }
    Ok(if and { Expr::all(parts) } else { Expr::any(parts) })
}

/// Two parts at a time, as one.
fn pairs(
    splitter: &mut Splitter<'_>,
    parts: &mut Vec<Expr>,
    and: bool,
    lower: Function,
    upper: Function,
) -> Result<(), TooLarge> {
    let join = |parts: Vec<Expr>| if and { Expr::all(parts) } else { Expr::any(parts) };
    for first in 0..parts.len() {
        for second in first + 1..parts.len() {
            if second >= parts.len() || splitter.is_late() {
                break;
            }
            let (low, high) = bounds(splitter.bdd, parts, &[first, second], and, lower, upper)?;
            let pair = splitter.split(low, high)?;
            let mut others = parts.clone();
            others.remove(second);
            others[first] = pair;
            if cost(&join(others.clone())) < cost(&join(parts.clone())) {
                *parts = others;
            }
        }
    }
    Ok(())
}

fn replaced(
    splitter: &mut Splitter<'_>,
    expr: Expr,
    lower: Function,
    upper: Function,
) -> Result<Expr, TooLarge> {
    let other = splitter.split(lower, upper)?;
    Ok(if cost(&other) < cost(&expr) { other } else { expr })
}

/// Between what the parts at `positions` may lie together.
fn bounds(
    bdd: &mut Bdd,
    parts: &[Expr],
    positions: &[usize],
    and: bool,
    lower: Function,
    upper: Function,
) -> Result<(Function, Function), TooLarge> {
    let mut others = Function::from(and);
    for (_, part) in parts.iter().enumerate().filter(|(position, _)| !positions.contains(position)) {
        let part = part.function(bdd)?;
        others = if and { bdd.and(others, part)? } else { bdd.or(others, part)? };
    }
    Ok(if and { (lower, bdd.or(upper, !others)?) } else { (bdd.without(lower, others)?, upper) })
}

//! Computing once what several conditions have in common.
//!
//! Parts that two operators have in common become a relay of their own, as long as that takes fewer instructions. A relay is
//! written right above the rung that reads it first and holds until a coil changes what it was computed from: rungs below that
//! coil compute it themselves.

use super::Assembly;
use crate::logic::{Expr, Function, TooLarge, Var, count};
use crate::plant::{Coil, Drive, Rung};
use std::collections::BTreeSet;

/// Beyond so many operators, not all pairs are looked at.
const OPERATORS: usize = 600;

/// Operands of a conjunction, or of a disjunction, in order.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
struct Common {
    and: bool,
    parts: Vec<Expr>,
}

impl Common {
    fn expr(&self) -> Expr {
        if self.and { Expr::all(self.parts.clone()) } else { Expr::any(self.parts.clone()) }
    }

    fn negated(&self) -> Common {
        let mut parts: Vec<Expr> = self.parts.iter().map(|part| part.negated().in_order()).collect();
        parts.sort_unstable();
        Common { and: !self.and, parts }
    }
}

/// Where it pays to have a relay.
struct Window {
    saved: usize,
    /// The first rung that reads it, and the one after the last.
    first: usize,
    end: usize,
}

impl Assembly<'_, '_> {
    /// Introduces relays; `false` if the conditions are no longer what they were.
    pub(super) fn share(&mut self) -> Result<bool, TooLarge> {
        let unshared: Vec<Expr> = self.program.rungs.iter().map(|rung| rung.condition.clone()).collect();
        let kept = self.program.variables.len();
        while let Some((common, window)) = self.best() {
            let relay = self.scratch("shared");
            for rung in &mut self.program.rungs[window.first..window.end] {
                rung.condition = replaced(&rung.condition, &common, relay);
            }
            let definition = Rung {
                event: None,
                comment: vec!["what conditions below have in common".to_owned()],
                condition: common.expr().in_order(),
                coils: vec![Coil { variable: relay, drive: Drive::Out }],
            };
            self.program.rungs.insert(window.first, definition);
        }
        self.check_shared(&unshared, kept)
    }

    fn best(&self) -> Option<(Common, Window)> {
        let mut operators = Vec::new();
        for rung in &self.program.rungs {
            collect(&rung.condition, &mut operators);
        }
        operators.truncate(OPERATORS);
        let mut candidates = BTreeSet::new();
        for (position, a) in operators.iter().enumerate() {
            for b in &operators[position + 1..] {
                for b in [b.clone(), b.negated()] {
                    let parts: Vec<Expr> =
                        a.parts.iter().filter(|part| b.parts.binary_search(part).is_ok()).cloned().collect();
                    if a.and == b.and && parts.len() > 1 {
                        candidates.insert(Common { and: a.and, parts });
                    }
                }
            }
        }
        let mut best: Option<(Common, Window)> = None;
        for common in candidates {
            for window in self.windows(&common) {
                if best.as_ref().is_none_or(|(_, best)| window.saved > best.saved) {
                    best = Some((common.clone(), window));
                }
            }
        }
        best
    }

    /// Runs of rungs in which a relay saves instructions.
    fn windows(&self, common: &Common) -> Vec<Window> {
        let mut variables = BTreeSet::new();
        mentioned(&common.expr(), &mut variables);
        let definition = count(&common.expr()) + 1;
        let mut windows = Vec::new();
        let (mut first, mut saved) = (None, 0);
        for (position, rung) in self.program.rungs.iter().enumerate() {
            // The number does not matter here, only that it is a literal.
            let with_relay = count(&replaced(&rung.condition, common, Var::MAX));
            let less = count(&rung.condition).saturating_sub(with_relay);
            if less > 0 {
                first = first.or(Some(position));
                saved += less;
            }
            let last = position + 1 == self.program.rungs.len();
            if last || rung.coils.iter().any(|coil| variables.contains(&coil.variable)) {
                if let Some(first) = first.take()
                    && saved > definition
                {
                    windows.push(Window { saved: saved - definition, first, end: position + 1 });
                }
                saved = 0;
            }
        }
        windows
    }

    /// Runs the program on functions: what reads relays is what it was before there were any.
    fn check_shared(&mut self, unshared: &[Expr], kept: usize) -> Result<bool, TooLarge> {
        let mut unshared = unshared.iter();
        let mut values = self.anything()?;
        for position in 0..self.program.rungs.len() {
            let rung = self.program.rungs[position].clone();
            let list = crate::logic::instructions(&rung.condition);
            let mut scratch = values.clone();
            let Some(found) = crate::logic::run(&mut self.bounds.bdd, &list, &mut scratch)? else {
                return Ok(false);
            };
            let defines =
                rung.coils.iter().map(|coil| coil.variable).find(|&variable| variable as usize >= kept);
            if let Some(relay) = defines {
                values[relay as usize] = found;
                continue;
            }
            let Some(expected) = unshared.next() else { return Ok(false) };
            if self.function(expected)? != found {
                return Ok(false);
            }
            self.forget(&rung, kept, &mut values)?;
        }
        Ok(unshared.next().is_none())
    }

    /// What relays were computed from has changed: they can be anything.
    fn forget(&mut self, rung: &Rung, kept: usize, values: &mut [Function]) -> Result<(), TooLarge> {
        for coil in &rung.coils {
            let changed = self.function(&Expr::literal(coil.variable, true))?;
            let changed = self.bounds.bdd.top(changed);
            for (relay, value) in values.iter_mut().enumerate().skip(kept) {
                let support = self.bounds.bdd.support(&[*value]);
                if changed.is_some_and(|changed| support.contains(&changed)) {
                    *value = self.function(&Expr::literal(relay as Var, true))?;
                }
            }
        }
        Ok(())
    }
}

/// All operators of an expression.
fn collect(expr: &Expr, operators: &mut Vec<Common>) {
    if let Expr::And(parts) | Expr::Or(parts) = expr {
        let mut sorted = parts.clone();
        sorted.sort_unstable();
        operators.push(Common { and: matches!(expr, Expr::And(_)), parts: sorted });
        parts.iter().for_each(|part| collect(part, operators));
    }
}

fn mentioned(expr: &Expr, variables: &mut BTreeSet<Var>) {
    match expr {
        Expr::Constant(_) => {}
        Expr::Literal(literal) => {
            variables.insert(literal.variable);
        }
        Expr::And(parts) | Expr::Or(parts) => parts.iter().for_each(|part| mentioned(part, variables)),
    }
}

/// With a relay in place of what it computes, or its negation in place of the negation, wherever that takes less.
fn replaced(expr: &Expr, common: &Common, relay: Var) -> Expr {
    let (and, parts) = match expr {
        Expr::Constant(_) | Expr::Literal(_) => return expr.clone(),
        Expr::And(parts) => (true, parts),
        Expr::Or(parts) => (false, parts),
    };
    let mut parts: Vec<Expr> = parts.clone();
    for (wanted, value) in [(common, true), (&common.negated(), false)] {
        if wanted.and == and && wanted.parts.iter().all(|part| parts.contains(part)) {
            parts.retain(|part| wanted.parts.binary_search(part).is_err());
            parts.push(Expr::literal(relay, value));
        }
    }
    let parts = parts.iter().map(|part| replaced(part, common, relay)).collect();
    if and { Expr::all(parts).in_order() } else { Expr::any(parts).in_order() }
}

//! Decomposition of a function, with don't-cares, into two that are joined by a conjunction or disjunction.
//!
//! Bi-decomposition (Mishchenko, Steinbach and Perkowski, "An algorithm for bi-decomposition of logic functions", DAC 2001).
//! `f = g || h` with variables `A` that only `g` depends on and `B` that only `h` depends on is possible if nowhere in `f`
//! both changing `A` and changing `B` can leave it. `g` then takes what changing `B` can leave, and whatever `g` covers is
//! free for `h`. Conjunctions are disjunctions of the negation. Where no split is possible, `h` lacks one variable and `g`
//! takes what is left ("weak"), which makes `g` hold more seldom and `h` smaller.

use super::super::{Bdd, Expr, Function, TooLarge, Var, heuristic};
use super::{cost, divide};
use hashbrown::HashMap;
use rustc_hash::FxBuildHasher;

/// Where `work` is left, several ways are followed to their ends, else only the one that seems best.
const WORK: usize = 300;
/// How many ways.
const WIDTH: usize = 3;
/// How many groupings of variables are looked for.
const SEEDS: usize = 40;
/// After so many visits of nodes, what is left is factored algebraically: about a second without optimisation.
const VISITS: u64 = 200_000;

/// All functions that hold where `lower` does and nowhere where `upper` does not.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
struct Interval {
    lower: Function,
    upper: Function,
}

impl Interval {
    fn negated(self) -> Interval {
        Interval { lower: !self.upper, upper: !self.lower }
    }
}

/// Remembers what it has split.
pub(super) struct Splitter<'a> {
    pub(super) bdd: &'a mut Bdd,
    memo: HashMap<Interval, Expr, FxBuildHasher>,
    work: usize,
    /// What the diagrams may have done in the end.
    deadline: u64,
}

/// A way to take a function apart.
#[derive(Clone, Debug)]
struct Way {
    /// Joined by a conjunction, else by a disjunction.
    and: bool,
    /// Variables that only the first part depends on.
    first: Vec<Var>,
    /// Variables that only the second part depends on.
    second: Vec<Var>,
}

impl<'a> Splitter<'a> {
    pub(super) fn new(bdd: &'a mut Bdd) -> Self {
        let deadline = bdd.work() + VISITS;
        Splitter { bdd, memo: HashMap::default(), work: 0, deadline }
    }

    /// Only what is quick is still done.
    pub(super) fn is_late(&self) -> bool {
        self.bdd.work() > self.deadline
    }

    /// An expression between the bounds.
    pub(super) fn split(&mut self, lower: Function, upper: Function) -> Result<Expr, TooLarge> {
        self.work = WORK;
        self.between(Interval { lower, upper })
    }

    fn between(&mut self, mut interval: Interval) -> Result<Expr, TooLarge> {
        if interval.lower == Function::FALSE {
            return Ok(Expr::Constant(false));
        }
        if interval.upper == Function::TRUE {
            return Ok(Expr::Constant(true));
        }
        if let Some(known) = self.memo.get(&interval) {
            return Ok(known.clone());
        }
        let asked = interval;
        let support = self.drop_variables(&mut interval)?;
        let expr = match self.literal(interval, &support)? {
            Some((variable, value, and)) => self.by_literal(interval, variable, value, and)?,
            None if self.is_late() => self.algebraic(interval, &support)?,
            None => self.by_ways(interval, &support)?,
        };
        self.memo.insert(asked, expr.clone());
        Ok(expr)
    }

    /// Narrows the bounds so that they depend on few variables, which are returned.
    fn drop_variables(&mut self, interval: &mut Interval) -> Result<Vec<Var>, TooLarge> {
        let support = self.bdd.support(&[interval.lower, interval.upper]);
        let mut left = Vec::with_capacity(support.len());
        for variable in support {
            let lower = self.bdd.exists(interval.lower, &[variable])?;
            let upper = self.bdd.forall(interval.upper, &[variable])?;
            if self.bdd.implies(lower, upper)? {
                *interval = Interval { lower, upper };
            } else {
                left.push(variable);
            }
        }
        Ok(left)
    }

    /// A literal that must hold, or that suffices; and which of the two.
    fn literal(
        &mut self,
        interval: Interval,
        support: &[Var],
    ) -> Result<Option<(Var, bool, bool)>, TooLarge> {
        for &variable in support {
            for value in [false, true] {
                let literal = self.bdd.literal(variable, value)?;
                if self.bdd.implies(interval.lower, literal)? {
                    return Ok(Some((variable, value, true)));
                }
                if self.bdd.implies(literal, interval.upper)? {
                    return Ok(Some((variable, value, false)));
                }
            }
        }
        Ok(None)
    }

    fn by_literal(
        &mut self,
        interval: Interval,
        variable: Var,
        value: bool,
        and: bool,
    ) -> Result<Expr, TooLarge> {
        let lower = self.bdd.cofactor(interval.lower, variable, value == and)?;
        let upper = self.bdd.cofactor(interval.upper, variable, value == and)?;
        let parts = vec![Expr::literal(variable, value), self.between(Interval { lower, upper })?];
        Ok(if and { Expr::all(parts) } else { Expr::any(parts) })
    }

    /// In terms of a disjunction that need not be the smallest.
    fn algebraic(&mut self, interval: Interval, support: &[Var]) -> Result<Expr, TooLarge> {
        match heuristic::minimize(self.bdd, interval.lower, interval.upper) {
            Ok(cover) => Ok(divide::factor(&cover)),
            Err(TooLarge::Nodes(limit)) => Err(TooLarge::Nodes(limit)),
            Err(_) => self.by_cases(interval, support),
        }
    }

    fn by_ways(&mut self, interval: Interval, support: &[Var]) -> Result<Expr, TooLarge> {
        let mut ways = self.strong(interval, support)?;
        if ways.is_empty() {
            ways = self.weak(interval, support)?;
        }
        if ways.is_empty() {
            return self.by_cases(interval, support);
        }
        let mut best: Option<Expr> = None;
        for way in ways.into_iter().take(WIDTH) {
            if best.is_some() && self.work == 0 {
                break;
            }
            self.work = self.work.saturating_sub(1);
            let expr = self.follow(interval, &way)?;
            if best.as_ref().is_none_or(|best| cost(&expr) < cost(best)) {
                best = Some(expr);
            }
        }
        Ok(best.unwrap_or(Expr::Constant(false)))
    }

    /// Computes the first part, then the second with the freedom that the first leaves.
    fn follow(&mut self, interval: Interval, way: &Way) -> Result<Expr, TooLarge> {
        let positive = if way.and { interval.negated() } else { interval };
        let bounds = self.first_part(positive, way)?;
        let first = self.between(if way.and { bounds.negated() } else { bounds })?;
        let covered = first.function(self.bdd)?;
        let open = self.bdd.without(positive.lower, if way.and { !covered } else { covered })?;
        let lower = self.bdd.exists(open, &way.first)?;
        let upper = self.bdd.forall(positive.upper, &way.first)?;
        let bounds = Interval { lower, upper };
        let second = self.between(if way.and { bounds.negated() } else { bounds })?;
        let parts = vec![first, second];
        Ok(if way.and { Expr::all(parts) } else { Expr::any(parts) })
    }

    /// The bounds of the first part of a disjunction: what the second cannot cover, and what does not depend on its variables.
    fn first_part(&mut self, interval: Interval, way: &Way) -> Result<Interval, TooLarge> {
        let leaves = self.bdd.exists(!interval.upper, &way.first)?;
        let needed = self.bdd.and(interval.lower, leaves)?;
        let lower = self.bdd.exists(needed, &way.second)?;
        let upper = self.bdd.forall(interval.upper, &way.second)?;
        Ok(Interval { lower, upper })
    }

    /// Ways with variables on both sides, those that share the fewest first. One that shares none is the only one.
    fn strong(&mut self, interval: Interval, support: &[Var]) -> Result<Vec<Way>, TooLarge> {
        let mut ways: Vec<(usize, usize, Way)> = Vec::new();
        let mut seeds = SEEDS;
        for and in [false, true] {
            let positive = if and { interval.negated() } else { interval };
            for (position, &x) in support.iter().enumerate() {
                for &y in &support[position + 1..] {
                    // Together in a way that is known: growing from here would find the same.
                    let known = ways.iter().any(|(_, _, way)| {
                        way.and == and
                            && (way.first.contains(&x) && way.second.contains(&y)
                                || way.first.contains(&y) && way.second.contains(&x))
                    });
                    if known || seeds == 0 {
                        continue;
                    }
                    let Some(way) = self.grow(positive, support, and, [x, y])? else { continue };
                    seeds -= 1;
                    let own = way.first.len() + way.second.len();
                    if own == support.len() {
                        return Ok(vec![way]);
                    }
                    ways.push((support.len() - own, way.first.len().abs_diff(way.second.len()), way));
                }
            }
        }
        ways.sort_by_key(|(shared, difference, _)| (*shared, *difference));
        Ok(ways.into_iter().map(|(_, _, way)| way).collect())
    }

    /// A disjunction whose parts depend alone on as many variables as possible, starting with one each.
    fn grow(
        &mut self,
        positive: Interval,
        support: &[Var],
        and: bool,
        [x, y]: [Var; 2],
    ) -> Result<Option<Way>, TooLarge> {
        let outside = !positive.upper;
        let mut without_first = self.bdd.exists(outside, &[x])?;
        let mut without_second = self.bdd.exists(outside, &[y])?;
        if !self.parts(positive.lower, without_first, without_second)? {
            return Ok(None);
        }
        let mut way = Way { and, first: vec![x], second: vec![y] };
        for &variable in support.iter().filter(|&&variable| variable != x && variable != y) {
            let more_first = self.bdd.exists(without_first, &[variable])?;
            if self.parts(positive.lower, more_first, without_second)? {
                without_first = more_first;
                way.first.push(variable);
                continue;
            }
            let more_second = self.bdd.exists(without_second, &[variable])?;
            if self.parts(positive.lower, without_first, more_second)? {
                without_second = more_second;
                way.second.push(variable);
            }
        }
        way.first.sort_unstable();
        way.second.sort_unstable();
        Ok(Some(way))
    }

    fn parts(&mut self, lower: Function, a: Function, b: Function) -> Result<bool, TooLarge> {
        let both = self.bdd.and(a, b)?;
        Ok(self.bdd.and(lower, both)? == Function::FALSE)
    }

    /// Ways in which the second part lacks a variable and takes something, those that leave the first part least first.
    fn weak(&mut self, interval: Interval, support: &[Var]) -> Result<Vec<Way>, TooLarge> {
        let mut ways = Vec::new();
        for and in [false, true] {
            let positive = if and { interval.negated() } else { interval };
            let all = self.bdd.density(positive.lower);
            for &variable in support {
                let way = Way { and, first: vec![variable], second: Vec::new() };
                let bounds = self.first_part(positive, &way)?;
                if bounds.lower != positive.lower {
                    ways.push((self.bdd.density(bounds.lower) / all, way));
                }
            }
        }
        ways.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        Ok(ways.into_iter().map(|(_, way)| way).collect())
    }

    /// One expression for each value of the variable for which the two are smallest.
    fn by_cases(&mut self, interval: Interval, support: &[Var]) -> Result<Expr, TooLarge> {
        let Some(&variable) = support.first() else { return Ok(Expr::Constant(false)) };
        let mut parts = Vec::with_capacity(2);
        for value in [false, true] {
            let lower = self.bdd.cofactor(interval.lower, variable, value)?;
            let upper = self.bdd.cofactor(interval.upper, variable, value)?;
            let part = self.between(Interval { lower, upper })?;
            parts.push(Expr::all(vec![Expr::literal(variable, value), part]));
        }
        Ok(Expr::any(parts))
    }
}

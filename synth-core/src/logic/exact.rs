//! Two-level minimisation: fewest terms, then fewest literals.
//!
//! All prime implicants are found on the decision diagram (Coudert and Madre, "Implicit and incremental computation of
//! primes and essential primes of Boolean functions", 1992). The assignments to be covered are not enumerated: those that
//! meet the same primes are one row of the covering problem.

use super::cover::{Mask, sort};
use super::covering::cover;
use super::{Bdd, Cover, Cube, Function, TooLarge, Var, heuristic};
use hashbrown::{HashMap, HashSet};
use rustc_hash::FxBuildHasher;
use std::rc::Rc;

/// A disjunction, and whether it is known to be a smallest.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Minimal {
    /// The terms, in order.
    pub cover: Cover,
    /// No disjunction has fewer terms, or as many and fewer literals. Not known beyond some size.
    pub proven: bool,
}

/// Beyond so many primes or rows the result of the heuristic is taken.
const PRIMES: usize = 2_000;
/// Work of the covering search, in comparisons of sets: a second without optimisation.
const BUDGET: u64 = 2_000_000;
/// A term weighs more than all literals that a cover could save.
const TERM: u64 = 1 << 24;

/// The smallest disjunction of terms that holds where `lower` does and nowhere where `upper` does not, if that can be
/// found out with a fixed amount of work, which mostly is so up to a dozen variables; else a small irredundant one of primes.
///
/// `lower` must imply `upper`.
///
/// # Errors
/// If even the heuristic needs too many variables, terms or nodes.
pub fn minimize(bdd: &mut Bdd, lower: Function, upper: Function) -> Result<Minimal, TooLarge> {
    let small = heuristic::minimize(bdd, lower, upper)?;
    let exact = Exact { frame: small.variables.clone(), primes: Vec::new() };
    exact.minimize(bdd, lower, upper, small)
}

struct Exact {
    frame: Vec<Var>,
    primes: Vec<Cube>,
}

impl Exact {
    fn minimize(
        mut self,
        bdd: &mut Bdd,
        lower: Function,
        upper: Function,
        small: Cover,
    ) -> Result<Minimal, TooLarge> {
        let Some(primes) = primes(bdd, upper, &self.frame)? else {
            return Ok(Minimal { cover: small, proven: false });
        };
        self.primes = primes;
        let Some(rows) = self.rows(bdd, lower) else {
            return Ok(Minimal { cover: small, proven: false });
        };
        let weight = |cube: &Cube| TERM + u64::from(cube.literals());
        let weights: Vec<u64> = self.primes.iter().map(weight).collect();
        let covered = cover(&rows, &weights, small.cubes.iter().map(weight).sum(), BUDGET);
        let cover = match covered.columns {
            None => small,
            Some(columns) => {
                let mut cubes: Vec<Cube> =
                    columns.iter().map(|&column| self.primes[column as usize]).collect();
                sort(&mut cubes);
                Cover { variables: small.variables, cubes }
            }
        };
        Ok(Minimal { cover, proven: covered.proven })
    }

    /// The sets of primes that assignments of `lower` meet; `None` if there are too many.
    fn rows(&self, bdd: &Bdd, lower: Function) -> Option<Vec<Vec<u32>>> {
        let mut rows = Rows { exact: self, bdd, rows: HashSet::default(), seen: HashSet::default() };
        rows.split(lower, 0, (0..self.primes.len() as u32).collect())?;
        let mut rows: Vec<Vec<u32>> = rows.rows.into_iter().collect();
        rows.sort_unstable();
        Some(rows)
    }
}

struct Rows<'a> {
    exact: &'a Exact,
    bdd: &'a Bdd,
    rows: HashSet<Vec<u32>, FxBuildHasher>,
    seen: HashSet<(Function, u32, Vec<u32>), FxBuildHasher>,
}

impl Rows<'_> {
    /// `alive` are the primes that hold as far as the variables before `position` tell.
    fn split(&mut self, f: Function, position: u32, alive: Vec<u32>) -> Option<()> {
        if f == Function::FALSE {
            return Some(());
        }
        let rest = Mask::MAX.checked_shl(position).unwrap_or(0);
        let mentioned =
            alive.iter().fold(0, |mask, &prime| mask | self.exact.primes[prime as usize].care) & rest;
        let tested = self.bdd.top(f).map_or(Mask::BITS, |variable| {
            self.exact.frame.partition_point(|&other| other < variable) as u32
        });
        let next = mentioned.trailing_zeros().min(tested);
        if next == Mask::BITS {
            self.rows.insert(alive);
            return (self.rows.len() <= PRIMES).then_some(());
        }
        if !self.seen.insert((f, next, alive.clone())) {
            return Some(());
        }
        if self.seen.len() > 16 * PRIMES {
            return None;
        }
        let (low, high) = self.bdd.branches(f, self.exact.frame[next as usize]);
        for (value, branch) in [(false, low), (true, high)] {
            let alive = alive.iter().copied().filter(|&prime| {
                let prime = self.exact.primes[prime as usize];
                prime.care >> next & 1 == 0 || (prime.value >> next & 1 == 1) == value
            });
            self.split(branch, next + 1, alive.collect())?;
        }
        Some(())
    }
}

/// All primes of `f` over the variables of `frame`, sorted; `None` if there are too many.
fn primes(bdd: &mut Bdd, f: Function, frame: &[Var]) -> Result<Option<Vec<Cube>>, TooLarge> {
    let found = Primes { frame, memo: HashMap::default(), work: 0 }.of(bdd, f)?;
    Ok(found.map(|cubes| cubes.to_vec()))
}

struct Primes<'a> {
    frame: &'a [Var],
    memo: HashMap<Function, Rc<[Cube]>, FxBuildHasher>,
    work: usize,
}

impl Primes<'_> {
    fn of(&mut self, bdd: &mut Bdd, f: Function) -> Result<Option<Rc<[Cube]>>, TooLarge> {
        if f == Function::FALSE {
            return Ok(Some(Rc::new([])));
        }
        let Some(variable) = bdd.top(f) else { return Ok(Some(Rc::new([Cube::ALL]))) };
        if let Some(known) = self.memo.get(&f) {
            return Ok(Some(known.clone()));
        }
        let (low, high) = bdd.branches(f, variable);
        let both = bdd.and(low, high)?;
        let Some(free) = self.of(bdd, both)? else { return Ok(None) };
        let Some(low) = self.of(bdd, low)? else { return Ok(None) };
        let Some(high) = self.of(bdd, high)? else { return Ok(None) };
        let position = self.frame.partition_point(|&other| other < variable) as u32;
        // A prime of one branch that holds in the other, too, does not need the variable.
        let bound = |cubes: &[Cube], value: bool| {
            let own = cubes.iter().filter(|cube| free.binary_search(cube).is_err());
            own.map(|cube| cube.with(position, value)).collect::<Vec<Cube>>()
        };
        let mut all = bound(&low, false);
        all.extend(bound(&high, true));
        all.extend(free.iter());
        all.sort_unstable();
        self.work += all.len();
        if all.len() > PRIMES || self.work > 32 * PRIMES {
            return Ok(None);
        }
        let all: Rc<[Cube]> = all.into();
        self.memo.insert(f, all.clone());
        Ok(Some(all))
    }
}

#[cfg(test)]
mod tests;

//! Two-level minimisation without a proof, for functions of many variables.
//!
//! An irredundant disjunction straight from the decision diagram (Minato, "Fast generation of prime-irredundant covers from
//! binary decision diagrams", 1993, after Morreale 1970), improved by the loop of espresso (Brayton, Hachtel, McMullen and
//! Sangiovanni-Vincentelli, "Logic minimization algorithms for VLSI synthesis", 1984): terms shrink as far as the others
//! allow, grow into other directions, and those that are no longer needed go.

use super::cover::{Mask, bits, sort, term};
use super::{Bdd, Cover, Cube, Function, TooLarge, Var};
use hashbrown::{HashMap, HashSet};
use rustc_hash::FxBuildHasher;
use std::cmp::Reverse;
use std::rc::Rc;

/// More terms than this are of no use to anybody.
const TERMS: usize = 20_000;
/// Rounds of the loop without gain end it; so does this many.
const ROUNDS: usize = 8;
/// With more terms, what came from the diagram is taken as it is: the loop takes quadratic time.
const LOOP_TERMS: usize = 1_000;

/// An irredundant disjunction of primes of `upper` that covers `lower`, in order. `lower` must imply `upper`.
pub(super) fn minimize(bdd: &mut Bdd, lower: Function, upper: Function) -> Result<Cover, TooLarge> {
    let frame = bdd.support(&[lower, upper]);
    if frame.len() > Cube::VARIABLES {
        return Err(TooLarge::Variables(frame.len()));
    }
    let (cubes, _) = Irredundant { frame: &frame, memo: HashMap::default() }.between(bdd, lower, upper)?;
    let mut cubes = cubes.to_vec();
    if cubes.len() <= LOOP_TERMS {
        Espresso { bdd, frame: &frame, lower, upper }.improve(&mut cubes)?;
    }
    sort(&mut cubes);
    Ok(Cover { variables: frame, cubes })
}

/// Terms and the function that they are.
type Terms = (Rc<[Cube]>, Function);

struct Irredundant<'a> {
    frame: &'a [Var],
    memo: HashMap<(Function, Function), Terms, FxBuildHasher>,
}

impl Irredundant<'_> {
    fn between(&mut self, bdd: &mut Bdd, lower: Function, upper: Function) -> Result<Terms, TooLarge> {
        if lower == Function::FALSE {
            return Ok((Rc::new([]), Function::FALSE));
        }
        if upper == Function::TRUE {
            return Ok((Rc::new([Cube::ALL]), Function::TRUE));
        }
        if let Some(known) = self.memo.get(&(lower, upper)) {
            return Ok(known.clone());
        }
        let variable = bdd.first(lower, upper);
        let (lower0, lower1) = bdd.branches(lower, variable);
        let (upper0, upper1) = bdd.branches(upper, variable);
        // What only one branch allows needs the literal.
        let needed0 = bdd.without(lower0, upper1)?;
        let (cubes0, covered0) = self.between(bdd, needed0, upper0)?;
        let needed1 = bdd.without(lower1, upper0)?;
        let (cubes1, covered1) = self.between(bdd, needed1, upper1)?;
        let left0 = bdd.without(lower0, covered0)?;
        let left1 = bdd.without(lower1, covered1)?;
        let left = bdd.or(left0, left1)?;
        let shared = bdd.and(upper0, upper1)?;
        let (cubes, covered) = self.between(bdd, left, shared)?;

        let position = self.frame.partition_point(|&other| other < variable) as u32;
        let mut all: Vec<Cube> = cubes0.iter().map(|cube| cube.with(position, false)).collect();
        all.extend(cubes1.iter().map(|cube| cube.with(position, true)));
        all.extend(cubes.iter());
        if all.len() > TERMS {
            return Err(TooLarge::Terms(TERMS));
        }
        let literal = bdd.variable(variable)?;
        let split = bdd.ite(literal, covered1, covered0)?;
        let result = (Rc::from(all), bdd.or(split, covered)?);
        self.memo.insert((lower, upper), result.clone());
        Ok(result)
    }
}

struct Espresso<'a> {
    bdd: &'a mut Bdd,
    frame: &'a [Var],
    lower: Function,
    upper: Function,
}

impl Espresso<'_> {
    fn improve(&mut self, cubes: &mut Vec<Cube>) -> Result<(), TooLarge> {
        self.expand(cubes)?;
        self.irredundant(cubes)?;
        for _ in 0..ROUNDS {
            let mut other = cubes.clone();
            self.reduce(&mut other)?;
            self.expand(&mut other)?;
            self.irredundant(&mut other)?;
            if cost(&other) >= cost(cubes) {
                break;
            }
            *cubes = other;
        }
        Ok(())
    }

    /// Every term becomes a prime; literals that keep it from swallowing many others go first.
    fn expand(&mut self, cubes: &mut Vec<Cube>) -> Result<(), TooLarge> {
        cubes.sort_unstable_by_key(|cube| (cube.literals(), *cube));
        cubes.dedup();
        let mut position = 0;
        while position < cubes.len() {
            let mut cube = cubes[position];
            let mut blocked = [0u32; Cube::VARIABLES];
            for &other in cubes.iter() {
                let conflicts = cube.conflicts(other);
                let distance = conflicts.count_ones().max(1);
                bits(conflicts | (cube.care & !other.care))
                    .for_each(|variable| blocked[variable as usize] += 8 / distance);
            }
            let mut order: Vec<u32> = bits(cube.care).collect();
            order.sort_by_key(|&variable| Reverse(blocked[variable as usize]));
            for variable in order {
                let wider = cube.without(1 << variable);
                if self.is_implicant(wider) {
                    cube = wider;
                }
            }
            let before = cubes[..position].iter().filter(|other| cube.covers(**other)).count();
            let mut index = 0;
            cubes.retain(|&other| {
                index += 1;
                index - 1 == position || !cube.covers(other)
            });
            position -= before;
            cubes[position] = cube;
            position += 1;
        }
        Ok(())
    }

    /// The term holds only where `upper` does.
    fn is_implicant(&self, cube: Cube) -> bool {
        let mut seen = HashSet::<Function, FxBuildHasher>::default();
        let mut open = vec![self.upper];
        while let Some(f) = open.pop() {
            if f == Function::FALSE {
                return false;
            }
            let Some(variable) = self.bdd.top(f) else { continue };
            if !seen.insert(f) {
                continue;
            }
            let position = self.frame.partition_point(|&other| other < variable) as u32;
            let (low, high) = self.bdd.branches(f, variable);
            let mask: Mask = 1 << position;
            if cube.care & mask == 0 || cube.value & mask == 0 {
                open.push(low);
            }
            if cube.care & mask == 0 || cube.value & mask != 0 {
                open.push(high);
            }
        }
        true
    }

    /// Terms go that hold nowhere alone, those with many literals first.
    fn irredundant(&mut self, cubes: &mut Vec<Cube>) -> Result<(), TooLarge> {
        cubes.sort_unstable_by_key(|cube| (Reverse(cube.literals()), *cube));
        let terms = self.terms(cubes)?;
        let after = self.sums_after(&terms)?;
        let mut before = Function::FALSE;
        let mut kept = Vec::with_capacity(cubes.len());
        for position in 0..cubes.len() {
            let others = self.bdd.or(before, after[position + 1])?;
            if !self.bdd.implies(self.lower, others)? {
                kept.push(cubes[position]);
                before = self.bdd.or(before, terms[position])?;
            }
        }
        *cubes = kept;
        Ok(())
    }

    /// Every term shrinks to what the others leave of `lower`.
    fn reduce(&mut self, cubes: &mut [Cube]) -> Result<(), TooLarge> {
        cubes.sort_unstable_by_key(|cube| (cube.literals(), *cube));
        let terms = self.terms(cubes)?;
        let after = self.sums_after(&terms)?;
        let mut before = Function::FALSE;
        for position in 0..cubes.len() {
            let others = self.bdd.or(before, after[position + 1])?;
            let wanted = self.bdd.and(self.lower, terms[position])?;
            let alone = self.bdd.without(wanted, others)?;
            cubes[position] = self.smallest(alone)?;
            let term = term(self.bdd, self.frame, cubes[position])?;
            before = self.bdd.or(before, term)?;
        }
        Ok(())
    }

    /// The smallest term that holds wherever `f` does, which is not false.
    fn smallest(&mut self, f: Function) -> Result<Cube, TooLarge> {
        let mut cube = Cube::ALL;
        for variable in self.bdd.support(&[f]) {
            let position = self.frame.partition_point(|&other| other < variable) as u32;
            for value in [false, true] {
                let literal = self.bdd.literal(variable, value)?;
                if self.bdd.implies(f, literal)? {
                    cube = cube.with(position, value);
                }
            }
        }
        Ok(cube)
    }

    fn terms(&mut self, cubes: &[Cube]) -> Result<Vec<Function>, TooLarge> {
        cubes.iter().map(|&cube| term(self.bdd, self.frame, cube)).collect()
    }

    /// The disjunction of the terms from each position on; one more for none.
    fn sums_after(&mut self, terms: &[Function]) -> Result<Vec<Function>, TooLarge> {
        let mut sums = vec![Function::FALSE; terms.len() + 1];
        for position in (0..terms.len()).rev() {
            sums[position] = self.bdd.or(terms[position], sums[position + 1])?;
        }
        Ok(sums)
    }
}

fn cost(cubes: &[Cube]) -> (usize, u32) {
    (cubes.len(), cubes.iter().map(|cube| cube.literals()).sum())
}

#[cfg(test)]
mod tests;

//! Algebraic factoring: the cover is treated as a polynomial.
//!
//! Good factoring by kernels (Brayton, "Factoring logic functions", 1987; Brayton and McMullen, "The decomposition and
//! factorization of Boolean expressions", 1982).

use super::super::cover::{Mask, bits};
use super::super::{Cover, Cube, Expr};
use super::cost;

/// Beyond so many terms only literals are tried as divisors.
const KERNEL_TERMS: usize = 60;

/// The cover, factored.
pub(super) fn factor(cover: &Cover) -> Expr {
    Division { cover }.factor(&cover.cubes)
}

struct Division<'a> {
    cover: &'a Cover,
}

/// Terms `all = divisor * quotient + rest`.
struct Divided {
    quotient: Vec<Cube>,
    rest: Vec<Cube>,
}

impl Division<'_> {
    fn term(&self, cube: Cube) -> Expr {
        Expr::all(self.cover.literals_of(cube).map(Expr::Literal).collect())
    }

    fn factor(&self, cubes: &[Cube]) -> Expr {
        if cubes.is_empty() {
            return Expr::Constant(false);
        }
        let common = common(cubes);
        let cubes = strip(cubes, common);
        if let [cube] = cubes[..] {
            return Expr::all(vec![self.term(common), self.term(cube)]);
        }
        let mut candidates = vec![self.by_literal(&cubes)];
        if cubes.len() <= KERNEL_TERMS {
            candidates.extend(self.by_kernel(&cubes));
        }
        let best = candidates.into_iter().min_by_key(cost).unwrap_or(Expr::Constant(false));
        Expr::all(vec![self.term(common), best])
    }

    /// By the literal in most terms.
    fn by_literal(&self, cubes: &[Cube]) -> Expr {
        match frequent(cubes, 2).first() {
            None => Expr::any(cubes.iter().map(|&cube| self.term(cube)).collect()),
            Some(&literal) => self.by(cubes, &[literal]),
        }
    }

    fn by_kernel(&self, cubes: &[Cube]) -> Option<Expr> {
        let mut kernels = Vec::new();
        kernels_of(cubes, 0, &mut kernels);
        let kernel =
            kernels.into_iter().filter(|kernel| kernel.len() < cubes.len()).max_by_key(|kernel| {
                let divided = divide(cubes, kernel);
                let literals: u32 = kernel.iter().map(|cube| cube.literals()).sum();
                let quotient: u32 = divided.quotient.iter().map(|cube| cube.literals()).sum();
                let (times, terms) = (divided.quotient.len() as u32, kernel.len() as u32);
                times.saturating_sub(1) * literals + terms.saturating_sub(1) * quotient
            })?;
        let divided = divide(cubes, &kernel);
        let quotient = strip(&divided.quotient, common(&divided.quotient));
        // The other factor is often better to start from: what it divides can be more than the kernel.
        Some(if quotient.len() > 1 { self.by(cubes, &quotient) } else { self.by(cubes, &kernel) })
    }

    fn by(&self, cubes: &[Cube], divisor: &[Cube]) -> Expr {
        let Divided { quotient, rest } = divide(cubes, divisor);
        if quotient.is_empty() {
            return Expr::any(cubes.iter().map(|&cube| self.term(cube)).collect());
        }
        let product = Expr::all(vec![self.factor(divisor), self.factor(&quotient)]);
        if rest.is_empty() { product } else { Expr::any(vec![product, self.factor(&rest)]) }
    }
}

/// The literals that all terms have.
fn common(cubes: &[Cube]) -> Cube {
    let Some(first) = cubes.first() else { return Cube::ALL };
    let care = cubes.iter().fold(first.care, |care, cube| care & cube.care & !(cube.value ^ first.value));
    Cube { care, value: first.value & care }
}

fn strip(cubes: &[Cube], common: Cube) -> Vec<Cube> {
    cubes.iter().map(|cube| cube.without(common.care)).collect()
}

/// Literals in so many terms at least, as terms, the most frequent first.
fn frequent(cubes: &[Cube], least: usize) -> Vec<Cube> {
    let all: Mask = cubes.iter().fold(0, |mask, cube| mask | cube.care);
    let mut literals: Vec<(usize, Cube)> = bits(all)
        .flat_map(|position| [Cube::ALL.with(position, false), Cube::ALL.with(position, true)])
        .map(|literal| (cubes.iter().filter(|cube| literal.covers(**cube)).count(), literal))
        .filter(|(count, _)| *count >= least)
        .collect();
    literals.sort_by_key(|(count, literal)| (usize::MAX - count, *literal));
    literals.into_iter().map(|(_, literal)| literal).collect()
}

/// Weak division: no variable is in both divisor and quotient.
fn divide(cubes: &[Cube], divisor: &[Cube]) -> Divided {
    let own: Mask = divisor.iter().fold(0, |mask, cube| mask | cube.care);
    let mut quotient: Option<Vec<Cube>> = None;
    for &part in divisor {
        let mut of_part: Vec<Cube> = cubes
            .iter()
            .filter(|cube| part.covers(**cube))
            .map(|cube| cube.without(part.care))
            .filter(|cube| cube.care & own == 0)
            .collect();
        of_part.sort_unstable();
        if let Some(so_far) = &quotient {
            of_part.retain(|cube| so_far.binary_search(cube).is_ok());
        }
        quotient = Some(of_part);
    }
    let quotient = quotient.unwrap_or_default();
    let product: Vec<Cube> = quotient
        .iter()
        .flat_map(|cube| {
            divisor.iter().map(|part| Cube { care: part.care | cube.care, value: part.value | cube.value })
        })
        .collect();
    let rest = cubes.iter().copied().filter(|cube| !product.contains(cube)).collect();
    Divided { quotient, rest }
}

/// All kernels of a cover without a common literal, itself included.
fn kernels_of(cubes: &[Cube], from: u32, kernels: &mut Vec<Vec<Cube>>) {
    let all: Mask = cubes.iter().fold(0, |mask, cube| mask | cube.care);
    for position in bits(all).filter(|&position| 2 * position + 1 >= from) {
        for value in [false, true] {
            let number = 2 * position + u32::from(value);
            let literal = Cube::ALL.with(position, value);
            let with: Vec<Cube> = cubes.iter().copied().filter(|cube| literal.covers(*cube)).collect();
            if number < from || with.len() < 2 {
                continue;
            }
            let common = common(&with);
            // A literal before this one is common, too: this kernel was found from there.
            if bits(common.care).any(|other| 2 * other + u32::from(common.value >> other & 1 == 1) < number) {
                continue;
            }
            kernels_of(&strip(&with, common), number + 1, kernels);
        }
    }
    let mut sorted = cubes.to_vec();
    sorted.sort_unstable();
    if !kernels.contains(&sorted) {
        kernels.push(sorted);
    }
}

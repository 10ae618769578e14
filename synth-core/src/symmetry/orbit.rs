//! How many states one stands for.

use super::interchangeable::Interchangeable;

/// The factors of a number too large to be written down.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(super) struct Factors(Vec<usize>);

impl Factors {
    /// Times a number, which is not 0.
    pub(super) fn multiply(&mut self, factor: usize) {
        self.0.push(factor);
    }

    /// Times the number of orders of so many things.
    pub(super) fn factorial(&mut self, things: usize) {
        self.0.extend(2..=things);
    }
}

/// The number of states that a state stands for: that of all permutations, divided by that of those that leave it as it is. `None` if
/// it does not fit, or is not known.
pub(super) fn orbit_size(interchangeable: &Interchangeable, stabiliser: &Factors) -> Option<u128> {
    let mut all = Factors::default();
    interchangeable.groups.iter().for_each(|group| all.factorial(group.len()));
    for &divisor in &stabiliser.0 {
        let mut divisor = divisor;
        for factor in &mut all.0 {
            let common = gcd(divisor, *factor);
            divisor /= common;
            *factor /= common;
        }
        // The order of a subgroup divides that of the group; otherwise two colours were the same by chance.
        if divisor != 1 {
            return None;
        }
    }
    all.0.iter().try_fold(1_u128, |product, &factor| product.checked_mul(factor as u128))
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}

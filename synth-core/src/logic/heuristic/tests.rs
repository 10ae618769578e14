use super::super::testing::function;
use super::minimize;
use crate::logic::{Bdd, Function, TooLarge};
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]
    #[test]
    fn lies_between_the_bounds_without_redundancy(lower: [u64; 2], free: [u64; 2]) {
        let mut bdd = Bdd::new();
        let low = function(&mut bdd, &lower, 7);
        let high = function(&mut bdd, &[lower[0] | free[0], lower[1] | free[1]], 7);
        let cover = minimize(&mut bdd, low, high).unwrap();
        let f = cover.function(&mut bdd).unwrap();
        prop_assert!(bdd.implies(low, f).unwrap() && bdd.implies(f, high).unwrap());
        for position in 0..cover.cubes.len() {
            let mut less = cover.clone();
            less.cubes.remove(position);
            let f = less.function(&mut bdd).unwrap();
            prop_assert!(!bdd.implies(low, f).unwrap());
        }
    }
}

/// The disjunction of conjunctions of neighbours.
fn chain(bdd: &mut Bdd, groups: u32, size: u32) -> Function {
    (0..groups).fold(Function::FALSE, |sum, group| {
        let term = (0..size).fold(Function::TRUE, |product, member| {
            let literal = bdd.literal(group * size + member, member % 2 == 0).unwrap();
            bdd.and(product, literal).unwrap()
        });
        bdd.or(sum, term).unwrap()
    })
}

#[test]
fn thirty_variables() {
    let mut bdd = Bdd::new();
    let f = chain(&mut bdd, 10, 3);
    let cover = minimize(&mut bdd, f, f).unwrap();
    assert_eq!((cover.cubes.len(), cover.literals()), (10, 30));
    assert_eq!(cover.function(&mut bdd).unwrap(), f);
}

#[test]
fn thirty_variables_with_freedom() {
    // Wherever the first conjunct of a group holds, its others may be ignored.
    let mut bdd = Bdd::new();
    let lower = chain(&mut bdd, 10, 3);
    let upper = (0..10).fold(Function::FALSE, |sum, group| {
        let literal = bdd.variable(3 * group).unwrap();
        bdd.or(sum, literal).unwrap()
    });
    let cover = minimize(&mut bdd, lower, upper).unwrap();
    assert_eq!((cover.cubes.len(), cover.literals()), (10, 10));
}

#[test]
fn limits_are_told() {
    let mut bdd = Bdd::new();
    let wide = chain(&mut bdd, 65, 2);
    assert_eq!(minimize(&mut bdd, wide, wide), Err(TooLarge::Variables(130)));
    let parity = (0..18).fold(Function::FALSE, |parity, variable| {
        let literal = bdd.variable(variable).unwrap();
        bdd.ite(literal, !parity, parity).unwrap()
    });
    assert_eq!(minimize(&mut bdd, parity, parity), Err(TooLarge::Terms(20_000)));
}

use super::super::testing::{bit, function};
use super::{Bdd, Function};
use crate::logic::TooLarge;
use proptest::prelude::*;

/// Two functions of six variables, as tables.
const VARIABLES: u32 = 6;

/// Checks that `f` is what `at` says of every row.
#[track_caller]
fn check(bdd: &Bdd, f: Function, at: impl Fn(usize) -> bool) {
    for row in 0..64 {
        assert_eq!(bdd.eval(f, &|variable| row >> variable & 1 == 1), at(row), "row {row}");
    }
}

proptest! {
    #[test]
    fn operations_are_those_of_tables(a: u64, b: u64, c: u64) {
        let mut bdd = Bdd::new();
        let [f, g, h] = [a, b, c].map(|table| function(&mut bdd, &[table], VARIABLES));
        let of = |table: u64| move |row: usize| bit(&[table], row);
        check(&bdd, f, of(a));
        check(&bdd, !f, of(!a));
        let both = bdd.and(f, g).unwrap();
        check(&bdd, both, of(a & b));
        let any = bdd.or(f, g).unwrap();
        check(&bdd, any, of(a | b));
        let choice = bdd.ite(f, g, h).unwrap();
        check(&bdd, choice, of(a & b | !a & c));
        prop_assert_eq!(bdd.implies(f, g).unwrap(), a & !b == 0);
        // Equal functions are the same.
        prop_assert_eq!(function(&mut bdd, &[a & b], VARIABLES), both);
        prop_assert_eq!(bdd.count(f, 6), f64::from(a.count_ones()));
        prop_assert_eq!(bdd.truth_table(f, &[0, 1, 2, 3, 4, 5]), vec![a]);
    }

    #[test]
    fn variables_are_fixed_and_quantified(a: u64, variable in 0..VARIABLES, value: bool) {
        let mut bdd = Bdd::new();
        let f = function(&mut bdd, &[a], VARIABLES);
        let at = |row: usize, value: bool| {
            let mask = 1 << variable;
            bit(&[a], if value { row | mask } else { row & !mask })
        };
        let fixed = bdd.cofactor(f, variable, value).unwrap();
        check(&bdd, fixed, |row| at(row, value));
        let some = bdd.exists(f, &[variable]).unwrap();
        check(&bdd, some, |row| at(row, false) || at(row, true));
        let all = bdd.forall(f, &[variable]).unwrap();
        check(&bdd, all, |row| at(row, false) && at(row, true));
        let depends = (0..64).any(|row| at(row, false) != at(row, true));
        prop_assert_eq!(bdd.support(&[f]).contains(&variable), depends);
    }

    #[test]
    fn a_witness_fulfils(a: u64) {
        let mut bdd = Bdd::new();
        let f = function(&mut bdd, &[a], VARIABLES);
        match bdd.witness(f) {
            None => prop_assert_eq!(a, 0),
            Some(literals) => prop_assert!(bdd.eval(f, &|variable| literals.contains(&(variable, true)))),
        }
    }
}

#[test]
fn several_variables_are_quantified_at_once() {
    let mut bdd = Bdd::new();
    let table = 0x0123_4567_89ab_cdef;
    let f = function(&mut bdd, &[table], VARIABLES);
    let mut one_by_one = f;
    for variable in [1, 3, 4] {
        one_by_one = bdd.exists(one_by_one, &[variable]).unwrap();
    }
    assert_eq!(bdd.exists(f, &[1, 3, 4]).unwrap(), one_by_one);
}

#[test]
fn a_table_of_some_variables() {
    let mut bdd = Bdd::new();
    let (a, b) = (bdd.variable(3).unwrap(), bdd.variable(9).unwrap());
    let f = bdd.without(b, a).unwrap();
    assert_eq!(bdd.truth_table(f, &[3, 9]), vec![0b0100]);
}

#[test]
fn too_many_nodes_are_refused() {
    // Equality of two words whose bits are far apart: every value of the first must be remembered.
    let mut bdd = Bdd::with_limit(1_000);
    let mut equal = Function::TRUE;
    let mut all = || -> Result<Function, TooLarge> {
        for bit in 0..16 {
            let (a, b) = (bdd.variable(bit)?, bdd.variable(bit + 16)?);
            let same = bdd.ite(a, b, !b)?;
            equal = bdd.and(equal, same)?;
        }
        Ok(equal)
    };
    assert_eq!(all(), Err(TooLarge::Nodes(1_000)));
}

use super::super::testing::{bit, function, written};
use super::{count, depth, factor};
use crate::logic::{Bdd, Expr, minimize};
use proptest::prelude::*;

fn factored(lower: &[u64], upper: &[u64], variables: u32) -> Expr {
    let mut bdd = Bdd::new();
    let lower = function(&mut bdd, lower, variables);
    let upper = function(&mut bdd, upper, variables);
    factor(&mut bdd, lower, upper, &[]).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn lies_between_the_bounds(lower: u64, free: u64) {
        let expr = factored(&[lower], &[lower | free], 6);
        for row in 0..64 {
            let value = expr.eval(&|variable| row >> variable & 1 == 1);
            prop_assert!(bit(&[lower], row) <= value && value <= bit(&[lower | free], row));
        }
    }
}

/// Per function of three variables the fewest instructions of any expression.
fn fewest() -> Vec<usize> {
    let columns = [0b1010_1010u8, 0b1100_1100, 0b1111_0000];
    let mut fewest = vec![usize::MAX / 4; 256];
    fewest[0] = 0;
    fewest[255] = 0;
    for column in columns {
        fewest[column as usize] = 1;
        fewest[!column as usize] = 1;
    }
    loop {
        let before = fewest.clone();
        for a in 1..255u8 {
            for b in 1..255u8 {
                let (cost_a, cost_b) = (fewest[a as usize], fewest[b as usize]);
                // Two compound operands need an instruction to be joined.
                let cost = cost_a + cost_b + usize::from(cost_a > 1 && cost_b > 1);
                for joined in [a & b, a | b] {
                    fewest[joined as usize] = fewest[joined as usize].min(cost);
                }
            }
        }
        if fewest == before {
            return fewest;
        }
    }
}

#[test]
fn three_variables_need_no_more_than_the_fewest() {
    let fewest = fewest();
    for (table, &least) in fewest.iter().enumerate() {
        let expr = factored(&[table as u64], &[table as u64], 3);
        assert_eq!(count(&expr), least, "{table:08b} {}", written(&expr));
    }
}

/// A function of up to six variables by its rows.
#[track_caller]
fn check(variables: u32, holds: impl Fn(u32) -> bool, expect: &str) {
    let table = (0..1u32 << variables).fold(0, |table, row| table | u64::from(holds(row)) << row);
    let expr = factored(&[table], &[table], variables);
    assert_eq!(format!("{} {} {}", written(&expr), count(&expr), depth(&expr)), expect);
}

/// Whether the variables with these letters hold in a row.
fn all(row: u32, letters: &str) -> bool {
    letters.bytes().all(|letter| row >> (letter - b'a') & 1 == 1)
}

#[test]
fn a_common_literal() {
    check(3, |row| all(row, "ab") || all(row, "ac"), "a (b + c) 3 1");
}

#[test]
fn a_product_of_sums() {
    check(
        6,
        |row| (all(row, "a") || all(row, "b") || all(row, "c")) && (all(row, "d") || all(row, "e")),
        "(d + e) (a + b + c) 6 2",
    );
}

#[test]
fn a_kernel_and_a_rest() {
    check(
        5,
        |row| all(row, "ac") || all(row, "ad") || all(row, "bc") || all(row, "bd") || all(row, "e"),
        "(e + (a + b) (c + d)) 6 2",
    );
}

#[test]
fn exclusive_or() {
    check(2, |row| row.count_ones() == 1, "(a !b + !a b) 5 2");
}

#[test]
fn majority_of_three() {
    check(3, |row| row.count_ones() >= 2, "(b c + a (b + c)) 6 2");
}

#[test]
fn constants() {
    check(1, |_| true, "true 0 0");
    check(1, |_| false, "false 0 0");
}

#[test]
fn a_precondition_frees_the_rest() {
    // Within `a`, `b` says the same as `b && !c`.
    let mut bdd = Bdd::new();
    let lower = function(&mut bdd, &[0b0000_1000], 3);
    let upper = function(&mut bdd, &[0b1000_1000], 3);
    let precondition = bdd.variable(0).unwrap();
    let expr = factor(&mut bdd, lower, upper, &[precondition]).unwrap();
    assert_eq!(written(&expr), "a b");
}

#[test]
fn a_function_without_structure_takes_no_endless_time() {
    let mut random = 0x9e37_79b9_7f4a_7c15u64;
    let mut next = || {
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        random
    };
    let table: Vec<u64> = (0..8).map(|_| next()).collect();
    let mut bdd = Bdd::new();
    let f = function(&mut bdd, &table, 9);
    let terms = minimize(&mut bdd, f, f).unwrap().cover.expr();
    let expr = factor(&mut bdd, f, f, &[]).unwrap();
    assert_eq!(expr.function(&mut bdd).unwrap(), f);
    assert!(3 * count(&expr) < 2 * count(&terms), "{} {}", count(&expr), count(&terms));
    // The search for less has been given up.
    assert!(bdd.work() < 20_000_000, "{}", bdd.work());
}

use super::super::testing::{bit, function, text};
use super::minimize;
use crate::logic::{Bdd, Function};
use proptest::prelude::*;

/// All terms of four variables: where they hold, and their literals.
fn terms() -> Vec<(u16, u32)> {
    let mut terms = Vec::new();
    for care in 0..16u32 {
        for value in (0..16u32).filter(|value| value & !care == 0) {
            let rows = (0..16u32).filter(|row| row & care == value).fold(0, |rows, row| rows | 1 << row);
            terms.push((rows, care.count_ones()));
        }
    }
    terms
}

/// Per function of four variables the fewest terms, and of those the fewest literals.
fn fewest() -> Vec<(u32, u32)> {
    let terms = terms();
    let mut fewest = vec![(u32::MAX, 0); 1 << 16];
    fewest[0] = (0, 0);
    let mut known = vec![0u16];
    for count in 1..=8 {
        let mut reached = Vec::new();
        for &table in &known {
            let (_, literals) = fewest[table as usize];
            for &(rows, more) in &terms {
                let better = (count, literals + more);
                let place = &mut fewest[(table | rows) as usize];
                if better < *place {
                    if place.0 != count {
                        reached.push(table | rows);
                    }
                    *place = better;
                }
            }
        }
        known = reached;
    }
    fewest
}

#[test]
fn no_cover_of_four_variables_is_smaller() {
    let fewest = fewest();
    for table in (0..=u16::MAX).step_by(61) {
        let mut bdd = Bdd::new();
        let f = function(&mut bdd, &[u64::from(table)], 4);
        let minimal = minimize(&mut bdd, f, f).unwrap();
        let found = (minimal.cover.cubes.len() as u32, minimal.cover.literals() as u32);
        assert_eq!((found, minimal.proven), (fewest[table as usize], true), "{table:016b}");
        assert_eq!(minimal.cover.function(&mut bdd).unwrap(), f, "{table:016b}");
    }
}

#[test]
fn freedom_is_used() {
    let fewest = fewest();
    for step in 0..300u64 {
        let lower = (step.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 40) as u16;
        let free = (step.wrapping_mul(0xd1b5_4a32_d192_ed03) >> 40) as u16 & !lower;
        // All functions between the two.
        let mut best = (u32::MAX, 0);
        let mut part = 0u16;
        loop {
            best = best.min(fewest[(lower | part) as usize]);
            part = part.wrapping_sub(free) & free;
            if part == 0 {
                break;
            }
        }
        let mut bdd = Bdd::new();
        let low = function(&mut bdd, &[u64::from(lower)], 4);
        let high = function(&mut bdd, &[u64::from(lower | free)], 4);
        let minimal = minimize(&mut bdd, low, high).unwrap();
        let found = (minimal.cover.cubes.len() as u32, minimal.cover.literals() as u32);
        assert_eq!((found, minimal.proven), (best, true), "{lower:016b} {free:016b}");
        let f = minimal.cover.function(&mut bdd).unwrap();
        assert!(bdd.implies(low, f).unwrap() && bdd.implies(f, high).unwrap());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]
    #[test]
    fn eight_variables(lower: [u64; 4], free: [u64; 4]) {
        let upper: Vec<u64> = lower.iter().zip(&free).map(|(lower, free)| lower | free).collect();
        let mut bdd = Bdd::new();
        let low = function(&mut bdd, &lower, 8);
        let high = function(&mut bdd, &upper, 8);
        let cover = minimize(&mut bdd, low, high).unwrap().cover;
        let expr = cover.expr();
        for row in 0..256 {
            let value = expr.eval(&|variable| row >> variable & 1 == 1);
            prop_assert!(bit(&lower, row) <= value && value <= bit(&upper, row));
        }
        // No term can go, and no literal of a term.
        for position in 0..cover.cubes.len() {
            let mut less = cover.clone();
            let cube = less.cubes.remove(position);
            let f = less.function(&mut bdd).unwrap();
            prop_assert!(!bdd.implies(low, f).unwrap());
            for (literal, _) in cube.iter() {
                let mut wider = cover.clone();
                wider.cubes = vec![cube.without(1 << literal)];
                let f = wider.function(&mut bdd).unwrap();
                prop_assert!(!bdd.implies(f, high).unwrap());
            }
        }
    }
}

/// The function of `variables` variables that holds in the rows that `holds` says, and is free where `free` says.
#[track_caller]
fn check(
    variables: u32,
    holds: impl Fn(u32) -> bool,
    free: impl Fn(u32) -> bool,
    terms: usize,
    literals: usize,
) -> String {
    let mut tables = [vec![0u64; 1 << variables >> 6 | 1], vec![0u64; 1 << variables >> 6 | 1]];
    for row in 0..1u32 << variables {
        tables[0][row as usize / 64] |= u64::from(holds(row)) << (row % 64);
        tables[1][row as usize / 64] |= u64::from(holds(row) || free(row)) << (row % 64);
    }
    let mut bdd = Bdd::new();
    let [lower, upper] = tables.map(|table| function(&mut bdd, &table, variables));
    let minimal = minimize(&mut bdd, lower, upper).unwrap();
    assert_eq!(
        (minimal.cover.cubes.len(), minimal.cover.literals(), minimal.proven),
        (terms, literals, true)
    );
    text(&minimal.cover)
}

fn never(_: u32) -> bool {
    false
}

#[test]
fn a_textbook_example_with_free_rows() {
    check(4, |row| [4, 8, 10, 11, 12, 15].contains(&row), |row| [9, 14].contains(&row), 3, 7);
}

#[test]
fn the_smallest_cyclic_core() {
    check(3, |row| ![3, 4].contains(&row), never, 3, 6);
}

#[test]
fn parity_has_no_prime_but_its_rows() {
    check(6, |row| row.count_ones() % 2 == 1, never, 32, 192);
}

#[test]
fn majority_of_seven() {
    check(7, |row| row.count_ones() >= 4, never, 35, 140);
}

#[test]
fn a_multiplexer_needs_no_consensus_term() {
    let text = check(3, |row| if row & 1 == 1 { row & 2 != 0 } else { row & 4 != 0 }, never, 2, 4);
    assert_eq!(text, "a && b || !a && c");
}

#[test]
fn carry_of_a_three_bit_adder() {
    // Primes with the carry of each position resolved: 2^3 - 1 terms.
    check(6, |row| (row & 7) + (row >> 3) > 7, never, 7, 24);
}

#[test]
fn constants_are_written_with_a_variable() {
    assert_eq!(check(2, never, never, 0, 0), "a && !a");
    assert_eq!(check(2, |_| true, never, 1, 0), "a || !a");
    assert_eq!(check(2, |row| row == 0, |row| row != 0, 1, 0), "a || !a");
}

#[test]
fn a_hard_function_is_not_claimed_to_be_proven() {
    // Symmetric in 12 variables: more primes than are looked at.
    let mut bdd = Bdd::new();
    let mut counts = vec![Function::TRUE];
    for variable in 0..12 {
        let literal = bdd.variable(variable).unwrap();
        let mut next = vec![Function::FALSE; counts.len() + 1];
        for (count, &f) in counts.iter().enumerate() {
            let more = bdd.and(f, literal).unwrap();
            next[count + 1] = bdd.or(next[count + 1], more).unwrap();
            let same = bdd.without(f, literal).unwrap();
            next[count] = bdd.or(next[count], same).unwrap();
        }
        counts = next;
    }
    let f = (4..=7).fold(Function::FALSE, |sum, count| bdd.or(sum, counts[count]).unwrap());
    let minimal = minimize(&mut bdd, f, f).unwrap();
    assert!(!minimal.proven);
    assert_eq!(minimal.cover.function(&mut bdd).unwrap(), f);
}

//! What is specified stays, whatever is merged.

use super::super::cycle::Machine;
use super::super::fixtures::{controller, controllers, show, trim};
use super::super::{Controller, Level, minimize, minimize_assuming};
use super::mealy::{Mealy, NOWHERE, REFUSED};
use super::{compatible, folded};
use crate::controller::reduce::fold::fold;
use proptest::prelude::*;
use std::collections::BTreeSet;

#[track_caller]
fn check(input: &str, expected: &str) {
    assert_eq!(show(&minimize(controller(input), Level::Ordered)), trim(expected));
}

#[test]
fn states_that_accept_different_events_merge() {
    check("0: a 1 \n 1: b 2 \n 2: c 0", "0: a 0, b 0, c 0");
}

#[test]
fn different_answers_keep_apart() {
    check("0: a 1 \n 1: a 2 \n 2! arm.go 0", "0: a 1\n1: a 2\n2! arm.go 0");
}

#[test]
fn answers_are_whole_super_steps() {
    let input = "0: a 1 \n 1! arm.go 2 \n 2! arm.stop 3 \n 3: a 4 \n 4! arm.go 0";
    check(input, "0: a 1\n1! arm.go 2\n2! arm.stop 3\n3: a 4\n4! arm.go 0");
}

#[test]
fn an_initial_super_step_stays() {
    check("0! arm.go 1 \n 1: a 2 \n 2: b 1", "0! arm.go 1\n1: a 1, b 1");
}

/// State 2 goes with 0 or with 1, and these do not go together: it is split, as coming from 0 and from 1.
#[test]
fn a_state_may_be_split() {
    let input = controller("0: a 1, b 2, c 3 \n 1! arm.go 0 \n 2: d 0 \n 3: a 4, b 2, c 0 \n 4! arm.stop 3");
    let mealy = Mealy::new(&input, &vec![Vec::new(); 5]).expect("a machine");
    assert_eq!(super::reduce(mealy).states(), 2);
}

#[test]
fn what_must_be_refused_is_a_difference() {
    let input = controller("0: a 1 \n 1: b 0");
    let count = |refused: &[Vec<u32>]| minimize_assuming(&input, refused).states;
    assert_eq!(count(&[vec![], vec![]]), 1);
    assert_eq!(count(&[vec![1], vec![]]), 2);
    assert_eq!(count(&[vec![], vec![0]]), 2);
}

#[test]
fn a_merged_state_owes_what_all_owe() {
    let mut input = controller("0: a 1 \n 1: b 0");
    input.owed = [[0], [1]].iter().collect();
    assert_eq!(minimize(input, Level::Ordered).owed, [[0, 1]].iter().collect());
}

#[test]
fn who_waits_and_acts_in_one_state_is_left_alone() {
    let mut input = controller("0: a 1 \n 1! arm.go 0");
    input.environment[0].push((1, 0));
    assert_eq!(minimize_assuming(&input, &[vec![], vec![]]), input);
}

/// Both machines side by side, under every event that the first specifies.
fn assert_covered(mealy: &Mealy, small: &Mealy) {
    let mut seen = BTreeSet::new();
    let mut open = vec![(mealy.initial, small.initial)];
    while let Some((state, other)) = open.pop() {
        if !seen.insert((state, other)) {
            continue;
        }
        for row in mealy.rows_of(state) {
            let found = small.rows_of(other).iter().find(|found| found.event == row.event);
            // Tables say nothing where they refuse.
            if row.answer == REFUSED {
                assert!(found.is_none_or(|found| found.answer == REFUSED));
                continue;
            }
            let found = found.expect("what is specified stays specified");
            assert_eq!(found.answer, row.answer);
            open.push((row.next, found.next));
        }
    }
}

proptest! {
    #[test]
    fn everything_specified_stays(
        input in controllers(24),
        refused in prop::collection::vec(any::<u8>(), 24),
        choices in prop::collection::vec(any::<u8>(), 40),
    ) {
        let exact = minimize(input.clone(), Level::Exact);
        let has_row = |state: u32, event: &u32| exact.environment[*event as usize].iter().any(|row| row.0 == state);
        let events = exact.events.len() as u32;
        let refused: Vec<Vec<u32>> = (0..exact.states)
            .map(|state| (0..events).filter(|e| refused[state as usize % 24] >> e & 3 == 3 && !has_row(state, e)).collect())
            .collect();
        if let Some(mealy) = Mealy::new(&exact, &refused) {
            let small = super::reduce(mealy.clone());
            assert_covered(&mealy, &small);
            prop_assert!(small.states() <= mealy.states());
            prop_assert!(small.states() >= super::least(&mealy));
            let result: Controller = small.controller(&exact);
            prop_assert_eq!(result.states as usize, small.table_states());
            let (mut left, mut right) = (Machine::new(&exact), Machine::new(&result));
            for choice in choices {
                let accepted: Vec<u32> = (0..exact.events.len() as u32).filter(|&e| left.accepts(e)).collect();
                let (before, after) = match accepted.get(choice as usize % accepted.len().max(1)) {
                    Some(&event) => (left.react(event), right.react(event)),
                    None => (Some(left.cycle()), Some(right.cycle())),
                };
                prop_assert_eq!(before, after);
            }
        }
    }

    #[test]
    fn folding_merges_only_what_goes_together(input in controllers(24)) {
        if let Some(mealy) = Mealy::new(&input, &vec![Vec::new(); input.states as usize]) {
            let members = fold(&mealy);
            prop_assert!(members[0].contains(&mealy.initial));
            assert_covered(&mealy, &folded(&mealy, &members));
        }
    }

    #[test]
    fn incompatible_is_what_a_sequence_tells_apart(input in controllers(12)) {
        if let Some(mealy) = Mealy::new(&input, &vec![Vec::new(); input.states as usize]) {
            let matrix = compatible::incompatible(&mealy);
            for a in 0..mealy.states() as u32 {
                for b in 0..mealy.states() as u32 {
                    prop_assert_eq!(matrix.contains(a, b), told_apart(&mealy, a, b), "{} {}", a, b);
                }
            }
        }
    }
}

/// By following all pairs.
fn told_apart(mealy: &Mealy, a: u32, b: u32) -> bool {
    let mut seen = BTreeSet::new();
    let mut open = vec![(a, b)];
    while let Some((a, b)) = open.pop() {
        if !seen.insert((a, b)) {
            continue;
        }
        for row in mealy.rows_of(a) {
            match mealy.rows_of(b).iter().find(|other| other.event == row.event) {
                Some(other) if other.answer != row.answer => return true,
                Some(other) if row.next != NOWHERE => open.push((row.next, other.next)),
                _ => {}
            }
        }
    }
    false
}

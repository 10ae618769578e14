//! Fewer states with the same behaviour.

use super::Controller;
use super::bisimulation::{Rows, bisimulation};
use super::reduce::{Mealy, least, reduce};
use crate::parallel::{each, threads_for};
use std::str::FromStr;

/// How far [`minimize`] goes.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Level {
    /// Every state stays.
    None,
    /// Merges the states that no environment can tell apart, whatever it does: what is refused stays refused.
    #[default]
    Exact,
    /// Also merges where the states differ only in events that cannot be pending there, however many come in one scan.
    /// [`minimize`] cannot know which these are and takes it for `Exact`; [`crate::pipeline`] finds out and calls
    /// [`minimize_assuming`].
    Assume,
    /// Also merges where the states differ only in events that cannot happen there if each event is answered before the next:
    /// for [`react`](super::cycle::Machine::react), one event at a time.
    Ordered,
}

impl Level {
    /// What it is called in options.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Level::None => "none",
            Level::Exact => "exact",
            Level::Assume => "assume",
            Level::Ordered => "ordered",
        }
    }

    /// The option of the command line that chooses it, with a space in front, if it need be said.
    #[must_use]
    pub fn option(self) -> String {
        if self == Level::default() { String::new() } else { format!(" --minimize {}", self.name()) }
    }
}

impl FromStr for Level {
    type Err = String;

    fn from_str(name: &str) -> Result<Level, String> {
        let levels = [Level::None, Level::Exact, Level::Assume, Level::Ordered];
        let level = levels.into_iter().find(|level| level.name() == name);
        level.ok_or_else(|| format!("unknown level `{name}`; there are `none`, `exact`, `assume`, `ordered`"))
    }
}

/// The smallest controller that behaves the same, as far as `level` allows.
///
/// Its states are numbered breadth first from the initial one, successors in table order, and all can be reached.
/// What a state owes is the union over the reachable states that it stands for.
///
/// [`Level::Exact`] is the coarsest bisimulation of the partial deterministic automaton whose labels are the
/// environment events and the distinct lists of super steps. See `bisimulation`.
#[must_use]
pub fn minimize(controller: Controller, level: Level) -> Controller {
    minimize_on(controller, level, 1)
}

/// As [`minimize`], on so many threads, or as many as the machine runs at once if that is 0; the result does not depend on it.
#[must_use]
pub fn minimize_on(controller: Controller, level: Level, threads: usize) -> Controller {
    match level {
        Level::None => controller,
        Level::Exact | Level::Assume => quotient(controller, threads),
        Level::Ordered => {
            let exact = quotient(controller, threads);
            let nothing = vec![Vec::new(); exact.states as usize];
            minimize_assuming(&exact, &nothing)
        }
    }
}

/// A controller that does the same where an event has a row or is in `refused`: per state, ascending, events without rows that must
/// have none. Everything else is a don't-care. What a state owes is the union over those that it stands for.
///
/// The result is small, not always the smallest; see `reduce`. States in which the controller both waits and acts, which only
/// plants have, and super steps without end leave the controller as it is.
#[must_use]
pub fn minimize_assuming(controller: &Controller, refused: &[Vec<u32>]) -> Controller {
    match Mealy::new(controller, refused) {
        Some(mealy) => reduce(mealy).controller(controller),
        None => controller.clone(),
    }
}

/// The number of states in a set of which any two are told apart by some sequence of events that the controller accepts: no controller that
/// answers the same waits in fewer, with [`Level::Ordered`] or any other. A large set is found, not always the largest; of controllers that
/// wait in more than 16,384 states only the nearest to the initial one are looked at. Time and memory grow with the square
/// of the states.
///
/// `None` where [`minimize_assuming`] leaves the controller as it is.
#[must_use]
pub fn never_fewer(controller: &Controller) -> Option<usize> {
    let nothing = vec![Vec::new(); controller.states as usize];
    Mealy::new(controller, &nothing).map(|mealy| least(&mealy))
}

const NONE: u32 = u32::MAX;

/// One state per class that can be reached.
///
/// The search goes through the states, not the classes: the first state met of a class gives its rows, the others
/// only what they owe. Classes are met in the order in which a search through classes would meet them, because
/// the rows of a later state of a class lead to classes that are known already.
fn quotient(mut controller: Controller, threads: usize) -> Controller {
    let rows = Rows::new(&controller, threads);
    let class = bisimulation(&rows, threads);
    let order = breadth_first(&rows, controller.initial);
    drop(rows);
    // By any state of a class, the number of the class; and the state that each has its rows of.
    let mut number = vec![NONE; class.len()];
    let mut given_by = Vec::new();
    let mut owed = controller.owed.cleared();
    let mut union = Vec::new();
    for state in order {
        let promised = controller.owed.number(state as usize);
        let known = number[class[state as usize] as usize];
        if known == NONE {
            number[class[state as usize] as usize] = given_by.len() as u32;
            given_by.push(state);
            owed.push_number(promised);
        } else if owed.number(known as usize) != promised {
            union.clear();
            union.extend_from_slice(&owed[known as usize]);
            union.extend_from_slice(controller.owed.list(promised));
            union.sort_unstable();
            union.dedup();
            owed.set(known as usize, &union);
        }
    }
    let new = |source: u32, target: u32| {
        let number = |state: u32| number[class[state as usize] as usize];
        let source = (given_by.get(number(source) as usize) == Some(&source)).then(|| number(source));
        source.map(|source| (source, number(target)))
    };
    let threads = threads_for(class.len() >> 14, threads);
    each(controller.environment.iter_mut(), threads, |rows| {
        rows.retain_mut(|row| new(row.0, row.1).map(|renamed| *row = renamed).is_some());
        // They ascend already if states were numbered breadth first before.
        rows.sort_unstable();
    });
    controller.super_steps.rename(new);
    Controller { states: given_by.len() as u32, initial: 0, owed, ..controller }
}

/// The states that can be reached, in the order in which they are met.
fn breadth_first(rows: &Rows, initial: u32) -> Vec<u32> {
    let mut met = vec![false; rows.states()];
    met[initial as usize] = true;
    let mut order = vec![initial];
    let mut head = 0;
    while let Some(&state) = order.get(head) {
        head += 1;
        for &next in rows.of(state) {
            if !std::mem::replace(&mut met[next as usize], true) {
                order.push(next);
            }
        }
    }
    order
}

#[cfg(test)]
mod tests {
    use super::super::fixtures::{State, build, controller, controllers, show, states, trim};
    use super::*;
    use proptest::prelude::*;
    use std::collections::{BTreeMap, BTreeSet};

    #[track_caller]
    fn check(input: &str, expected: &str) {
        assert_eq!(show(&minimize(controller(input), Level::Exact)), trim(expected));
    }

    #[test]
    fn one_state_stays() {
        check("0:", "0:");
    }

    #[test]
    fn equal_states_become_one() {
        check("0: a 1, b 2 \n 1! arm.go 0 \n 2! arm.go 0", "0: a 1, b 1 \n 1! arm.go 0");
    }

    #[test]
    fn a_loop_unrolled_is_rolled_up() {
        check("0: a 1 \n 1: a 2 \n 2: a 1", "0: a 0");
    }

    #[test]
    fn lists_in_another_order_differ() {
        let input = "0: a 1, b 2 \n 1! arm.go press.go 0 \n 2! press.go arm.go 0";
        check(input, input);
    }

    #[test]
    fn events_between_controllable_objects_count() {
        let input = "0: a 1, b 2 \n 1! arm.go 0 \n 2! arm.go log.x 0";
        check(input, input);
    }

    #[test]
    fn what_one_of_two_states_refuses_keeps_them_apart() {
        let input = "0: a 1, b 2 \n 1: a 0 \n 2: a 0, b 2";
        check(input, input);
    }

    #[test]
    fn a_difference_far_away_keeps_states_apart() {
        check(
            "0: a 1, b 4 \n 1: c 2 \n 2: c 3 \n 3! arm.go 0 \n 4: c 5 \n 5: c 6 \n 6! arm.stop 0",
            "0: a 1, b 2\n1: c 3\n2: c 4\n3: c 5\n4: c 6\n5! arm.go 0\n6! arm.stop 0",
        );
    }

    #[test]
    fn states_out_of_reach_go() {
        check("0: a 2 \n 1: b 0 \n 2! arm.go 0", "0: a 1\n1! arm.go 0");
    }

    #[test]
    fn a_class_owes_what_its_reachable_states_owe() {
        let mut input = controller("0: a 1, b 2, c 0 \n 1! arm.go 0 \n 2! arm.go 0 \n 3! arm.go 0");
        input.owed = [vec![2], vec![1, 2], vec![0, 1], vec![2]].iter().collect();
        assert_eq!(minimize(input, Level::Exact).owed, [vec![2], vec![0, 1, 2]].iter().collect());
    }

    #[test]
    fn level_none_keeps_everything() {
        let input = controller("0: a 2 \n 1: b 0 \n 2: a 2");
        assert_eq!(minimize(input.clone(), Level::None), input);
    }

    /// The rows of a state: per label (event, or list of commands) the target.
    type Moves = Vec<BTreeMap<(Option<usize>, Vec<u32>), u32>>;

    fn moves(controller: &Controller) -> Moves {
        let mut moves: Moves = vec![BTreeMap::new(); controller.states as usize];
        for (event, rows) in controller.environment.iter().enumerate() {
            for &(source, target) in rows {
                assert_eq!(moves[source as usize].insert((Some(event), Vec::new()), target), None);
            }
        }
        for step in &controller.super_steps {
            assert_eq!(moves[step.source as usize].insert((None, step.events.to_vec()), step.target), None);
        }
        moves
    }

    /// The number of classes of the reachable states, by refining all of them until nothing changes.
    fn classes_after_moore(controller: &Controller) -> usize {
        let moves = moves(controller);
        let mut reached = BTreeSet::new();
        let mut open = vec![controller.initial];
        while let Some(state) = open.pop() {
            if reached.insert(state) {
                open.extend(moves[state as usize].values());
            }
        }
        let mut class = vec![0; moves.len()];
        let mut classes = 1;
        loop {
            let mut signatures = BTreeMap::new();
            let mut next = class.clone();
            for &state in &reached {
                let signature: Vec<_> = moves[state as usize]
                    .iter()
                    .map(|(label, &target)| (label, class[target as usize]))
                    .collect();
                let fresh = signatures.len();
                next[state as usize] = *signatures.entry(signature).or_insert(fresh);
            }
            class = next;
            if signatures.len() == classes {
                return classes;
            }
            classes = signatures.len();
        }
    }

    fn assert_bisimilar(left: &Controller, right: &Controller) {
        let (left_moves, right_moves) = (moves(left), moves(right));
        let mut seen = BTreeSet::new();
        let mut open = vec![(left.initial, right.initial)];
        while let Some(pair) = open.pop() {
            if seen.insert(pair) {
                let (left, right) = (&left_moves[pair.0 as usize], &right_moves[pair.1 as usize]);
                assert!(left.keys().eq(right.keys()), "{pair:?}");
                open.extend(left.values().copied().zip(right.values().copied()));
            }
        }
    }

    /// Every state in several copies; each row leads to any copy of its target.
    fn unfold(states: &[State], copies: u32, choices: &[u32]) -> Vec<State> {
        let count = states.len() as u32;
        let mut choices = choices.iter().cycle();
        let mut any = |target: u32| target + count * (choices.next().expect("endless") % copies);
        let mut unfolded = Vec::new();
        for _ in 0..copies {
            for state in states {
                unfolded.push(match state {
                    State::Environment(rows) => {
                        State::Environment(rows.iter().map(|(event, &t)| (event.clone(), any(t))).collect())
                    }
                    State::SuperStep(list, target) => State::SuperStep(list.clone(), any(*target)),
                });
            }
        }
        unfolded
    }

    proptest! {
        #[test]
        fn the_result_is_minimal_and_behaves_the_same(input in controllers(24)) {
            let result = minimize(input.clone(), Level::Exact);
            assert_bisimilar(&input, &result);
            prop_assert_eq!(result.states as usize, classes_after_moore(&input));
            prop_assert_eq!(&minimize(result.clone(), Level::Exact), &result);
        }

        #[test]
        fn copies_of_states_make_no_difference(
            states in states(8),
            copies in 1_u32..4,
            choices in prop::collection::vec(0_u32..100, 1..40),
        ) {
            let unfolded = minimize(build(&unfold(&states, copies, &choices)), Level::Exact);
            prop_assert_eq!(unfolded, minimize(build(&states), Level::Exact));
        }

        #[test]
        fn rows_are_sorted_and_states_breadth_first(input in controllers(24)) {
            let result = minimize(input.clone(), Level::Exact);
            prop_assert!(result.environment.iter().all(|rows| rows.is_sorted_by(|a, b| a.0 < b.0)));
            prop_assert!(result.super_steps.source.is_sorted_by(|a, b| a < b));
            let mut met = 0;
            for (state, row) in moves(&result).iter().enumerate() {
                prop_assert!(state as u32 <= met);
                for &target in row.values() {
                    prop_assert!(target <= met + 1);
                    met = met.max(target);
                }
            }
            prop_assert_eq!(met + 1, result.states);
        }
    }
}

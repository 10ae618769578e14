//! Fewer states with the same behaviour.

use super::partition::{Partition, bucket};
use super::reduce::{Mealy, least, reduce};
use super::{Controller, SuperStep};
use hashbrown::HashMap;
use rustc_hash::FxBuildHasher;
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
/// environment events and the distinct lists of super steps. It takes `O(m log n)` for `m` rows and `n` states
/// (Valmari and Lehtinen, "Efficient minimization of DFAs with partial transition functions", STACS 2008).
#[must_use]
pub fn minimize(controller: &Controller, level: Level) -> Controller {
    match level {
        Level::None => controller.clone(),
        Level::Exact | Level::Assume => {
            let rows = Rows::new(controller);
            quotient(controller, &rows, &bisimulation(controller, &rows))
        }
        Level::Ordered => {
            let exact = minimize(controller, Level::Exact);
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

/// All rows of a controller in table order: per event, then the super steps.
struct Rows {
    source: Vec<u32>,
    target: Vec<u32>,
    /// Row of the first super step.
    super_steps: u32,
}

impl Rows {
    fn new(controller: &Controller) -> Self {
        let environment: usize = controller.environment.iter().map(Vec::len).sum();
        let mut source = Vec::with_capacity(environment + controller.super_steps.len());
        let mut target = Vec::with_capacity(environment + controller.super_steps.len());
        for &(from, to) in controller.environment.iter().flatten() {
            source.push(from);
            target.push(to);
        }
        for step in &controller.super_steps {
            source.push(step.source);
            target.push(step.target);
        }
        Rows { source, target, super_steps: environment as u32 }
    }
}

/// Per row its label, and the number of labels.
fn labels(controller: &Controller) -> (Vec<u32>, u32) {
    let mut labels = Vec::new();
    let mut count = 0;
    // A partition has no empty set: an event without rows gets no label.
    for rows in controller.environment.iter().filter(|rows| !rows.is_empty()) {
        labels.resize(labels.len() + rows.len(), count);
        count += 1;
    }
    let mut lists: HashMap<&[u32], u32, FxBuildHasher> = HashMap::default();
    for step in &controller.super_steps {
        let label = *lists.entry(&step.events).or_insert_with(|| {
            count += 1;
            count - 1
        });
        labels.push(label);
    }
    (labels, count)
}

/// Per state its class.
///
/// Two partitions refine each other: states into blocks, rows into cords. All rows of a cord have the same label and
/// lead into the same block. The sources of a cord split blocks (only some states of a block have such a row);
/// the rows into a new block split cords.
fn bisimulation(controller: &Controller, rows: &Rows) -> Vec<u32> {
    let states = controller.states;
    let (incoming, by_target) = bucket(&rows.target, states);
    let (labels, count) = labels(controller);
    // Rows go by their place in `by_target` here, so that those into a state are neighbours.
    let pick = |per_row: &[u32]| -> Vec<u32> { by_target.iter().map(|&row| per_row[row as usize]).collect() };
    let source = pick(&rows.source);
    let mut cords = Partition::new(&pick(&labels), count);
    let mut blocks = Partition::new(&vec![0; states as usize], 1);
    let mut cord = 0;
    // Block 0 splits no cord: every row leads into it.
    let mut block = 1;
    while cord < cords.sets() {
        for &row in cords.elements(cord) {
            blocks.mark(source[row as usize]);
        }
        blocks.split();
        cord += 1;
        while block < blocks.sets() {
            for &state in blocks.elements(block) {
                for row in incoming[state as usize]..incoming[state as usize + 1] {
                    cords.mark(row);
                }
            }
            cords.split();
            block += 1;
        }
    }
    blocks.into_sets()
}

const UNSEEN: u32 = u32::MAX;

/// One state per class that can be reached.
///
/// The search goes through the states, not the classes: the first state met of a class gives its rows, the others
/// only what they owe. Classes are met in the order in which a search through classes would meet them, because
/// the rows of a later state of a class lead to classes that are known already.
fn quotient(controller: &Controller, rows: &Rows, class: &[u32]) -> Controller {
    let (outgoing, by_source) = bucket(&rows.source, controller.states);
    let label = row_events(controller);
    let mut environment = vec![Vec::new(); controller.events.len()];
    let mut super_steps = Vec::new();
    let mut owed: Vec<Vec<u32>> = Vec::new();
    let mut number = vec![UNSEEN; class.len()];
    let mut seen = vec![false; class.len()];
    let mut queue = vec![controller.initial];
    seen[controller.initial as usize] = true;
    number[class[controller.initial as usize] as usize] = 0;
    let mut numbered = 1;
    let mut head = 0;
    while let Some(&state) = queue.get(head) {
        head += 1;
        let source = number[class[state as usize] as usize];
        // Classes are numbered when queued and so come out in order: a number without an entry is a new class.
        let first_of_class = source as usize == owed.len();
        if first_of_class {
            owed.push(Vec::new());
        }
        owed[source as usize].extend_from_slice(&controller.owed[state as usize]);
        for &row in &by_source[outgoing[state as usize] as usize..outgoing[state as usize + 1] as usize] {
            let next = rows.target[row as usize];
            if !seen[next as usize] {
                seen[next as usize] = true;
                queue.push(next);
            }
            let target = &mut number[class[next as usize] as usize];
            if *target == UNSEEN {
                *target = numbered;
                numbered += 1;
            }
            if !first_of_class {
                continue;
            }
            match row.checked_sub(rows.super_steps) {
                None => environment[label[row as usize] as usize].push((source, *target)),
                Some(step) => {
                    let events = controller.super_steps[step as usize].events.clone();
                    super_steps.push(SuperStep { source, target: *target, events });
                }
            }
        }
    }
    for events in &mut owed {
        events.sort_unstable();
        events.dedup();
    }
    Controller {
        states: numbered,
        initial: 0,
        events: controller.events.clone(),
        commands: controller.commands.clone(),
        components: controller.components.clone(),
        environment,
        super_steps,
        owed,
    }
}

/// Per environment row its event.
fn row_events(controller: &Controller) -> Vec<u32> {
    let mut events = Vec::new();
    for (event, rows) in controller.environment.iter().enumerate() {
        events.resize(events.len() + rows.len(), event as u32);
    }
    events
}

#[cfg(test)]
mod tests {
    use super::super::fixtures::{State, build, controller, controllers, show, states, trim};
    use super::*;
    use proptest::prelude::*;
    use std::collections::{BTreeMap, BTreeSet};

    #[track_caller]
    fn check(input: &str, expected: &str) {
        assert_eq!(show(&minimize(&controller(input), Level::Exact)), trim(expected));
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
        input.owed = vec![vec![2], vec![1, 2], vec![0, 1], vec![2]];
        assert_eq!(minimize(&input, Level::Exact).owed, [vec![2], vec![0, 1, 2]]);
    }

    #[test]
    fn level_none_keeps_everything() {
        let input = controller("0: a 2 \n 1: b 0 \n 2: a 2");
        assert_eq!(minimize(&input, Level::None), input);
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
            assert_eq!(moves[step.source as usize].insert((None, step.events.clone()), step.target), None);
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
            let result = minimize(&input, Level::Exact);
            assert_bisimilar(&input, &result);
            prop_assert_eq!(result.states as usize, classes_after_moore(&input));
            prop_assert_eq!(&minimize(&result, Level::Exact), &result);
        }

        #[test]
        fn copies_of_states_make_no_difference(
            states in states(8),
            copies in 1_u32..4,
            choices in prop::collection::vec(0_u32..100, 1..40),
        ) {
            let unfolded = minimize(&build(&unfold(&states, copies, &choices)), Level::Exact);
            prop_assert_eq!(unfolded, minimize(&build(&states), Level::Exact));
        }

        #[test]
        fn rows_are_sorted_and_states_breadth_first(input in controllers(24)) {
            let result = minimize(&input, Level::Exact);
            prop_assert!(result.environment.iter().all(|rows| rows.is_sorted_by(|a, b| a.0 < b.0)));
            prop_assert!(result.super_steps.is_sorted_by(|a, b| a.source < b.source));
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

//! The numbers of states, chosen so that tables are short.
//!
//! A strategy may call its states as it likes. States that accept the same events, or issue the same commands, get
//! neighbouring numbers here; so most tables become a few *runs* of consecutive states (see [`super::runs`]).

use super::Controller;
use super::partition::bucket;
use hashbrown::HashMap;
use rustc_hash::FxBuildHasher;
use std::cmp::Ordering;

/// The same controller with other numbers; the initial state is 0.
///
/// First come the states that wait for an event and then those in which a super step is due (the other way round if one
/// is due initially). Those that wait are in the order of a reflected Gray code over the sets of events that they accept,
/// turned so that it begins with the initial one: from one set to the next, few events come or go. Those with a super step
/// are in the order of their commands. Among equals the former order stays.
#[must_use]
pub fn number(controller: Controller) -> Controller {
    let rows = Rows::of(&controller);
    let order = order(&controller, &rows);
    let mut number = vec![0; order.len()];
    for (new, &old) in (0..).zip(&order) {
        number[old as usize] = new;
    }
    renamed(controller, &rows, &order, &number)
}

/// The states in their new order.
fn order(controller: &Controller, rows: &Rows) -> Vec<u32> {
    let initial = controller.initial as usize;
    let commands = commands(controller);
    // There are few sets of events and few lists of commands: ranks are all that states are compared by.
    let (accepted, sets) = ranks((0..controller.states).map(|state| rows.events_of(state)), gray);
    let (commanded, lists) = ranks(commands.iter().map(|list| list.as_deref().unwrap_or(&[])), Ord::cmp);
    let behind = if commands[initial].is_some() { (lists, 0) } else { (0, sets) };
    let key = |state: usize| match &commands[state] {
        None => behind.0 + accepted[state],
        Some(_) => behind.1 + commanded[state],
    };
    let keys: Vec<u32> = (0..commands.len()).map(key).collect();
    let (bounds, mut order) = bucket(&keys, sets + lists);
    let section = keys.iter().filter(|&&key| key < behind.0.max(behind.1)).count();
    // The initial state is the first of its equals, and then of all.
    let start = bounds[keys[initial] as usize] as usize;
    let place = order[start..].iter().position(|&state| state as usize == initial).unwrap_or(0);
    order[start..=start + place].rotate_right(1);
    order[..section].rotate_left(start);
    order
}

/// Per list its rank among the distinct ones, and how many these are.
fn ranks<'l>(
    lists: impl Iterator<Item = &'l [u32]>,
    compare: impl Fn(&[u32], &[u32]) -> Ordering,
) -> (Vec<u32>, u32) {
    let mut numbers: HashMap<&[u32], u32, FxBuildHasher> = HashMap::default();
    let mut distinct: Vec<&[u32]> = Vec::new();
    let mut ranks: Vec<u32> = lists
        .map(|list| {
            *numbers.entry(list).or_insert_with(|| {
                distinct.push(list);
                distinct.len() as u32 - 1
            })
        })
        .collect();
    let mut sorted: Vec<u32> = (0..distinct.len() as u32).collect();
    sorted.sort_unstable_by(|&a, &b| compare(distinct[a as usize], distinct[b as usize]));
    let mut rank = vec![0; sorted.len()];
    (0..).zip(&sorted).for_each(|(place, &number)| rank[number as usize] = place);
    ranks.iter_mut().for_each(|number| *number = rank[*number as usize]);
    (ranks, sorted.len() as u32)
}

/// Compares two sets, as ascending lists, by their places in a reflected Gray code whose leading digit is the
/// smallest element: the first digit in which they differ decides, in turned order behind an odd number of ones.
fn gray(a: &[u32], b: &[u32]) -> Ordering {
    let shared = a.iter().zip(b).take_while(|(a, b)| a == b).count();
    let differing = |list: &[u32]| list.get(shared).copied().unwrap_or(u32::MAX);
    // Who has the smaller element has the digit 1.
    let order = differing(b).cmp(&differing(a));
    if shared % 2 == 0 { order } else { order.reverse() }
}

/// The environment's rows by states.
struct Rows {
    /// Per state where its rows begin; one more entry ends the last.
    start: Vec<u32>,
    /// The events of the rows, ascending for each state, and where they lead.
    events: Vec<u32>,
    targets: Vec<u32>,
}

impl Rows {
    fn of(controller: &Controller) -> Rows {
        let mut start = vec![0; controller.states as usize + 1];
        for (source, _) in controller.environment.iter().flatten() {
            start[*source as usize + 1] += 1;
        }
        for state in 1..start.len() {
            start[state] += start[state - 1];
        }
        let mut next = start.clone();
        let mut events = vec![0; start.last().copied().unwrap_or(0) as usize];
        let mut targets = events.clone();
        for (event, rows) in (0..).zip(&controller.environment) {
            for &(source, target) in rows {
                let place = &mut next[source as usize];
                events[*place as usize] = event;
                targets[*place as usize] = target;
                *place += 1;
            }
        }
        Rows { start, events, targets }
    }

    fn of_state(&self, state: u32) -> std::ops::Range<usize> {
        self.start[state as usize] as usize..self.start[state as usize + 1] as usize
    }

    fn events_of(&self, state: u32) -> &[u32] {
        &self.events[self.of_state(state)]
    }
}

/// Per state with a super step what it tells components, ascending; what controllable objects tell each other is in no
/// table.
fn commands(controller: &Controller) -> Vec<Option<Vec<u32>>> {
    let mut commanded = vec![false; controller.commands.len()];
    for &command in controller.components.iter().flat_map(|component| &component.commands) {
        commanded[command as usize] = true;
    }
    let mut of_state = vec![None; controller.states as usize];
    for step in &controller.super_steps {
        let commands = step.events.iter().copied().filter(|&event| commanded[event as usize]);
        let mut commands: Vec<u32> = commands.collect();
        commands.sort_unstable();
        of_state[step.source as usize] = Some(commands);
    }
    of_state
}

/// Gives every state its new number; `order` is the inverse of `number`.
fn renamed(mut controller: Controller, rows: &Rows, order: &[u32], number: &[u32]) -> Controller {
    controller.initial = number[controller.initial as usize];
    controller.environment.iter_mut().for_each(Vec::clear);
    for (new, &old) in (0..).zip(order) {
        let places = rows.of_state(old);
        for (&event, &target) in rows.events[places.clone()].iter().zip(&rows.targets[places]) {
            controller.environment[event as usize].push((new, number[target as usize]));
        }
    }
    for step in &mut controller.super_steps {
        (step.source, step.target) = (number[step.source as usize], number[step.target as usize]);
    }
    controller.super_steps.sort_unstable_by_key(|step| step.source);
    controller.owed = order.iter().map(|&old| std::mem::take(&mut controller.owed[old as usize])).collect();
    controller
}

#[cfg(test)]
mod tests {
    use super::super::cycle::Machine;
    use super::super::fixtures::{controller, controllers, show};
    use super::*;
    use proptest::prelude::*;

    /// Every subset of four elements, in the order of the code.
    #[test]
    fn neighbours_in_a_gray_code_differ_in_one_element() {
        let mut sets: Vec<Vec<u32>> =
            (0..16u32).map(|bits| (0..4).filter(|i| bits >> i & 1 == 1).collect()).collect();
        sets.sort_by(|a, b| gray(a, b));
        for pair in sets.windows(2) {
            let differing = (0..4).filter(|i| pair[0].contains(i) != pair[1].contains(i)).count();
            assert_eq!(differing, 1, "{pair:?}");
        }
    }

    #[test]
    fn equal_kinds_become_neighbours() {
        let before = controller(
            "0: b 1 \n 1! arm.go 2 \n 2: a 3, b 5 \n 3! press.go arm.go 4 \n 4: a 0, b 1 \n 5! arm.go log.x 4 \n 6: c 0",
        );
        let after = number(before);
        let expected = "0: b 4 \n 1: a 6, b 5 \n 2: a 0, b 4 \n 3: c 0 \n 4! arm.go 1 \n 5! arm.go log.x 2 \n 6! press.go arm.go 2";
        assert_eq!(show(&after), show(&controller(expected)));
    }

    #[test]
    fn an_initial_super_step_is_first() {
        let after = number(controller("0! press.go 1 \n 1: a 2 \n 2! arm.go 1"));
        assert_eq!(show(&after), show(&controller("0! press.go 2 \n 1! arm.go 2 \n 2: a 1")));
    }

    proptest! {
        /// Only numbers change, and a second time not even they.
        #[test]
        fn behaviour_stays(before in controllers(12), events in proptest::collection::vec(0u32..8, 0..60)) {
            let after = number(before.clone());
            prop_assert_eq!(&number(after.clone()), &after);
            prop_assert_eq!(after.initial, 0);
            let (mut old, mut new) = (Machine::new(&before), Machine::new(&after));
            let mut number_of = std::collections::BTreeMap::new();
            for event in events {
                if let Some(event) = event.checked_rem(before.events.len() as u32) {
                    old.raise(event);
                    new.raise(event);
                }
                prop_assert_eq!(old.cycle(), new.cycle());
                prop_assert_eq!(old.owed(), new.owed());
                prop_assert_eq!(old.unexpected(), new.unexpected());
                let number = *number_of.entry(old.state()).or_insert(new.state());
                prop_assert_eq!(number, new.state());
            }
        }
    }
}

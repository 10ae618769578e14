//! The numbers of states, chosen so that tables are short.
//!
//! A strategy may call its states as it likes. States that accept the same events, or issue the same commands, get
//! neighbouring numbers here; so most tables become a few *runs* of consecutive states (see [`super::runs`]).

use std::cmp::Ordering;

use super::Controller;

/// The same controller with other numbers; the initial state is 0.
///
/// First come the states that wait for an event and then those in which a super step is due (the other way round if one
/// is due initially). Those that wait are in the order of a reflected Gray code over the sets of events that they accept,
/// turned so that it begins with the initial one: from one set to the next, few events come or go. Those with a super step
/// are in the order of their commands. Among equals the former order stays.
#[must_use]
pub fn number(controller: Controller) -> Controller {
    let order = order(&controller);
    let mut number = vec![0; order.len()];
    for (new, &old) in (0..).zip(&order) {
        number[old as usize] = new;
    }
    renamed(controller, &order, &number)
}

/// The states in their new order.
fn order(controller: &Controller) -> Vec<u32> {
    let initial = controller.initial;
    let accepted = Accepted::of(controller);
    let commands = Commands::of(controller);
    let is_step = |state: u32| commands.of_state(state).is_some();
    let compare = |a: u32, b: u32| match (commands.of_state(a), commands.of_state(b)) {
        (None, None) => gray(accepted.of_state(a), accepted.of_state(b)),
        (a, b) => a.cmp(&b),
    };
    let mut order: Vec<u32> = (0..controller.states).collect();
    order.sort_by(|&a, &b| {
        let section = |state| is_step(state) != is_step(initial);
        let among_equals = |state| (state != initial, state);
        section(a)
            .cmp(&section(b))
            .then_with(|| compare(a, b))
            .then_with(|| among_equals(a).cmp(&among_equals(b)))
    });
    let section = order.partition_point(|&state| is_step(state) == is_step(initial));
    let start = order[..section].iter().position(|&state| state == initial).unwrap_or(0);
    order[..section].rotate_left(start);
    order
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

/// Per state the events that it accepts, ascending.
struct Accepted {
    /// Per state where its events begin; one more entry ends the last.
    start: Vec<u32>,
    events: Vec<u32>,
}

impl Accepted {
    fn of(controller: &Controller) -> Accepted {
        let mut start = vec![0; controller.states as usize + 1];
        for (source, _) in controller.environment.iter().flatten() {
            start[*source as usize + 1] += 1;
        }
        for state in 1..start.len() {
            start[state] += start[state - 1];
        }
        let mut next = start.clone();
        let mut events = vec![0; start.last().copied().unwrap_or(0) as usize];
        for (event, rows) in (0..).zip(&controller.environment) {
            for &(source, _) in rows {
                let place = &mut next[source as usize];
                events[*place as usize] = event;
                *place += 1;
            }
        }
        Accepted { start, events }
    }

    fn of_state(&self, state: u32) -> &[u32] {
        let state = state as usize;
        &self.events[self.start[state] as usize..self.start[state + 1] as usize]
    }
}

/// Per state with a super step what it tells components, ascending; what controllable objects tell each other is in no
/// table.
struct Commands {
    of_state: Vec<Option<Vec<u32>>>,
}

impl Commands {
    fn of(controller: &Controller) -> Commands {
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
        Commands { of_state }
    }

    fn of_state(&self, state: u32) -> Option<&[u32]> {
        self.of_state[state as usize].as_deref()
    }
}

/// Gives every state its new number; `order` is the inverse of `number`.
fn renamed(mut controller: Controller, order: &[u32], number: &[u32]) -> Controller {
    controller.initial = number[controller.initial as usize];
    for rows in &mut controller.environment {
        for (source, target) in rows.iter_mut() {
            (*source, *target) = (number[*source as usize], number[*target as usize]);
        }
        rows.sort_unstable();
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

//! The numbers of states, chosen so that tables are short.
//!
//! A strategy may call its states as it likes. States that accept the same events, or issue the same commands, get
//! neighbouring numbers here; so most tables become a few *runs* of consecutive states (see [`super::runs`]).

use super::Controller;
use super::kinds::Kinds;
use super::partition::bucket;
use crate::parallel::{each, threads_for};

/// The same controller with other numbers; the initial state is 0.
///
/// First come the states that wait for an event and then those in which a super step is due (the other way round if one
/// is due initially). Those that wait are in the order of a reflected Gray code over the sets of events that they accept,
/// turned so that it begins with the initial one: from one set to the next, few events come or go. Those with a super step
/// are in the order of their commands. Among equals the former order stays.
#[must_use]
pub fn number(controller: Controller) -> Controller {
    number_on(controller, 1)
}

/// As [`number`], on so many threads, or as many as the machine runs at once if that is 0; the result does not depend on it.
#[must_use]
pub fn number_on(controller: Controller, threads: usize) -> Controller {
    let order = order(&controller);
    let mut number = vec![0; order.len()];
    for (new, &old) in (0..).zip(&order) {
        number[old as usize] = new;
    }
    renamed(controller, &order, &number, threads)
}

/// The states in their new order.
fn order(controller: &Controller) -> Vec<u32> {
    let initial = controller.initial as usize;
    let kinds = Kinds::of_events(controller);
    let (commanded, lists) = by_commands(controller);
    // There are few sets of events and few lists of commands: their ranks are all that states are compared by.
    let accepted = gray(&kinds);
    let sets = kinds.len() as u32;
    let mut keys = kinds.of;
    keys.iter_mut().for_each(|kind| *kind = accepted[*kind as usize]);
    let acts = |state: u32| controller.super_steps.source.binary_search(&state).is_ok();
    let (waiting, acting) = if acts(controller.initial) { (lists, 0) } else { (0, sets) };
    keys.iter_mut().for_each(|key| *key += waiting);
    for (&source, &list) in controller.super_steps.source.iter().zip(controller.super_steps.events.numbers())
    {
        keys[source as usize] = acting + commanded[list as usize];
    }
    let (bounds, mut order) = bucket(&keys, sets + lists);
    let section = bounds[waiting.max(acting) as usize] as usize;
    // The initial state is the first of its equals, and then of all.
    let start = bounds[keys[initial] as usize] as usize;
    let place = order[start..].iter().position(|&state| state as usize == initial).unwrap_or(0);
    order[start..=start + place].rotate_right(1);
    order[..section].rotate_left(start);
    order
}

/// Per set of events its place in a reflected Gray code whose leading digit is the smallest event: the first digit in which
/// two sets differ decides, in turned order behind an odd number of ones.
fn gray(kinds: &Kinds) -> Vec<u32> {
    // The root is no child of itself. Children are in ascending order of their labels.
    let (first, children) = bucket(&kinds.parent[1..], kinds.len() as u32);
    let children = |kind: u32| {
        let of_kind = first[kind as usize] as usize..first[kind as usize + 1] as usize;
        children[of_kind].iter().map(|child| child + 1)
    };
    let mut places = vec![0; kinds.len()];
    let mut place = 0;
    // What is still to come, the next one last: with all sets that begin with it, or alone.
    let mut open = vec![(0, true)];
    while let Some((kind, all)) = open.pop() {
        let even = kinds.labels[kind as usize].is_multiple_of(2);
        if !all {
            places[kind as usize] = place;
            place += 1;
        } else if even {
            // What ends here has the digit 0 for every event to come; the larger the next event, the more zeros before it.
            open.extend(children(kind).map(|child| (child, true)));
            open.push((kind, false));
        } else {
            open.push((kind, false));
            open.extend(children(kind).rev().map(|child| (child, true)));
        }
    }
    places
}

/// Per list of super steps the rank of what it tells components, as an ascending list, and the number of ranks; what
/// controllable objects tell each other is in no table.
fn by_commands(controller: &Controller) -> (Vec<u32>, u32) {
    let mut commanded = vec![false; controller.commands.len()];
    for &command in controller.components.iter().flat_map(|component| &component.commands) {
        commanded[command as usize] = true;
    }
    let lists = &controller.super_steps.events;
    let mut told: Vec<(Vec<u32>, u32)> = (0..lists.distinct() as u32)
        .map(|list| {
            let events = lists.list(list).iter().copied();
            let mut commands: Vec<u32> = events.filter(|&event| commanded[event as usize]).collect();
            commands.sort_unstable();
            (commands, list)
        })
        .collect();
    told.sort_unstable();
    let mut rank = vec![0; told.len()];
    let mut ranks = 0;
    for alike in told.chunk_by(|a, b| a.0 == b.0) {
        alike.iter().for_each(|(_, list)| rank[*list as usize] = ranks);
        ranks += 1;
    }
    (rank, ranks)
}

/// Gives every state its new number; `order` is the inverse of `number`.
fn renamed(mut controller: Controller, order: &[u32], number: &[u32], threads: usize) -> Controller {
    let new = |state: u32| number[state as usize];
    controller.initial = new(controller.initial);
    each(controller.environment.iter_mut(), threads_for(order.len() >> 14, threads), |rows| {
        let sources = Ranks::new(order.len(), rows.iter().map(|row| new(row.0)));
        let mut sorted = vec![(0, 0); rows.len()];
        for &(source, target) in &*rows {
            sorted[sources.rank(new(source))] = (new(source), new(target));
        }
        *rows = sorted;
    });
    controller.super_steps.rename(|source, target| Some((new(source), new(target))));
    controller.owed = controller.owed.reordered(order);
    controller
}

/// A set of numbers in which each knows how many are smaller: sorts distinct numbers that are not spread too far.
struct Ranks {
    /// Bit by bit, which numbers are in the set.
    words: Vec<u64>,
    /// Per word how many there are before it.
    before: Vec<u32>,
}

impl Ranks {
    /// The set of these numbers below `limit`.
    fn new(limit: usize, members: impl Iterator<Item = u32>) -> Ranks {
        let mut words = vec![0_u64; limit.div_ceil(u64::BITS as usize)];
        members.for_each(|member| words[(member / u64::BITS) as usize] |= 1 << (member % u64::BITS));
        let mut count = 0;
        let before = words.iter().map(|word| {
            let before = count;
            count += word.count_ones();
            before
        });
        Ranks { before: before.collect(), words }
    }

    fn rank(&self, member: u32) -> usize {
        let word = (member / u64::BITS) as usize;
        let smaller = self.words[word] & ((1 << (member % u64::BITS)) - 1);
        (self.before[word] + smaller.count_ones()) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::super::cycle::Machine;
    use super::super::fixtures::{controller, controllers, show};
    use super::*;
    use proptest::prelude::*;

    /// Every subset of four events.
    #[test]
    fn neighbours_in_a_gray_code_differ_in_one_element() {
        let accepts = |state: u32| {
            ["a 0", "b 0", "c 0", "d 0"].into_iter().enumerate().filter(move |(i, _)| state >> i & 1 == 1)
        };
        let rows = |state| accepts(state).map(|(_, row)| row).collect::<Vec<_>>().join(", ");
        let lines: Vec<String> = (0..16).map(|state| format!("{state}: {}", rows(state))).collect();
        let order = order(&controller(&lines.join("\n")));
        assert_eq!(order[..4], [0b0000, 0b1000, 0b1100, 0b0100]);
        for pair in order.windows(2) {
            assert_eq!((pair[0] ^ pair[1]).count_ones(), 1, "{pair:?}");
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

//! A large machine as small ones side by side.
//!
//! What a controller answers to one event often depends on little: whether a press is full, where an arm is. A machine that need only
//! answer this one event right is then small, and machines for all events, run side by side, answer everything (Hartmanis,
//! "Symbolic analysis of a decomposition of information processing machines", 1960). Their reachable combinations are a closed
//! cover of the large machine, found without comparing its states.
//!
//! The machine for an event is looked for in a part of the large one, the states nearest to the initial one. It is
//! followed through all of the large machine; what it gets wrong there is added to the part.

use super::at_most;
use super::mealy::{Mealy, NOWHERE, Row};
use hashbrown::{HashMap, HashSet};
use rustc_hash::FxBuildHasher;

/// States of the part that is looked at first.
const NEAREST: usize = 600;
/// States of the part at most.
const MOST_INSIDE: usize = 1 << 12;
/// How often what went wrong is added.
const ROUNDS: usize = 60;
/// What went wrong that is added each time.
const MOST_WRONG: usize = 8;
/// A machine for one event that has more states is not small.
const MOST_STATES: usize = 16;
/// Steps of work for one search.
const WORK: u64 = 1_000_000;
/// Combinations with states of the large machine, for each of its states.
const MOST_PAIRS: usize = 4;

/// The machine of combinations, if it is smaller.
pub(super) fn side_by_side(mealy: &Mealy) -> Option<Mealy> {
    let mut inside = mealy.nearest(NEAREST);
    let mut parts: Vec<Part> = Vec::new();
    for event in telling(mealy) {
        let mut alone = vec![false; mealy.events as usize];
        alone[event as usize] = true;
        // One of those that are there may be able to answer this event, too.
        let found = parts.iter_mut().any(|part| {
            let mut both = part.events.clone();
            both[event as usize] = true;
            let found = answering(mealy, &both, &mut inside, part.machine.states());
            found.map(|machine| *part = Part { events: both, machine }).is_some()
        });
        if !found {
            let machine = answering(mealy, &alone, &mut inside, MOST_STATES)?;
            parts.push(Part { events: alone, machine });
            let combinations =
                parts.iter().try_fold(1usize, |product, part| product.checked_mul(part.machine.states()));
            if combinations.is_none_or(|combinations| combinations > mealy.states()) {
                return None;
            }
        }
    }
    let all: Vec<&Mealy> = parts.iter().map(|part| &part.machine).collect();
    let mut product = product(mealy, &all)?;
    // The largest first: what others can answer together needs no machine of its own.
    parts.sort_by_key(|part| std::cmp::Reverse(part.machine.states()));
    let mut kept: Vec<&Mealy> = parts.iter().map(|part| &part.machine).collect();
    let mut place = 0;
    while place < kept.len() {
        let part = kept.remove(place);
        match self::product(&product, &kept) {
            Some(smaller) => product = smaller,
            None => {
                kept.insert(place, part);
                place += 1;
            }
        }
    }
    (product.states() < mealy.states()).then_some(product)
}

/// Events to which there are several answers.
fn telling(mealy: &Mealy) -> Vec<u32> {
    let mut answers = vec![None; mealy.events as usize];
    let mut telling = vec![false; mealy.events as usize];
    for row in &mealy.rows {
        let event = row.event as usize;
        telling[event] |= *answers[event].get_or_insert(row.answer) != row.answer;
    }
    (0..mealy.events).filter(|&event| telling[event as usize]).collect()
}

/// A machine with at most so many states that answers these events right.
fn answering(mealy: &Mealy, events: &[bool], inside: &mut Vec<u32>, most: usize) -> Option<Mealy> {
    for _ in 0..ROUNDS {
        let small = at_most(&mealy.part(inside, events), most, WORK)?;
        let wrong = wrong(mealy, &small, events);
        if wrong.is_empty() {
            return Some(small);
        }
        inside.extend(wrong);
        inside.sort_unstable();
        inside.dedup();
        if inside.len() > MOST_INSIDE {
            return None;
        }
    }
    None
}

/// A machine, and the events that it answers right.
struct Part {
    events: Vec<bool>,
    machine: Mealy,
}

/// Follows a small machine through the large one: the states on the ways to what it does not know or gets wrong.
fn wrong(mealy: &Mealy, small: &Mealy, events: &[bool]) -> Vec<u32> {
    let index = |state: u32, class: u32| state as usize * small.states() + class as usize;
    let mut met = vec![false; mealy.states() * small.states()];
    met[index(mealy.initial, small.initial)] = true;
    let mut order = vec![(mealy.initial, small.initial, 0)];
    let mut head = 0;
    let mut places = Vec::new();
    while let Some(&(state, class, _)) = order.get(head) {
        let has_answer = |row: &&Row| row.next != NOWHERE || events[row.event as usize];
        for row in mealy.rows_of(state).iter().filter(has_answer) {
            let known = small.row(class, row.event);
            let Some(known) = known.filter(|known| !events[row.event as usize] || known.answer == row.answer)
            else {
                // A transition is known if both its ends are.
                places.push((head, row.next));
                continue;
            };
            if row.next != NOWHERE && !std::mem::replace(&mut met[index(row.next, known.next)], true) {
                order.push((row.next, known.next, head));
            }
        }
        head += 1;
        if places.len() >= MOST_WRONG {
            break;
        }
    }
    let mut wrong: Vec<u32> = places.iter().map(|place| place.1).filter(|&next| next != NOWHERE).collect();
    for (mut place, _) in places {
        loop {
            wrong.push(order[place].0);
            if place == 0 {
                break;
            }
            place = order[place].2;
        }
    }
    wrong
}

/// Machines side by side, followed through the large one; `None` if that tells too little for some answer, or splits states too often.
fn product(mealy: &Mealy, parts: &[&Mealy]) -> Option<Mealy> {
    let events = mealy.events as usize;
    let mut product = Product::default();
    let initial = product.number(parts.iter().map(|part| part.initial).collect(), events);
    let mut met: HashSet<(u32, u32), FxBuildHasher> = HashSet::default();
    met.insert((initial, mealy.initial));
    let mut open = vec![(initial, mealy.initial)];
    while let Some((class, state)) = open.pop() {
        product.members[class as usize].push(state);
        for row in mealy.rows_of(state) {
            let at = class as usize * events + row.event as usize;
            if *product.answer[at].get_or_insert(row.answer) != row.answer {
                return None;
            }
            if row.next == NOWHERE {
                continue;
            }
            if product.target[at] == NOWHERE {
                let places = &product.tuples[class as usize];
                let next = parts.iter().zip(places).map(|(part, &place)| part.next(place, row.event));
                let next: Option<Vec<u32>> = next.collect();
                product.target[at] = product.number(next?, events);
            }
            let pair = (product.target[at], row.next);
            if met.insert(pair) {
                open.push(pair);
            }
        }
        if met.len() > mealy.states() * MOST_PAIRS {
            return None;
        }
    }
    Some(mealy.quotient(&product.members, |class, row| {
        product.target[class as usize * events + row.event as usize]
    }))
}

/// Combinations of states that were reached: classes of states of the large machine.
#[derive(Default)]
struct Product {
    numbers: HashMap<Vec<u32>, u32, FxBuildHasher>,
    /// Per class the state of each machine.
    tuples: Vec<Vec<u32>>,
    members: Vec<Vec<u32>>,
    /// Per class and event.
    answer: Vec<Option<u32>>,
    /// Per class and event the class after it; [`NOWHERE`] if that is not known.
    target: Vec<u32>,
}

impl Product {
    fn number(&mut self, tuple: Vec<u32>, events: usize) -> u32 {
        let fresh = self.tuples.len() as u32;
        let number = *self.numbers.entry(tuple).or_insert_with_key(|tuple| {
            self.tuples.push(tuple.clone());
            fresh
        });
        if number == fresh {
            self.members.push(Vec::new());
            self.answer.resize(self.answer.len() + events, None);
            self.target.resize(self.target.len() + events, NOWHERE);
        }
        number
    }
}

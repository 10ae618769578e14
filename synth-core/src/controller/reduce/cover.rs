//! A small machine that does all that is specified, by merging from the initial state on.
//!
//! The new machine grows from one class with the initial state. What follows a class under an event is a set of states;
//! it goes into a class that is there, if that contains nothing incompatible, or becomes a class of its own. A class that
//! takes states passes their successors on to the classes that follow it. So states may end up in several classes, one
//! for each way to reach them: a *closed cover* (Paull and Unger, "Minimizing the number of states in incompletely
//! specified sequential switching functions", 1959), built as automata are learned (Lang, Pearlmutter and Price, "Results
//! of the Abbadingo One DFA learning competition", 1998), but with all incompatible pairs known beforehand.

use super::compatible::Matrix;
use super::mealy::{Mealy, NOWHERE};
use super::random::Random;
use std::collections::VecDeque;

/// How a search decides: what a class is charged for taking a set of states, and which set comes next.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Policy {
    /// The price of each state that some class takes.
    pub(super) growth: i64,
    /// The price of each state that some class then excludes.
    pub(super) exclusion: i64,
    /// The reward of each answer that a class has already.
    pub(super) evidence: i64,
    /// Prices are raised at random by less than this, which must not be 0.
    pub(super) jitter: u64,
    /// States that cannot be merged begin a class each before anything else is decided, and the next set is always one that
    /// fewest classes can take. Otherwise sets come in order of discovery.
    pub(super) constrained: bool,
    /// Of the random numbers.
    pub(super) seed: u64,
}

/// A transition that is to be decided.
struct Open {
    /// Class and event in one number.
    transition: u32,
    /// If the policy wants to know: the states after it, and as bits the classes that admit them.
    states: Vec<u32>,
    takers: Vec<u64>,
}

/// Classes of states, each a state of the new machine. A state may be in several.
pub(super) struct Cover<'a> {
    mealy: &'a Mealy,
    incompatible: &'a Matrix,
    policy: Policy,
    random: Random,
    words: usize,
    /// Per class its states.
    members: Vec<Vec<u32>>,
    /// Per class the same as bits.
    within: Vec<u64>,
    /// Per class, as bits, the states that some member is incompatible with.
    excluded: Vec<u64>,
    /// Per class and event the class after it; [`NOWHERE`] if that is not decided.
    target: Vec<u32>,
    /// Per class and event how many members specify it.
    specified: Vec<u32>,
    /// Per class and event whether a decision was asked for.
    listed: Vec<bool>,
    /// Undecided transitions, in order of discovery.
    open: VecDeque<Open>,
    /// The states that classes took since the last decision.
    log: Vec<(u32, u32)>,
    /// The excluded states of these classes before.
    saved: Vec<(u32, Vec<u64>)>,
    /// The answers in common since the last decision.
    evidence: i64,
    /// What was done so far, in rows and words looked at.
    work: u64,
}

/// A machine that was found.
pub(super) struct Found {
    /// Per class its states; the first is the initial class.
    pub(super) members: Vec<Vec<u32>>,
    /// Per class and event the class after it, [`NOWHERE`] if it has no row.
    pub(super) target: Vec<u32>,
}

/// Searches with one policy. Gives up when there would be `bound` classes or more, or `budget` is used up; what was used is
/// taken from it.
pub(super) fn search(
    mealy: &Mealy,
    incompatible: &Matrix,
    seeds: &[u32],
    policy: Policy,
    bound: usize,
    budget: &mut u64,
) -> Option<Found> {
    let mut cover = Cover::new(mealy, incompatible, policy);
    for &seed in seeds.iter().filter(|_| policy.constrained) {
        cover.add_class(&[seed]);
    }
    let initial = cover.begin();
    while !cover.open.is_empty() && cover.members.len() < bound && cover.work < *budget {
        cover.decide();
    }
    *budget = budget.saturating_sub(cover.work);
    let done = cover.open.is_empty() && cover.members.len() < bound;
    done.then(|| cover.needed(initial))
}

impl<'a> Cover<'a> {
    fn new(mealy: &'a Mealy, incompatible: &'a Matrix, policy: Policy) -> Self {
        Cover {
            mealy,
            incompatible,
            policy,
            random: Random::new(policy.seed),
            words: mealy.states().div_ceil(64),
            members: Vec::new(),
            within: Vec::new(),
            excluded: Vec::new(),
            target: Vec::new(),
            specified: Vec::new(),
            listed: Vec::new(),
            open: VecDeque::new(),
            log: Vec::new(),
            saved: Vec::new(),
            evidence: 0,
            work: 0,
        }
    }

    /// The class of the initial state.
    fn begin(&mut self) -> u32 {
        let initial = [self.mealy.initial];
        match self.cheapest(&initial, 0..self.members.len() as u32) {
            Some(class) => {
                let joined = self.join(class, &initial);
                debug_assert!(joined, "it was tried");
                self.commit();
                class
            }
            None => self.add_class(&initial),
        }
    }

    /// The class that takes these states at the lowest price.
    fn cheapest(&mut self, states: &[u32], classes: impl Iterator<Item = u32>) -> Option<u32> {
        let mut best: Option<(i64, u32)> = None;
        for class in classes {
            if let Some(price) = self.price(class, states)
                && best.is_none_or(|best| price < best.0)
            {
                best = Some((price, class));
            }
        }
        best.map(|(_, class)| class)
    }

    /// Where in the list of open transitions the next one is: that which fewest classes can take, the first of these.
    fn most_constrained(&mut self) -> usize {
        self.work += self.open.len() as u64 / 8;
        let takers = |open: &Open| open.takers.iter().map(|word| word.count_ones()).sum::<u32>();
        let fewest = self.open.iter().enumerate().min_by_key(|(_, open)| takers(open));
        fewest.map_or(0, |(place, _)| place)
    }

    /// Brings what is known of open transitions up to date: `old` of them were known when these classes changed. A class that could
    /// not take a set will never be able to, because both only grow.
    fn refresh(&mut self, old: usize, changed: &[u32]) {
        let mut changes = vec![0u64; self.members.len().div_ceil(64)];
        changed.iter().for_each(|class| changes[*class as usize / 64] |= 1 << (class % 64));
        let mut all = vec![!0; changes.len()];
        if let (Some(last), rest @ 1..) = (all.last_mut(), self.members.len() % 64) {
            *last = (1 << rest) - 1;
        }
        let has_changed = |class: u32| changes[class as usize / 64] >> (class % 64) & 1 == 1;
        let mut open = std::mem::take(&mut self.open);
        for (place, open) in open.iter_mut().enumerate() {
            let grown = place >= old || has_changed(open.transition / self.mealy.events);
            if grown {
                open.states = self.successors(open.transition);
            }
            if place >= old {
                open.takers = all.clone();
            }
            for (word, takers) in open.takers.iter_mut().enumerate() {
                let mut doubtful = if grown { *takers } else { *takers & changes[word] };
                while doubtful != 0 {
                    let bit = doubtful.trailing_zeros();
                    doubtful &= doubtful - 1;
                    if !self.admits(word as u32 * 64 + bit, &open.states) {
                        *takers &= !(1 << bit);
                    }
                }
            }
            self.work += 1;
        }
        self.open = open;
    }

    fn admits(&mut self, class: u32, states: &[u32]) -> bool {
        self.work += 1;
        states.iter().all(|&state| !has(&self.excluded, self.words, class, state))
    }

    /// The classes and states that are reached from the initial one: seeds, and what followed from them, may not be needed.
    fn needed(&self, initial: u32) -> Found {
        let events = self.mealy.events as usize;
        let mut number = vec![NOWHERE; self.members.len()];
        let mut found = Found { members: Vec::new(), target: Vec::new() };
        let mut within = vec![0; self.within.len()];
        let mut open = vec![(initial, self.mealy.initial)];
        while let Some((class, state)) = open.pop() {
            if has(&within, self.words, class, state) {
                continue;
            }
            within[class as usize * self.words + state as usize / 64] |= 1 << (state % 64);
            let number = &mut number[class as usize];
            if *number == NOWHERE {
                *number = found.members.len() as u32;
                found.members.push(Vec::new());
                found.target.extend(&self.target[class as usize * events..][..events]);
            }
            found.members[*number as usize].push(state);
            for row in self.mealy.rows_of(state).iter().filter(|row| row.next != NOWHERE) {
                open.push((self.target[class as usize * events + row.event as usize], row.next));
            }
        }
        for target in found.target.iter_mut().filter(|target| **target != NOWHERE) {
            *target = number[*target as usize];
        }
        found
    }

    /// Decides one transition: the class that takes its successors at the lowest price, or a new one.
    fn decide(&mut self) {
        let place = if self.policy.constrained { self.most_constrained() } else { 0 };
        let Some(Open { transition, states, takers }) = self.open.remove(place) else { return };
        let best = if self.policy.constrained {
            self.cheapest(&states, ones(&takers))
        } else {
            let states = self.successors(transition);
            self.cheapest(&states, 0..self.members.len() as u32)
        };
        let states = self.successors(transition);
        if let Some(class) = best {
            self.target[transition as usize] = class;
            // Once more, now that the transition passes on what its source takes.
            if self.join(class, &states) {
                return self.commit();
            }
            self.undo();
            self.target[transition as usize] = NOWHERE;
        }
        self.target[transition as usize] = self.add_class(&states);
    }

    fn add_class(&mut self, states: &[u32]) -> u32 {
        let class = self.members.len() as u32;
        let events = self.mealy.events as usize;
        self.members.push(Vec::new());
        self.within.resize(self.within.len() + self.words, 0);
        self.excluded.resize(self.excluded.len() + self.words, 0);
        self.target.resize(self.target.len() + events, NOWHERE);
        self.specified.resize(self.specified.len() + events, 0);
        self.listed.resize(self.listed.len() + events, false);
        for open in self.open.iter_mut().filter(|_| self.policy.constrained) {
            open.takers.resize(class as usize / 64 + 1, 0);
            open.takers[class as usize / 64] |= 1 << (class % 64);
        }
        let joined = self.join(class, states);
        debug_assert!(joined, "what follows compatible states is compatible");
        self.commit();
        class
    }

    /// The states after an event in a class.
    fn successors(&mut self, transition: u32) -> Vec<u32> {
        let (class, event) = (transition / self.mealy.events, transition % self.mealy.events);
        let members = &self.members[class as usize];
        let mut states: Vec<u32> =
            members.iter().filter_map(|&state| self.mealy.next(state, event)).collect();
        self.work += members.len() as u64;
        states.sort_unstable();
        states.dedup();
        states
    }

    /// What it costs that a class takes these states; `None` if it cannot.
    fn price(&mut self, class: u32, states: &[u32]) -> Option<i64> {
        if !self.admits(class, states) {
            return None;
        }
        let joined = self.join(class, states);
        let policy = self.policy;
        let mut price = self.log.len() as i64 * policy.growth - self.evidence * policy.evidence;
        if policy.exclusion != 0 {
            let lost = self.saved.iter().map(|(class, before)| {
                let now = &self.excluded[*class as usize * self.words..][..self.words];
                now.iter()
                    .zip(before)
                    .map(|(now, before)| i64::from((now & !before).count_ones()))
                    .sum::<i64>()
            });
            price += lost.sum::<i64>() * policy.exclusion;
        }
        self.undo();
        joined.then(|| price + self.random.below(policy.jitter as usize) as i64)
    }

    /// Adds states to a class, and what follows from that along decided transitions; whether all goes together. What was
    /// added stays in the log.
    fn join(&mut self, class: u32, states: &[u32]) -> bool {
        let mealy = self.mealy;
        let mut open: Vec<(u32, u32)> = states.iter().map(|&state| (class, state)).collect();
        while let Some((class, state)) = open.pop() {
            if has(&self.within, self.words, class, state) {
                continue;
            }
            if has(&self.excluded, self.words, class, state) {
                return false;
            }
            self.insert(class, state);
            for row in mealy.rows_of(state) {
                let transition = (class * mealy.events + row.event) as usize;
                self.evidence += i64::from(self.specified[transition] > 0);
                self.specified[transition] += 1;
                if self.target[transition] != NOWHERE {
                    open.push((self.target[transition], row.next));
                }
            }
        }
        true
    }

    fn insert(&mut self, class: u32, state: u32) {
        let at = class as usize * self.words;
        if !self.saved.iter().any(|(saved, _)| *saved == class) {
            self.saved.push((class, self.excluded[at..at + self.words].to_vec()));
        }
        self.members[class as usize].push(state);
        self.within[at + state as usize / 64] |= 1 << (state % 64);
        for (excluded, more) in self.excluded[at..].iter_mut().zip(self.incompatible.row(state)) {
            *excluded |= more;
        }
        self.log.push((class, state));
        self.work += self.mealy.rows_of(state).len() as u64 + self.words as u64 / 8 + 1;
    }

    /// Takes back what was added since the last decision.
    fn undo(&mut self) {
        let logged = std::mem::take(&mut self.log);
        for &(class, state) in logged.iter().rev() {
            self.members[class as usize].pop();
            self.within[class as usize * self.words + state as usize / 64] &= !(1 << (state % 64));
            for row in self.mealy.rows_of(state) {
                self.specified[(class * self.mealy.events + row.event) as usize] -= 1;
            }
        }
        for (class, before) in self.saved.drain(..) {
            self.excluded[class as usize * self.words..][..self.words].copy_from_slice(&before);
        }
        self.log = logged;
        self.log.clear();
        self.evidence = 0;
    }

    /// Keeps it, and asks for the decisions that it brings.
    fn commit(&mut self) {
        let old = self.open.len();
        for (class, state) in self.log.drain(..) {
            for row in self.mealy.rows_of(state).iter().filter(|row| row.next != NOWHERE) {
                let transition = class * self.mealy.events + row.event;
                if !std::mem::replace(&mut self.listed[transition as usize], true) {
                    self.open.push_back(Open { transition, states: Vec::new(), takers: Vec::new() });
                }
            }
        }
        let changed: Vec<u32> = self.saved.drain(..).map(|(class, _)| class).collect();
        if self.policy.constrained {
            self.refresh(old, &changed);
        }
        self.evidence = 0;
    }
}

fn has(bits: &[u64], words: usize, class: u32, state: u32) -> bool {
    bits[class as usize * words + state as usize / 64] >> (state % 64) & 1 == 1
}

fn ones(bits: &[u64]) -> impl Iterator<Item = u32> {
    (0..).zip(bits).flat_map(|(word, &bits)| {
        (0..64).filter(move |bit| bits >> bit & 1 == 1).map(move |bit| word * 64 + bit)
    })
}

//! The smallest controller for one event at a time, by exhaustive search: the yardstick for `--minimize ordered`.
//!
//! Written without a look at the minimiser: states that wait are numbered, sets of them are bits of a `u128`, and the search
//! decides one transition of the new machine after the other, the one with the fewest choices first. A machine with *k*
//! states is looked for with growing *k*, so what is found first is smallest.

use std::collections::{BTreeMap, BTreeSet};
use synth_core::controller::Controller;

/// What an event does in a state: the commands of all parts of its super step, and the state after it.
type Row = (u32, Vec<Vec<u32>>, usize);

/// The states that wait, as a Mealy machine.
struct Waiting {
    /// Per state its rows, by event.
    rows: Vec<Vec<Row>>,
    initial: usize,
    /// Per state the states that some sequence of events tells apart from it.
    apart: Vec<u128>,
}

/// Number of states of the controller that wait for events: those of its Mealy machine.
#[must_use]
pub fn mealy_states(controller: &Controller) -> usize {
    let acting: BTreeSet<u32> = controller.super_steps.source.iter().copied().collect();
    controller.states as usize - acting.len()
}

impl Waiting {
    fn of(controller: &Controller) -> Waiting {
        let due: BTreeMap<u32, usize> = controller.super_steps.source.iter().copied().zip(0..).collect();
        let waiting: Vec<u32> = (0..controller.states).filter(|state| !due.contains_key(state)).collect();
        let number: BTreeMap<u32, usize> = waiting.iter().copied().zip(0..).collect();
        let follow = |mut state: u32| {
            let mut answer = Vec::new();
            while let Some(&row) = due.get(&state) {
                answer.push(controller.super_steps.events[row].to_vec());
                state = controller.super_steps.target[row];
            }
            (answer, number[&state])
        };
        let mut rows = vec![Vec::new(); waiting.len()];
        for (event, mapping) in (0..).zip(&controller.environment) {
            for &(source, target) in mapping {
                let (answer, next) = follow(target);
                rows[number[&source]].push((event, answer, next));
            }
        }
        let initial = follow(controller.initial).1;
        let apart = apart(&rows);
        Waiting { rows, initial, apart }
    }

    fn row(&self, state: usize, event: u32) -> Option<&Row> {
        self.rows[state].iter().find(|row| row.0 == event)
    }
}

/// By going through all pairs until nothing changes.
fn apart(rows: &[Vec<Row>]) -> Vec<u128> {
    let mut apart = vec![0u128; rows.len()];
    loop {
        let mut changed = false;
        for a in 0..rows.len() {
            for b in (0..a).filter(|&b| b != a) {
                let differ = || {
                    rows[a].iter().any(|(event, answer, next)| {
                        let other = rows[b].iter().find(|row| row.0 == *event);
                        other.is_some_and(|row| row.1 != *answer || apart[*next] >> row.2 & 1 == 1)
                    })
                };
                if apart[a] >> b & 1 == 0 && differ() {
                    apart[a] |= 1 << b;
                    apart[b] |= 1 << a;
                    changed = true;
                }
            }
        }
        if !changed {
            return apart;
        }
    }
}

fn states(set: u128) -> impl Iterator<Item = usize> {
    (0..128).filter(move |&state| set >> state & 1 == 1)
}

/// A machine that is not finished.
#[derive(Clone)]
struct Machine {
    members: Vec<u128>,
    target: BTreeMap<(usize, u32), usize>,
}

struct Search<'a> {
    waiting: &'a Waiting,
    most: usize,
    /// Nodes of the search that are left.
    budget: usize,
}

impl Search<'_> {
    fn fits(&self, class: u128, set: u128) -> bool {
        states(set).all(|state| class & self.waiting.apart[state] == 0)
    }

    fn successors(&self, class: u128, event: u32) -> u128 {
        states(class).filter_map(|state| self.waiting.row(state, event)).fold(0, |set, row| set | 1 << row.2)
    }

    /// Adds states to a class and what follows to those that follow; whether that goes together.
    fn join(&self, machine: &mut Machine, class: usize, set: u128) -> bool {
        let mut open = vec![(class, set)];
        while let Some((class, set)) = open.pop() {
            let new = set & !machine.members[class];
            if new == 0 {
                continue;
            }
            if !self.fits(machine.members[class], new) {
                return false;
            }
            machine.members[class] |= new;
            for (&(_, event), &target) in machine.target.range((class, 0)..=(class, u32::MAX)) {
                open.push((target, self.successors(new, event)));
            }
        }
        true
    }

    /// Whether a machine that begins with these states can be finished, whichever the initial one is in.
    fn begin(&mut self, seeds: &Machine) -> Option<bool> {
        let initial = 1 << self.waiting.initial;
        for class in 0..=seeds.members.len().min(self.most - 1) {
            let mut machine = seeds.clone();
            machine.members.resize(machine.members.len().max(class + 1), 0);
            if self.join(&mut machine, class, initial) && self.finish(&machine)? {
                return Some(true);
            }
        }
        Some(false)
    }

    /// Whether the machine can be finished; `None` if the budget is used up.
    fn finish(&mut self, machine: &Machine) -> Option<bool> {
        self.budget = self.budget.checked_sub(1)?;
        let mut fewest: Option<(Vec<Machine>, usize, u32, u128)> = None;
        for class in 0..machine.members.len() {
            let events: BTreeSet<u32> = states(machine.members[class])
                .flat_map(|state| self.waiting.rows[state].iter().map(|row| row.0))
                .collect();
            for event in events.into_iter().filter(|&event| !machine.target.contains_key(&(class, event))) {
                let set = self.successors(machine.members[class], event);
                let mut choices = Vec::new();
                for target in 0..machine.members.len() {
                    if self.fits(machine.members[target], set) {
                        let mut chosen = machine.clone();
                        chosen.target.insert((class, event), target);
                        if self.join(&mut chosen, target, set) {
                            choices.push(chosen);
                        }
                    }
                }
                if fewest.as_ref().is_none_or(|fewest| choices.len() < fewest.0.len()) {
                    fewest = Some((choices, class, event, set));
                }
            }
        }
        let Some((choices, class, event, set)) = fewest else { return Some(true) };
        for choice in &choices {
            if self.finish(choice)? {
                return Some(true);
            }
        }
        if machine.members.len() == self.most {
            return Some(false);
        }
        let mut grown = machine.clone();
        grown.target.insert((class, event), grown.members.len());
        grown.members.push(0);
        let target = grown.members.len() - 1;
        if self.join(&mut grown, target, set) { self.finish(&grown) } else { Some(false) }
    }
}

/// The least number of states that wait for events in a controller which answers every event sequence as this one does where
/// this one accepts it; with the number of states of a set that no machine can merge. The first is `None` if that takes
/// more than `budget` nodes of search.
///
/// # Panics
///
/// If more than 128 states wait.
#[must_use]
pub fn smallest(controller: &Controller, budget: usize) -> (Option<usize>, usize) {
    let waiting = Waiting::of(controller);
    let count = waiting.rows.len();
    assert!(count <= 128, "{count} states wait");
    let mut clique: Vec<usize> = Vec::new();
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by_key(|&state| std::cmp::Reverse(waiting.apart[state].count_ones()));
    for state in order {
        if clique.iter().all(|&other| waiting.apart[state] >> other & 1 == 1) {
            clique.push(state);
        }
    }
    // No machine merges two of these, so each begins a state of its own.
    let seeds = Machine { members: clique.iter().map(|state| 1 << state).collect(), target: BTreeMap::new() };
    let mut left = budget;
    for most in clique.len().. {
        let mut search = Search { waiting: &waiting, most, budget: left };
        match search.begin(&seeds) {
            Some(true) => return (Some(most), clique.len()),
            Some(false) => left = search.budget,
            None => break,
        }
    }
    (None, clique.len())
}

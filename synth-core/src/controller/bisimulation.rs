//! The coarsest bisimulation: which states nothing can tell apart.
//!
//! At first all states are looked at over and over, in passes over the rows: a state's hash is made of its own and those of the
//! states to which its rows lead. That is done as long as it tells more and more states apart, which is soon over where few are to be merged.
//!
//! States with the same hash are in one *block* then, until something tells them apart: their kind, the labels that they have rows
//! of, or the blocks to which their rows lead, which together are a state's *signature*. Where a block falls apart, its largest part
//! keeps the number, so that only the predecessors of the others have new signatures: a state comes into a part with
//! another number at most `log n` times. (Jacobs and Wissmann, "Fast coalgebraic bisimilarity minimization", POPL 2023,
//! for automata whose states have rows.)

use super::Controller;
use super::kinds::Kinds;
use crate::intern::hash;
use crate::parallel::{each, fill, threads_for};
use rustc_hash::FxHasher;
use std::collections::VecDeque;
use std::hash::Hasher;
use std::iter::once;
use std::mem::swap;

/// The rows of a controller by state.
pub(super) struct Rows {
    /// The labels of rows, of which there is one of each for a state.
    pub(super) kinds: Kinds,
    /// Per state where its rows begin; one more entry ends the last.
    first: Vec<u32>,
    /// Where rows lead, in ascending order of their labels for each state.
    target: Vec<u32>,
}

impl Rows {
    /// On so many threads, or as many as the machine runs at once if that is 0.
    pub(super) fn new(controller: &Controller, threads: usize) -> Rows {
        // So few states that what is written of them stays in the cache, whatever the order.
        const STATES: usize = 1 << 14;
        let kinds = Kinds::of_all_rows(controller);
        let mut first = Vec::with_capacity(kinds.of.len() + 1);
        let mut rows = 0;
        first.push(0);
        for &kind in &kinds.of {
            rows += kinds.labels[kind as usize];
            first.push(rows);
        }
        let mut target = vec![0; rows as usize];
        let mut rest = &mut target[..];
        let mut parts = Vec::new();
        for begin in (0..kinds.of.len()).step_by(STATES) {
            let states = begin..kinds.of.len().min(begin + STATES);
            let (part, others) = rest.split_at_mut((first[states.end] - first[begin]) as usize);
            parts.push((states, part));
            rest = others;
        }
        let threads = threads_for(parts.len(), threads);
        let steps = &controller.super_steps;
        each(parts.into_iter(), threads, |(states, target)| {
            let mut next: Vec<u32> =
                first[states.clone()].iter().map(|row| row - first[states.start]).collect();
            let mut add = |from: u32, to: u32| {
                let place = &mut next[from as usize - states.start];
                target[*place as usize] = to;
                *place += 1;
            };
            let (begin, end) = (states.start as u32, states.end as u32);
            for rows in &controller.environment {
                let first = rows.partition_point(|row| row.0 < begin);
                rows[first..].iter().take_while(|row| row.0 < end).for_each(|row| add(row.0, row.1));
            }
            let first = steps.source.partition_point(|&source| source < begin);
            let rows = steps.source[first..].iter().zip(&steps.target[first..]);
            rows.take_while(|row| *row.0 < end).for_each(|(&source, &target)| add(source, target));
        });
        Rows { kinds, first, target }
    }

    pub(super) fn states(&self) -> usize {
        self.kinds.of.len()
    }

    /// Where the rows of a state lead.
    pub(super) fn of(&self, state: u32) -> &[u32] {
        &self.target[self.first[state as usize] as usize..self.first[state as usize + 1] as usize]
    }
}

/// Per state the first one of its class. The result does not depend on the number of threads, which is as for [`fill`].
pub(super) fn bisimulation(rows: &Rows, threads: usize) -> Vec<u32> {
    refine(rows, u64::MAX, threads)
}

/// Signatures are told apart by those bits of their hashes first, and in full where these are equal.
fn refine(rows: &Rows, bits: u64, threads: usize) -> Vec<u32> {
    let mut blocks = Blocks::new(rows.states() as u32, alike(rows, bits, threads));
    let mut parts = Parts::default();
    let mut into = None;
    while let Some(block) = blocks.suspects.pop_front() {
        blocks.split(block, rows, bits, &mut parts);
        if !parts.renumbered.is_empty() {
            let Incoming { first, sources } = into.get_or_insert_with(|| Incoming::new(rows, &blocks));
            for &state in &parts.renumbered {
                let of_state = first[state as usize] as usize..first[state as usize + 1] as usize;
                sources[of_state].iter().for_each(|&source| blocks.suspect(source));
            }
        }
    }
    blocks.classes()
}

/// Hashes of states that may be equal to those of others, and whose they are: hashes of all that is seen of a state in as many steps
/// as it takes until one more tells hardly any more of them apart.
fn alike(rows: &Rows, bits: u64, threads: usize) -> Vec<(u64, u32)> {
    const LEAST: usize = 1 << 14;
    let states = rows.states();
    let mut hashes: Vec<u64> = rows.kinds.of.iter().map(|kind| hash(kind) & bits).collect();
    let mut further = vec![0; states];
    let mut seen = Seen::new(states);
    let mut distinct = seen.set(&hashes);
    loop {
        fill(&mut further, LEAST, threads, |state| {
            let own = hashes[state];
            if seen.once(own) {
                return own;
            }
            let mut hasher = FxHasher::default();
            hasher.write_u64(own);
            rows.of(state as u32).iter().for_each(|&target| hasher.write_u64(hashes[target as usize]));
            hasher.finish() & bits
        });
        swap(&mut hashes, &mut further);
        let found = seen.set(&hashes);
        if found <= distinct + states / 64 {
            break;
        }
        distinct = found;
    }
    drop(further);
    (0..).zip(hashes).filter(|(_, hash)| !seen.once(*hash)).map(|(state, hash)| (hash, state)).collect()
}

/// Which of many hashes are there once, or not at all, for all that a few bits of each tell.
struct Seen {
    /// By the last bits of hashes: two bits for none, one, and more.
    counts: Vec<u64>,
}

impl Seen {
    /// For so many hashes, one in eight of which may have its bits in common with another one.
    fn new(hashes: usize) -> Seen {
        Seen { counts: vec![0; hashes.next_power_of_two().div_ceil(4)] }
    }

    /// The word of a hash, and the lower of its bits there.
    fn place(&self, hash: u64) -> (usize, u64) {
        ((hash >> 5) as usize & (self.counts.len() - 1), 1 << (2 * (hash & 31)))
    }

    /// Counts these hashes, and says how many differ, which is a little less than there are.
    fn set(&mut self, hashes: &[u64]) -> usize {
        self.counts.fill(0);
        let mut distinct = 0;
        for &hash in hashes {
            let (word, one) = self.place(hash);
            let counts = &mut self.counts[word];
            distinct += usize::from(*counts & (one | one << 1) == 0);
            *counts |= if *counts & one == 0 { one } else { one << 1 };
        }
        distinct
    }

    /// Whether no other hash of those counted is the same.
    fn once(&self, hash: u64) -> bool {
        let (word, one) = self.place(hash);
        self.counts[word] & (one << 1) == 0
    }
}

/// The rows that lead into each state from states that are not alone.
struct Incoming {
    /// Per state where its sources begin; one more entry ends the last.
    first: Vec<u32>,
    sources: Vec<u32>,
}

impl Incoming {
    fn new(rows: &Rows, blocks: &Blocks) -> Incoming {
        let states = rows.states();
        let targets =
            || blocks.order.iter().flat_map(|&source| rows.of(source).iter().map(move |&to| (source, to)));
        let mut first = vec![0; states + 1];
        targets().for_each(|(_, target)| first[target as usize + 1] += 1);
        for state in 0..states {
            first[state + 1] += first[state];
        }
        let mut next = first.clone();
        let mut sources = vec![0; first[states] as usize];
        for (source, target) in targets() {
            let place = &mut next[target as usize];
            sources[*place as usize] = source;
            *place += 1;
        }
        Incoming { first, sources }
    }
}

/// A partition of the states into blocks. Those of a block are contiguous in the order, suspects in front: the states whose
/// signature may have changed. All others of a block have the same.
struct Blocks {
    order: Vec<u32>,
    states: Vec<State>,
    blocks: Vec<Block>,
    /// The blocks with suspects, in the order in which they came to have some.
    suspects: VecDeque<u32>,
}

/// What is looked up together lies together.
#[derive(Clone, Copy)]
struct State {
    /// Where it is in the order.
    place: u32,
    block: u32,
}

/// `order[begin..end]`, of which `order[begin..trusted]` are suspects.
#[derive(Clone, Copy)]
struct Block {
    begin: u32,
    trusted: u32,
    end: u32,
}

impl Block {
    fn len(self) -> u32 {
        self.end - self.begin
    }
}

/// How a block falls apart; room for that.
#[derive(Default)]
struct Parts {
    /// Hashes of signatures, and whose they are.
    signed: Vec<(u64, u32)>,
    /// Per part the number of its states.
    sizes: Vec<u32>,
    /// The states that came into parts with other numbers.
    renumbered: Vec<u32>,
}

impl Blocks {
    /// A block for each hash that several states have, which are all suspects. Blocks of others are only numbers, behind them.
    fn new(states: u32, mut alike: Vec<(u64, u32)>) -> Blocks {
        alike.sort_unstable();
        let mut all = Blocks {
            order: Vec::with_capacity(alike.len()),
            states: (states..2 * states).map(|block| State { place: 0, block }).collect(),
            blocks: Vec::new(),
            suspects: VecDeque::new(),
        };
        for states in alike.chunk_by(|a, b| a.0 == b.0).filter(|states| states.len() > 1) {
            let (begin, block) = (all.order.len() as u32, all.blocks.len() as u32);
            for &(_, state) in states {
                all.states[state as usize] = State { place: all.order.len() as u32, block };
                all.order.push(state);
            }
            let end = all.order.len() as u32;
            all.blocks.push(Block { begin, trusted: end, end });
            all.suspects.push_back(block);
        }
        all
    }

    /// Per state the first one of its block.
    fn classes(mut self) -> Vec<u32> {
        let mut classes: Vec<u32> = (0..self.states.len() as u32).collect();
        for block in &self.blocks {
            let states = &mut self.order[block.begin as usize..block.end as usize];
            let first = states.iter().copied().min();
            states.iter().for_each(|&state| classes[state as usize] = first.unwrap_or(state));
        }
        classes
    }

    /// The signature of a state may have changed.
    fn suspect(&mut self, state: u32) {
        let State { place: from, block: number } = self.states[state as usize];
        let Some(block) = self.blocks.get_mut(number as usize) else { return };
        let to = block.trusted;
        // Known already, or alone: then there is nobody to be told apart from.
        if from < to || block.len() == 1 {
            return;
        }
        if to == block.begin {
            self.suspects.push_back(number);
        }
        block.trusted += 1;
        let other = self.order[to as usize];
        self.order[to as usize] = state;
        self.order[from as usize] = other;
        self.states[other as usize].place = from;
        self.states[state as usize].place = to;
    }

    /// The kind of a state and the blocks to which its rows lead.
    fn signature(&self, rows: &Rows, state: u32) -> impl Iterator<Item = u32> {
        let blocks = rows.of(state).iter().map(|&target| self.states[target as usize].block);
        once(rows.kinds.of[state as usize]).chain(blocks)
    }

    fn hash(&self, rows: &Rows, state: u32) -> u64 {
        let mut hasher = FxHasher::default();
        self.signature(rows, state).for_each(|number| hasher.write_u32(number));
        hasher.finish()
    }

    /// Splits a block by signatures, and says whose numbers changed.
    fn split(&mut self, number: u32, rows: &Rows, bits: u64, parts: &mut Parts) {
        let Parts { signed, sizes, renumbered } = parts;
        renumbered.clear();
        let Block { begin, trusted, end } = self.blocks[number as usize];
        self.blocks[number as usize].trusted = begin;
        // One of those without suspicion stands for all of them.
        let witness = (trusted < end).then(|| self.order[trusted as usize]);
        let looked_at = &self.order[begin as usize..(trusted + u32::from(witness.is_some())) as usize];
        let same = |other: &u32| self.signature(rows, *other).eq(self.signature(rows, looked_at[0]));
        if looked_at[1..].iter().all(same) {
            return;
        }
        let rest = end - begin - looked_at.len() as u32;
        signed.clear();
        signed.extend(looked_at.iter().map(|&state| (self.hash(rows, state) & bits, state)));
        let staying = self.group(rows, signed, witness, sizes);
        if let Some(staying) = staying {
            let before = sizes[..staying].iter().sum::<u32>() as usize;
            signed[before..].rotate_left(sizes[staying] as usize);
            sizes[staying..].rotate_left(1);
        }
        for (place, &(_, state)) in (begin..).zip(&*signed) {
            self.order[place as usize] = state;
            self.states[state as usize].place = place;
        }
        if let Some(last) = sizes.last_mut() {
            *last += rest;
        }
        let largest = sizes.iter().copied().max();
        let mut largest = sizes.iter().position(|&size| Some(size) == largest);
        let mut begin = begin;
        for (part, &size) in sizes.iter().enumerate() {
            let block = Block { begin, trusted: begin, end: begin + size };
            if largest == Some(part) {
                largest = None;
                self.blocks[number as usize] = block;
            } else {
                let new = self.blocks.len() as u32;
                self.blocks.push(block);
                for &state in &self.order[begin as usize..block.end as usize] {
                    self.states[state as usize].block = new;
                    renumbered.push(state);
                }
            }
            begin = block.end;
        }
    }

    /// Sorts states by signature into parts, whose sizes are the second result. Returns the part of the witness.
    fn group(
        &self,
        rows: &Rows,
        signed: &mut [(u64, u32)],
        witness: Option<u32>,
        sizes: &mut Vec<u32>,
    ) -> Option<usize> {
        let same = |a: &(u64, u32), b: &(u64, u32)| {
            a.0 == b.0 && self.signature(rows, a.1).eq(self.signature(rows, b.1))
        };
        signed.sort_unstable();
        for alike in signed.chunk_by_mut(|a, b| a.0 == b.0) {
            if !alike.iter().all(|other| same(&alike[0], other)) {
                alike.sort_by(|a, b| self.signature(rows, a.1).cmp(self.signature(rows, b.1)));
            }
        }
        sizes.clear();
        let mut staying = None;
        for part in signed.chunk_by(same) {
            if part.iter().any(|(_, state)| Some(*state) == witness) {
                staying = Some(sizes.len());
            }
            sizes.push(part.len() as u32);
        }
        staying
    }
}

#[cfg(test)]
mod tests {
    use super::super::fixtures::controllers;
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeMap;

    /// Per state the first one of its class, by refining all states until nothing changes.
    fn naive(rows: &Rows) -> Vec<usize> {
        let mut class: Vec<usize> = rows.kinds.of.iter().map(|&kind| kind as usize).collect();
        loop {
            let mut first = BTreeMap::new();
            let next: Vec<usize> = (0..class.len())
                .map(|state| {
                    let targets = rows.of(state as u32).iter().map(|&target| class[target as usize]);
                    *first.entry((class[state], targets.collect::<Vec<_>>())).or_insert(state)
                })
                .collect();
            if next == class {
                return class;
            }
            class = next;
        }
    }

    proptest! {
        /// Also if hashes hardly tell anything apart.
        #[test]
        fn it_is_the_coarsest(controller in controllers(24), bits in prop::sample::select(vec![0, 1, 6, u64::MAX])) {
            let rows = Rows::new(&controller, 1);
            let found = refine(&rows, bits, 1).into_iter().map(|state| state as usize);
            prop_assert_eq!(found.collect::<Vec<_>>(), naive(&rows));
        }
    }
}

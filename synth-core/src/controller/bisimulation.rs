//! The coarsest bisimulation: which states nothing can tell apart.
//!
//! States are in one block as long as nothing tells them apart. At first that is their kind, the labels that they have rows
//! of; then a state's *signature*, the blocks to which its rows lead. Where a block falls apart, its largest part
//! keeps the number, so that only the predecessors of the others have new signatures: a state comes into a part with
//! another number at most `log n` times. (Jacobs and Wissmann, "Fast coalgebraic bisimilarity minimization", POPL 2023,
//! for automata whose states have rows.)
//!
//! Beside numbers per state it holds one a row in either direction; and where nothing or little is left to be merged after
//! some steps, it comes to an end in few passes over the rows.

use super::Controller;
use super::kinds::Kinds;
use super::partition::bucket;
use rustc_hash::FxHasher;
use std::collections::VecDeque;
use std::hash::Hasher;

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
    pub(super) fn new(controller: &Controller) -> Rows {
        let kinds = Kinds::of_all_rows(controller);
        let mut first = Vec::with_capacity(kinds.of.len() + 1);
        let mut rows = 0;
        first.push(0);
        for &kind in &kinds.of {
            rows += kinds.labels[kind as usize];
            first.push(rows);
        }
        let mut next = first.clone();
        let mut target = vec![0; rows as usize];
        let steps = &controller.super_steps;
        let steps = steps.source.iter().copied().zip(steps.target.iter().copied());
        for (from, to) in controller.environment.iter().flatten().copied().chain(steps) {
            let place = &mut next[from as usize];
            target[*place as usize] = to;
            *place += 1;
        }
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

/// Per state its class; all numbers are below that of kinds and states together.
pub(super) fn bisimulation(rows: &Rows) -> Vec<u32> {
    refine(rows, u64::MAX)
}

/// Signatures are told apart by those bits of their hashes first, and in full where these are equal.
fn refine(rows: &Rows, bits: u64) -> Vec<u32> {
    let (incoming, sources) = incoming(rows);
    let mut blocks = Blocks::new(&rows.kinds);
    let mut parts = Parts::default();
    while let Some(block) = blocks.suspects.pop_front() {
        blocks.split(block, rows, bits, &mut parts);
        for &state in &parts.renumbered {
            let of_state = incoming[state as usize] as usize..incoming[state as usize + 1] as usize;
            sources[of_state].iter().for_each(|&source| blocks.suspect(source));
        }
    }
    blocks.states.into_iter().map(|state| state.block).collect()
}

/// The sources of the rows that lead into each state, and where those of a state begin.
fn incoming(rows: &Rows) -> (Vec<u32>, Vec<u32>) {
    let states = rows.states() as u32;
    let mut first = vec![0; states as usize + 1];
    rows.target.iter().for_each(|&target| first[target as usize + 1] += 1);
    for state in 1..first.len() {
        first[state] += first[state - 1];
    }
    let mut next = first.clone();
    let mut sources = vec![0; rows.target.len()];
    for source in 0..states {
        for &target in rows.of(source) {
            let place = &mut next[target as usize];
            sources[*place as usize] = source;
            *place += 1;
        }
    }
    (first, sources)
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
    /// A block for each kind. All states are suspects, but for those that are alone.
    fn new(kinds: &Kinds) -> Blocks {
        let (bounds, order) = bucket(&kinds.of, kinds.len() as u32);
        let mut states: Vec<State> = kinds.of.iter().map(|&block| State { place: 0, block }).collect();
        for (place, &state) in (0..).zip(&order) {
            states[state as usize].place = place;
        }
        let blocks: Vec<Block> =
            bounds.windows(2).map(|pair| Block { begin: pair[0], trusted: pair[1], end: pair[1] }).collect();
        let suspects =
            (0..).zip(&blocks).filter(|(_, block)| block.len() > 1).map(|(number, _)| number).collect();
        Blocks { order, states, blocks, suspects }
    }

    /// The signature of a state may have changed.
    fn suspect(&mut self, state: u32) {
        let State { place: from, block: number } = self.states[state as usize];
        let block = &mut self.blocks[number as usize];
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

    fn signature(&self, rows: &Rows, state: u32) -> impl Iterator<Item = u32> {
        rows.of(state).iter().map(|&target| self.states[target as usize].block)
    }

    fn hash(&self, rows: &Rows, state: u32) -> u64 {
        let mut hasher = FxHasher::default();
        self.signature(rows, state).for_each(|block| hasher.write_u32(block));
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
        let looked_at = begin as usize..(trusted + u32::from(witness.is_some())) as usize;
        let rest = end - looked_at.end as u32;
        signed.clear();
        signed.extend(self.order[looked_at].iter().map(|&state| (self.hash(rows, state) & bits, state)));
        let staying = self.group(rows, signed, witness, sizes);
        if sizes.len() == 1 {
            return;
        }
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
            let rows = Rows::new(&controller);
            let found = refine(&rows, bits);
            let mut first = BTreeMap::new();
            let first: Vec<usize> =
                (0..).zip(&found).map(|(state, class)| *first.entry(class).or_insert(state)).collect();
            prop_assert_eq!(first, naive(&rows));
        }
    }
}

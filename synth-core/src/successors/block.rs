//! The moves of consecutive states, as one thread notes them for all to number.
//!
//! While many states are looked at, no row gets a number. Rows that were known have one; those that are new are kept once, whatever
//! leads there, and numbered when the block is read, in the order of its edges. That is as if each edge had been followed
//! when it was found.

use super::moves::PackedMoves;
use super::rows::{PackedRows, hash_row};
use super::sets::SetId;
use crate::game::{KeySetsBuilder, Turn, hash_set};
use crate::index::{Index, WINDOW};
use crate::playout::EventId;
use std::ops::Range;

/// Where an edge leads before its row was looked up, or when it was not found.
const NONE: u32 = u32::MAX;

/// The states to look at next: `done` of those that were found have been looked at, and had so many edges. Where states have had many
/// edges they are fewer, as what is noted of them takes memory.
pub(crate) fn next_batch(done: usize, found: usize, edges: usize) -> Range<u32> {
    const STATES: usize = 1 << 14;
    const EDGES: usize = 1 << 18;
    let states = (EDGES * done / edges.max(1)).clamp(1, STATES);
    done as u32..found.min(done + states) as u32
}

/// What has numbers while states are looked at.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Known<'k> {
    pub(crate) rows: &'k PackedRows,
    pub(crate) sets: &'k KeySetsBuilder,
}

/// What is known of one state.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Head {
    pub(crate) turn: Turn,
    pub(crate) silent: bool,
    /// Nothing is known: it must be looked at again.
    pub(crate) missed: bool,
    /// The set of its open keys, for [`Reader::open`]; new ones count down from the greatest number, as learning may make more sets.
    open: SetId,
    /// Behind its last edge.
    end: u32,
}

/// One of its edges.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Found {
    pub(crate) event: EventId,
    pub(crate) discharged: SetId,
}

/// What is known of consecutive states.
#[derive(Debug, Default)]
pub(crate) struct Block {
    heads: Vec<Head>,
    edges: Vec<Found>,
    /// Per edge: the number of a row that was known, or behind how many were known, that of a new one.
    targets: Vec<u32>,
    known: u32,
    /// The new rows in the order in which edges lead there.
    new: New,
    /// The sets of open keys that had no number, in the order of the states, a bit for each key.
    new_sets: New,
    waiting: Waiting,
    waiting_sets: Waiting,
    /// Room to find moves, and a row.
    pub(crate) moves: PackedMoves,
    pub(crate) row: Vec<u64>,
}

/// Distinct rows that have no number yet.
#[derive(Debug, Default)]
struct New {
    /// Words of a row.
    length: usize,
    rows: Vec<u64>,
    hashes: Vec<u64>,
    index: Index,
}

impl New {
    fn clear(&mut self) {
        self.rows.clear();
        self.hashes.clear();
        self.index.clear();
    }

    /// Which of these a row is. Rows may become longer: words that were left out are 0.
    fn intern(&mut self, hash: u64, row: &[u64]) -> u32 {
        if self.length != row.len() {
            self.lengthen(row.len());
        }
        let New { rows, hashes, index, .. } = self;
        let is = |at: u32| rows[at as usize * row.len()..].iter().zip(row).all(|(one, other)| one == other);
        if let Some(at) = index.find(hash, is) {
            return at;
        }
        if !index.has_room() {
            *index = Index::with_room_for(hashes.len() + 1);
            (0..).zip(&*hashes).for_each(|(at, &hash)| index.insert(hash, at));
        }
        let at = hashes.len() as u32;
        index.insert(hash, at);
        hashes.push(hash);
        rows.extend_from_slice(row);
        at
    }

    #[cold]
    fn lengthen(&mut self, length: usize) {
        debug_assert!(length > self.length || self.rows.is_empty());
        let mut longer = Vec::with_capacity(self.hashes.len() * length);
        for row in self.rows.chunks(self.length.max(1)) {
            longer.extend_from_slice(row);
            longer.resize(longer.len() + length - row.len(), 0);
        }
        (self.rows, self.length) = (longer, length);
    }

    fn get(&self, at: usize) -> &[u64] {
        &self.rows[at * self.length..(at + 1) * self.length]
    }
}

/// Rows, or sets, that have not been looked up yet, side by side.
#[derive(Debug, Default)]
struct Waiting {
    /// For each the edge that leads there, or the state.
    places: Vec<u32>,
    hashes: Vec<u64>,
    words: Vec<u64>,
    found: Vec<u32>,
}

impl Waiting {
    fn clear(&mut self) {
        self.places.clear();
        self.hashes.clear();
        self.words.clear();
    }

    fn is_full(&self) -> bool {
        self.places.len() >= WINDOW
    }
}

impl Block {
    /// Forgets everything.
    pub(crate) fn clear(&mut self, known: Known<'_>) {
        self.heads.clear();
        self.edges.clear();
        self.targets.clear();
        self.known = known.rows.len() as u32;
        self.new.clear();
        self.new_sets.clear();
        self.waiting.clear();
        self.waiting_sets.clear();
    }

    /// Notes the next state, of which nothing is known.
    pub(crate) fn miss(&mut self) {
        let (turn, end) = (Turn::EnvironmentAny, self.edges.len() as u32);
        self.heads.push(Head { turn, silent: false, missed: true, open: 0, end });
    }

    /// Notes an edge of the next state, which leads to a row.
    pub(crate) fn add(&mut self, known: Known<'_>, edge: Found, row: impl IntoIterator<Item = u64>) {
        let Waiting { places, hashes, words, .. } = &mut self.waiting;
        let start = words.len();
        words.extend(row);
        hashes.push(hash_row(&words[start..]));
        places.push(self.edges.len() as u32);
        self.add_end(edge, NONE);
        if self.waiting.is_full() {
            self.look_up_rows(known.rows);
        }
    }

    /// Notes an edge of the next state, which leads to something beyond all numbers of rows.
    pub(crate) fn add_end(&mut self, edge: Found, target: u32) {
        self.edges.push(edge);
        self.targets.push(target);
    }

    /// Notes the next state; its edges have been added.
    pub(crate) fn push(&mut self, known: Known<'_>, moves: &PackedMoves) {
        let keys = moves.open_keys();
        let Waiting { places, words, .. } = &self.waiting_sets;
        // All that wait have as many words.
        if self.waiting_sets.is_full() || words.len() != places.len() * keys.len() {
            self.look_up_sets(known.sets);
        }
        let Waiting { places, hashes, words, .. } = &mut self.waiting_sets;
        words.extend_from_slice(keys);
        hashes.push(hash_set(keys));
        places.push(self.heads.len() as u32);
        let (turn, silent, end) = (moves.turn, moves.silent, self.edges.len() as u32);
        self.heads.push(Head { turn, silent, missed: false, open: NONE, end });
    }

    /// Looks up where the edges added last lead, and what is open in the states noted last. Only then can the block be read.
    pub(crate) fn look_up(&mut self, known: Known<'_>) {
        self.look_up_rows(known.rows);
        self.look_up_sets(known.sets);
    }

    fn look_up_rows(&mut self, known: &PackedRows) {
        let Waiting { places, hashes, words, found } = &mut self.waiting;
        known.find_all(hashes, words, NONE, found);
        let rows = hashes.iter().zip(words.chunks_exact(known.words()));
        for ((&edge, &id), (&hash, row)) in places.iter().zip(&*found).zip(rows) {
            self.targets[edge as usize] =
                if id == NONE { self.known + self.new.intern(hash, row) } else { id };
        }
        self.waiting.clear();
    }

    fn look_up_sets(&mut self, known: &KeySetsBuilder) {
        let Waiting { places, hashes, words, .. } = &mut self.waiting_sets;
        known.fetch(hashes);
        let length = words.len() / places.len().max(1);
        for (index, (&state, &hash)) in places.iter().zip(&*hashes).enumerate() {
            let keys = &words[index * length..(index + 1) * length];
            let new = || SetId::MAX - self.new_sets.intern(hash, keys);
            self.heads[state as usize].open = known.find_hashed(hash, keys).unwrap_or_else(new);
        }
        self.waiting_sets.clear();
    }

    pub(crate) fn heads(&self) -> &[Head] {
        &self.heads
    }

    /// Bytes of what was noted of states and edges. What new rows take depends on how many blocks there are; it is at most
    /// about as much again, and batches are small.
    pub(crate) fn memory(&self) -> usize {
        self.heads.len() * size_of::<Head>() + self.edges.len() * (size_of::<Found>() + size_of::<u32>())
    }
}

/// Reads a block, state by state and edge by edge.
#[derive(Debug)]
pub(crate) struct Reader<'b> {
    block: &'b Block,
    head: usize,
    edge: usize,
    target: usize,
    /// The numbers that new rows, and new sets, have been given.
    numbers: Vec<u32>,
    sets: Vec<SetId>,
}

impl<'b> Reader<'b> {
    pub(crate) fn new(block: &'b Block) -> Self {
        Reader { block, head: 0, edge: 0, target: 0, numbers: Vec::new(), sets: Vec::new() }
    }

    /// The next state, and its edges for [`Reader::target`].
    pub(crate) fn state(&mut self) -> Option<(Head, &'b [Found])> {
        let head = *self.block.heads.get(self.head)?;
        self.head += 1;
        let edges = &self.block.edges[self.edge..head.end as usize];
        self.edge = head.end as usize;
        Some((head, edges))
    }

    /// The set of a state's open keys; one that is new gets its number now.
    pub(crate) fn open(&mut self, head: Head, sets: &mut KeySetsBuilder) -> SetId {
        let New { hashes, .. } = &self.block.new_sets;
        let at = (SetId::MAX - head.open) as usize;
        if at >= hashes.len() {
            return head.open;
        }
        // They come in their order.
        if at == self.sets.len() {
            if at.is_multiple_of(WINDOW) {
                sets.fetch(&hashes[at..hashes.len().min(at + WINDOW)]);
            }
            self.sets.push(sets.intern_hashed(hashes[at], self.block.new_sets.get(at)));
        }
        self.sets[at]
    }

    /// Where the next edge leads; a row that is new gets its number now.
    #[inline]
    pub(crate) fn target(&mut self, rows: &mut PackedRows) -> u32 {
        let target = self.block.targets[self.target];
        self.target += 1;
        let at = target.wrapping_sub(self.block.known) as usize;
        if at >= self.block.new.hashes.len() {
            return target;
        }
        // They come in their order.
        if at == self.numbers.len() {
            let New { hashes, .. } = &self.block.new;
            if at.is_multiple_of(WINDOW) {
                rows.fetch(&hashes[at..hashes.len().min(at + WINDOW)]);
            }
            self.numbers.push(rows.intern(hashes[at], self.block.new.get(at)));
        }
        self.numbers[at]
    }
}

/// The states of consecutive blocks; those of which nothing was known come from one more block, in which they were noted when they
/// had been looked at again.
#[derive(Debug)]
pub(crate) struct InOrder<'b> {
    blocks: std::slice::Iter<'b, Block>,
    reader: Option<Reader<'b>>,
    again: Reader<'b>,
}

impl<'b> InOrder<'b> {
    pub(crate) fn new(blocks: &'b [Block], again: &'b Block) -> Self {
        let mut blocks = blocks.iter();
        let reader = blocks.next().map(Reader::new);
        InOrder { blocks, reader, again: Reader::new(again) }
    }

    /// The next state, its edges, and who tells what is open there and where they lead.
    pub(crate) fn next(&mut self) -> Option<(Head, &'b [Found], &mut Reader<'b>)> {
        loop {
            if let Some((head, edges)) = self.reader.as_mut()?.state() {
                if head.missed {
                    let (head, edges) = self.again.state()?;
                    return Some((head, edges, &mut self.again));
                }
                return Some((head, edges, self.reader.as_mut()?));
            }
            self.reader = self.blocks.next().map(Reader::new);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::collection::vec;
    use proptest::prelude::{prop_assert_eq, proptest};

    #[test]
    fn states_with_many_edges_come_in_small_batches() {
        assert_eq!(next_batch(0, 1, 0), 0..1);
        assert_eq!(next_batch(100, 100_000, 1600), 100..100 + (1 << 14));
        assert_eq!(next_batch(100, 200, 1600), 100..200);
        assert_eq!(next_batch(1, 4504, 4503), 1..59);
        assert_eq!(next_batch(2, 9, 1 << 20), 2..3);
    }

    #[test]
    fn sets_may_become_longer() {
        let mut new = New::default();
        let rows: [&[u64]; 6] = [&[1], &[2], &[1], &[0, 1], &[1, 1], &[0, 1]];
        assert_eq!(rows.map(|row| new.intern(hash_row(row), row)), [0, 1, 0, 2, 3, 2]);
        assert_eq!([0, 1, 2, 3].map(|at| new.get(at).to_vec()), [[1, 0], [2, 0], [0, 1], [1, 1]]);
    }

    proptest! {
        /// Numbers are those of following each edge at once, whatever is in which block, and whatever sets learning makes while a
        /// block is filled.
        #[test]
        fn numbers_are_those_of_one_search(
            known in vec(0..300_u64, 0..100),
            first in vec(vec(0..300_u64, 0..5), 0..600),
            second in vec(vec(0..300_u64, 0..5), 0..300),
            learned in vec(0..300_u64, 0..3),
        ) {
            const END: u32 = u32::MAX - 1;
            let mut rows = PackedRows::new(2, 0);
            let mut expected = PackedRows::new(2, 0);
            for row in &known {
                rows.intern(hash_row(&[*row]), &[*row]);
                expected.intern(hash_row(&[*row]), &[*row]);
            }
            let (mut sets, mut expected_sets) = (KeySetsBuilder::default(), KeySetsBuilder::default());
            let blocks = [first, second].map(|states| {
                let mut block = Block::default();
                block.clear(Known { rows: &rows, sets: &sets });
                let mut moves = PackedMoves::default();
                for (state, edges) in states.iter().enumerate() {
                    let known = Known { rows: &rows, sets: &sets };
                    for &row in edges {
                        let edge = Found { event: row as u32, discharged: 0 };
                        if row == 0 { block.add_end(edge, END) } else { block.add(known, edge, [row]) }
                    }
                    let Some(&keys) = edges.last() else {
                        block.miss();
                        continue;
                    };
                    // There are more keys from some state on.
                    moves.open_keys = if state < 100 { vec![keys] } else { vec![keys, keys & 1] };
                    block.push(known, &moves);
                    // Learning may be the first to number a set that the block has noted.
                    for &keys in &learned {
                        prop_assert_eq!(sets.intern_bits(&[keys]), expected_sets.intern_bits(&[keys]));
                    }
                }
                block.look_up(Known { rows: &rows, sets: &sets });
                Ok((states, block))
            });
            for block in blocks {
                let (states, block) = block?;
                let mut reader = Reader::new(&block);
                for (state, edges) in states.iter().enumerate() {
                    let (head, found) = reader.state().expect("as many states");
                    prop_assert_eq!((head.missed, found.len()), (edges.is_empty(), edges.len()));
                    if let Some(&keys) = edges.last() {
                        let keys = if state < 100 { vec![keys] } else { vec![keys, keys & 1] };
                        prop_assert_eq!(reader.open(head, &mut sets), expected_sets.intern_bits(&keys));
                    }
                    for (&row, found) in edges.iter().zip(found) {
                        let number = if row == 0 { END } else { expected.intern(hash_row(&[row]), &[row]) };
                        prop_assert_eq!((found.event, reader.target(&mut rows)), (row as u32, number));
                    }
                }
                prop_assert_eq!(reader.state().map(|(head, _)| head.missed), None);
            }
            prop_assert_eq!(rows.len(), expected.len());
            prop_assert_eq!(sets.len(), expected_sets.len());
        }
    }
}

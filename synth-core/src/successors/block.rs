//! The moves of consecutive states, as one thread notes them for all to number.
//!
//! While many states are looked at, no row gets a number. Rows that were known have one; those that are new are kept once, whatever
//! leads there, and numbered when the block is read, in the order of its edges. That is as if each edge had been followed
//! when it was found.

use super::UNKNOWN_SET;
use super::index::Index;
use super::moves::PackedMoves;
use super::rows::{PackedRows, hash_row};
use super::sets::SetId;
use crate::game::Turn;
use crate::playout::EventId;

/// So many rows are looked up at a time.
const WINDOW: usize = 256;

/// Where an edge leads before its row was looked up, or when it was not found.
const NONE: u32 = u32::MAX;

/// What is known of one state.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Head {
    pub(crate) turn: Turn,
    pub(crate) silent: bool,
    /// Nothing is known: it must be looked at again.
    pub(crate) missed: bool,
    /// The set of its open keys, or [`UNKNOWN_SET`].
    pub(crate) open: SetId,
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
    /// The new rows in the order in which edges lead there, and their hashes.
    rows: Vec<u64>,
    hashes: Vec<u64>,
    index: Index,
    waiting: Waiting,
    /// Room to find moves, and a row.
    pub(crate) moves: PackedMoves,
    pub(crate) row: Vec<u64>,
}

/// Rows that have not been looked up yet.
#[derive(Debug, Default)]
struct Waiting {
    /// Per row: the edge that leads there.
    edges: Vec<u32>,
    hashes: Vec<u64>,
    rows: Vec<u64>,
    found: Vec<u32>,
}

impl Waiting {
    fn clear(&mut self) {
        self.edges.clear();
        self.hashes.clear();
        self.rows.clear();
    }
}

impl Block {
    /// Forgets everything; so many rows are known.
    pub(crate) fn clear(&mut self, known: &PackedRows) {
        self.heads.clear();
        self.edges.clear();
        self.targets.clear();
        self.known = known.len() as u32;
        self.rows.clear();
        self.hashes.clear();
        self.index.clear();
        self.waiting.clear();
    }

    /// Notes the next state, of which nothing is known.
    pub(crate) fn miss(&mut self) {
        let (turn, open, end) = (Turn::EnvironmentAny, UNKNOWN_SET, self.edges.len() as u32);
        self.heads.push(Head { turn, silent: false, missed: true, open, end });
    }

    /// Notes an edge of the next state, which leads to a row.
    pub(crate) fn add(&mut self, known: &PackedRows, edge: Found, row: impl IntoIterator<Item = u64>) {
        let Waiting { edges, hashes, rows, .. } = &mut self.waiting;
        let start = rows.len();
        rows.extend(row);
        hashes.push(hash_row(&rows[start..]));
        edges.push(self.edges.len() as u32);
        let is_full = edges.len() == WINDOW;
        self.add_end(edge, NONE);
        if is_full {
            self.look_up(known);
        }
    }

    /// Notes an edge of the next state, which leads to something beyond all numbers of rows.
    pub(crate) fn add_end(&mut self, edge: Found, target: u32) {
        self.edges.push(edge);
        self.targets.push(target);
    }

    /// Notes the next state; its edges have been added.
    pub(crate) fn push(&mut self, turn: Turn, silent: bool, open: SetId) {
        let end = self.edges.len() as u32;
        self.heads.push(Head { turn, silent, missed: false, open, end });
    }

    /// Looks up where the edges added last lead. Only then can the block be read.
    pub(crate) fn look_up(&mut self, known: &PackedRows) {
        let mut waiting = std::mem::take(&mut self.waiting);
        let Waiting { edges, hashes, rows, found } = &mut waiting;
        known.find_all(hashes, rows, NONE, found);
        let rows = hashes.iter().zip(rows.chunks_exact(known.words()));
        for ((&edge, &id), (&hash, row)) in edges.iter().zip(&*found).zip(rows) {
            self.targets[edge as usize] = if id == NONE { self.known + self.new_row(hash, row) } else { id };
        }
        waiting.clear();
        self.waiting = waiting;
    }

    /// The number of a new row among those of the block.
    fn new_row(&mut self, hash: u64, row: &[u64]) -> u32 {
        let Block { rows, hashes, index, .. } = self;
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

    pub(crate) fn heads(&self) -> &[Head] {
        &self.heads
    }

    /// Bytes held.
    pub(crate) fn memory(&self) -> usize {
        let Waiting { edges, hashes, rows, found } = &self.waiting;
        self.heads.capacity() * size_of::<Head>()
            + self.edges.capacity() * size_of::<Found>()
            + (self.targets.capacity() + edges.capacity() + found.capacity()) * size_of::<u32>()
            + (self.rows.capacity() + self.hashes.capacity() + rows.capacity() + hashes.capacity())
                * size_of::<u64>()
            + self.index.memory()
    }
}

/// Reads a block, state by state and edge by edge.
#[derive(Debug)]
pub(crate) struct Reader<'b> {
    block: &'b Block,
    head: usize,
    edge: usize,
    target: usize,
    /// The numbers that new rows have been given.
    numbers: Vec<u32>,
}

impl<'b> Reader<'b> {
    pub(crate) fn new(block: &'b Block) -> Self {
        Reader { block, head: 0, edge: 0, target: 0, numbers: Vec::with_capacity(block.hashes.len()) }
    }

    /// The next state, and its edges for [`Reader::target`].
    pub(crate) fn state(&mut self) -> Option<(Head, &'b [Found])> {
        let head = *self.block.heads.get(self.head)?;
        self.head += 1;
        let edges = &self.block.edges[self.edge..head.end as usize];
        self.edge = head.end as usize;
        Some((head, edges))
    }

    /// Where the next edge leads; a row that is new gets its number now.
    #[inline]
    pub(crate) fn target(&mut self, rows: &mut PackedRows) -> u32 {
        let target = self.block.targets[self.target];
        self.target += 1;
        let at = target.wrapping_sub(self.block.known) as usize;
        if at >= self.block.hashes.len() {
            return target;
        }
        if at == self.numbers.len() {
            self.number(rows);
        }
        self.numbers[at]
    }

    /// Gives the next new row its number. They come in their order.
    fn number(&mut self, rows: &mut PackedRows) {
        let Block { rows: new, hashes, .. } = self.block;
        let (at, words) = (self.numbers.len(), rows.words());
        if at.is_multiple_of(WINDOW) {
            rows.fetch(&hashes[at..hashes.len().min(at + WINDOW)]);
        }
        self.numbers.push(rows.intern(hashes[at], &new[at * words..(at + 1) * words]));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::collection::vec;
    use proptest::prelude::{prop_assert_eq, proptest};

    proptest! {
        /// Numbers are those of following each edge at once, whatever is in which block.
        #[test]
        fn numbers_are_those_of_one_search(
            known in vec(0..300_u64, 0..100),
            first in vec(vec(0..300_u64, 0..5), 0..300),
            second in vec(vec(0..300_u64, 0..5), 0..300),
        ) {
            const END: u32 = u32::MAX - 1;
            let mut rows = PackedRows::new(2, 0);
            let mut expected = PackedRows::new(2, 0);
            for row in &known {
                rows.intern(hash_row(&[*row]), &[*row]);
                expected.intern(hash_row(&[*row]), &[*row]);
            }
            let blocks = [first, second].map(|states| {
                let mut block = Block::default();
                block.clear(&rows);
                for edges in &states {
                    for &row in edges {
                        let edge = Found { event: row as u32, discharged: 0 };
                        if row == 0 { block.add_end(edge, END) } else { block.add(&rows, edge, [row]) }
                    }
                    if edges.is_empty() { block.miss() } else { block.push(Turn::SystemUrgent, true, 3) }
                }
                block.look_up(&rows);
                (states, block)
            });
            for (states, block) in &blocks {
                let mut reader = Reader::new(block);
                for edges in states {
                    let (head, found) = reader.state().expect("as many states");
                    prop_assert_eq!((head.missed, found.len()), (edges.is_empty(), edges.len()));
                    for (&row, found) in edges.iter().zip(found) {
                        let number = if row == 0 { END } else { expected.intern(hash_row(&[row]), &[row]) };
                        prop_assert_eq!((found.event, reader.target(&mut rows)), (row as u32, number));
                    }
                }
                prop_assert_eq!(reader.state().map(|(head, _)| head.missed), None);
            }
            prop_assert_eq!(rows.len(), expected.len());
        }
    }
}

//! The moves of many states at once, found by several threads.
//!
//! While a batch is looked at nothing changes: the tables and the states are read, and each thread notes for a part of the
//! batch what it finds. States that are new have no number yet, and neither have those whose moves the tables do not give.
//! Both are seen to afterwards, in the order of the states, so that all numbers are those of a search that takes one state
//! after the other.

use crate::game::{KeySetsBuilder, Turn};
use crate::parallel;
use crate::playout::EventId;
use crate::successors::{PackedMoves, SetId, StateId, StateStore, UNKNOWN_SET, hash_row};
use std::ops::Range;

/// Fewer states are not worth another thread.
const LEAST_SHARE: usize = 512;

/// Stands for the losing and the won state until all others have their numbers.
pub(super) const LOST: u32 = u32::MAX;
pub(super) const WON: u32 = u32::MAX - 1;

/// Stands for a state that was not known when the batch began.
const NEW: u32 = u32::MAX - 2;

/// What is known of one state of the batch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Head {
    pub(super) turn: Turn,
    pub(super) silent: bool,
    /// The tables do not give its moves.
    pub(super) missed: bool,
    /// The game's set of open keys, or [`UNKNOWN_SET`] if it had none like this when the batch began.
    pub(super) open: SetId,
    edges: u32,
}

/// One of its edges.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    pub(super) event: EventId,
    pub(super) discharged: SetId,
    target: u32,
}

/// Where an edge leads.
#[derive(Clone, Copy, Debug)]
pub(super) enum Target<'b> {
    /// To a state that was known, or to [`LOST`] or [`WON`].
    Known(u32),
    /// To a row with this hash.
    New(u64, &'b [u64]),
}

/// The moves of consecutive states.
#[derive(Debug, Default)]
pub(super) struct Block {
    heads: Vec<Head>,
    edges: Vec<Found>,
    /// Of the edges that lead to something new: hash and row.
    hashes: Vec<u64>,
    rows: Vec<u64>,
    moves: PackedMoves,
}

impl Block {
    pub(super) fn clear(&mut self) {
        self.heads.clear();
        self.edges.clear();
        self.hashes.clear();
        self.rows.clear();
    }

    fn fill(&mut self, store: &StateStore, sets: &KeySetsBuilder, states: Range<StateId>) {
        self.clear();
        let mut moves = std::mem::take(&mut self.moves);
        let mut row = Vec::new();
        for state in states {
            if store.successors.moves_and_keys(store.rows.get(state, &mut row), &mut moves).is_ok() {
                self.add(store, sets, &moves);
            } else {
                let (turn, open) = (Turn::EnvironmentAny, UNKNOWN_SET);
                self.heads.push(Head { turn, silent: false, missed: true, open, edges: 0 });
            }
        }
        self.moves = moves;
    }

    /// Notes the moves of the next state.
    pub(super) fn add(&mut self, store: &StateStore, sets: &KeySetsBuilder, moves: &PackedMoves) {
        let PackedMoves { turn, silent, .. } = *moves;
        let open = sets.find_bits(moves.open_keys()).unwrap_or(UNKNOWN_SET);
        let edges = moves.edges().len() as u32;
        self.heads.push(Head { turn, silent, missed: false, open, edges });
        for edge in moves.edges() {
            let target = match edge.end {
                None => {
                    let row = moves.target(edge);
                    let hash = hash_row(row);
                    store.rows.find(hash, row).unwrap_or_else(|| {
                        self.hashes.push(hash);
                        self.rows.extend_from_slice(row);
                        NEW
                    })
                }
                Some(Turn::Won) => WON,
                Some(_) => LOST,
            };
            self.edges.push(Found { event: edge.event, discharged: edge.discharged, target });
        }
    }

    pub(super) fn heads(&self) -> &[Head] {
        &self.heads
    }

    pub(super) fn memory(&self) -> usize {
        self.heads.capacity() * size_of::<Head>()
            + self.edges.capacity() * size_of::<Found>()
            + (self.hashes.capacity() + self.rows.capacity()) * size_of::<u64>()
    }
}

/// Reads a block, state by state.
#[derive(Debug)]
pub(super) struct Reader<'b> {
    block: &'b Block,
    words: usize,
    head: usize,
    edge: usize,
    new: usize,
}

impl<'b> Reader<'b> {
    pub(super) fn new(block: &'b Block, words: usize) -> Self {
        Reader { block, words, head: 0, edge: 0, new: 0 }
    }

    /// The next state, and its edges for [`Reader::target`].
    pub(super) fn state(&mut self) -> Option<(Head, &'b [Found])> {
        let head = *self.block.heads.get(self.head)?;
        self.head += 1;
        let edges = &self.block.edges[self.edge..self.edge + head.edges as usize];
        self.edge += head.edges as usize;
        Some((head, edges))
    }

    /// Where the next edge leads.
    pub(super) fn target(&mut self, edge: &Found) -> Target<'b> {
        if edge.target != NEW {
            return Target::Known(edge.target);
        }
        let row = &self.block.rows[self.new * self.words..(self.new + 1) * self.words];
        self.new += 1;
        Target::New(self.block.hashes[self.new - 1], row)
    }
}

/// Fills blocks with the moves of these states; how many blocks have been filled. `threads` as in [`parallel::share`].
pub(super) fn fill(
    blocks: &mut Vec<Block>,
    store: &StateStore,
    sets: &KeySetsBuilder,
    states: Range<StateId>,
    threads: usize,
) -> usize {
    parallel::share(blocks, states, LEAST_SHARE, threads, |block, part| block.fill(store, sets, part))
}

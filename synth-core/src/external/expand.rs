//! The moves of many rows, found by several threads.

use super::counts::Counts;
use crate::successors::{PackedMoves, Successors};
use std::num::NonZeroUsize;
use std::thread;

/// Fewer rows are not worth another thread.
const LEAST_SHARE: usize = 512;

/// What was found of consecutive rows.
#[derive(Debug, Default)]
pub(super) struct Block {
    pub(super) counts: Counts,
    /// The rows that they lead to.
    pub(super) rows: Vec<u64>,
    /// The rows whose moves the tables do not give, by their place in the batch.
    pub(super) missed: Vec<usize>,
    moves: PackedMoves,
}

impl Block {
    pub(super) fn clear(&mut self) {
        self.counts.clear();
        self.rows.clear();
        self.missed.clear();
    }

    pub(super) fn memory(&self) -> usize {
        self.rows.capacity() * size_of::<u64>() + self.missed.capacity() * size_of::<usize>()
    }

    fn fill(&mut self, successors: &Successors, rows: &[u64], first: usize) {
        self.clear();
        for (place, row) in (first..).zip(rows.chunks_exact(successors.layout().words())) {
            if successors.moves(row, &mut self.moves).is_ok() {
                self.counts.add(successors, row, &self.moves, &mut self.rows);
            } else {
                self.missed.push(place);
            }
        }
    }
}

/// Fills blocks with the moves of a batch, on at most so many threads, or as many as the machine runs at once if that is 0;
/// how many blocks have been filled.
pub(super) fn fill(blocks: &mut Vec<Block>, successors: &Successors, batch: &[u64], threads: usize) -> usize {
    let words = successors.layout().words();
    let rows = batch.len() / words;
    let threads = match (rows / LEAST_SHARE).max(1) {
        1 => 1,
        most if threads == 0 => most.min(thread::available_parallelism().map_or(1, NonZeroUsize::get)),
        most => most.min(threads),
    };
    blocks.resize_with(blocks.len().max(threads), Block::default);
    let share = rows.div_ceil(threads);
    let part = |index: usize| {
        let start = (share * index).min(rows);
        let end = (start + share).min(rows);
        (start, &batch[start * words..end * words])
    };
    let (first, others) = blocks[..threads].split_at_mut(1);
    thread::scope(|scope| {
        for (index, block) in others.iter_mut().enumerate() {
            let (start, rows) = part(index + 1);
            scope.spawn(move || block.fill(successors, rows, start));
        }
        let (start, rows) = part(0);
        first[0].fill(successors, rows, start);
    });
    threads
}

//! The moves of many rows, found by several threads.

use super::counts::Counts;
use crate::parallel;
use crate::successors::{PackedMoves, Successors};

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

/// Fills blocks with the moves of a batch; how many blocks have been filled. `threads` as in [`parallel::share`].
pub(super) fn fill(blocks: &mut Vec<Block>, successors: &Successors, batch: &[u64], threads: usize) -> usize {
    let words = successors.layout().words();
    let rows = (batch.len() / words) as u32;
    parallel::share(blocks, 0..rows, LEAST_SHARE, threads, |block, part| {
        let (start, end) = (part.start as usize, part.end as usize);
        block.fill(successors, &batch[start * words..end * words], start);
    })
}

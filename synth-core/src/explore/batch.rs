//! The moves of many states at once, found by several threads.
//!
//! While a batch is looked at nothing changes: the tables and the states are read, and each thread notes for a part of the
//! batch what it finds. States that are new have no number yet, and neither have those whose moves the tables do not give.
//! Both are seen to afterwards, in the order of the states, so that all numbers are those of a search that takes one state
//! after the other.

use crate::game::{KeySetsBuilder, Turn};
use crate::parallel;
use crate::successors::{Block, Found, Known, PackedMoves, StateId, StateStore};
use std::ops::Range;

/// Fewer states are not worth another thread.
const LEAST_SHARE: usize = 512;

/// Stands for the losing and the won state until all others have their numbers.
pub(super) const LOST: u32 = u32::MAX;
pub(super) const WON: u32 = u32::MAX - 1;

/// Fills blocks with the moves of these states; how many blocks have been filled. `threads` as in [`parallel::share`].
pub(super) fn fill(
    blocks: &mut Vec<Block>,
    store: &StateStore,
    sets: &KeySetsBuilder,
    states: Range<StateId>,
    threads: usize,
) -> usize {
    parallel::share(blocks, states, LEAST_SHARE, threads, |block, part| fill_one(block, store, sets, part))
}

fn fill_one(block: &mut Block, store: &StateStore, sets: &KeySetsBuilder, states: Range<StateId>) {
    let known = Known { rows: &store.rows, sets };
    block.clear(known);
    let (mut moves, mut row) = (std::mem::take(&mut block.moves), std::mem::take(&mut block.row));
    for state in states {
        if store.successors.moves_and_keys(store.rows.get(state, &mut row), &mut moves).is_ok() {
            add(block, known, &moves);
        } else {
            block.miss();
        }
    }
    block.look_up(known);
    (block.moves, block.row) = (moves, row);
}

/// Notes the moves of the next state. The set of its open keys is one of the game, whose sets are known.
pub(super) fn add(block: &mut Block, known: Known<'_>, moves: &PackedMoves) {
    for edge in moves.edges() {
        let found = Found { event: edge.event, discharged: edge.discharged };
        match edge.end {
            None => block.add(known, found, moves.target(edge).iter().copied()),
            Some(Turn::Won) => block.add_end(found, WON),
            Some(_) => block.add_end(found, LOST),
        }
    }
    block.push(known, moves);
}

//! What many nodes lead to, found by several threads.
//!
//! While a batch is looked at nothing changes: tables, nodes and controller are read, and each thread notes for a part of the
//! batch what it finds. Where the tables do not give the moves of a node, or something is wrong with it, it notes no more
//! than that; such nodes are looked at again afterwards, in their order, and so are numbers given. A batch does not
//! depend on the number of threads, so nothing does.

use super::machine::Machine;
use super::nodes::Nodes;
use super::rules::{Step, steps};
use crate::parallel;
use crate::successors::{Block, Found, PackedMoves};
use std::ops::Range;

/// Fewer nodes are not worth another thread.
const LEAST_SHARE: usize = 128;

/// Fills blocks with what these nodes lead to; how many blocks have been filled. `threads` as in [`parallel::share`].
pub(super) fn fill(
    blocks: &mut Vec<Block>,
    nodes: &Nodes,
    machine: &Machine<'_>,
    batch: Range<u32>,
    threads: usize,
) -> usize {
    parallel::share(blocks, batch, LEAST_SHARE, threads, |block, part| fill_one(block, nodes, machine, part))
}

fn fill_one(block: &mut Block, nodes: &Nodes, machine: &Machine<'_>, part: Range<u32>) {
    block.clear(nodes.known());
    let (mut moves, mut row) = (std::mem::take(&mut block.moves), std::mem::take(&mut block.row));
    let mut found = Vec::new();
    for node in part {
        let (state, control) = nodes.get(node, &mut row);
        // Of the system's moves only the one counts that the controller makes. Mistakes of the others are none of its plays.
        let by_command =
            machine.next(control).map(|event| nodes.successors.command(state, event, &mut moves));
        let is_known =
            by_command == Some(Ok(())) || nodes.successors.moves_and_keys(state, &mut moves).is_ok();
        if is_known && steps(machine, control, &moves, &mut found).is_ok() {
            add(block, nodes, &moves, &found);
        } else {
            block.miss();
        }
    }
    block.look_up(nodes.known());
    (block.moves, block.row) = (moves, row);
}

/// Notes the next node.
pub(super) fn add(block: &mut Block, nodes: &Nodes, moves: &PackedMoves, steps: &[Step]) {
    for step in steps {
        let edge = &moves.edges()[step.edge];
        let row = moves.target(edge).iter().copied().chain([nodes.word(step.control)]);
        block.add(nodes.known(), Found { event: edge.event, discharged: edge.discharged }, row);
    }
    block.push(nodes.known(), moves);
}

//! What many nodes lead to, found by several threads.
//!
//! While a batch is looked at nothing changes: tables, nodes and controller are read, and each thread notes for a part of the
//! batch what it finds. Where the tables do not give the moves of a node, or something is wrong with it, it notes no more
//! than that; such nodes are looked at again afterwards, in their order, and so are numbers given. A batch does not
//! depend on the number of threads, so nothing does.

use super::graph::Rest;
use super::machine::Machine;
use super::nodes::Nodes;
use super::rules::{Step, steps};
use crate::parallel;
use crate::playout::EventId;
use crate::successors::{PackedMoves, SetId};
use std::ops::Range;

/// Most nodes of a batch.
pub(super) const BATCH: usize = 1 << 14;

/// Fewer nodes are not worth another thread.
const LEAST_SHARE: usize = 128;

/// Stands for a node that was not known when the batch began.
const NEW: u32 = u32::MAX;

/// One node of the batch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Head {
    /// It must be looked at again.
    pub(super) again: bool,
    pub(super) rest: Rest,
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
pub(super) enum Target<'b> {
    /// To a node that was known.
    Known(u32),
    /// To this row.
    New(&'b [u64]),
}

/// Consecutive nodes.
#[derive(Debug, Default)]
pub(super) struct Block {
    heads: Vec<Head>,
    edges: Vec<Found>,
    /// Of the edges that lead to something new: the rows.
    rows: Vec<u64>,
    // Room to find them.
    moves: PackedMoves,
    steps: Vec<Step>,
    row: Vec<u64>,
}

impl Block {
    pub(super) fn clear(&mut self) {
        self.heads.clear();
        self.edges.clear();
        self.rows.clear();
    }

    fn fill(&mut self, nodes: &Nodes, machine: &Machine<'_>, part: Range<u32>) {
        self.clear();
        let (mut moves, mut found) = (std::mem::take(&mut self.moves), std::mem::take(&mut self.steps));
        for node in part {
            let (state, control) = nodes.get(node);
            let is_known = nodes.successors.moves(state, &mut moves).is_ok();
            if is_known && steps(machine, control, &moves, &mut found).is_ok() {
                self.add(nodes, &moves, &found);
            } else {
                let rest = Rest { environment: false, silent: false };
                self.heads.push(Head { again: true, rest, open: 0, edges: 0 });
            }
        }
        (self.moves, self.steps) = (moves, found);
    }

    /// Notes the next node.
    pub(super) fn add(&mut self, nodes: &Nodes, moves: &PackedMoves, steps: &[Step]) {
        let rest = Rest { environment: moves.turn.is_environment(), silent: moves.silent };
        self.heads.push(Head { again: false, rest, open: moves.open, edges: steps.len() as u32 });
        for step in steps {
            let edge = &moves.edges()[step.edge];
            self.row.clear();
            self.row.extend_from_slice(moves.target(edge));
            self.row.push(step.control.word());
            let target = nodes.find(&self.row).unwrap_or_else(|| {
                self.rows.extend_from_slice(&self.row);
                NEW
            });
            self.edges.push(Found { event: edge.event, discharged: edge.discharged, target });
        }
    }

    pub(super) fn heads(&self) -> &[Head] {
        &self.heads
    }
}

/// Reads a block, node by node.
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

    /// The next node, and its edges for [`Reader::target`].
    pub(super) fn node(&mut self) -> Option<(Head, &'b [Found])> {
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
        Target::New(row)
    }
}

/// Fills blocks with what these nodes lead to; how many blocks have been filled. `threads` as in [`parallel::share`].
pub(super) fn fill(
    blocks: &mut Vec<Block>,
    nodes: &Nodes,
    machine: &Machine<'_>,
    batch: Range<u32>,
    threads: usize,
) -> usize {
    parallel::share(blocks, batch, LEAST_SHARE, threads, |block, part| block.fill(nodes, machine, part))
}

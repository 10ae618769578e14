//! The game up to symmetry, without syntax: a state for all that differ only by interchangeable objects.
//!
//! A fairness key belongs to objects, so an edge does not only lead to a state: it also says what each key that is
//! open in its source is called in the representative that it leads to.

use crate::game::Turn;
use std::ops::Range;

/// Of a key: the edge meets it, since it discharges it or since it is not open behind it. Of an assumption both are the same: it is
/// accepted.
pub(super) const MET: u32 = u32::MAX;

/// The explicit game. A state's *goals* are the keys of guarantees that are open there, and behind these, where the system has the turn,
/// that the super step ends; its *promises* are the keys of assumptions that are open. Both are numbered for each state anew.
#[derive(Debug, Default)]
pub(super) struct Quotient {
    /// Per state: whose turn.
    pub(super) turn: Vec<Turn>,
    /// Per state: the environment may stay silent.
    pub(super) silent: Vec<bool>,
    /// Offsets of edges, one more than there are states whose edges are known.
    pub(super) first: Vec<u32>,
    /// Per edge.
    pub(super) target: Vec<u32>,
    /// Per state: number of goals, and of promises.
    pub(super) open: Vec<(u32, u32)>,
    /// Per edge, offset into `names`; one more than there are edges.
    pub(super) named: Vec<usize>,
    /// Per edge and goal of its source, and then per promise: which it is in the target, or [`MET`].
    pub(super) names: Vec<u32>,
}

impl Quotient {
    pub(super) fn states(&self) -> usize {
        self.turn.len()
    }

    pub(super) fn edges_of(&self, state: usize) -> Range<usize> {
        self.first[state] as usize..self.first[state + 1] as usize
    }

    /// What a goal of the source of an edge is in its target.
    pub(super) fn goal(&self, edge: usize, goal: u32) -> u32 {
        self.names[self.named[edge] + goal as usize]
    }

    /// What a promise is there; `goals` is the number of goals in the source.
    pub(super) fn promise(&self, edge: usize, goals: u32, promise: u32) -> u32 {
        self.names[self.named[edge] + (goals + promise) as usize]
    }

    /// Bytes held.
    pub(super) fn memory(&self) -> usize {
        self.turn.capacity() * 2
            + (self.first.capacity() + self.target.capacity() + self.names.capacity()) * size_of::<u32>()
            + self.open.capacity() * size_of::<(u32, u32)>()
            + self.named.capacity() * size_of::<usize>()
    }
}

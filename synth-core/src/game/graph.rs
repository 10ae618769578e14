//! Graphs of plays in which the system has made its choices.

use super::Strategy;
use fixedbitset::FixedBitSet;
use std::ops::Range;

/// A graph of all plays of a strategy.
pub(super) trait Graph: Sync {
    /// Number of nodes; not all of them need be reached.
    fn nodes(&self) -> usize;
    /// The reached nodes with one of these states of the game.
    fn nodes_in<'s>(&'s self, states: &'s FixedBitSet) -> impl Iterator<Item = u32> + 's;
    /// The state of the game in a node.
    fn state(&self, node: u32) -> u32;
    /// The edges that leave a node: one where the system has the turn.
    fn edges_of(&self, node: u32) -> Range<usize>;
    /// The node that an edge leads to.
    fn target(&self, edge: usize) -> u32;
    /// The edge of the game that an edge is.
    fn of_game(&self, edge: usize) -> usize;
}

/// The graph of a strategy with memory.
pub(super) struct OfStrategy<'a>(pub(super) &'a Strategy);

impl Graph for OfStrategy<'_> {
    fn nodes(&self) -> usize {
        self.0.nodes()
    }

    fn nodes_in<'s>(&'s self, states: &'s FixedBitSet) -> impl Iterator<Item = u32> + 's {
        let all = (0..).zip(&self.0.state);
        all.filter(|(_, state)| states.contains(**state as usize)).map(|(node, _)| node)
    }

    fn state(&self, node: u32) -> u32 {
        self.0.state[node as usize]
    }

    fn edges_of(&self, node: u32) -> Range<usize> {
        self.0.edges_of(node)
    }

    fn target(&self, edge: usize) -> u32 {
        self.0.target[edge]
    }

    fn of_game(&self, edge: usize) -> usize {
        self.0.edge[edge] as usize
    }
}

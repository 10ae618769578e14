//! Graphs of plays in which the system has made its choices.

use super::Strategy;
use std::ops::Range;

/// A graph of all plays of a strategy.
pub(super) trait Graph: Sync {
    /// Number of nodes.
    fn nodes(&self) -> usize;
    /// Whether a node is reached.
    fn is_reached(&self, node: u32) -> bool;
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

    fn is_reached(&self, _: u32) -> bool {
        true
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

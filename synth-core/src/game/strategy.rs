//! A winning strategy as a graph.

use super::{Game, ShortestPaths};

/// A deterministic strategy with memory, as the graph of its plays.
///
/// A node is a game state together with what the controller remembers there. A node whose game state is the
/// system's has exactly one edge (the choice); a node of the environment has all edges of its game state, in their
/// order. Edges of node `n` are `first[n]..first[n + 1]`. Nodes are numbered breadth first from `initial` = 0.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Strategy {
    /// Per node: the game state.
    pub state: Vec<u32>,
    /// Offsets into the edge arrays, one more than there are nodes.
    pub first: Vec<u32>,
    /// Per edge: the edge of the game.
    pub edge: Vec<u32>,
    /// Per edge: the node it leads to.
    pub target: Vec<u32>,
}

impl Strategy {
    /// Number of nodes.
    #[must_use]
    pub fn nodes(&self) -> usize {
        self.state.len()
    }

    /// A node to which a run of choices of the system comes back, so that it never ends, if there is one.
    #[must_use]
    pub fn endless_run(&self, game: &Game) -> Option<u32> {
        const NONE: u32 = u32::MAX;
        // Per node: the run, by its first node, that was the first to come by.
        let mut run = vec![NONE; self.nodes()];
        (0..self.nodes() as u32).find_map(|begin| {
            let mut node = begin;
            while run[node as usize] == NONE
                && game.turn[self.state[node as usize] as usize].is_system()
                && let Some(edge) = self.edges_of(node).next()
            {
                run[node as usize] = begin;
                node = self.target[edge];
            }
            (run[node as usize] == begin).then_some(node)
        })
    }

    /// The edges of a shortest play to `node`.
    #[must_use]
    pub fn play_to(&self, node: u32) -> Vec<usize> {
        ShortestPaths::new(self.nodes(), &self.first, &self.target).to(node)
    }

    /// The edges that leave `node`.
    #[must_use]
    pub fn edges_of(&self, node: u32) -> std::ops::Range<usize> {
        self.first[node as usize] as usize..self.first[node as usize + 1] as usize
    }
}

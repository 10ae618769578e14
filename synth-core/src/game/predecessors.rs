//! The edges of a game, backwards.

use super::Game;

/// An edge as seen from its target.
#[derive(Clone, Copy, Debug)]
pub(super) struct Incoming {
    /// The state that the edge leaves.
    pub(super) source: u32,
    /// What happens on the edge.
    pub(super) action: u32,
}

/// Per state its incoming edges: first those from states in which something must happen, then those from states in which the
/// environment may be silent; each by ascending source.
#[derive(Debug)]
pub(super) struct Predecessors {
    first: Vec<u32>,
    /// Per state: where the edges from states with silence begin.
    silent: Vec<u32>,
    incoming: Vec<Incoming>,
}

impl Predecessors {
    /// Turns all edges around (a counting sort by target).
    pub(super) fn new(game: &Game) -> Self {
        // `first[t + 1]` is where the next edge into `t` goes, and so ends as the start of `t + 1`.
        let mut first = vec![0; game.states() + 2];
        for &target in &game.target {
            first[target as usize + 2] += 1;
        }
        for state in 2..first.len() {
            first[state] += first[state - 1];
        }
        let mut incoming = vec![Incoming { source: 0, action: 0 }; game.edges()];
        let mut silent = Vec::new();
        for rests in [false, true] {
            if rests {
                silent = first[1..=game.states()].to_vec();
            }
            for source in (0..game.states() as u32).filter(|&source| may_rest(game, source) == rests) {
                for edge in game.edges_of(source) {
                    let next = &mut first[game.target[edge] as usize + 1];
                    incoming[*next as usize] = Incoming { source, action: game.action[edge] };
                    *next += 1;
                }
            }
        }
        first.pop();
        Predecessors { first, silent, incoming }
    }

    /// The edges that lead to `state`.
    pub(super) fn of(&self, state: u32) -> &[Incoming] {
        &self.incoming[self.first[state as usize] as usize..self.first[state as usize + 1] as usize]
    }

    /// Of these the ones from states in which something must happen.
    pub(super) fn forced(&self, state: u32) -> &[Incoming] {
        &self.incoming[self.first[state as usize] as usize..self.silent[state as usize] as usize]
    }
}

/// Whether the environment may be silent in a state.
fn may_rest(game: &Game, state: u32) -> bool {
    game.silent[state as usize] && !game.turn[state as usize].is_system()
}

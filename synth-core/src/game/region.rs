//! The states that the system may still win, as the solver shrinks them.

use super::{Game, Turn, predecessors::Predecessors};
use fixedbitset::FixedBitSet;

/// A set of states that the environment cannot leave and in which the system always has a move that stays.
///
/// It begins as what remains without the environment's attractor of [`Turn::Lost`] and only shrinks; all removals
/// together look at every edge at most once.
#[derive(Debug)]
pub(super) struct Region {
    /// The states.
    pub(super) states: FixedBitSet,
    /// Per system state inside: how many of its edges stay inside.
    choices: Vec<u32>,
    /// The states taken out by the last removal.
    pub(super) removed: Vec<u32>,
}

impl Region {
    /// All states from which the environment cannot force the loss of the game.
    pub(super) fn new(game: &Game, predecessors: &Predecessors) -> Self {
        let mut states = FixedBitSet::with_capacity(game.states());
        states.insert_range(..);
        let choices = game.first.windows(2).map(|pair| pair[1] - pair[0]).collect::<Vec<_>>();
        let mut region = Region { states, choices, removed: Vec::new() };
        for (state, turn) in game.turn.iter().enumerate() {
            if *turn == Turn::Lost || turn.is_system() && region.choices[state] == 0 {
                region.lose(state as u32);
            }
        }
        region.attract(game, predecessors);
        region
    }

    /// Removes the environment's attractor of `lost`.
    pub(super) fn remove(&mut self, game: &Game, predecessors: &Predecessors, lost: &FixedBitSet) {
        self.removed.clear();
        for state in lost.ones() {
            self.lose(state as u32);
        }
        self.attract(game, predecessors);
    }

    fn attract(&mut self, game: &Game, predecessors: &Predecessors) {
        let mut next = 0;
        while let Some(&lost) = self.removed.get(next) {
            next += 1;
            for incoming in predecessors.of(lost) {
                let source = incoming.source as usize;
                if !self.states.contains(source) {
                    continue;
                }
                if game.turn[source].is_system() {
                    self.choices[source] -= 1;
                    if self.choices[source] > 0 {
                        continue;
                    }
                }
                self.lose(incoming.source);
            }
        }
    }

    fn lose(&mut self, state: u32) {
        if self.states.contains(state as usize) {
            self.states.set(state as usize, false);
            self.removed.push(state);
        }
    }
}

//! The sets of keys of a game that is being made from packed moves.

use crate::game::KeySetsBuilder;
use crate::playout::KeyId;
use crate::successors::{SetId, StateStore, UNKNOWN_SET};

/// Sets are numbered in the order in which they come up.
#[derive(Debug, Default)]
pub(crate) struct GameSets {
    /// Those of the game.
    pub(crate) builder: KeySetsBuilder,
    /// Per set of the successor function: that of the game, or [`UNKNOWN_SET`].
    known: Vec<u32>,
}

impl GameSets {
    /// The set of the game for one of the successor function.
    pub(crate) fn of(&mut self, set: SetId, store: &StateStore) -> u32 {
        let index = set as usize;
        if index >= self.known.len() {
            self.known.resize(index + 1, UNKNOWN_SET);
        }
        if self.known[index] == UNKNOWN_SET {
            let members: Vec<KeyId> = store.keys(set).collect();
            self.known[index] = self.builder.intern(&members);
        }
        self.known[index]
    }
}

//! Where a play is fair: the accepting states and edges of a key, and of the end of super steps.

use super::Game;
use super::bits::{BITS, by_set};
use fixedbitset::FixedBitSet;

/// The acceptance condition of one assumption or guarantee: it must be met infinitely often, by a state or an edge.
#[derive(Clone, Debug)]
pub(super) struct Acceptance {
    /// The states that do *not* accept: the key is open there.
    pub(super) open: FixedBitSet,
    /// Per action: an edge with it accepts, since it discharges the key.
    accepting: Vec<bool>,
}

impl Acceptance {
    /// The conditions of the assumptions, in the order of [`Game::assumptions`].
    pub(super) fn assumptions(game: &Game) -> Vec<Acceptance> {
        Self::of_keys(game, &game.assumptions)
    }

    /// The goals of the system: the guarantees, in the order of [`Game::guarantees`], and then the one that super
    /// steps end.
    pub(super) fn goals(game: &Game) -> Vec<Acceptance> {
        Self::goals_of(game, &game.guarantees)
    }

    /// The goals of a system that has only these keys to meet: they, and then the one that super steps end.
    pub(super) fn goals_of(game: &Game, keys: &[u32]) -> Vec<Acceptance> {
        let mut goals = Self::of_keys(game, keys);
        let mut open = FixedBitSet::with_capacity(game.states());
        for (state, turn) in game.turn.iter().enumerate() {
            open.set(state, turn.is_system());
        }
        goals.push(Acceptance { open, accepting: vec![false; game.actions.len()] });
        goals
    }

    /// A goal that is never accepted.
    pub(super) fn never(game: &Game) -> Acceptance {
        let mut open = FixedBitSet::with_capacity(game.states());
        open.insert_range(..);
        Acceptance { open, accepting: vec![false; game.actions.len()] }
    }

    fn of_keys(game: &Game, keys: &[u32]) -> Vec<Acceptance> {
        let Game { key_sets, open, .. } = game;
        let firsts = (0..key_sets.keys()).step_by(BITS);
        let opens: Vec<FixedBitSet> = firsts
            .flat_map(|first| {
                let words = open.iter().map(|&set| key_sets.word(set, first));
                by_set(BITS.min((key_sets.keys() - first) as usize), words)
            })
            .collect();
        let accepts = |key| game.actions.discharged_sets().map(|set| key_sets.contains(set, key)).collect();
        let of_key = |&key: &u32| Acceptance { open: opens[key as usize].clone(), accepting: accepts(key) };
        keys.iter().map(of_key).collect()
    }

    /// Whether an edge with this action accepts.
    pub(super) fn accepts(&self, action: u32) -> bool {
        self.accepting[action as usize]
    }
}

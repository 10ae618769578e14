//! Where a play is fair: the accepting states and edges of a key, and of the end of super steps.

use super::Game;
use fixedbitset::FixedBitSet;

/// The acceptance condition of one assumption or guarantee: it must be met infinitely often, by a state or an edge.
#[derive(Clone, Debug)]
pub(super) struct Acceptance {
    /// The states that do *not* accept: the key is open there.
    pub(super) open: FixedBitSet,
    /// Per set of discharged keys: an edge with that set accepts.
    discharging: Vec<bool>,
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
        goals.push(Acceptance { open, discharging: vec![false; game.key_sets.len()] });
        goals
    }

    /// A goal that is never accepted.
    pub(super) fn never(game: &Game) -> Acceptance {
        let mut open = FixedBitSet::with_capacity(game.states());
        open.insert_range(..);
        Acceptance { open, discharging: vec![false; game.key_sets.len()] }
    }

    fn of_keys(game: &Game, keys: &[u32]) -> Vec<Acceptance> {
        let of_key = |&key: &u32| {
            let containing = game.key_sets.containing(key);
            let mut open = FixedBitSet::with_capacity(game.states());
            for (state, &set) in game.open.iter().enumerate() {
                if containing[set as usize] {
                    open.insert(state);
                }
            }
            Acceptance { open, discharging: containing }
        };
        keys.iter().map(of_key).collect()
    }

    /// Whether a step that discharges this set of keys accepts.
    pub(super) fn accepts(&self, discharged: u32) -> bool {
        self.discharging[discharged as usize]
    }
}

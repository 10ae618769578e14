//! Where a play is fair: the accepting states and edges of a key, and of the end of super steps.

use super::Game;
use crate::parallel::share;
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
    pub(super) fn assumptions(game: &Game, threads: usize) -> Vec<Acceptance> {
        Self::of_keys(game, &game.assumptions, threads)
    }

    /// The goals of the system: the guarantees, in the order of [`Game::guarantees`], and then the one that super
    /// steps end.
    pub(super) fn goals(game: &Game, threads: usize) -> Vec<Acceptance> {
        Self::goals_of(game, &game.guarantees, threads)
    }

    /// The goals of a system that has only these keys to meet: they, and then the one that super steps end.
    pub(super) fn goals_of(game: &Game, keys: &[u32], threads: usize) -> Vec<Acceptance> {
        let mut goals = Self::of_keys(game, keys, threads);
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

    fn of_keys(game: &Game, keys: &[u32], threads: usize) -> Vec<Acceptance> {
        let of_key = |key: u32| {
            let containing = game.key_sets.containing(key);
            // A word at a time: an insertion for each state takes longer than all else.
            let word = |sets: &[u32]| {
                let bits = sets.iter().enumerate();
                bits.fold(0, |word, (bit, &set)| word | usize::from(containing[set as usize]) << bit)
            };
            let words = game.open.chunks(usize::BITS as usize).map(word);
            let open = FixedBitSet::with_capacity_and_blocks(game.states(), words);
            let accepting = game.actions.discharged_sets().map(|set| containing[set as usize]).collect();
            Acceptance { open, accepting }
        };
        let mut places: Vec<Vec<Acceptance>> = Vec::new();
        share(&mut places, 0..keys.len() as u32, 1, threads, |place, part| {
            place.extend(part.map(|index| of_key(keys[index as usize])));
        });
        places.into_iter().flatten().collect()
    }

    /// Whether an edge with this action accepts.
    pub(super) fn accepts(&self, action: u32) -> bool {
        self.accepting[action as usize]
    }
}

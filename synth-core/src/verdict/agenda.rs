//! What is explored next.

use super::partial::{LOST, Partial, WON};
use crate::explore::{ExploreError, Limits};
use crate::successors::StateId;
use fixedbitset::FixedBitSet;
use std::collections::VecDeque;

/// One of the players.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Side {
    /// Who has to meet the guarantees.
    System,
    /// Who has to meet the assumptions.
    Environment,
}

/// How many of a side's choices are followed, at first and then: one, two, all.
const BREADTHS: [usize; 3] = [1, 2, usize::MAX];

/// The plays that are followed, in turn those of a system and those of an environment that have only a few choices.
///
/// If the system wins with a few of its choices, all that matters is what the environment can do against these, and the other way
/// round. Choices are taken in the order of their texts, without those that are known to be bad.
#[derive(Debug, Default)]
pub(super) struct Agenda {
    /// Per side: which of [`BREADTHS`].
    breadth: [usize; 2],
    /// Per place: the system is known to win there, or the environment.
    won: FixedBitSet,
    lost: FixedBitSet,
}

impl Agenda {
    /// Explores at most so many states, breadth first, where one side has few choices and the other all; whether that was
    /// enough for all plays with these choices that are not decided. Then there will be more of them the next time.
    pub(super) fn follow(
        &mut self,
        side: Side,
        partial: &mut Partial<'_, '_>,
        budget: usize,
        limits: &Limits,
    ) -> Result<bool, ExploreError> {
        let breadth = BREADTHS[self.breadth[side as usize]];
        let end = partial.explored().saturating_add(budget);
        let mut reached = FixedBitSet::with_capacity(partial.found());
        reached.insert(0);
        let mut queue: VecDeque<StateId> = VecDeque::from([0]);
        while let Some(state) = queue.pop_front() {
            let place = match partial.place(state) {
                Some(place) => place,
                None if partial.explored() == end => return Ok(false),
                None => self.explore(state, partial, limits)?,
            };
            if self.is_decided(place) {
                continue;
            }
            reached.grow(partial.found());
            let choosing = if partial.turn(place).is_system() { Side::System } else { Side::Environment };
            let useful = |&target: &StateId| match partial.place(target) {
                Some(place) if choosing == Side::System => !self.lost.contains(place),
                Some(place) => !self.won.contains(place),
                None => target < WON,
            };
            let most = if choosing == side { breadth } else { usize::MAX };
            for &target in partial.targets(place).iter().filter(|target| useful(target)).take(most) {
                if !reached.put(target as usize) {
                    queue.push_back(target);
                }
            }
        }
        let breadth = &mut self.breadth[side as usize];
        *breadth = (*breadth + 1).min(BREADTHS.len() - 1);
        Ok(true)
    }

    /// Explores a state, which may be decided by its moves alone.
    fn explore(
        &mut self,
        state: StateId,
        partial: &mut Partial<'_, '_>,
        limits: &Limits,
    ) -> Result<usize, ExploreError> {
        let place = partial.explore(state, limits)?;
        self.won.grow(place + 1);
        self.lost.grow(place + 1);
        let is_system = partial.turn(place).is_system();
        self.won.set(place, is_system && partial.targets(place).contains(&WON));
        self.lost.set(place, !is_system && partial.targets(place).contains(&LOST));
        Ok(place)
    }

    fn is_decided(&self, place: usize) -> bool {
        self.won.contains(place) || self.lost.contains(place)
    }

    /// The system wins at these places.
    pub(super) fn note_won(&mut self, winning: &FixedBitSet, places: usize) {
        (0..places).filter(|&place| winning.contains(place)).for_each(|place| self.won.insert(place));
    }

    /// The environment wins at all places but these.
    pub(super) fn note_lost(&mut self, winning: &FixedBitSet, places: usize) {
        (0..places).filter(|&place| !winning.contains(place)).for_each(|place| self.lost.insert(place));
    }
}

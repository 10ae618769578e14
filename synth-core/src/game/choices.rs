//! Strategies without memory: one choice for each state of the system.

use super::extract::ExtractError;
use super::graph::Graph;
use super::preference::Preference;
use super::{Game, Solution, Strategy};
use crate::parallel::share;
use fixedbitset::FixedBitSet;
use std::ops::Range;

pub(super) const NONE: u32 = u32::MAX;

/// The choices of the system, and the states that its plays reach.
///
/// It is a graph of its plays as it stands: nodes are states of the game.
pub(super) struct Choices<'a> {
    game: &'a Game,
    /// Per state of the system: the edge chosen. [`NONE`] for others.
    chosen: Vec<u32>,
    reached: FixedBitSet,
}

impl<'a> Choices<'a> {
    /// Chooses by an order of the goals, the most important first.
    ///
    /// # Errors
    /// [`ExtractError::Leaves`].
    pub(super) fn new(
        game: &'a Game,
        solution: &Solution,
        order: &[usize],
        threads: usize,
    ) -> Result<Self, ExtractError> {
        let preference = Preference { game, solution };
        let chosen = of_states(game, solution, threads, |state, candidates| {
            preference.collect_candidates(state, candidates);
            preference.choose(order, candidates)
        });
        let mut choices = Choices { game, chosen, reached: FixedBitSet::with_capacity(game.states()) };
        choices.reach(solution)?;
        Ok(choices)
    }

    fn reach(&mut self, solution: &Solution) -> Result<(), ExtractError> {
        // Breadth first, as states are numbered, so that those looked at one after the other are near each other.
        let mut found = vec![self.game.initial];
        let mut next = 0;
        self.reached.insert(self.game.initial as usize);
        while let Some(&state) = found.get(next) {
            next += 1;
            let is_stuck = self.chosen[state as usize] == NONE && self.game.turn[state as usize].is_system();
            if is_stuck || !solution.wins(state) {
                return Err(ExtractError::Leaves(state));
            }
            for edge in self.edges_of(state) {
                let target = self.game.target[edge];
                if !self.reached.put(target as usize) {
                    found.push(target);
                }
            }
        }
        Ok(())
    }

    /// The same as a strategy, its nodes numbered.
    pub(super) fn strategy(&self) -> Strategy {
        let nodes = self.reached.count_ones(..);
        let mut node = vec![NONE; self.game.states()];
        let mut strategy = Strategy {
            state: Vec::with_capacity(nodes),
            first: vec![0],
            edge: Vec::new(),
            target: Vec::new(),
        };
        strategy.state.push(self.game.initial);
        node[self.game.initial as usize] = 0;
        let mut next = 0;
        while let Some(&state) = strategy.state.get(next) {
            for edge in self.edges_of(state) {
                let target = self.game.target[edge];
                let number = &mut node[target as usize];
                if *number == NONE {
                    *number = strategy.state.len() as u32;
                    strategy.state.push(target);
                }
                strategy.edge.push(edge as u32);
                strategy.target.push(*number);
            }
            strategy.first.push(strategy.edge.len() as u32);
            next += 1;
        }
        strategy
    }
}

impl Graph for Choices<'_> {
    fn nodes(&self) -> usize {
        self.game.states()
    }

    fn is_reached(&self, node: u32) -> bool {
        self.reached.contains(node as usize)
    }

    fn state(&self, node: u32) -> u32 {
        node
    }

    fn edges_of(&self, node: u32) -> Range<usize> {
        match self.chosen[node as usize] {
            NONE => self.game.edges_of(node),
            edge => edge as usize..edge as usize + 1,
        }
    }

    fn target(&self, edge: usize) -> u32 {
        self.game.target[edge]
    }

    fn of_game(&self, edge: usize) -> usize {
        edge
    }
}

/// Per state: what `choose` chooses where the system has the turn and wins; [`NONE`] if that is nothing, and elsewhere. `choose` is
/// also given room for candidates.
pub(super) fn of_states(
    game: &Game,
    solution: &Solution,
    threads: usize,
    choose: impl Fn(u32, &mut Vec<usize>) -> Option<usize> + Sync,
) -> Vec<u32> {
    const LEAST: usize = 4096;
    let mut places: Vec<Vec<u32>> = Vec::new();
    share(&mut places, 0..game.states() as u32, LEAST, threads, |place, states| {
        let mut candidates = Vec::new();
        place.extend(states.map(|state| {
            let chooses = game.turn[state as usize].is_system() && solution.wins(state);
            chooses.then(|| choose(state, &mut candidates)).flatten().map_or(NONE, |edge| edge as u32)
        }));
    });
    if let [all] = places.as_mut_slice() { std::mem::take(all) } else { places.concat() }
}

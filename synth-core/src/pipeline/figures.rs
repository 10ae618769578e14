//! The size of a solved game.

use super::Solved;
use crate::explore::Explored;

/// The size of the game; how each is counted is fixed, so that implementations can be compared.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
#[expect(missing_docs, reason = "the names are the definition; see the language reference")]
pub struct Figures {
    pub realizable: bool,
    pub states: usize,
    pub transitions: usize,
    pub system_states: usize,
    pub environment_states: usize,
    pub yielded_states: usize,
    pub idle_states: usize,
    pub winning_states: usize,
    pub assumption_sets: usize,
    pub guarantee_sets: usize,
}

impl Solved<'_> {
    /// Counts.
    #[must_use]
    pub fn figures(&self) -> Figures {
        let Solved { explored: Explored { store, game, .. }, solution, .. } = self;
        let count =
            |counts: &dyn Fn(usize) -> bool| (0..game.states()).filter(|&state| counts(state)).count();
        let yielded_states = (0..store.len() as u32).filter(|&state| store.yielded(state)).count();
        Figures {
            realizable: solution.wins(game.initial),
            states: game.states(),
            transitions: game.edges(),
            system_states: count(&|s| game.turn[s].is_system()),
            environment_states: count(&|s| game.turn[s].is_environment()),
            yielded_states,
            idle_states: count(&|s| game.turn[s].is_environment() && game.edges_of(s as u32).is_empty()),
            winning_states: solution.winning_states(),
            assumption_sets: game.assumptions.len(),
            guarantee_sets: game.guarantees.len() + 1,
        }
    }
}

//! The game between controller and environment, without any syntax: states, edges, fairness keys.
//!
//! Flat arrays with `u32` ids throughout; 10^7 states are meant to fit.

mod acceptance;
mod actions;
mod bits;
mod choices;
mod components;
mod counter;
mod counter_strategy;
mod extract;
mod fairness;
mod graph;
mod keysets;
mod paths;
mod plays;
mod predecessors;
mod preference;
mod pursuit;
mod region;
mod separation;
mod solve;
mod starving;
mod strategy;

pub use actions::{Actions, ActionsBuilder};
pub use counter::{CounterPlay, Loss, can_meet, counter_play, wins};
pub use counter_strategy::{CounterStrategy, Standing};
pub use extract::{ExtractError, extract, extract_on};
pub use fairness::trapped;
pub use keysets::{KeySets, KeySetsBuilder};
pub(crate) use keysets::{hash_set, insert, words_for};
pub use paths::ShortestPaths;
pub use separation::overpowered;
pub use solve::{Solution, solve, solve_ending, solve_on};
pub use strategy::Strategy;

/// Whose turn it is in a state, by the rules of the language reference, section 4 (cases 1 to 6).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[repr(u8)]
pub enum Turn {
    /// Case 1: the system must choose a `committed` event.
    SystemCommitted = 1,
    /// Case 2: the environment must choose a `committed` event.
    EnvironmentCommitted = 2,
    /// Case 3: the system must choose an `urgent` or `requested` event.
    SystemUrgent = 3,
    /// Case 4: the environment must choose an `urgent` or `requested` event.
    EnvironmentUrgent = 4,
    /// Case 5: the system chooses an `eventually` event or yields.
    SystemEventually = 5,
    /// Case 6: the environment chooses any event.
    EnvironmentAny = 6,
    /// The environment has violated a guarantee: the system has lost. At most one state; no edges.
    Lost = 7,
    /// Classic semantics only: the system has violated an assumption and so won. At most one state; no edges.
    Won = 8,
}

impl Turn {
    /// The system chooses (cases 1, 3, 5).
    #[must_use]
    pub fn is_system(self) -> bool {
        matches!(self, Turn::SystemCommitted | Turn::SystemUrgent | Turn::SystemEventually)
    }

    /// The environment chooses (cases 2, 4, 6).
    #[must_use]
    pub fn is_environment(self) -> bool {
        matches!(self, Turn::EnvironmentCommitted | Turn::EnvironmentUrgent | Turn::EnvironmentAny)
    }
}

/// The label of an edge that is a yield; all other labels are event ids.
pub const YIELD: u32 = u32::MAX;

/// The explicit game graph.
///
/// States are `0..turn.len()`. The edges of state `s` are `first[s]..first[s + 1]`, ordered by event text, a yield
/// last. A system state has at least one edge; an environment state has one or may be silent.
#[derive(Clone, Debug)]
pub struct Game {
    /// The initial state.
    pub initial: u32,
    /// Per state: whose turn.
    pub turn: Vec<Turn>,
    /// Per state: the environment may stay silent, a self-loop that is no edge and discharges nothing.
    pub silent: Vec<bool>,
    /// Per state: the set (of [`Game::key_sets`]) of keys that are open there.
    pub open: Vec<u32>,
    /// Offsets into the edge arrays, one more than there are states.
    pub first: Vec<u32>,
    /// Per edge: what happens, one of [`Game::actions`].
    pub action: Vec<u32>,
    /// Per edge: the state it leads to.
    pub target: Vec<u32>,
    /// The distinct pairs of an event and the set of keys that it discharges.
    pub actions: Actions,
    /// The distinct sets of keys.
    pub key_sets: KeySets,
    /// Keys of assumptions (the `A_i`): ids below [`KeySets::keys`].
    pub assumptions: Vec<u32>,
    /// Keys of guarantees (the `G_j`), without the one for super steps, which every player of the game adds: the
    /// states in which the environment has the turn, and [`Turn::Won`], are visited infinitely often.
    pub guarantees: Vec<u32>,
}

impl Game {
    /// Number of states.
    #[must_use]
    pub fn states(&self) -> usize {
        self.turn.len()
    }

    /// Number of edges.
    #[must_use]
    pub fn edges(&self) -> usize {
        self.target.len()
    }

    /// The event id of an edge, or [`YIELD`].
    #[must_use]
    pub fn label(&self, edge: usize) -> u32 {
        self.actions.label(self.action[edge])
    }

    /// The set (of [`Game::key_sets`]) of keys that an edge discharges.
    #[must_use]
    pub fn discharged(&self, edge: usize) -> u32 {
        self.actions.discharged(self.action[edge])
    }

    /// The edges that leave `state`.
    #[must_use]
    pub fn edges_of(&self, state: u32) -> std::ops::Range<usize> {
        self.first[state as usize] as usize..self.first[state as usize + 1] as usize
    }
}

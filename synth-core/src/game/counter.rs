//! Why the system cannot win: one play that the environment forces.
//!
//! The environment follows its [`CounterStrategy`]; the play shown is the one of a system that holds out: it chooses
//! what was taken off last.

use super::counter_strategy::{CounterStrategy, Layers};
use super::{Game, Solution, acceptance::Acceptance, predecessors::Predecessors};
use std::collections::BTreeMap;

/// How the system loses a play.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Loss {
    /// The environment violates a guarantee: the last edge of the play leads to [`Turn::Lost`](super::Turn::Lost).
    Violation,
    /// This key of a guarantee is open throughout the cycle and never discharged.
    Starvation(u32),
    /// A super step never ends: the cycle consists of the system's states.
    Endless,
}

/// A play, consistent with a strategy by which the environment wins.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct CounterPlay {
    /// Edges from the initial state on.
    pub play: Vec<u32>,
    /// Edges that are repeated for ever behind `play`. Empty after a [`Loss::Violation`], or if the environment
    /// simply stays silent.
    pub cycle: Vec<u32>,
    /// How the system loses it.
    pub loss: Loss,
}

/// A play that the environment wins, or `None` if the system wins from the initial state.
///
/// The choices of the environment are those of a winning strategy; the system holds out as long as it can where
/// the play ends in [`Turn::Lost`](super::Turn::Lost), and otherwise chooses the first edge that keeps it in the layer. Time is that
/// of solving, up to the layer of the initial state, and a pass over one core for each assumption.
#[must_use]
pub fn counter_play(game: &Game, solution: &Solution) -> Option<CounterPlay> {
    let mut strategy = CounterStrategy::new(game, solution)?;
    let mut at = strategy.begin();
    let mut play = Vec::new();
    // When the play came to a place in a core.
    let mut visited = BTreeMap::new();
    loop {
        let starved = strategy.starves(at);
        if let Some(loss) = starved
            && let Some(first) = visited.insert(at, play.len())
        {
            let cycle = play.split_off(first);
            return Some(CounterPlay { play, cycle, loss });
        }
        let edge = if game.turn[at.state as usize].is_system() {
            strategy.hold_out(at)
        } else {
            strategy.choose(at)
        };
        let Some(edge) = edge else {
            let loss = starved.unwrap_or(Loss::Violation);
            return Some(CounterPlay { play, cycle: Vec::new(), loss });
        };
        play.push(edge);
        at = strategy.follow(at, edge);
    }
}

/// Whether the system wins from the initial state: what [`solve`](super::solve) says of it, without the rest, and found out as
/// soon as the initial state is lost.
#[must_use]
pub fn wins(game: &Game) -> bool {
    can_meet(game, &game.guarantees)
}

/// Whether the system would win from the initial state if these keys of guarantees were its only goals, beside never
/// losing the game and ending every super step.
#[must_use]
pub fn can_meet(game: &Game, keys: &[u32]) -> bool {
    let goals = Acceptance::goals_of(game, keys);
    let layers = Layers::new(game, &Predecessors::new(game), &Acceptance::assumptions(game), &goals);
    !layers.contains(game.initial)
}

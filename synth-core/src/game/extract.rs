//! From the solution of a game to a winning strategy, with as little memory as can be had cheaply.
//!
//! A solution knows, for each goal, which moves make progress towards it. A strategy that remembers one goal at a
//! time, makes progress towards it until it is accepted, and then turns to the next goal, always wins, but it is
//! larger than it must be. So strategies are tried in this order, and each is checked exactly:
//!
//! 1. *Without memory*: among the moves that win, keep those that make progress towards the goal that comes first in
//!    an order of the goals, among these those for the second, and so on, as long as there are any. Goals
//!    that a strategy misses are moved to the front of the order, each once.
//! 2. *With the last decision as memory*: where several moves make progress towards goals that were missed, the one like
//!    last time, or the one whose turn is next. What was missed once counts from then on. A cabin that keeps its direction and
//!    an arbiter that goes round are such strategies.
//! 3. *With the goal that is pursued as memory*, rotating over the goals that were missed.

use super::choices::Choices;
use super::graph::OfStrategy;
use super::plays::{Memory, Moves, Plays};
use super::{Game, Solution, Strategy, acceptance::Acceptance, fairness::Fairness};
use std::{error::Error, fmt};

/// Why there is no strategy to hand out.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ExtractError {
    /// The environment wins from the initial state.
    Unrealizable,
    /// The solution is wrong: a play of its strategies misses this goal (an index of [`Game::guarantees`]; their
    /// number stands for the end of super steps). It would be a bug of the solver.
    Misses(usize),
    /// The solution is wrong: the system has no move in this state that wins, or the environment one that leaves the
    /// winning states. It would be a bug of the solver.
    Leaves(u32),
}

impl fmt::Display for ExtractError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ExtractError::Unrealizable => f.write_str("the environment wins from the initial state"),
            ExtractError::Misses(goal) => write!(f, "the computed strategy misses goal {goal}"),
            ExtractError::Leaves(state) => {
                write!(f, "the computed strategy leaves the winning states in state {state}")
            }
        }
    }
}

impl Error for ExtractError {}

/// A strategy that wins from the initial state: deterministic, the same for the same game, and checked. On one thread.
///
/// # Errors
///
/// [`ExtractError::Unrealizable`] if the initial state is not winning; the others only if `solution` is not that of
/// `game`, or wrong.
pub fn extract(game: &Game, solution: &Solution) -> Result<Strategy, ExtractError> {
    extract_on(game, solution, 1)
}

/// As [`extract`], with so many goals checked at a time, each on a thread of its own; the result does not depend on it.
/// Each takes at most seven `u32` for a state or node, and all together a word for each state and one for each node.
///
/// # Errors
///
/// As for [`extract`].
pub fn extract_on(game: &Game, solution: &Solution, threads: usize) -> Result<Strategy, ExtractError> {
    if !solution.wins(game.initial) {
        return Err(ExtractError::Unrealizable);
    }
    Extraction::new(game, solution, threads.max(1)).run()
}

struct Extraction<'a> {
    game: &'a Game,
    solution: &'a Solution,
    threads: usize,
    goals: Vec<Acceptance>,
    fairness: Fairness<'a>,
    /// All goals, the most important first.
    order: Vec<usize>,
    /// The goals that some strategy has missed, ascending.
    demanding: Vec<usize>,
}

impl<'a> Extraction<'a> {
    fn new(game: &'a Game, solution: &'a Solution, threads: usize) -> Self {
        let goals = Acceptance::goals(game);
        let order = (0..goals.len()).collect();
        let fairness = Fairness::new(game, &goals);
        Extraction { game, solution, threads, order, goals, fairness, demanding: Vec::new() }
    }

    fn run(mut self) -> Result<Strategy, ExtractError> {
        let Extraction { game, solution, threads, .. } = self;
        let rotation = loop {
            let choices = Choices::new(game, solution, &self.order, threads)?;
            let missed = self.fairness.missed(&choices, &[], solution.ending, threads);
            if missed.is_empty() {
                return Ok(choices.strategy());
            }
            let first = self.order[0];
            self.order.sort_by_key(|goal| missed.binary_search(goal).is_err());
            if !self.demand(&missed) {
                break [vec![first], missed].concat();
            }
        };
        for memory in [Memory::KeepDecision, Memory::RotateDecisions] {
            if let Some(strategy) = self.attempts(memory)? {
                return Ok(strategy);
            }
        }
        // Goals that displace each other, and those that are missed besides: a rotation meets all of its own.
        self.demanding.clear();
        self.demand(&rotation);
        self.attempts(Memory::Goal)?.ok_or(ExtractError::Misses(rotation[0]))
    }

    /// The first strategy with this memory that wins, with more and more goals between which it divides its time.
    fn attempts(&mut self, memory: Memory) -> Result<Option<Strategy>, ExtractError> {
        loop {
            let (strategy, missed) = self.attempt(memory)?;
            if missed.is_empty() {
                return Ok(Some(strategy));
            }
            if !self.demand(&missed) {
                return Ok(None);
            }
        }
    }

    /// A strategy with this memory, and the goals that it misses; of the demanding ones hardly more than whether it does.
    fn attempt(&self, memory: Memory) -> Result<(Strategy, Vec<usize>), ExtractError> {
        let &Extraction { game, solution, threads, ref goals, ref order, ref demanding, .. } = self;
        let moves = Moves { game, solution, goals, order, demanding };
        let strategy = Plays::new(moves, memory, threads).explore()?;
        let missed = self.fairness.missed(&OfStrategy(&strategy), demanding, solution.ending, threads);
        Ok((strategy, missed))
    }

    /// Notes what was missed; whether there is something new among it.
    fn demand(&mut self, missed: &[usize]) -> bool {
        let known = self.demanding.len();
        self.demanding.extend_from_slice(missed);
        self.demanding.sort_unstable();
        self.demanding.dedup();
        self.demanding.len() > known
    }
}

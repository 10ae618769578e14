//! From the solution of a game to a winning strategy, with as little memory as can be had cheaply.
//!
//! A solution knows, for each goal, which moves make progress towards it. A strategy that remembers one goal at a
//! time, makes progress towards it until it is accepted, and then turns to the next goal, always wins, but it is
//! larger than it must be. So strategies are tried in this order, and each is checked exactly:
//!
//! 1. *Without memory*: among the moves that win, keep those that make progress towards the goal that comes first in
//!    an order of the goals, among these those for the second, and so on, as long as there are any. A goal
//!    that a strategy misses is moved to the front of the order, once.
//! 2. *With the goal that is pursued as memory*, rotating over few goals: first the two that displaced each other,
//!    then also each that is still missed. The goal that is pursued is the first in the order.

use super::{Game, Solution, Strategy, YIELD, acceptance::Acceptance, fairness::first_missed};
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

/// A strategy that wins from the initial state: deterministic, the same for the same game, and checked.
///
/// # Errors
///
/// [`ExtractError::Unrealizable`] if the initial state is not winning; the others only if `solution` is not that of
/// `game`, or wrong.
pub fn extract(game: &Game, solution: &Solution) -> Result<Strategy, ExtractError> {
    if !solution.wins(game.initial) {
        return Err(ExtractError::Unrealizable);
    }
    let goals = Acceptance::goals(game);
    let mut order = (0..goals.len()).collect::<Vec<_>>();
    let mut displaced = vec![false; goals.len()];
    let missed = loop {
        let strategy = Builder::new(game, solution, &goals, &order, &[]).build()?;
        let Some(missed) = first_missed(game, &strategy, &goals, solution.ending) else {
            return Ok(strategy);
        };
        if std::mem::replace(&mut displaced[missed], true) {
            break missed;
        }
        move_to_front(&mut order, missed);
    };
    let mut rotation = vec![order[0]];
    add(&mut rotation, missed)?;
    loop {
        let strategy = Builder::new(game, solution, &goals, &order, &rotation).build()?;
        let Some(missed) = first_missed(game, &strategy, &goals, solution.ending) else {
            return Ok(strategy);
        };
        add(&mut rotation, missed)?;
    }
}

fn move_to_front(order: &mut [usize], goal: usize) {
    if let Some(position) = order.iter().position(|&other| other == goal) {
        order[..=position].rotate_right(1);
    }
}

/// Adds a goal to a rotation, which meets all of its goals already.
fn add(rotation: &mut Vec<usize>, missed: usize) -> Result<(), ExtractError> {
    match rotation.binary_search(&missed) {
        Ok(_) => Err(ExtractError::Misses(missed)),
        Err(place) => {
            rotation.insert(place, missed);
            Ok(())
        }
    }
}

/// Explores the plays of one strategy.
struct Builder<'a> {
    game: &'a Game,
    solution: &'a Solution,
    goals: &'a [Acceptance],
    /// What the memory may hold: one of these goals is pursued. Empty: there is no memory.
    rotation: &'a [usize],
    /// Per content of the memory: all goals, the most important first.
    orders: Vec<Vec<usize>>,
    /// Per state and content of the memory: 1 + its node, 0 while there is none.
    node: Vec<u32>,
    /// Per node: the content of the memory.
    memory: Vec<u32>,
    strategy: Strategy,
    candidates: Vec<usize>,
}

impl<'a> Builder<'a> {
    fn new(
        game: &'a Game,
        solution: &'a Solution,
        goals: &'a [Acceptance],
        order: &[usize],
        rotation: &'a [usize],
    ) -> Self {
        let mut orders = vec![order.to_vec(); rotation.len().max(1)];
        for (order, &goal) in orders.iter_mut().zip(rotation) {
            move_to_front(order, goal);
        }
        Builder {
            game,
            solution,
            goals,
            rotation,
            node: vec![0; game.states() * orders.len()],
            orders,
            memory: Vec::new(),
            strategy: Strategy { state: Vec::new(), first: vec![0], edge: Vec::new(), target: Vec::new() },
            candidates: Vec::new(),
        }
    }

    /// The graph of the plays, breadth first.
    fn build(mut self) -> Result<Strategy, ExtractError> {
        self.enter(self.game.initial, 0);
        let mut node = 0;
        while let Some(&state) = self.strategy.state.get(node) {
            if !self.solution.wins(state) {
                return Err(ExtractError::Leaves(state));
            }
            let memory = self.memory[node] as usize;
            if self.game.turn[state as usize].is_system() {
                let edge = self.choose(state, memory).ok_or(ExtractError::Leaves(state))?;
                self.follow(edge, memory);
            } else {
                for edge in self.game.edges_of(state) {
                    self.follow(edge, memory);
                }
            }
            self.strategy.first.push(self.strategy.edge.len() as u32);
            node += 1;
        }
        Ok(self.strategy)
    }

    fn follow(&mut self, edge: usize, memory: usize) {
        let action = self.game.action[edge];
        let memory = self.turn_to(memory, |goal| !goal.accepts(action));
        let target = self.enter(self.game.target[edge], memory);
        self.strategy.edge.push(edge as u32);
        self.strategy.target.push(target);
    }

    /// The node of `state` when the memory holds `memory` on arrival.
    fn enter(&mut self, state: u32, memory: usize) -> u32 {
        let memory = self.turn_to(memory, |goal| goal.open.contains(state as usize));
        let node = &mut self.node[memory * self.game.states() + state as usize];
        if *node == 0 {
            self.strategy.state.push(state);
            self.memory.push(memory as u32);
            *node = self.strategy.state.len() as u32;
        }
        *node - 1
    }

    /// The first goal in the rotation, from `memory` on, that is still to be met; the first of all if none is.
    ///
    /// A goal is passed over only when it is met, so a play either stays with one goal for ever, or meets
    /// all of them again and again.
    fn turn_to(&self, memory: usize, unmet: impl Fn(&Acceptance) -> bool) -> usize {
        let modes = self.rotation.len();
        let mut following = (memory..modes).chain(0..memory.min(modes));
        following.find(|&mode| unmet(&self.goals[self.rotation[mode]])).unwrap_or(0)
    }

    /// The move of the system.
    fn choose(&mut self, state: u32, memory: usize) -> Option<usize> {
        let Builder { game, solution, candidates, .. } = self;
        candidates.clear();
        candidates.extend(game.edges_of(state).filter(|&edge| solution.wins(game.target[edge])));
        for &goal in &self.orders[memory] {
            let progress = &solution.progress[goal];
            if candidates.len() > 1 && candidates.iter().any(|&edge| progress.contains(edge)) {
                candidates.retain(|&edge| progress.contains(edge));
            }
        }
        // The shorter super step; of these a yield, which sends nothing; of the others the smaller text.
        candidates.iter().copied().min_by_key(|&edge| {
            let target = game.target[edge];
            let system = game.turn[target as usize].is_system();
            let remaining = if system { solution.remaining[target as usize] } else { 0 };
            (remaining, game.label(edge) != YIELD, edge)
        })
    }
}

//! The plays of one strategy: explored breadth first, with the choices of the system made on the way.

use super::extract::ExtractError;
use super::{Game, Solution, Strategy, YIELD, acceptance::Acceptance};
use rustc_hash::FxHashSet;

/// What a strategy remembers.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Memory {
    /// The state of the game is enough.
    Nothing,
    /// The last decision between moves that make progress towards different goals; the same is taken again as long as it makes
    /// progress.
    KeepDecision,
    /// The last such decision; the next one in a fixed order is taken, round and round.
    RotateDecisions,
    /// The goal that is pursued, until it is met.
    Goal,
}

const NONE: u32 = u32::MAX;

/// Explores the plays of a strategy.
pub(super) struct Plays<'a> {
    game: &'a Game,
    solution: &'a Solution,
    goals: &'a [Acceptance],
    /// The goals between which the system has to divide its time. A goal in memory is an index of these.
    demanding: &'a [usize],
    memory: Memory,
    /// Per goal in memory, or only one: all goals, the most important first.
    orders: Vec<Vec<usize>>,
    /// Per action: it is one of those between which there is something to decide.
    decides: Vec<bool>,
    /// Per state: the first of its nodes.
    node: Vec<u32>,
    /// Per node: the next one of the same state.
    next: Vec<u32>,
    /// Per node: the content of the memory.
    remembered: Vec<u32>,
    strategy: Strategy,
    candidates: Vec<usize>,
}

impl<'a> Plays<'a> {
    pub(super) fn new(
        game: &'a Game,
        solution: &'a Solution,
        goals: &'a [Acceptance],
        order: &[usize],
        demanding: &'a [usize],
        memory: Memory,
    ) -> Self {
        let mut orders = vec![order.to_vec()];
        if memory == Memory::Goal {
            orders.resize(demanding.len(), order.to_vec());
            for (order, &pursued) in orders.iter_mut().zip(demanding) {
                order.sort_by_key(|&goal| goal != pursued);
            }
        }
        let plays = Plays {
            game,
            solution,
            goals,
            demanding,
            memory,
            orders,
            node: vec![NONE; game.states()],
            next: Vec::new(),
            remembered: Vec::new(),
            strategy: Strategy { state: Vec::new(), first: vec![0], edge: Vec::new(), target: Vec::new() },
            decides: vec![false; game.actions.len()],
            candidates: Vec::new(),
        };
        if plays.remembers_decisions() { plays.find_decisions() } else { plays }
    }

    fn remembers_decisions(&self) -> bool {
        matches!(self.memory, Memory::KeepDecision | Memory::RotateDecisions)
    }

    /// Looks for states in which several moves make progress towards demanding goals. Moves like these are remembered
    /// even where there is no choice.
    fn find_decisions(mut self) -> Self {
        let mut labels = FxHashSet::default();
        for state in self.solution.winning.ones().filter(|&state| self.game.turn[state].is_system()) {
            self.collect_candidates(state as u32);
            let useful: Vec<u32> = self.useful(state as u32).map(|edge| self.game.label(edge)).collect();
            if useful.len() > 1 {
                labels.extend(useful);
            }
        }
        self.decides = self.game.actions.labels().map(|label| labels.contains(&label)).collect();
        self
    }

    /// The graph of the plays.
    ///
    /// # Errors
    /// [`ExtractError::Leaves`].
    pub(super) fn explore(mut self) -> Result<Strategy, ExtractError> {
        self.enter(self.game.initial, self.begin());
        let mut node = 0;
        while let Some(&state) = self.strategy.state.get(node) {
            if !self.solution.wins(state) {
                return Err(ExtractError::Leaves(state));
            }
            let remembered = self.remembered[node];
            if self.game.turn[state as usize].is_system() {
                let choice = self.choose(state, remembered);
                let (edge, remembered) = choice.ok_or(ExtractError::Leaves(state))?;
                self.follow(edge, remembered);
            } else {
                for edge in self.game.edges_of(state) {
                    self.follow(edge, remembered);
                }
            }
            self.strategy.first.push(self.strategy.edge.len() as u32);
            node += 1;
        }
        Ok(self.strategy)
    }

    /// What is remembered before anything has happened: a decision after which the first of all is taken.
    fn begin(&self) -> u32 {
        let decides = |action: &u32| self.decides[*action as usize];
        let labels =
            (0..self.decides.len() as u32).filter(decides).map(|action| self.game.actions.label(action));
        match self.memory {
            Memory::Nothing | Memory::Goal => Some(0),
            Memory::KeepDecision => labels.min(),
            Memory::RotateDecisions => labels.max(),
        }
        .unwrap_or(0)
    }

    fn follow(&mut self, edge: usize, remembered: u32) {
        let action = self.game.action[edge];
        let remembered = self.turn_to(remembered, |goal| !goal.accepts(action));
        let target = self.enter(self.game.target[edge], remembered);
        self.strategy.edge.push(edge as u32);
        self.strategy.target.push(target);
    }

    /// The node of `state` when the memory holds `remembered` on arrival.
    fn enter(&mut self, state: u32, remembered: u32) -> u32 {
        let remembered = self.turn_to(remembered, |goal| goal.open.contains(state as usize));
        let mut node = self.node[state as usize];
        while node != NONE && self.remembered[node as usize] != remembered {
            node = self.next[node as usize];
        }
        if node == NONE {
            node = self.strategy.state.len() as u32;
            self.strategy.state.push(state);
            self.remembered.push(remembered);
            self.next.push(std::mem::replace(&mut self.node[state as usize], node));
        }
        node
    }

    /// The first goal in the rotation, from the remembered one on, that is still to be met; the first of all if none is.
    ///
    /// A goal is passed over only when it is met, so a play either stays with one goal for ever, or meets
    /// all of them again and again.
    fn turn_to(&self, remembered: u32, unmet: impl Fn(&Acceptance) -> bool) -> u32 {
        if self.memory != Memory::Goal {
            return remembered;
        }
        let goals = self.demanding.len() as u32;
        let mut following = (remembered..goals).chain(0..remembered.min(goals));
        following.find(|&goal| unmet(&self.goals[self.demanding[goal as usize]])).unwrap_or(0)
    }

    /// The move of the system, and what it remembers of it.
    fn choose(&mut self, state: u32, remembered: u32) -> Option<(usize, u32)> {
        self.collect_candidates(state);
        if !self.remembers_decisions() {
            let order = if self.memory == Memory::Goal { remembered as usize } else { 0 };
            return self.prefer(order).map(|edge| (edge, remembered));
        }
        let edge = self.decide(state, remembered).or_else(|| self.prefer(0))?;
        let is_decision = self.decides[self.game.action[edge] as usize];
        Some((edge, if is_decision { self.game.label(edge) } else { remembered }))
    }

    /// The moves that win.
    fn collect_candidates(&mut self, state: u32) {
        let Plays { game, solution, candidates, .. } = self;
        candidates.clear();
        candidates.extend(game.edges_of(state).filter(|&edge| solution.wins(game.target[edge])));
    }

    /// The candidates that make progress towards a demanding goal that is open.
    fn useful(&self, state: u32) -> impl Iterator<Item = usize> {
        let is_open = move |goal: &&usize| self.goals[**goal].open.contains(state as usize);
        let is_useful = move |edge: usize| {
            self.demanding.iter().filter(is_open).any(|&goal| self.solution.progress[goal].contains(edge))
        };
        self.candidates.iter().copied().filter(move |&edge| is_useful(edge))
    }

    /// A useful candidate by the last decision, if there are several.
    fn decide(&self, state: u32, last: u32) -> Option<usize> {
        if self.candidates.len() < 2 {
            return None;
        }
        let after = |label: u32| match self.memory {
            Memory::KeepDecision => label >= last,
            _ => label > last,
        };
        self.useful(state).min_by_key(|&edge| {
            let label = self.game.label(edge);
            (!after(label), label)
        })
    }

    /// By an order of the goals: those that make progress towards the first, of these those for the second, and so on.
    fn prefer(&mut self, order: usize) -> Option<usize> {
        let Plays { game, solution, candidates, orders, .. } = self;
        for &goal in &orders[order] {
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

//! The plays of one strategy with memory: explored breadth first, with the choices of the system made on the way.

use super::choices::{NONE, of_states};
use super::extract::ExtractError;
use super::preference::Preference;
use super::{Game, Solution, Strategy, acceptance::Acceptance};
use fixedbitset::FixedBitSet;
use rustc_hash::FxHashSet;
use std::sync::atomic::{AtomicBool, Ordering};

/// What a strategy remembers.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Memory {
    /// The last decision between moves that make progress towards different goals; the same is taken again as long as it makes
    /// progress.
    KeepDecision,
    /// The last such decision; the next one in a fixed order is taken, round and round.
    RotateDecisions,
    /// The goal that is pursued, until it is met.
    Goal,
}

/// Between what the system chooses.
#[derive(Clone, Copy)]
pub(super) struct Moves<'a> {
    pub(super) game: &'a Game,
    pub(super) solution: &'a Solution,
    pub(super) goals: &'a [Acceptance],
    /// All goals, the most important first.
    pub(super) order: &'a [usize],
    /// The goals between which the system has to divide its time. A goal in memory is an index of these.
    pub(super) demanding: &'a [usize],
}

impl Moves<'_> {
    fn preference(&self) -> Preference<'_> {
        Preference { game: self.game, solution: self.solution }
    }
}

/// Explores the plays of a strategy.
pub(super) struct Plays<'a> {
    moves: Moves<'a>,
    memory: Memory,
    /// Per goal in memory: all goals, the most important first.
    orders: Vec<Vec<usize>>,
    /// If decisions are remembered: the edges that make progress towards a demanding goal.
    useful: FixedBitSet,
    /// If decisions are remembered, per state of the system: what it chooses whatever it remembers.
    fixed: Vec<u32>,
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
    pub(super) fn new(moves: Moves<'a>, memory: Memory, threads: usize) -> Self {
        let Moves { game, order, demanding, .. } = moves;
        let mut plays = Plays {
            moves,
            memory,
            orders: Vec::new(),
            useful: FixedBitSet::new(),
            fixed: Vec::new(),
            decides: Vec::new(),
            node: vec![NONE; game.states()],
            next: Vec::new(),
            remembered: Vec::new(),
            strategy: Strategy { state: Vec::new(), first: vec![0], edge: Vec::new(), target: Vec::new() },
            candidates: Vec::new(),
        };
        if memory == Memory::Goal {
            plays.orders = vec![order.to_vec(); demanding.len()];
            for (order, &pursued) in plays.orders.iter_mut().zip(demanding) {
                order.sort_by_key(|&goal| goal != pursued);
            }
        } else {
            plays.find_decisions(threads);
        }
        plays
    }

    /// Looks for states in which several moves make progress towards demanding goals. Moves like these are remembered
    /// even where there is no choice.
    fn find_decisions(&mut self, threads: usize) {
        let Moves { game, solution, order, demanding, .. } = self.moves;
        self.useful.grow(game.edges());
        demanding.iter().for_each(|&goal| self.useful.union_with(&solution.progress[goal]));
        let decides: Vec<AtomicBool> = game.actions.labels().map(|_| AtomicBool::new(false)).collect();
        self.fixed = of_states(game, solution, threads, |state, candidates| {
            let preference = self.moves.preference();
            preference.collect_candidates(state, candidates);
            let mut useful = candidates.iter().copied().filter(|&edge| self.useful.contains(edge));
            match (useful.next(), useful.next()) {
                (Some(one), Some(other)) => {
                    for edge in [one, other].into_iter().chain(useful) {
                        decides[game.action[edge] as usize].store(true, Ordering::Relaxed);
                    }
                    None
                }
                (Some(only), None) => Some(only),
                _ => {
                    drop(useful);
                    preference.choose(order, candidates)
                }
            }
        });
        let labels = || game.actions.labels();
        let decided = labels().zip(decides).filter(|(_, decides)| decides.load(Ordering::Relaxed));
        let decided: FxHashSet<u32> = decided.map(|(label, _)| label).collect();
        self.decides = labels().map(|label| decided.contains(&label)).collect();
    }

    /// The graph of the plays.
    ///
    /// # Errors
    /// [`ExtractError::Leaves`].
    pub(super) fn explore(mut self) -> Result<Strategy, ExtractError> {
        let Moves { game, solution, .. } = self.moves;
        self.enter(game.initial, self.begin());
        let mut node = 0;
        while let Some(&state) = self.strategy.state.get(node) {
            if !solution.wins(state) {
                return Err(ExtractError::Leaves(state));
            }
            let remembered = self.remembered[node];
            if game.turn[state as usize].is_system() {
                let edge = self.choose(state, remembered).ok_or(ExtractError::Leaves(state))?;
                self.follow(edge, self.remember(edge, remembered));
            } else {
                for edge in game.edges_of(state) {
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
        let labels = self.moves.game.actions.labels().zip(&self.decides);
        let decided = labels.filter(|(_, decides)| **decides).map(|(label, _)| label);
        match self.memory {
            Memory::Goal => Some(0),
            Memory::KeepDecision => decided.min(),
            Memory::RotateDecisions => decided.max(),
        }
        .unwrap_or(0)
    }

    fn follow(&mut self, edge: usize, remembered: u32) {
        let action = self.moves.game.action[edge];
        let remembered = self.turn_to(remembered, |goal| !goal.accepts(action));
        let target = self.enter(self.moves.game.target[edge], remembered);
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
        let Moves { goals, demanding, .. } = self.moves;
        let all = demanding.len() as u32;
        let mut following = (remembered..all).chain(0..remembered.min(all));
        following.find(|&goal| unmet(&goals[demanding[goal as usize]])).unwrap_or(0)
    }

    /// The move of the system.
    fn choose(&mut self, state: u32, remembered: u32) -> Option<usize> {
        let fixed = self.fixed.get(state as usize).filter(|&&edge| edge != NONE);
        if let Some(&edge) = fixed {
            return Some(edge as usize);
        }
        let preference = self.moves.preference();
        preference.collect_candidates(state, &mut self.candidates);
        match self.memory {
            Memory::Goal => preference.choose(&self.orders[remembered as usize], &mut self.candidates),
            Memory::KeepDecision => self.decide(|label| label < remembered),
            Memory::RotateDecisions => self.decide(|label| label <= remembered),
        }
    }

    /// The first useful candidate in the order of decisions; those whose turn comes `later` come last.
    fn decide(&self, later: impl Fn(u32) -> bool) -> Option<usize> {
        let useful = self.candidates.iter().copied().filter(|&edge| self.useful.contains(edge));
        useful.min_by_key(|&edge| {
            let label = self.moves.game.label(edge);
            (later(label), label)
        })
    }

    /// What the system remembers behind an edge that it has chosen.
    fn remember(&self, edge: usize, remembered: u32) -> u32 {
        let action = self.moves.game.action[edge];
        let is_decision = self.decides.get(action as usize).is_some_and(|&decides| decides);
        if is_decision { self.moves.game.label(edge) } else { remembered }
    }
}

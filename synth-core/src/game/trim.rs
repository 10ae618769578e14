//! Which goals can a play miss at all? A quick answer for many goals at once, one bit for each.
//!
//! A play that misses a goal for ever goes on for ever through nodes where the goal is open. Nodes from which none does are
//! removed, backwards, until nothing changes; the goals are the bits of a word, so that one pass serves 64 of them. What
//! is left holds every cycle that misses a goal, and in a good strategy nothing is left.

use super::{Game, Strategy, acceptance::Acceptance};
use std::collections::VecDeque;

/// Goals that are looked at together.
pub(super) const GOALS: usize = u64::BITS as usize;

/// Removes what cannot belong to a play that misses a goal and is fair.
pub(super) struct Trim<'a> {
    game: &'a Game,
    strategy: &'a Strategy,
    /// Per node: where its predecessors begin in `source`.
    first: Vec<u32>,
    source: Vec<u32>,
    /// Per node: a play that stays there in silence is fair.
    rests: Vec<bool>,
    queue: VecDeque<u32>,
    queued: Vec<bool>,
}

impl<'a> Trim<'a> {
    /// `is_assumption` says of each key whether plays must be fair to it.
    pub(super) fn new(game: &'a Game, strategy: &'a Strategy, is_assumption: &[bool]) -> Self {
        let sets = 0..game.key_sets.len() as u32;
        let assumes: Vec<bool> =
            sets.map(|set| game.key_sets.members(set).any(|key| is_assumption[key as usize])).collect();
        let rests = |&state: &u32| {
            let state = state as usize;
            game.silent[state] && game.turn[state].is_environment() && !assumes[game.open[state] as usize]
        };
        let nodes = strategy.nodes();
        let mut first = vec![0; nodes + 2];
        for &target in &strategy.target {
            first[target as usize + 2] += 1;
        }
        for node in 2..first.len() {
            first[node] += first[node - 1];
        }
        let mut source = vec![0; strategy.target.len()];
        for node in 0..nodes as u32 {
            for edge in strategy.edges_of(node) {
                let next = &mut first[strategy.target[edge] as usize + 1];
                source[*next as usize] = node;
                *next += 1;
            }
        }
        first.pop();
        let rests = strategy.state.iter().map(rests).collect();
        Trim {
            game,
            strategy,
            first,
            source,
            rests,
            queue: VecDeque::with_capacity(nodes),
            queued: vec![false; nodes],
        }
    }

    /// Per node: the goals, at most [`GOALS`], that a play from there may miss for ever.
    pub(super) fn run(&mut self, goals: &[Acceptance]) -> Vec<u64> {
        let strategy = self.strategy;
        let mut open = vec![0u64; self.game.states()];
        let mut kept = vec![0u64; self.game.actions.len()];
        for (bit, goal) in goals.iter().enumerate() {
            goal.open.ones().for_each(|state| open[state] |= 1 << bit);
            for (action, kept) in (0..).zip(&mut kept) {
                *kept |= u64::from(!goal.accepts(action)) << bit;
            }
        }
        let mut alive: Vec<u64> = strategy.state.iter().map(|&state| open[state as usize]).collect();
        drop(open);
        // Successors have mostly been found later than their predecessors. First in, first out: what more than one successor
        // has to say is heard at once.
        self.queue.extend((0..strategy.nodes() as u32).rev());
        self.queued.fill(true);
        while let Some(node) = self.queue.pop_front() {
            let index = node as usize;
            self.queued[index] = false;
            let before = alive[index];
            if before == 0 || self.rests[index] {
                continue;
            }
            let mut after = 0;
            for edge in strategy.edges_of(node) {
                let action = self.game.action[strategy.edge[edge] as usize];
                after |= alive[strategy.target[edge] as usize] & kept[action as usize];
                if after & before == before {
                    break;
                }
            }
            let after = after & before;
            if after != before {
                alive[index] = after;
                for &source in &self.source[self.first[index] as usize..self.first[index + 1] as usize] {
                    if alive[source as usize] & before & !after != 0 && !self.queued[source as usize] {
                        self.queued[source as usize] = true;
                        self.queue.push_back(source);
                    }
                }
            }
        }
        alive
    }
}

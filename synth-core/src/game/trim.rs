//! Which goals can a play miss at all? A quick answer for many goals at once, one bit for each.
//!
//! A play that misses a goal for ever goes on for ever through nodes where the goal is open. Nodes from which none does are
//! removed, backwards, until nothing changes; the goals are the bits of a word, so that one pass serves 64 of them. What
//! is left holds every cycle that misses a goal, and in a good strategy nothing is left.

use super::{Game, Strategy, acceptance::Acceptance};

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
    /// Per node: it must be looked at.
    pending: Vec<bool>,
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
        Trim { game, strategy, first, source, rests, pending: vec![false; nodes] }
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
        // Successors have mostly been found later than their predecessors, so sweeps go backwards.
        self.pending.fill(true);
        let mut is_last = false;
        while !is_last {
            is_last = true;
            for node in (0..strategy.nodes()).rev() {
                let before = alive[node];
                if !std::mem::take(&mut self.pending[node]) || before == 0 || self.rests[node] {
                    continue;
                }
                let after = before & self.missed_behind(node as u32, before, &alive, &kept);
                if after == before {
                    continue;
                }
                alive[node] = after;
                for &source in &self.source[self.first[node] as usize..self.first[node + 1] as usize] {
                    let source = source as usize;
                    if alive[source] & before & !after != 0 {
                        self.pending[source] = true;
                        is_last &= source < node;
                    }
                }
            }
        }
        alive
    }

    /// Which of the goals `before` a play that goes on from a node may miss.
    fn missed_behind(&self, node: u32, before: u64, alive: &[u64], kept: &[u64]) -> u64 {
        let mut after = 0;
        for edge in self.strategy.edges_of(node) {
            let action = self.game.action[self.strategy.edge[edge] as usize];
            after |= alive[self.strategy.target[edge] as usize] & kept[action as usize];
            if after & before == before {
                break;
            }
        }
        after
    }
}

//! Which goals can a play miss at all? A quick answer for many goals at once, one bit for each.
//!
//! A play that misses a goal for ever goes on for ever through nodes where the goal is open. Nodes from which none does are
//! removed, backwards, until nothing changes; the goals are the bits of a word, so that one pass serves 64 of them. What
//! is left holds every cycle that misses a goal, and in a good strategy nothing is left.

use super::{Game, Strategy, acceptance::Acceptance};
use fixedbitset::FixedBitSet;

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
    /// The nodes to look at.
    pending: FixedBitSet,
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
        Trim { game, strategy, first, source, rests, pending: FixedBitSet::with_capacity(nodes) }
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
        // Successors have mostly been found later than their predecessors, so a sweep goes backwards.
        self.pending.insert_range(..);
        while !self.pending.is_clear() {
            let mut below = strategy.nodes();
            while let Some(index) = last_below(&self.pending, below) {
                below = index;
                self.pending.set(index, false);
                let before = alive[index];
                if before == 0 || self.rests[index] {
                    continue;
                }
                let after = before & self.missed_behind(index as u32, before, &alive, &kept);
                if after != before {
                    alive[index] = after;
                    for &source in &self.source[self.first[index] as usize..self.first[index + 1] as usize] {
                        if alive[source as usize] & before & !after != 0 {
                            self.pending.insert(source as usize);
                        }
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

/// The last element of a set that is less than `below`.
fn last_below(set: &FixedBitSet, below: usize) -> Option<usize> {
    let words = set.as_slice();
    let bits = usize::BITS as usize;
    let (mut word, bit) = (below / bits, below % bits);
    let mut value = if bit == 0 { 0 } else { words[word] & (usize::MAX >> (bits - bit)) };
    loop {
        if value != 0 {
            return Some(word * bits + bits - 1 - value.leading_zeros() as usize);
        }
        word = word.checked_sub(1)?;
        value = words[word];
    }
}

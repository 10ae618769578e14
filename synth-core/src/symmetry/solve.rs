//! Who wins the game up to symmetry.
//!
//! The winning region of the whole game is mapped onto itself by every permutation, so it is a set of representatives. The
//! states from which the system can force progress towards a goal are not, but pairs of a state and a goal are mapped onto such
//! pairs, and so are triples with a promise. So the fixed point `νZ. ⋀j μY. ⋁i νX. (Gj ∧ ◇Z) ∨ ◇Y ∨ (¬Ai ∧ ◇X)` of Piterman, Pnueli and Sa'ar
//! (2006) is computed with `Z` over states, `Y` over states with a goal that is open there, and `X` over these with an open
//! promise; an edge leads to the goal and the promise that its permutation makes of them. A goal that is not open is met.

use super::quotient::{MET, Quotient};
use crate::game::Turn;
use fixedbitset::FixedBitSet;
use std::collections::VecDeque;

/// The states from which the system wins.
pub(super) fn solve(game: &Quotient) -> FixedBitSet {
    let mut solver = Solver::new(game);
    let is_lost = |&state: &usize| game.turn[state] == Turn::Lost;
    solver.remove((0..game.states()).filter(is_lost).collect());
    loop {
        solver.pursue();
        let lost: Vec<usize> = solver.winning.ones().filter(|&state| solver.fails(state)).collect();
        if lost.is_empty() {
            return solver.winning;
        }
        solver.remove(lost);
    }
}

struct Solver<'g> {
    game: &'g Quotient,
    /// Per state: the states with an edge there.
    sources: Vec<Vec<u32>>,
    /// Per system state: how many of its edges stay inside `winning`.
    choices: Vec<u32>,
    /// Offsets of pairs by state, and of triples.
    pairs: Vec<usize>,
    triples: Vec<usize>,
    /// `Z`: the environment cannot leave it, and the system need not.
    winning: FixedBitSet,
    /// `Y`.
    good: FixedBitSet,
    /// `X`.
    kept: FixedBitSet,
    /// States to be looked at once more.
    queue: VecDeque<usize>,
    queued: FixedBitSet,
}

impl<'g> Solver<'g> {
    fn new(game: &'g Quotient) -> Self {
        let states = game.states();
        let mut sources = vec![Vec::new(); states];
        let mut choices = vec![0; states];
        let (mut pairs, mut triples) = (vec![0], vec![0]);
        for state in 0..states {
            for edge in game.edges_of(state) {
                sources[game.target[edge] as usize].push(state as u32);
                choices[state] += 1;
            }
            let (goals, promises) = game.open[state];
            pairs.push(pairs[state] + goals as usize);
            triples.push(triples[state] + goals as usize * promises as usize);
        }
        let mut winning = FixedBitSet::with_capacity(states);
        winning.insert_range(..);
        Solver {
            good: FixedBitSet::with_capacity(pairs[states]),
            kept: FixedBitSet::with_capacity(triples[states]),
            queued: FixedBitSet::with_capacity(states),
            queue: VecDeque::new(),
            game,
            sources,
            choices,
            pairs,
            triples,
            winning,
        }
    }

    /// Removes states and all from which the environment can force the play there.
    fn remove(&mut self, mut lost: Vec<usize>) {
        lost.iter().for_each(|&state| self.winning.set(state, false));
        while let Some(state) = lost.pop() {
            for &source in &self.sources[state] {
                let source = source as usize;
                if !self.winning.contains(source) {
                    continue;
                }
                if self.game.turn[source].is_system() {
                    self.choices[source] -= 1;
                    if self.choices[source] > 0 {
                        continue;
                    }
                }
                self.winning.set(source, false);
                lost.push(source);
            }
        }
    }

    /// Whether some goal cannot be pursued from a state.
    fn fails(&self, state: usize) -> bool {
        (self.pairs[state]..self.pairs[state + 1]).any(|pair| !self.good.contains(pair))
    }

    /// Finds the pairs from which the goal is met or a promise is broken, inside `winning`.
    fn pursue(&mut self) {
        self.good.clear();
        self.look_at_all();
        loop {
            self.attract();
            self.kept.insert_range(..);
            self.look_at_all();
            self.avoid();
            if !self.add_kept() {
                return;
            }
        }
    }

    /// From where the system can force the play to good pairs.
    fn attract(&mut self) {
        while let Some(state) = self.next() {
            let mut changed = false;
            for goal in 0..self.game.open[state].0 {
                let pair = self.pairs[state] + goal as usize;
                if !self.good.contains(pair) && self.is_attracted(state, goal) {
                    self.good.insert(pair);
                    changed = true;
                }
            }
            if changed {
                self.look_before(state);
            }
        }
    }

    fn is_attracted(&self, state: usize, goal: u32) -> bool {
        let game = self.game;
        let mut edges = game.edges_of(state);
        if game.turn[state].is_system() {
            edges.any(|edge| self.is_good(edge, goal))
        } else {
            !game.silent[state] && edges.all(|edge| self.is_good(edge, goal))
        }
    }

    /// Takes triples out of `kept` from which the system cannot avoid that the promise is kept.
    fn avoid(&mut self) {
        while let Some(state) = self.next() {
            let (goals, promises) = self.game.open[state];
            let mut changed = false;
            for goal in 0..goals {
                if self.good.contains(self.pairs[state] + goal as usize) {
                    continue;
                }
                for promise in 0..promises {
                    let triple = self.triples[state] + goal as usize * promises as usize + promise as usize;
                    if self.kept.contains(triple) && !self.is_kept(state, goal, promise) {
                        self.kept.set(triple, false);
                        changed = true;
                    }
                }
            }
            if changed {
                self.look_before(state);
            }
        }
    }

    fn is_kept(&self, state: usize, goal: u32, promise: u32) -> bool {
        let game = self.game;
        let mut edges = game.edges_of(state);
        let stays = |edge| self.is_good(edge, goal) || self.avoids(state, edge, goal, promise);
        if game.turn[state].is_system() { edges.any(stays) } else { edges.all(stays) }
    }

    /// Whether an edge meets the goal or leads to a good pair.
    fn is_good(&self, edge: usize, goal: u32) -> bool {
        let target = self.game.target[edge] as usize;
        let name = self.game.goal(edge, goal);
        self.winning.contains(target)
            && (name == MET || self.good.contains(self.pairs[target] + name as usize))
    }

    /// Whether an edge leads to a kept triple and does not keep the promise.
    fn avoids(&self, state: usize, edge: usize, goal: u32, promise: u32) -> bool {
        let game = self.game;
        let target = game.target[edge] as usize;
        let kept = game.promise(edge, game.open[state].0, promise);
        if kept == MET || !self.winning.contains(target) {
            return false;
        }
        let name = game.goal(edge, goal);
        name != MET
            && self
                .kept
                .contains(self.triples[target] + name as usize * game.open[target].1 as usize + kept as usize)
    }

    /// Makes the pairs of kept triples good; whether there was any.
    fn add_kept(&mut self) -> bool {
        let mut any = false;
        for state in self.winning.ones().collect::<Vec<_>>() {
            let (goals, promises) = self.game.open[state];
            let mut changed = false;
            for goal in 0..goals {
                let pair = self.pairs[state] + goal as usize;
                let from = self.triples[state] + goal as usize * promises as usize;
                let is_kept = || (from..from + promises as usize).any(|triple| self.kept.contains(triple));
                if !self.good.contains(pair) && is_kept() {
                    self.good.insert(pair);
                    changed = true;
                }
            }
            if changed {
                self.look_before(state);
                any = true;
            }
        }
        any
    }

    fn next(&mut self) -> Option<usize> {
        let state = self.queue.pop_front()?;
        self.queued.set(state, false);
        Some(state)
    }

    fn look_at_all(&mut self) {
        // What is far from the initial state comes first, since what holds there decides what holds before it.
        for state in self.winning.ones().rev().collect::<Vec<_>>() {
            self.look_at(state);
        }
    }

    fn look_before(&mut self, state: usize) {
        for index in 0..self.sources[state].len() {
            let source = self.sources[state][index] as usize;
            if self.winning.contains(source) {
                self.look_at(source);
            }
        }
    }

    fn look_at(&mut self, state: usize) {
        if !self.queued.put(state) {
            self.queue.push_back(state);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A game in which no edge meets anything unless `met` says so: states with their goals and promises, edges as source,
    /// target and the names of what is open in the source.
    #[track_caller]
    fn check(states: &[(Turn, bool, (u32, u32))], edges: &[(usize, u32, &[u32])], winning: &[usize]) {
        let mut game = Quotient { first: vec![0], named: vec![0], ..Quotient::default() };
        for (state, &(turn, silent, open)) in states.iter().enumerate() {
            for (_, target, names) in edges.iter().filter(|edge| edge.0 == state) {
                game.target.push(*target);
                game.names.extend_from_slice(names);
                game.named.push(game.names.len());
            }
            game.turn.push(turn);
            game.silent.push(silent);
            game.open.push(open);
            game.first.push(game.target.len() as u32);
        }
        assert_eq!(solve(&game).ones().collect::<Vec<_>>(), winning);
    }

    #[test]
    fn goals_that_change_places_are_never_met() {
        // One edge that swaps two goals: neither is met; and one that meets what is called the first.
        check(&[(Turn::EnvironmentAny, false, (2, 0))], &[(0, 0, &[1, 0])], &[]);
        check(&[(Turn::EnvironmentAny, false, (2, 0))], &[(0, 0, &[MET, 0])], &[0]);
        check(&[(Turn::EnvironmentAny, false, (2, 0))], &[(0, 0, &[MET, 1])], &[]);
    }

    #[test]
    fn a_promise_is_followed_to_where_it_is_kept() {
        // The goal stays open for ever. Both promises, which take turns, are kept again and again; or the second one is not.
        check(&[(Turn::EnvironmentAny, false, (1, 2))], &[(0, 0, &[0, MET, 0])], &[]);
        check(&[(Turn::EnvironmentAny, false, (1, 2))], &[(0, 0, &[0, MET, 1])], &[0]);
    }

    #[test]
    fn silence_keeps_everything_open() {
        check(&[(Turn::EnvironmentAny, true, (1, 0))], &[(0, 0, &[MET])], &[]);
        check(&[(Turn::EnvironmentAny, true, (1, 1))], &[(0, 0, &[MET, MET])], &[0]);
    }

    #[test]
    fn a_system_does_not_go_where_it_loses() {
        let lost = (Turn::Lost, false, (0, 0));
        let system = (Turn::SystemUrgent, false, (1, 0));
        check(&[system, lost], &[(0, 1, &[MET])], &[]);
        check(
            &[system, lost, (Turn::EnvironmentAny, true, (0, 0))],
            &[(0, 1, &[MET]), (0, 2, &[MET])],
            &[0, 2],
        );
    }
}

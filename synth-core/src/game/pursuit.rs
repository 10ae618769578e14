//! One goal pursued inside a region: where can the system force that the goal is accepted once more, or that some
//! assumption never is again?
//!
//! Only states in which the goal is open matter: the others accept it. Of these, states that are known to be good are
//! removed from a set `left` and given a *rank*, in two ways that alternate:
//!
//! * **Attraction**: a system state with an edge (inside the region) that accepts or leads to a good state; an
//!   environment state all of whose choices do. Silence is a choice that accepts nothing, so where the environment
//!   may be silent nothing is attracted. The rank is the number of steps.
//! * **Avoidance** of one assumption `A`: the largest part of `left` where `A` is open and in which the system can
//!   keep the play, or see it go to good states, without a step that accepts `A`. It gets one rank for all, above
//!   the ones before. A play that stays there is not fair to `A`; one that leaves it goes to a lower rank.
//!
//! So along moves that make *progress* (to a lower rank, or inside an avoidance without accepting its assumption)
//! ranks never rise until the goal is accepted, and if they stay the same for ever, then in an avoidance.
//!
//! Each assumption is tried again and again, and what is good only grows. An avoidance that was not there the last time
//! leads to something that has become good since. Where that is little, it is looked for backwards from there, and not
//! in the whole of `left`.
//!
//! If super steps must end, an avoidance is also such that the end of the super step can always be reached in it, and
//! only moves towards that end make progress.
//!
//! What is left in the end is the environment's: no system state has an edge to good states or one that accepts, each
//! environment state has a choice that stays and does not, and for every `A` the environment can force its
//! acceptance inside `left`, since otherwise there would be an avoidance. So it accepts them all in rotation.

use super::{
    Game,
    acceptance::Acceptance,
    predecessors::{Incoming, Predecessors},
};
use fixedbitset::FixedBitSet;
use std::collections::VecDeque;

/// To look backwards from a state costs about so many times what it costs to look at a state.
const DEARER: usize = 4;

/// Pursues goals one after the other, with arrays that are allocated once.
#[derive(Debug)]
pub(super) struct Pursuit<'g> {
    game: &'g Game,
    predecessors: &'g Predecessors,
    /// Super steps must end in an avoidance, too.
    ending: bool,
    /// The states not known to be good.
    left: FixedBitSet,
    /// Per good state in which the goal is open: its rank, from 1.
    rank: Vec<u32>,
    /// The good states in which the goal is open, by ascending rank.
    good: Vec<u32>,
    /// How many of `good` have been looked at by [`Self::attract`].
    attracted: usize,
    /// Per assumption: how many of `good` were known when its avoidance was last computed.
    known: Vec<Option<usize>>,
    /// The states of an avoidance while it is computed.
    kept: FixedBitSet,
    /// The states that were in `kept` at first, or are still.
    candidates: Vec<u32>,
    /// Per state of the environment: why it could not be kept the last time; mostly it is the same reason the next time.
    refusals: Vec<Refusal>,
    /// What a refusal of now is about: a number of its own for each run and assumption.
    about: u32,
    /// The states that have been dropped from `kept`, to be looked at.
    dropped: Vec<u32>,
    /// Of an environment state in `left`: its choices that stay in `left` and do not accept the goal. Of a system
    /// state in `kept`: its edges that stay in `kept` and do not accept the assumption.
    choices: Vec<u32>,
    /// If super steps must end, per state in `kept`: how many choices of the system their end takes at least.
    distance: Vec<u32>,
}

impl<'g> Pursuit<'g> {
    /// No goal is pursued yet.
    pub(super) fn new(game: &'g Game, predecessors: &'g Predecessors, ending: bool) -> Self {
        let states = game.states();
        Pursuit {
            game,
            predecessors,
            ending,
            left: FixedBitSet::with_capacity(states),
            rank: vec![0; states],
            good: Vec::new(),
            attracted: 0,
            known: Vec::new(),
            kept: FixedBitSet::with_capacity(states),
            candidates: Vec::new(),
            refusals: vec![Refusal::default(); states],
            about: 0,
            dropped: Vec::new(),
            choices: vec![0; states],
            distance: vec![0; if ending { states } else { 0 }],
        }
    }

    /// Pursues `goal`, or the avoidance of one of the assumptions, inside `region`: the states from which the
    /// environment wins against it, and in `progress` the edges of the other system states that make progress.
    pub(super) fn run(
        &mut self,
        goal: &Acceptance,
        assumptions: &[Acceptance],
        region: &FixedBitSet,
        progress: &mut FixedBitSet,
    ) -> &FixedBitSet {
        // It may have been another goal's, or nobody's.
        progress.clear();
        progress.grow(self.game.edges());
        self.known.clear();
        self.known.resize(assumptions.len(), None);
        self.start(goal, region);
        self.attract(goal, region, progress);
        // The assumptions in rotation, until none of them has an avoidance any more.
        let (mut assumption, mut without) = (0, 0);
        let about = self.about + 1;
        while without < assumptions.len() && !self.left.is_clear() {
            without += 1;
            self.about = about + assumption as u32;
            let known = self.known[assumption].replace(self.good.len());
            if self.avoid(&assumptions[assumption], goal, known) {
                self.collect_kept(&assumptions[assumption], progress);
                self.attract(goal, region, progress);
                without = 0;
            }
            assumption = (assumption + 1) % assumptions.len();
        }
        self.about = about + assumptions.len() as u32;
        &self.left
    }

    /// The ranks of the last run; 0 where its goal is not open, or cannot be met.
    pub(super) fn into_ranks(self) -> Vec<u32> {
        let mut ranks = vec![0; self.rank.len()];
        for state in self.good {
            ranks[state as usize] = self.rank[state as usize];
        }
        ranks
    }

    /// The states of rank 1, and the choices of the others.
    fn start(&mut self, goal: &Acceptance, region: &FixedBitSet) {
        let Game { target, action, .. } = self.game;
        self.good.clear();
        self.attracted = 0;
        self.left.clone_from(region);
        self.left.intersect_with(&goal.open);
        for state in self.left.ones() {
            if self.game.silent[state] && !self.game.turn[state].is_system() {
                continue;
            }
            let mut edges = self.game.edges_of(state as u32);
            let good = if self.game.turn[state].is_system() {
                edges.any(|edge| {
                    let target = target[edge] as usize;
                    region.contains(target) && (goal.accepts(action[edge]) || !goal.open.contains(target))
                })
            } else {
                // The environment does not leave the region, so `goal.open` is as good as `left`. Where there is no
                // choice at all, as in `Turn::Won`, the play is over and the system has not lost.
                let stays =
                    |&edge: &usize| !goal.accepts(action[edge]) && goal.open.contains(target[edge] as usize);
                self.choices[state] = edges.filter(stays).count() as u32;
                self.choices[state] == 0
            };
            if good {
                self.good.push(state as u32);
            }
        }
        for &state in &self.good {
            self.left.set(state as usize, false);
            self.rank[state as usize] = 1;
        }
    }

    /// Attracts what can be forced to good states.
    fn attract(&mut self, goal: &Acceptance, region: &FixedBitSet, progress: &mut FixedBitSet) {
        while let Some(&state) = self.good.get(self.attracted) {
            self.attracted += 1;
            let rank = self.rank[state as usize];
            if self.game.turn[state as usize].is_system() {
                self.mark_progress(state, goal, region, progress);
            }
            for &Incoming { source, action } in self.predecessors.forced(state) {
                let index = source as usize;
                if !self.left.contains(index) {
                    continue;
                }
                if !self.game.turn[index].is_system() {
                    if goal.accepts(action) {
                        continue;
                    }
                    self.choices[index] -= 1;
                    if self.choices[index] > 0 {
                        continue;
                    }
                }
                self.left.set(index, false);
                self.rank[index] = rank + 1;
                self.good.push(source);
            }
        }
    }

    /// Marks the edges of a system state that accept the goal or lead to a lower rank.
    fn mark_progress(&self, state: u32, goal: &Acceptance, region: &FixedBitSet, progress: &mut FixedBitSet) {
        let rank = self.rank[state as usize];
        for edge in self.game.edges_of(state) {
            let target = self.game.target[edge] as usize;
            if region.contains(target)
                && (goal.accepts(self.game.action[edge])
                    || !goal.open.contains(target)
                    || !self.left.contains(target) && self.rank[target] < rank)
            {
                progress.insert(edge);
            }
        }
    }

    /// Computes in `kept` the avoidance of `assumption`, if `known` of the good states were known the last time; whether
    /// there is one.
    fn avoid(&mut self, assumption: &Acceptance, goal: &Acceptance, known: Option<usize>) -> bool {
        let Game { target, action, .. } = self.game;
        self.candidates.drain(..).for_each(|state| self.kept.set(state as usize, false));
        let possible = self.left.intersection_count(&assumption.open);
        match known {
            Some(known) if self.good.len() - known < possible / DEARER => {
                self.collect_behind(assumption, goal, known);
            }
            _ => self.collect_candidates(assumption),
        }
        for &state in &self.candidates {
            let mut edges = self.game.edges_of(state);
            let avoids =
                |edge: usize| !assumption.accepts(action[edge]) && self.kept.contains(target[edge] as usize);
            let drop = if self.game.turn[state as usize].is_system() {
                let count = edges.filter(|&edge| avoids(edge)).count() as u32;
                self.choices[state as usize] = count;
                count == 0
            } else {
                let refusing = edges.find(|&edge| {
                    let stays = self.left.contains(target[edge] as usize) && !goal.accepts(action[edge]);
                    stays && !avoids(edge)
                });
                // If the target is only not kept now, that is no reason for later.
                if let Some(edge) = refusing
                    && (assumption.accepts(action[edge]) || !assumption.open.contains(target[edge] as usize))
                {
                    self.refusals[state as usize] = Refusal { target: target[edge], about: self.about };
                }
                refusing.is_some()
            };
            if drop {
                self.dropped.push(state);
            }
        }
        for &state in &self.dropped {
            self.kept.set(state as usize, false);
        }
        self.drop_all(assumption, goal);
        while self.ending && self.drop_endless(assumption) {
            self.drop_all(assumption, goal);
        }
        self.candidates.retain(|&state| self.kept.contains(state as usize));
        !self.candidates.is_empty()
    }

    /// Collects in `kept` what can belong to an avoidance: what no known refusal speaks against.
    fn collect_candidates(&mut self, assumption: &Acceptance) {
        let Pursuit { left, candidates, refusals, kept, .. } = self;
        kept.clone_from(left);
        kept.intersect_with(&assumption.open);
        candidates.extend(kept.ones().map(|state| state as u32));
        candidates.retain(|&state| {
            let is_refused = refusals[state as usize].holds(self.about, left);
            kept.set(state as usize, !is_refused);
            !is_refused
        });
    }

    /// Collects what nothing speaks against at once, but only what leads to states that are good since the first `known` were.
    fn collect_behind(&mut self, assumption: &Acceptance, goal: &Acceptance, known: usize) {
        let Pursuit { game, left, candidates, refusals, kept, .. } = self;
        let Game { target, action: actions, .. } = game;
        let refuses = |&edge: &usize| {
            let (action, target) = (actions[edge], target[edge] as usize);
            left.contains(target)
                && (assumption.accepts(action) || !assumption.open.contains(target))
                && !goal.accepts(action)
        };
        let (mut new, mut next) = (known, 0);
        loop {
            let state = if let Some(&state) = self.good.get(new) {
                new += 1;
                state
            } else if let Some(&state) = candidates.get(next) {
                next += 1;
                state
            } else {
                break;
            };
            for &Incoming { source, action } in self.predecessors.of(state) {
                let index = source as usize;
                if !left.contains(index) || !assumption.open.contains(index) || kept.contains(index) {
                    continue;
                }
                let is_refused = if game.turn[index].is_system() {
                    assumption.accepts(action)
                } else if goal.accepts(action) || refusals[index].holds(self.about, left) {
                    true
                } else if let Some(edge) = game.edges_of(source).find(refuses) {
                    refusals[index] = Refusal { target: target[edge], about: self.about };
                    true
                } else {
                    false
                };
                if !is_refused {
                    kept.insert(index);
                    candidates.push(source);
                }
            }
        }
    }

    /// Drops the states that cannot be kept without those in `dropped`.
    fn drop_all(&mut self, assumption: &Acceptance, goal: &Acceptance) {
        while let Some(state) = self.dropped.pop() {
            for &Incoming { source, action } in self.predecessors.of(state) {
                let index = source as usize;
                if !self.kept.contains(index) {
                    continue;
                }
                if self.game.turn[index].is_system() {
                    if assumption.accepts(action) {
                        continue;
                    }
                    self.choices[index] -= 1;
                    if self.choices[index] > 0 {
                        continue;
                    }
                } else if goal.accepts(action) {
                    continue;
                }
                self.kept.set(index, false);
                self.dropped.push(source);
            }
        }
    }

    /// Computes `distance`, and drops the states from which no super step ends among the kept ones; whether there are
    /// any.
    fn drop_endless(&mut self, assumption: &Acceptance) -> bool {
        const FAR: u32 = u32::MAX;
        let mut reached: VecDeque<u32> = VecDeque::new();
        let kept = self.candidates.iter().filter(|&&state| self.kept.contains(state as usize));
        for &state in kept.clone() {
            if self.game.turn[state as usize].is_system() {
                self.distance[state as usize] = FAR;
            } else {
                self.distance[state as usize] = 0;
                reached.push_back(state);
            }
        }
        while let Some(state) = reached.pop_front() {
            for &Incoming { source, action } in self.predecessors.of(state) {
                let index = source as usize;
                if self.kept.contains(index) && self.distance[index] == FAR && !assumption.accepts(action) {
                    self.distance[index] = self.distance[state as usize] + 1;
                    reached.push_back(source);
                }
            }
        }
        self.dropped.extend(kept.filter(|&&state| self.distance[state as usize] == FAR));
        for &state in &self.dropped {
            self.kept.set(state as usize, false);
        }
        !self.dropped.is_empty()
    }

    /// Makes the states of an avoidance good, all with the same rank.
    fn collect_kept(&mut self, assumption: &Acceptance, progress: &mut FixedBitSet) {
        let rank = self.good.last().map_or(0, |&last| self.rank[last as usize]) + 1;
        for &state in &self.candidates {
            self.left.set(state as usize, false);
            self.rank[state as usize] = rank;
            self.good.push(state);
            if self.game.turn[state as usize].is_system() {
                for edge in self.game.edges_of(state) {
                    let target = self.game.target[edge] as usize;
                    if !assumption.accepts(self.game.action[edge])
                        && self.kept.contains(target)
                        && (!self.ending || self.distance[target] < self.distance[state as usize])
                    {
                        progress.insert(edge);
                    }
                }
            }
        }
    }
}

/// Why a state of the environment cannot be kept as long as this target of an edge is left, whatever else is kept: the edge accepts
/// the assumption, or the assumption is not open there.
#[derive(Clone, Copy, Default, Debug)]
struct Refusal {
    target: u32,
    about: u32,
}

impl Refusal {
    /// Whether it holds of a goal and an assumption.
    fn holds(self, about: u32, left: &FixedBitSet) -> bool {
        self.about == about && left.contains(self.target as usize)
    }
}

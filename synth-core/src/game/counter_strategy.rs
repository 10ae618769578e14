//! The environment's side of a game that the system cannot win: how it plays against whatever the system does.
//!
//! The solver takes states out of the game in layers: first the environment's attractor of
//! [`Turn::Lost`](super::Turn::Lost), then, again and again, a *core* (the states in which the environment starves one
//! goal for ever while it keeps every assumption) with its attractor. Here the layers are taken off once more, only
//! until the initial state is among them, and remembered. That gives the environment's strategy: towards the core where
//! the state is attracted, and inside the core towards the acceptance of one assumption after the other. What the
//! system can do against it is to stay in the core, or to step out of it into a layer that was taken off before, so
//! every play ends in `Lost` or for ever in one core.

use super::{Game, Loss, Solution, acceptance::Acceptance, predecessors::Predecessors, pursuit::Pursuit};
use super::{predecessors::Incoming, region::Region};
use fixedbitset::FixedBitSet;
use std::collections::{BTreeMap, VecDeque};

const NONE: u32 = u32::MAX;

/// When and why states were taken out.
#[derive(Debug)]
pub(super) struct Layers {
    /// Per state: its place in the order of removal, or [`NONE`].
    order: Vec<u32>,
    /// Per state: the core that it belongs to, or [`NONE`] if it was only attracted.
    core: Vec<u32>,
    /// Per core: the goal that starves there.
    goal: Vec<usize>,
}

impl Layers {
    /// Takes layers off until the initial state is in one.
    pub(super) fn new(
        game: &Game,
        predecessors: &Predecessors,
        assumptions: &[Acceptance],
        goals: &[Acceptance],
    ) -> Self {
        let states = game.states();
        let mut layers = Layers { order: vec![NONE; states], core: vec![NONE; states], goal: Vec::new() };
        let mut removed = 0;
        let mut region = Region::new(game, predecessors);
        let mut pursuit = Pursuit::new(game, predecessors, false);
        let mut progress = FixedBitSet::with_capacity(game.edges());
        layers.record(&region, &mut removed);
        let (mut goal, mut settled) = (0, 0);
        while settled < goals.len() && region.states.contains(game.initial as usize) {
            settled += 1;
            let lost = pursuit.run(&goals[goal], assumptions, &region.states, &mut progress);
            if !lost.is_clear() {
                for state in lost.ones() {
                    layers.core[state] = layers.goal.len() as u32;
                }
                layers.goal.push(goal);
                region.remove(game, predecessors, lost);
                layers.record(&region, &mut removed);
                settled = 0;
            }
            goal = (goal + 1) % goals.len();
        }
        layers
    }

    /// Whether the environment wins from `state`, as far as layers were taken off.
    pub(super) fn contains(&self, state: u32) -> bool {
        self.order[state as usize] != NONE
    }

    fn record(&mut self, region: &Region, removed: &mut u32) {
        for &state in &region.removed {
            self.order[state as usize] = *removed;
            *removed += 1;
        }
    }
}

/// Where a play against a [`CounterStrategy`] stands: a state of the game, and what the environment remembers.
///
/// A play that comes back to the same place, with [`CounterStrategy::starves`] saying that something starves there, can
/// go on like this for ever: every assumption was met on the way.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Standing {
    /// The state of the game.
    pub state: u32,
    /// Its core, or [`NONE`].
    core: u32,
    /// In a core: the assumption that the environment sees to.
    memory: usize,
}

/// A strategy by which the environment wins from the initial state, to be played move by move.
#[derive(Debug)]
pub struct CounterStrategy<'g> {
    game: &'g Game,
    predecessors: Predecessors,
    assumptions: Vec<Acceptance>,
    goals: Vec<Acceptance>,
    layers: Layers,
    /// The core that `ranks` is about.
    ranked: u32,
    /// Per assumption, computed when it is needed: how far its acceptance is, for each state of the core.
    ranks: BTreeMap<usize, Vec<u32>>,
}

impl<'g> CounterStrategy<'g> {
    /// The strategy; `None` if the system wins. Time is that of solving, up to the layer of the initial state.
    #[must_use]
    pub fn new(game: &'g Game, solution: &Solution) -> Option<Self> {
        if solution.wins(game.initial) {
            return None;
        }
        let predecessors = Predecessors::new(game);
        let assumptions = Acceptance::assumptions(game);
        let goals = Acceptance::goals(game);
        let layers = Layers::new(game, &predecessors, &assumptions, &goals);
        let ranks = BTreeMap::new();
        Some(CounterStrategy { game, predecessors, assumptions, goals, layers, ranked: NONE, ranks })
    }

    /// Where every play begins.
    #[must_use]
    pub fn begin(&self) -> Standing {
        self.enter(self.game.initial, NONE, 0)
    }

    /// The environment's choice where it has the turn; `None` if it stays silent for ever, or the game is over. Time
    /// is that of a pass over the core where an assumption is seen to for the first time.
    pub fn choose(&mut self, at: Standing) -> Option<u32> {
        if at.core == NONE {
            let order = |&edge: &usize| self.layers.order[self.game.target[edge] as usize];
            return self.game.edges_of(at.state).min_by_key(order).map(|edge| edge as u32);
        }
        let index = at.state as usize;
        let stays = |&edge: &usize| self.stays(at.core, edge);
        if !self.assumptions.iter().any(|assumption| assumption.open.contains(index)) {
            let first = self.game.edges_of(at.state).find(stays);
            return first.filter(|_| !self.game.silent[index]).map(|edge| edge as u32);
        }
        if self.ranked != at.core {
            self.ranked = at.core;
            self.ranks.clear();
        }
        if !self.ranks.contains_key(&at.memory) {
            let rank = self.rank(at.core, &self.assumptions[at.memory]);
            self.ranks.insert(at.memory, rank);
        }
        let (assumption, rank) = (&self.assumptions[at.memory], &self.ranks[&at.memory]);
        let distance = |&edge: &usize| {
            let accepts = assumption.accepts(self.game.action[edge]);
            if accepts { 0 } else { rank[self.game.target[edge] as usize] }
        };
        let edges = self.game.edges_of(at.state).filter(|edge| self.stays(at.core, *edge));
        edges.min_by_key(distance).map(|edge| edge as u32)
    }

    /// What a system chooses that holds out where the play ends in [`Turn::Lost`](super::Turn::Lost), and otherwise
    /// stays in the core; `None` if it has no choice at all.
    #[must_use]
    pub fn hold_out(&self, at: Standing) -> Option<u32> {
        let mut edges = self.game.edges_of(at.state);
        let order =
            |&edge: &usize| (self.layers.order[self.game.target[edge] as usize], std::cmp::Reverse(edge));
        let edge = if at.core == NONE {
            edges.max_by_key(order)
        } else {
            edges.find(|&edge| self.stays(at.core, edge))
        };
        edge.map(|edge| edge as u32)
    }

    /// Where the play stands behind an edge, whoever chose it.
    #[must_use]
    pub fn follow(&self, at: Standing, edge: u32) -> Standing {
        let action = self.game.action[edge as usize];
        let memory = self.turn_to(at.memory, |assumption| !assumption.accepts(action));
        self.enter(self.game.target[edge as usize], at.core, memory)
    }

    /// What starves from here on, as long as the play stays in its core; `None` outside of cores.
    #[must_use]
    pub fn starves(&self, at: Standing) -> Option<Loss> {
        let goal = *self.layers.goal.get(at.core as usize)?;
        Some(self.game.guarantees.get(goal).map_or(Loss::Endless, |&key| Loss::Starvation(key)))
    }

    fn enter(&self, state: u32, from: u32, memory: usize) -> Standing {
        let core = self.layers.core[state as usize];
        if core == NONE {
            return Standing { state, core, memory: 0 };
        }
        let memory = if core == from { memory } else { 0 };
        let memory = self.turn_to(memory, |assumption| assumption.open.contains(state as usize));
        Standing { state, core, memory }
    }

    /// The first assumption, in rotation, that is still to be met. All that are passed over are met, so a
    /// play that comes round to the same memory has met them all.
    fn turn_to(&self, memory: usize, unmet: impl Fn(&Acceptance) -> bool) -> usize {
        let all = self.assumptions.len();
        let mut rotation = (memory..all).chain(0..memory);
        rotation.find(|&assumption| unmet(&self.assumptions[assumption])).unwrap_or(0)
    }

    /// Whether an edge stays in the core and does not accept its goal.
    fn stays(&self, core: u32, edge: usize) -> bool {
        let goal = &self.goals[self.layers.goal[core as usize]];
        self.layers.core[self.game.target[edge] as usize] == core && !goal.accepts(self.game.action[edge])
    }

    /// Per state of the core: in how many steps at most the environment sees the assumption accepted, or the play
    /// leaves the core.
    fn rank(&self, core: u32, assumption: &Acceptance) -> Vec<u32> {
        let Game { turn, action, target, .. } = self.game;
        let goal = &self.goals[self.layers.goal[core as usize]];
        let inside = |state: usize| self.layers.core[state] == core;
        let mut rank = vec![NONE; self.game.states()];
        let mut choices = vec![0_u32; self.game.states()];
        let (mut now, mut next) = (VecDeque::new(), Vec::new());
        for state in (0..rank.len()).filter(|&state| inside(state)) {
            let mut edges = self.game.edges_of(state as u32);
            if !assumption.open.contains(state) {
                rank[state] = 0;
                now.push_back(state as u32);
                continue;
            }
            let soon = if turn[state].is_system() {
                let delays =
                    |&edge: &usize| inside(target[edge] as usize) && !assumption.accepts(action[edge]);
                choices[state] = edges.filter(delays).count() as u32;
                choices[state] == 0
            } else {
                edges.any(|edge| self.stays(core, edge) && assumption.accepts(action[edge]))
            };
            if soon {
                rank[state] = 1;
                next.push(state as u32);
            }
        }
        now.extend(next);
        while let Some(state) = now.pop_front() {
            for &Incoming { source, action } in self.predecessors.of(state) {
                let index = source as usize;
                if !inside(index) || rank[index] != NONE {
                    continue;
                }
                if turn[index].is_system() {
                    if assumption.accepts(action) {
                        continue;
                    }
                    choices[index] -= 1;
                    if choices[index] > 0 {
                        continue;
                    }
                } else if goal.accepts(action) {
                    continue;
                }
                rank[index] = rank[state as usize] + 1;
                now.push_back(source);
            }
        }
        rank
    }
}

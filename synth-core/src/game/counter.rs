//! Why the system cannot win: one play that the environment forces.
//!
//! The solver takes states out of the game in layers: first the environment's attractor of [`Turn::Lost`](super::Turn::Lost), then, again
//! and again, a *core* (the states in which the environment starves one goal for ever while it keeps every
//! assumption) with its attractor. Here the layers are taken off once more, only until the initial state is among
//! them, and remembered. That gives the environment's strategy: towards the core where the state is attracted, and
//! inside the core towards the acceptance of one assumption after the other. What the system can do against it
//! is to stay in the core, or to step out of it into a layer that was taken off before, so every play ends in `Lost` or
//! for ever in one core. The play shown is the one of a system that holds out: it chooses what was taken off last.

use super::{Game, Solution, acceptance::Acceptance, predecessors::Predecessors, pursuit::Pursuit};
use super::{predecessors::Incoming, region::Region};
use fixedbitset::FixedBitSet;
use std::collections::{BTreeMap, VecDeque};

/// How the system loses a play.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Loss {
    /// The environment violates a guarantee: the last edge of the play leads to [`Turn::Lost`](super::Turn::Lost).
    Violation,
    /// This key of a guarantee is open throughout the cycle and never discharged.
    Starvation(u32),
    /// A super step never ends: the cycle consists of the system's states.
    Endless,
}

/// A play, consistent with a strategy by which the environment wins.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct CounterPlay {
    /// Edges from the initial state on.
    pub play: Vec<u32>,
    /// Edges that are repeated for ever behind `play`. Empty after a [`Loss::Violation`], or if the environment
    /// simply stays silent.
    pub cycle: Vec<u32>,
    /// How the system loses it.
    pub loss: Loss,
}

/// A play that the environment wins, or `None` if the system wins from the initial state.
///
/// The choices of the environment are those of a winning strategy; the system holds out as long as it can where
/// the play ends in [`Turn::Lost`](super::Turn::Lost), and otherwise chooses the first edge that keeps it in the layer. Time is that
/// of solving, up to the layer of the initial state, and a pass over one core for each assumption.
#[must_use]
pub fn counter_play(game: &Game, solution: &Solution) -> Option<CounterPlay> {
    if solution.wins(game.initial) {
        return None;
    }
    let predecessors = Predecessors::new(game);
    let assumptions = Acceptance::assumptions(game);
    let goals = Acceptance::goals(game);
    let layers = Layers::new(game, &predecessors, &assumptions, &goals);
    let walk = Walk {
        game,
        predecessors: &predecessors,
        assumptions: &assumptions,
        goals: &goals,
        layers: &layers,
        core: NONE,
        memory: 0,
        ranks: Vec::new(),
        visited: BTreeMap::new(),
    };
    Some(walk.run())
}

/// Whether the system wins from the initial state: what [`solve`](super::solve) says of it, without the rest, and found out as
/// soon as the initial state is lost.
#[must_use]
pub fn wins(game: &Game) -> bool {
    can_meet(game, &game.guarantees)
}

/// Whether the system would win from the initial state if these keys of guarantees were its only goals, beside never
/// losing the game and ending every super step.
#[must_use]
pub fn can_meet(game: &Game, keys: &[u32]) -> bool {
    let goals = Acceptance::goals_of(game, keys);
    let layers = Layers::new(game, &Predecessors::new(game), &Acceptance::assumptions(game), &goals);
    layers.order[game.initial as usize] == NONE
}

const NONE: u32 = u32::MAX;

/// When and why states were taken out.
struct Layers {
    /// Per state: its place in the order of removal, or [`NONE`].
    order: Vec<u32>,
    /// Per state: the core that it belongs to, or [`NONE`] if it was only attracted.
    core: Vec<u32>,
    /// Per core: the goal that starves there.
    goal: Vec<usize>,
}

impl Layers {
    /// Takes layers off until the initial state is in one.
    fn new(
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

    fn record(&mut self, region: &Region, removed: &mut u32) {
        for &state in &region.removed {
            self.order[state as usize] = *removed;
            *removed += 1;
        }
    }
}

/// The play on its way.
struct Walk<'a> {
    game: &'a Game,
    predecessors: &'a Predecessors,
    assumptions: &'a [Acceptance],
    goals: &'a [Acceptance],
    layers: &'a Layers,
    /// The core of the present state, or [`NONE`].
    core: u32,
    /// In a core: the assumption that the environment sees to.
    memory: usize,
    /// Per assumption, computed when it is needed: how far its acceptance is, for each state of the core.
    ranks: Vec<Option<Vec<u32>>>,
    /// When the play came to a state of the core with this memory.
    visited: BTreeMap<(u32, usize), usize>,
}

impl Walk<'_> {
    fn run(mut self) -> CounterPlay {
        let mut play = Vec::new();
        let mut state = self.game.initial;
        loop {
            self.enter(state);
            if self.core != NONE
                && let Some(first) = self.visited.insert((state, self.memory), play.len())
            {
                let cycle = play.split_off(first);
                return CounterPlay { play, cycle, loss: self.starvation() };
            }
            let Some(edge) = self.choose(state) else {
                let loss = if self.core == NONE { Loss::Violation } else { self.starvation() };
                return CounterPlay { play, cycle: Vec::new(), loss };
            };
            if self.core != NONE {
                let discharged = self.game.discharged[edge];
                self.turn_to(|assumption| !assumption.accepts(discharged));
            }
            play.push(edge as u32);
            state = self.game.target[edge];
        }
    }

    fn starvation(&self) -> Loss {
        let goal = self.layers.goal[self.core as usize];
        self.game.guarantees.get(goal).map_or(Loss::Endless, |&key| Loss::Starvation(key))
    }

    fn enter(&mut self, state: u32) {
        let core = self.layers.core[state as usize];
        if core != self.core {
            self.core = core;
            self.memory = 0;
            self.ranks = vec![None; self.assumptions.len()];
            self.visited.clear();
        }
        self.turn_to(|assumption| assumption.open.contains(state as usize));
    }

    /// Turns to the first assumption, in rotation, that is still to be met. All that are passed over are met, so a
    /// play that comes round to the same memory has met them all.
    fn turn_to(&mut self, unmet: impl Fn(&Acceptance) -> bool) {
        let all = self.assumptions.len();
        let mut rotation = (self.memory..all).chain(0..self.memory);
        self.memory = rotation.find(|&assumption| unmet(&self.assumptions[assumption])).unwrap_or(0);
    }

    /// The edge that is taken; `None` if the game is over, or nothing happens any more.
    fn choose(&mut self, state: u32) -> Option<usize> {
        let game = self.game;
        let edges = game.edges_of(state);
        let order = |edge: usize| self.layers.order[game.target[edge] as usize];
        match (self.core == NONE, game.turn[state as usize].is_system()) {
            (true, true) => edges.max_by_key(|&edge| (order(edge), std::cmp::Reverse(edge))),
            (true, false) => edges.min_by_key(|&edge| order(edge)),
            (false, true) => edges.into_iter().find(|&edge| self.stays(edge)),
            (false, false) => self.starve(state),
        }
    }

    /// Whether an edge stays in the core and does not accept its goal.
    fn stays(&self, edge: usize) -> bool {
        let goal = &self.goals[self.layers.goal[self.core as usize]];
        self.layers.core[self.game.target[edge] as usize] == self.core
            && !goal.accepts(self.game.discharged[edge])
    }

    /// The environment's choice in a core; `None` is silence for ever.
    fn starve(&mut self, state: u32) -> Option<usize> {
        let index = state as usize;
        let owes = self.assumptions.iter().any(|assumption| assumption.open.contains(index));
        if !owes {
            let first = self.game.edges_of(state).find(|&edge| self.stays(edge));
            return if self.game.silent[index] { None } else { first };
        }
        let rank = match self.ranks[self.memory].take() {
            Some(rank) => rank,
            None => self.rank(&self.assumptions[self.memory]),
        };
        let assumption = &self.assumptions[self.memory];
        let distance = |edge: usize| {
            let accepts = assumption.accepts(self.game.discharged[edge]);
            if accepts { 0 } else { rank[self.game.target[edge] as usize] }
        };
        let edges = self.game.edges_of(state).filter(|&edge| self.stays(edge));
        let best = edges.min_by_key(|&edge| distance(edge));
        self.ranks[self.memory] = Some(rank);
        best
    }

    /// Per state of the core: in how many steps at most the environment sees the assumption accepted, or the play
    /// leaves the core.
    fn rank(&self, assumption: &Acceptance) -> Vec<u32> {
        let Game { turn, discharged, target, .. } = self.game;
        let goal = &self.goals[self.layers.goal[self.core as usize]];
        let inside = |state: usize| self.layers.core[state] == self.core;
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
                    |&edge: &usize| inside(target[edge] as usize) && !assumption.accepts(discharged[edge]);
                choices[state] = edges.filter(delays).count() as u32;
                choices[state] == 0
            } else {
                edges.any(|edge| self.stays(edge) && assumption.accepts(discharged[edge]))
            };
            if soon {
                rank[state] = 1;
                next.push(state as u32);
            }
        }
        now.extend(next);
        while let Some(state) = now.pop_front() {
            for &Incoming { source, discharged } in self.predecessors.of(state) {
                let index = source as usize;
                if !inside(index) || rank[index] != NONE {
                    continue;
                }
                if turn[index].is_system() {
                    if assumption.accepts(discharged) {
                        continue;
                    }
                    choices[index] -= 1;
                    if choices[index] > 0 {
                        continue;
                    }
                } else if goal.accepts(discharged) {
                    continue;
                }
                rank[index] = rank[state as usize] + 1;
                now.push_back(source);
            }
        }
        rank
    }
}

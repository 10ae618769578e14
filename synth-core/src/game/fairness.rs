//! Checking a strategy: is every play of its graph won by the system?
//!
//! With all choices of the system made, only the environment plays. A play that misses a goal stays from some time on
//! in nodes where the goal's key is open and takes only edges that do not discharge it; the nodes and edges that it
//! repeats for ever lie in one strongly connected component of that part of the graph. So a goal fails exactly if
//! such a component, as a whole, accepts every assumption. Most nodes are in none, and [`Trim`] finds that out for all
//! goals together.

use super::components::{Components, Part};
use super::trim::{GOALS, Trim};
use super::{Game, Strategy, Turn, acceptance::Acceptance};

/// The goals that some play of the strategy, fair to all assumptions, misses, ascending. If `ending`, the last goal, the end
/// of super steps, must also be met by plays that are not fair.
pub(super) fn missed(game: &Game, strategy: &Strategy, goals: &[Acceptance], ending: bool) -> Vec<usize> {
    let is_assumption = assumptions(game);
    let none = vec![false; is_assumption.len()];
    let mut trim = Trim::new(game, strategy, &is_assumption);
    let mut components = None;
    let mut missed = Vec::new();
    for (first, goals_together) in (0..).step_by(GOALS).zip(goals.chunks(GOALS)) {
        let alive = trim.run(goals_together);
        let any = alive.iter().fold(0, |any, alive| any | alive);
        for (bit, goal) in goals_together.iter().enumerate().filter(|(bit, _)| any >> bit & 1 == 1) {
            let is_assumption = if ending && first + bit + 1 == goals.len() { &none } else { &is_assumption };
            let part = Missing { game, strategy, goal, is_assumption };
            let part = Trimmed { part, alive: &alive, bit };
            let components = components.get_or_insert_with(|| Components::new(strategy));
            let nodes = (0..strategy.nodes() as u32).filter(|&node| alive[node as usize] >> bit & 1 == 1);
            if components.any(&part, nodes, |component, of| part.part.is_fair(component, of)) {
                missed.push(first + bit);
            }
        }
    }
    missed
}

/// Per key: whether it is one of an assumption.
fn assumptions(game: &Game) -> Vec<bool> {
    let mut is_assumption = vec![false; game.key_sets.keys() as usize];
    for &key in &game.assumptions {
        is_assumption[key as usize] = true;
    }
    is_assumption
}

/// Per node of the strategy: the environment has no play from there that is fair to all assumptions, nor has the system won
/// already.
#[must_use]
pub fn trapped(game: &Game, strategy: &Strategy) -> Vec<bool> {
    let is_assumption = assumptions(game);
    let goal = Acceptance::never(game);
    let part = Missing { game, strategy, goal: &goal, is_assumption: &is_assumption };
    let mut trapped = vec![false; strategy.nodes()];
    // A component comes after those that it leads to.
    Components::new(strategy).any(&part, 0..strategy.nodes() as u32, |component, of| {
        let leads_out = |&node: &u32| {
            strategy.edges_of(node).any(|edge| {
                let target = strategy.target[edge];
                of[target as usize] != of[node as usize] && !trapped[target as usize]
            })
        };
        let is_over = game.turn[strategy.state[component[0] as usize] as usize] == Turn::Won;
        if !is_over && !component.iter().any(leads_out) && !part.is_fair(component, of) {
            component.iter().for_each(|&node| trapped[node as usize] = true);
        }
        false
    });
    trapped
}

/// The part of a strategy's graph in which a goal is not accepted.
struct Missing<'a> {
    game: &'a Game,
    strategy: &'a Strategy,
    goal: &'a Acceptance,
    is_assumption: &'a [bool],
}

impl Part for Missing<'_> {
    fn has_node(&self, node: u32) -> bool {
        self.goal.open.contains(self.strategy.state[node as usize] as usize)
    }

    fn has_edge(&self, edge: usize) -> bool {
        !self.goal.accepts(self.action(edge))
    }
}

/// Of that part what is left of it.
struct Trimmed<'a> {
    part: Missing<'a>,
    alive: &'a [u64],
    bit: usize,
}

impl Part for Trimmed<'_> {
    fn has_node(&self, node: u32) -> bool {
        self.alive[node as usize] >> self.bit & 1 == 1
    }

    fn has_edge(&self, edge: usize) -> bool {
        self.part.has_edge(edge)
    }
}

impl Missing<'_> {
    /// What happens on an edge of the strategy.
    fn action(&self, edge: usize) -> u32 {
        self.game.action[self.strategy.edge[edge] as usize]
    }

    /// Whether the environment can stay in the component for ever and be fair to all assumptions.
    fn is_fair(&self, component: &[u32], component_of: &[u32]) -> bool {
        let Game { key_sets, open, silent, .. } = self.game;
        let state = |node: u32| self.strategy.state[node as usize] as usize;
        let own = component_of[component[0] as usize];
        let inner = |node: u32| {
            self.strategy.edges_of(node).filter(move |&edge| {
                component_of[self.strategy.target[edge] as usize] == own && self.has_edge(edge)
            })
        };
        if let &[single] = component {
            let stays = self.game.turn[state(single)].is_environment() && silent[state(single)];
            if !stays && inner(single).next().is_none() {
                return false;
            }
        }
        // The assumptions that no node seen so far and no edge between nodes accepts.
        let mut missed: Vec<u32> = key_sets.members(open[state(component[0])]).collect();
        missed.retain(|&key| self.is_assumption[key as usize]);
        for &node in component {
            missed.retain(|&key| key_sets.contains(open[state(node)], key));
            for edge in inner(node) {
                let discharged = self.game.actions.discharged(self.action(edge));
                missed.retain(|&key| !key_sets.contains(discharged, key));
            }
            if missed.is_empty() {
                return true;
            }
        }
        false
    }
}

//! Checking a strategy: is every play of its graph won by the system?
//!
//! With all choices of the system made, only the environment plays. A play that misses a goal stays from some time on
//! in nodes where the goal's key is open and takes only edges that do not discharge it; the nodes and edges that it
//! repeats for ever lie in one strongly connected component of that part of the graph. So a goal fails exactly if
//! such a component, as a whole, accepts every assumption.

use super::{Game, Strategy, Turn, acceptance::Acceptance};

/// The first goal that some play of the strategy, fair to all assumptions, misses. If `ending`, the last goal, the end of
/// super steps, must also be met by plays that are not fair.
pub(super) fn first_missed(
    game: &Game,
    strategy: &Strategy,
    goals: &[Acceptance],
    ending: bool,
) -> Option<usize> {
    let mut is_assumption = vec![false; game.key_sets.keys() as usize];
    for &key in &game.assumptions {
        is_assumption[key as usize] = true;
    }
    let mut components = Components::new(strategy.nodes());
    let none = vec![false; is_assumption.len()];
    (0..goals.len()).find(|&goal| {
        let is_assumption = if ending && goal + 1 == goals.len() { &none } else { &is_assumption };
        let part = Part { game, strategy, goal: &goals[goal], is_assumption };
        components.any(&part, |component, of| part.is_fair(component, of))
    })
}

/// Per node of the strategy: the environment has no play from there that is fair to all assumptions, nor has the system won
/// already.
#[must_use]
pub fn trapped(game: &Game, strategy: &Strategy) -> Vec<bool> {
    let mut is_assumption = vec![false; game.key_sets.keys() as usize];
    for &key in &game.assumptions {
        is_assumption[key as usize] = true;
    }
    let goal = Acceptance::never(game);
    let part = Part { game, strategy, goal: &goal, is_assumption: &is_assumption };
    let mut trapped = vec![false; strategy.nodes()];
    // A component comes after those that it leads to.
    Components::new(strategy.nodes()).any(&part, |component, of| {
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
struct Part<'a> {
    game: &'a Game,
    strategy: &'a Strategy,
    goal: &'a Acceptance,
    is_assumption: &'a [bool],
}

impl Part<'_> {
    fn has_node(&self, node: u32) -> bool {
        self.goal.open.contains(self.strategy.state[node as usize] as usize)
    }

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
                component_of[self.strategy.target[edge] as usize] == own
                    && !self.goal.accepts(self.action(edge))
            })
        };
        if let &[single] = component {
            let stays = self.game.turn[state(single)].is_environment() && silent[state(single)];
            if !stays && inner(single).next().is_none() {
                return false;
            }
        }
        // The assumptions that no node seen so far and no edge between nodes accepts.
        let mut missed = key_sets.members(open[state(component[0])]).to_vec();
        missed.retain(|&key| self.is_assumption[key as usize]);
        for &node in component {
            let open = key_sets.members(open[state(node)]);
            missed.retain(|key| open.binary_search(key).is_ok());
            for edge in inner(node) {
                let discharged = key_sets.members(self.game.actions.discharged(self.action(edge)));
                missed.retain(|key| discharged.binary_search(key).is_err());
            }
            if missed.is_empty() {
                return true;
            }
        }
        false
    }
}

/// Tarjan's strongly connected components, without recursion and with arrays that are allocated once.
struct Components {
    /// Per node: when it was found, from 1; 0 before.
    found: Vec<u32>,
    /// Per node: the least `found` known to be reachable, of nodes that have no component yet.
    low: Vec<u32>,
    /// Per node: its component, from 1; 0 before.
    component: Vec<u32>,
    /// Nodes without a component, in the order in which they were found.
    pending: Vec<u32>,
    /// The path from the root: a node and its next edge.
    path: Vec<(u32, u32)>,
}

impl Components {
    fn new(nodes: usize) -> Self {
        Components {
            found: vec![0; nodes],
            low: vec![0; nodes],
            component: vec![0; nodes],
            pending: Vec::new(),
            path: Vec::new(),
        }
    }

    /// Whether a component of the part satisfies `holds`, which is given its nodes and the component of each node
    /// (complete for nodes of this and earlier components, and 0 for others).
    fn any(&mut self, part: &Part<'_>, mut holds: impl FnMut(&[u32], &[u32]) -> bool) -> bool {
        let strategy = part.strategy;
        self.found.fill(0);
        self.component.fill(0);
        self.pending.clear();
        self.path.clear();
        let (mut time, mut components) = (0, 0);
        for root in 0..strategy.nodes() as u32 {
            if self.found[root as usize] > 0 || !part.has_node(root) {
                continue;
            }
            self.find(root, strategy, &mut time);
            while let Some((node, next)) = self.path.last_mut() {
                let edge = *next as usize;
                if edge < strategy.edges_of(*node).end {
                    *next += 1;
                    let (node, target) = (*node as usize, strategy.target[edge]);
                    if !part.has_node(target) || part.goal.accepts(part.action(edge)) {
                        continue;
                    }
                    if self.found[target as usize] == 0 {
                        self.find(target, strategy, &mut time);
                    } else if self.component[target as usize] == 0 {
                        self.low[node] = self.low[node].min(self.found[target as usize]);
                    }
                    continue;
                }
                let node = *node;
                self.path.pop();
                let low = self.low[node as usize];
                if let Some(&(parent, _)) = self.path.last() {
                    self.low[parent as usize] = self.low[parent as usize].min(low);
                }
                if low == self.found[node as usize] {
                    components += 1;
                    let first = self.pending.iter().rposition(|&other| other == node).unwrap_or(0);
                    for &member in &self.pending[first..] {
                        self.component[member as usize] = components;
                    }
                    if holds(&self.pending[first..], &self.component) {
                        return true;
                    }
                    self.pending.truncate(first);
                }
            }
        }
        false
    }

    fn find(&mut self, node: u32, strategy: &Strategy, time: &mut u32) {
        *time += 1;
        self.found[node as usize] = *time;
        self.low[node as usize] = *time;
        self.pending.push(node);
        self.path.push((node, strategy.first[node as usize]));
    }
}

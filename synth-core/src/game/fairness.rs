//! Checking a strategy: is every play of its graph won by the system?
//!
//! With all choices of the system made, only the environment plays. A play that misses a goal stays from some time on
//! in nodes where the goal's key is open and takes only edges that do not discharge it; the nodes and edges that it
//! repeats for ever lie in one strongly connected component of that part of the graph. So a goal fails exactly if
//! such a component, as a whole, accepts every assumption.

use super::components::{Component, Components, Part};
use super::graph::{Graph, OfStrategy};
use super::{Game, Strategy, Turn, acceptance::Acceptance};
use crate::parallel::take_turns;
use fixedbitset::FixedBitSet;

/// What is asked of plays, whatever the strategy.
pub(super) struct Fairness<'a> {
    game: &'a Game,
    /// Per key: whether it is one of an assumption.
    is_assumption: Vec<bool>,
    /// The edges that discharge a key of an assumption: few, and to ask for a bit is to spare most looks at actions.
    assumed: FixedBitSet,
    /// The edges that discharge a key of a guarantee that is open at both ends; of others it makes no difference. None in most games.
    inner: Option<FixedBitSet>,
    /// The states in which a play may stay for ever in silence and be fair.
    rests: FixedBitSet,
}

impl<'a> Fairness<'a> {
    pub(super) fn new(game: &'a Game) -> Self {
        let mut is_assumption = vec![false; game.key_sets.keys() as usize];
        for &key in &game.assumptions {
            is_assumption[key as usize] = true;
        }
        let sets = 0..game.key_sets.len() as u32;
        let assumes: Vec<bool> =
            sets.map(|set| game.key_sets.members(set).any(|key| is_assumption[key as usize])).collect();
        let may_rest = |&state: &usize| {
            game.silent[state] && game.turn[state].is_environment() && !assumes[game.open[state] as usize]
        };
        let mut rests = FixedBitSet::with_capacity(game.states());
        (0..game.states()).filter(may_rest).for_each(|state| rests.insert(state));
        let assumed = discharging(game, &game.assumptions);
        let inner = Some(inner(game)).filter(|edges| !edges.is_clear());
        Fairness { game, is_assumption, assumed, inner, rests }
    }

    /// The goals that some play of a strategy, fair to all assumptions, misses, ascending. If `ending`, the last goal, the end
    /// of super steps, must also be met by plays that are not fair.
    pub(super) fn missed<G: Graph>(
        &self,
        graph: &G,
        goals: &[Acceptance],
        ending: bool,
        threads: usize,
    ) -> Vec<usize> {
        let mut places: Vec<(Option<Components<'_, G>>, Vec<usize>)> = Vec::new();
        take_turns(&mut places, goals.len(), threads, |(components, missed), index| {
            let part = Missing { fairness: self, graph, goal: &goals[index] };
            if part.goal.open.is_clear() {
                return;
            }
            let must_end = ending && index + 1 == goals.len();
            let fails =
                |component: Component<'_>| component.is_cyclic && (must_end || part.is_fair(component));
            let mut silent = self.rests.clone();
            silent.intersect_with(&part.goal.open);
            if !silent.is_clear() && graph.nodes_in(&silent).next().is_some()
                || components.get_or_insert_with(|| Components::new(graph)).any(&part, fails)
            {
                missed.push(index);
            }
        });
        let mut missed: Vec<usize> = places.into_iter().flat_map(|(_, missed)| missed).collect();
        missed.sort_unstable();
        missed
    }
}

/// Per node of the strategy: the environment has no play from there that is fair to all assumptions, nor has the system won
/// already.
#[must_use]
pub fn trapped(game: &Game, strategy: &Strategy) -> Vec<bool> {
    let (fairness, goal) = (Fairness::new(game), Acceptance::never(game));
    let graph = OfStrategy(strategy);
    let part = Missing { fairness: &fairness, graph: &graph, goal: &goal };
    let mut trapped = vec![false; strategy.nodes()];
    Components::new(&graph).any(&part, |component| {
        let Component { nodes, number, .. } = component;
        let leads_out = |&node: &u32| {
            strategy.edges_of(node).any(|edge| {
                let target = strategy.target[edge] as usize;
                number[target] != number[node as usize] && !trapped[target]
            })
        };
        let is_over = game.turn[strategy.state[nodes[0] as usize] as usize] == Turn::Won;
        if !is_over && !nodes.iter().any(leads_out) && !part.is_fair(component) {
            nodes.iter().for_each(|&node| trapped[node as usize] = true);
        }
        false
    });
    trapped
}

/// The part of a strategy's graph in which a goal is not accepted.
struct Missing<'a, G> {
    fairness: &'a Fairness<'a>,
    graph: &'a G,
    goal: &'a Acceptance,
}

impl<G: Graph> Part for Missing<'_, G> {
    fn nodes(&self) -> impl Iterator<Item = u32> {
        self.graph.nodes_in(&self.goal.open)
    }

    fn has_edge(&self, edge: usize) -> bool {
        let Some(inner) = &self.fairness.inner else { return true };
        let edge = self.graph.of_game(edge);
        !inner.contains(edge) || !self.goal.accepts(self.fairness.game.action[edge])
    }
}

impl<G: Graph> Missing<'_, G> {
    /// Whether the environment can stay in the component for ever and be fair to all assumptions.
    fn is_fair(&self, component: Component<'_>) -> bool {
        let Component { nodes, is_cyclic, number } = component;
        if let [node] = nodes
            && self.fairness.rests.contains(self.graph.state(*node) as usize)
        {
            return true;
        }
        if !is_cyclic {
            return false;
        }
        let Fairness { game, is_assumption, assumed, .. } = self.fairness;
        let Game { key_sets, open, actions, .. } = game;
        let open = |&node: &u32| open[self.graph.state(node) as usize];
        // The assumptions that no node and no edge between nodes accepts, of those looked at so far.
        let mut missed: Vec<u32> = key_sets.members(open(&nodes[0])).collect();
        missed.retain(|&key| is_assumption[key as usize]);
        for node in nodes {
            let set = open(node);
            missed.retain(|&key| key_sets.contains(set, key));
            if missed.is_empty() {
                return true;
            }
        }
        let own = number[nodes[0] as usize];
        for edge in nodes.iter().flat_map(|&node| self.graph.edges_of(node)) {
            let of_game = self.graph.of_game(edge);
            if !assumed.contains(of_game) {
                continue;
            }
            let discharged = actions.discharged(game.action[of_game]);
            let stays = |edge| number[self.graph.target(edge) as usize] == own && self.has_edge(edge);
            if missed.iter().any(|&key| key_sets.contains(discharged, key)) && stays(edge) {
                missed.retain(|&key| !key_sets.contains(discharged, key));
                if missed.is_empty() {
                    return true;
                }
            }
        }
        false
    }
}

/// The edges that discharge a key of a guarantee that is open at both ends.
fn inner(game: &Game) -> FixedBitSet {
    let mut inner = discharging(game, &game.guarantees);
    for state in 0..game.states() as u32 {
        for edge in game.edges_of(state) {
            if !inner.contains(edge) {
                continue;
            }
            let ends = [state, game.target[edge]].map(|end| game.open[end as usize]);
            let mut keys = game.key_sets.members(game.discharged(edge));
            let stays_open = |key| ends.iter().all(|&set| game.key_sets.contains(set, key));
            inner.set(edge, keys.any(stays_open));
        }
    }
    inner
}

/// The edges that discharge one of these keys.
fn discharging(game: &Game, keys: &[u32]) -> FixedBitSet {
    let discharges = |set: u32| keys.iter().any(|&key| game.key_sets.contains(set, key));
    let by_action: Vec<bool> = game.actions.discharged_sets().map(discharges).collect();
    // A word at a time: an insertion for each edge takes longer than all else.
    let word = |actions: &[u32]| {
        let bits = actions.iter().enumerate();
        bits.fold(0, |word, (bit, &action)| word | usize::from(by_action[action as usize]) << bit)
    };
    FixedBitSet::with_capacity_and_blocks(game.edges(), game.action.chunks(usize::BITS as usize).map(word))
}

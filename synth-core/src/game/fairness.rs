//! Checking a strategy: is every play of its graph won by the system?
//!
//! With all choices of the system made, only the environment plays. A play that misses a goal stays from some time on
//! in nodes where the goal's key is open and takes only edges that do not discharge it; the nodes and edges that it
//! repeats for ever lie in one strongly connected component of that part of the graph. So a goal fails exactly if
//! such a component, as a whole, accepts every assumption.

use super::bits::{BITS, by_state};
use super::components::{Component, Components, Part};
use super::graph::{Graph, OfStrategy};
use super::starving::Starving;
use super::{Game, Strategy, Turn, acceptance::Acceptance};
use crate::parallel::take_turns;
use fixedbitset::FixedBitSet;
use std::sync::atomic::{AtomicUsize, Ordering};

/// What is asked of plays, whatever the strategy.
pub(super) struct Fairness<'a> {
    pub(super) game: &'a Game,
    /// The number of goals.
    goals: usize,
    /// They, a word at a time.
    groups: Vec<Group>,
    /// Per key: whether it is one of an assumption.
    is_assumption: Vec<bool>,
    /// The edges that discharge a key of an assumption: few, and to ask for a bit is to spare most looks at actions.
    assumed: FixedBitSet,
    /// The edges that discharge a key of a guarantee that is open at both ends; of others it makes no difference. None in most games.
    pub(super) inner: Option<FixedBitSet>,
    /// The states in which an assumption is open.
    assuming: FixedBitSet,
    /// The states in which a play may stay for ever in silence and be fair.
    pub(super) rests: FixedBitSet,
}

/// Goals, each a bit.
pub(super) struct Group {
    /// Per state: the goals that are open there.
    pub(super) open: Vec<usize>,
    /// Per action: the goals that it does not discharge.
    pub(super) spares: Vec<usize>,
}

impl Group {
    fn new(game: &Game, goals: &[Acceptance]) -> Self {
        let open: Vec<&FixedBitSet> = goals.iter().map(|goal| &goal.open).collect();
        let open = by_state(game.states(), &open);
        let accepts = |action| {
            let goals = goals.iter().enumerate();
            goals.fold(0, |word, (bit, goal)| word | usize::from(goal.accepts(action)) << bit)
        };
        Group { open, spares: (0..game.actions.len() as u32).map(|action| !accepts(action)).collect() }
    }
}

impl<'a> Fairness<'a> {
    pub(super) fn new(game: &'a Game, goals: &[Acceptance]) -> Self {
        let mut is_assumption = vec![false; game.key_sets.keys() as usize];
        for &key in &game.assumptions {
            is_assumption[key as usize] = true;
        }
        let mut assuming = FixedBitSet::with_capacity(game.states());
        Acceptance::assumptions(game).iter().for_each(|assumption| assuming.union_with(&assumption.open));
        let may_rest = |&state: &usize| {
            game.silent[state] && game.turn[state].is_environment() && !assuming.contains(state)
        };
        let mut rests = FixedBitSet::with_capacity(game.states());
        (0..game.states()).filter(may_rest).for_each(|state| rests.insert(state));
        let assumed = discharging(game, &game.assumptions);
        let inner = Some(inner(game)).filter(|edges| !edges.is_clear());
        let groups = goals.chunks(BITS).map(|goals| Group::new(game, goals)).collect();
        Fairness { game, goals: goals.len(), groups, is_assumption, assumed, inner, assuming, rests }
    }

    /// The goals that some play of a strategy, fair to all assumptions, misses, ascending; but of those that are `known` to be
    /// demanding only whether any is missed if no other is, and then not which ones. If `ending`, the last goal, the end of
    /// super steps, must also be met by plays that are not fair.
    pub(super) fn missed<G: Graph>(
        &self,
        graph: &G,
        known: &[usize],
        ending: bool,
        threads: usize,
    ) -> Vec<usize> {
        let mut missed = Vec::new();
        for (group, first) in self.groups.iter().zip((0..).step_by(BITS)) {
            let last = if ending { (self.goals - 1).wrapping_sub(first) } else { BITS };
            let strict = if last < BITS { 1 << last } else { 0 };
            let mut starving = Starving::new(self, graph, group, strict);
            starving.strike_out(threads);
            let is_known = |bit: &usize| known.binary_search(&(first + bit)).is_ok();
            let mut suspects: Vec<usize> = ones(starving.any()).collect();
            suspects.sort_by_key(is_known);
            let found = AtomicUsize::new(starving.resting);
            let mut places: Vec<Option<Components<'_, G>>> = Vec::new();
            take_turns(&mut places, suspects.len(), threads, |components, index| {
                let bit = suspects[index];
                if found.load(Ordering::Relaxed) != 0 && is_known(&bit) {
                    return;
                }
                let part = Missing { starving: &starving, graph, bit };
                let is_strict = strict >> bit & 1 == 1;
                let has_fair_walk = || {
                    let walk = starving.closed_walk(bit)?;
                    let states = walk.iter().map(|&(node, _)| graph.state(node));
                    let edges = walk.iter().map(|&(_, edge)| graph.of_game(edge));
                    (is_strict || self.meets_assumptions(states, edges)).then_some(())
                };
                let fails = |component: Component<'_>| {
                    component.is_cyclic && (is_strict || self.is_fair(&part, component))
                };
                if has_fair_walk().is_some()
                    || components.get_or_insert_with(|| Components::new(graph)).any(&part, fails)
                {
                    found.fetch_or(1 << bit, Ordering::Relaxed);
                }
            });
            missed.extend(ones(found.into_inner()).map(|bit| first + bit));
        }
        missed
    }

    /// Whether nothing but time passes on an edge from a state to itself, while an assumption is open.
    pub(super) fn is_idle(&self, state: u32, edge: usize) -> bool {
        self.assuming.contains(state as usize) && !self.assumed.contains(edge)
    }

    /// Whether the environment can stay in a component for ever and be fair to all assumptions.
    fn is_fair<G: Graph>(&self, part: &Missing<'_, G>, component: Component<'_>) -> bool {
        let Component { nodes, is_cyclic, number } = component;
        let graph = part.graph;
        if let [node] = nodes
            && self.rests.contains(graph.state(*node) as usize)
        {
            return true;
        }
        let own = number[nodes[0] as usize];
        let edges = nodes.iter().flat_map(|&node| graph.edges_of(node));
        let edges = edges.filter(|&edge| {
            self.assumed.contains(graph.of_game(edge))
                && number[graph.target(edge) as usize] == own
                && part.has_edge(edge)
        });
        let states = nodes.iter().map(|&node| graph.state(node));
        is_cyclic && self.meets_assumptions(states, edges.map(|edge| graph.of_game(edge)))
    }

    /// Whether each assumption is accepted by one of these states or edges; there is one state at least.
    fn meets_assumptions(
        &self,
        mut states: impl Iterator<Item = u32> + Clone,
        mut edges: impl Iterator<Item = usize>,
    ) -> bool {
        let Game { key_sets, open, .. } = self.game;
        let Some(first) = states.clone().next() else { return false };
        // The assumptions that nothing accepts of what was looked at so far.
        let mut missed: Vec<u32> = key_sets.members(open[first as usize]).collect();
        missed.retain(|&key| self.is_assumption[key as usize]);
        missed.is_empty()
            || states.any(|state| {
                missed.retain(|&key| key_sets.contains(open[state as usize], key));
                missed.is_empty()
            })
            || edges.any(|edge| {
                let discharged = self.game.discharged(edge);
                missed.retain(|&key| !key_sets.contains(discharged, key));
                missed.is_empty()
            })
    }
}

/// The bits that are set.
fn ones(word: usize) -> impl Iterator<Item = usize> {
    (0..BITS).filter(move |&bit| word >> bit & 1 == 1)
}

/// Per node of the strategy: the environment has no play from there that is fair to all assumptions, nor has the system won
/// already.
#[must_use]
pub fn trapped(game: &Game, strategy: &Strategy) -> Vec<bool> {
    let fairness = Fairness::new(game, &[Acceptance::never(game)]);
    let graph = OfStrategy(strategy);
    let starving = Starving::new(&fairness, &graph, &fairness.groups[0], 0);
    let part = Missing { starving: &starving, graph: &graph, bit: 0 };
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
        if !is_over && !nodes.iter().any(leads_out) && !fairness.is_fair(&part, component) {
            nodes.iter().for_each(|&node| trapped[node as usize] = true);
        }
        false
    });
    trapped
}

/// The part of a strategy's graph in which a goal starves.
struct Missing<'a, G> {
    starving: &'a Starving<'a, G>,
    graph: &'a G,
    bit: usize,
}

impl<G: Graph> Part for Missing<'_, G> {
    fn nodes(&self) -> impl Iterator<Item = u32> {
        self.starving.of(self.bit)
    }

    fn has_edge(&self, edge: usize) -> bool {
        self.starving.spared(edge) >> self.bit & 1 == 1
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::{ActionsBuilder, KeySetsBuilder};
    use proptest::collection::vec;
    use proptest::prelude::{any, prop_assert_eq, proptest};

    /// A state: its turn, silence, open keys and edges with what they discharge.
    type State = (bool, bool, usize, Vec<(usize, u32)>);

    const ASSUMPTIONS: [u32; 2] = [0, 1];
    const GUARANTEES: [u32; 2] = [2, 3];

    fn game(states: &[State]) -> Game {
        let (mut actions, mut sets) = (ActionsBuilder::default(), KeySetsBuilder::default());
        let mut game = Game {
            initial: 0,
            turn: Vec::new(),
            silent: Vec::new(),
            open: Vec::new(),
            first: vec![0],
            action: Vec::new(),
            target: Vec::new(),
            actions: actions.actions(),
            key_sets: sets.sets().clone(),
            assumptions: ASSUMPTIONS.to_vec(),
            guarantees: GUARANTEES.to_vec(),
        };
        // All keys are known, whatever the states say.
        sets.intern(&[0, 1, 2, 3]);
        let mut set = |bits: usize| sets.intern(&ones(bits).map(|key| key as u32).collect::<Vec<_>>());
        for (system, silent, open, edges) in states {
            game.turn.push(if *system { Turn::SystemUrgent } else { Turn::EnvironmentAny });
            game.silent.push(*silent);
            game.open.push(set(*open));
            for &(discharged, target) in edges {
                game.action.push(actions.intern(0, set(discharged)));
                game.target.push(target % states.len() as u32);
            }
            game.first.push(game.target.len() as u32);
        }
        (game.actions, game.key_sets) = (actions.finish(), sets.finish());
        game
    }

    /// By what can be reached from where.
    fn is_missed(game: &Game, goal: usize, strict: bool) -> bool {
        let states = 0..game.states();
        let has = |set: u32, key: u32| game.key_sets.contains(set, key);
        let assumes = |state: usize, key: u32| has(game.open[state], key);
        let key = GUARANTEES.get(goal);
        let is_open =
            |state: usize| key.map_or(game.turn[state].is_system(), |&key| has(game.open[state], key));
        let rests = |state: usize| {
            let is_silent = game.silent[state] && game.turn[state].is_environment();
            is_silent && is_open(state) && !ASSUMPTIONS.iter().any(|&key| assumes(state, key))
        };
        let mut edges = Vec::new();
        for state in states.clone().filter(|&state| is_open(state)) {
            for edge in game.edges_of(state as u32) {
                let target = game.target[edge] as usize;
                if is_open(target) && !key.is_some_and(|&key| has(game.discharged(edge), key)) {
                    edges.push((state, target, game.discharged(edge)));
                }
            }
        }
        let mut reaches = vec![vec![false; game.states()]; game.states()];
        edges.iter().for_each(|&(from, to, _)| reaches[from][to] = true);
        for (via, from) in states.clone().flat_map(|via| states.clone().map(move |from| (via, from))) {
            if reaches[from][via] {
                let further = reaches[via].clone();
                reaches[from].iter_mut().zip(further).for_each(|(to, further)| *to |= further);
            }
        }
        let is_fair = |state: usize| {
            let is_in = |other: usize| reaches[state][other] && reaches[other][state];
            let discharges = |key: u32| {
                edges.iter().any(|&(from, to, discharged)| is_in(from) && is_in(to) && has(discharged, key))
            };
            let closes = |key: u32| states.clone().any(|other| is_in(other) && !assumes(other, key));
            strict || ASSUMPTIONS.iter().all(|&key| discharges(key) || closes(key))
        };
        states.clone().any(|state| rests(state) || reaches[state][state] && is_fair(state))
    }

    proptest! {
        #[test]
        fn missed_is_what_starves_on_a_fair_cycle(
            states in vec((any::<bool>(), any::<bool>(), 0..16usize, vec((0..16usize, 0..12u32), 1..4)), 1..12),
            ending in any::<bool>(),
            known in vec(any::<bool>(), 3),
        ) {
            let game = game(&states);
            let edge = (0..game.edges() as u32).collect();
            let (state, first, target) = ((0..game.states() as u32).collect(), game.first.clone(), game.target.clone());
            let strategy = Strategy { state, first, edge, target };
            let fairness = Fairness::new(&game, &Acceptance::goals(&game));
            let graph = OfStrategy(&strategy);
            let expected: Vec<usize> =
                (0..3).filter(|&goal| is_missed(&game, goal, ending && goal == 2)).collect();
            for threads in [1, 2, 8] {
                prop_assert_eq!(&fairness.missed(&graph, &[], ending, threads), &expected);
            }
            // Of the known ones it is only asked whether there are any, if there are no others.
            let known: Vec<usize> = (0..3).filter(|&goal| known[goal]).collect();
            let missed = fairness.missed(&graph, &known, ending, 1);
            let others = |missed: &[usize]| -> Vec<usize> {
                missed.iter().copied().filter(|goal| !known.contains(goal)).collect()
            };
            prop_assert_eq!(others(&missed), others(&expected));
            prop_assert_eq!(missed.is_empty(), expected.is_empty());
        }
    }
}

//! The closed loop as one constraint automaton and the components around it see it.

use std::collections::BTreeSet;

use super::needed::enabled;
use crate::intern::Rows;
use crate::plant::{AutomatonId, ClosedLoop, EventId, Plant};

/// The projection of the closed loop to a constraint automaton and the components that share events with it.
///
/// A *sight* is one state of each of these components; a *node* is a sight and a state of the automaton.
pub(super) struct Local {
    /// Ascending.
    pub(super) components: Vec<AutomatonId>,
    /// The automaton, as a position in an entry.
    automaton: usize,
    /// The states of sights.
    sights: Rows<u16>,
    /// Per node its sight and the state of the automaton.
    nodes: Rows<u32>,
    /// Per entry its node.
    pub(super) of_entry: Vec<u32>,
    /// Of the events of the automaton and of the components, in ascending order.
    pub(super) edges: BTreeSet<Edge>,
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Edge {
    pub(super) source: u32,
    pub(super) event: EventId,
    pub(super) target: u32,
}

impl Local {
    pub(super) fn new(plant: &Plant, closed: &ClosedLoop, automaton: AutomatonId) -> Local {
        let alphabet = &plant.automata[automaton as usize].alphabet;
        let shares = |a: &AutomatonId| {
            plant.automata[*a as usize].alphabet.iter().any(|event| alphabet.binary_search(event).is_ok())
        };
        let components: Vec<AutomatonId> = (0..plant.components as AutomatonId).filter(shares).collect();
        let mut local = Local {
            automaton: automaton as usize,
            sights: Rows::new(components.len()),
            nodes: Rows::new(2),
            of_entry: Vec::with_capacity(closed.len()),
            edges: BTreeSet::new(),
            components,
        };
        let mut sight = Vec::with_capacity(local.components.len());
        for entry in 0..closed.len() {
            let states = closed.entry(entry);
            sight.clear();
            sight.extend(local.components.iter().map(|&c| states[c as usize]));
            let seen = local.sights.intern(&sight);
            let node = local.nodes.intern(&[seen, u32::from(states[local.automaton])]);
            local.of_entry.push(node);
        }
        let around: Vec<AutomatonId> = local.components.iter().copied().chain([automaton]).collect();
        let is_local: Vec<bool> = (0..plant.events.len() as EventId)
            .map(|e| around.iter().any(|&a| plant.automata[a as usize].alphabet.binary_search(&e).is_ok()))
            .collect();
        for entry in 0..closed.len() {
            let source = local.of_entry[entry];
            for &(event, target) in closed.edges(entry).iter().filter(|(event, _)| is_local[*event as usize])
            {
                local.edges.insert(Edge { source, event, target: local.of_entry[target as usize] });
            }
        }
        local
    }

    /// How many nodes there are.
    pub(super) fn len(&self) -> usize {
        self.nodes.len()
    }

    /// The sight of a node.
    pub(super) fn sight_of(&self, node: u32) -> u32 {
        self.nodes.get(node)[0]
    }

    /// The states of a sight.
    pub(super) fn sight(&self, sight: u32) -> &[u16] {
        self.sights.get(sight)
    }

    /// What a node leads to.
    pub(super) fn successors(&self, node: u32) -> impl Iterator<Item = Edge> {
        let first = Edge { source: node, event: 0, target: 0 };
        self.edges.range(first..).copied().take_while(move |edge| edge.source == node)
    }

    /// Pairs of nodes, the lesser first, with one sight, in which something different is enabled although all that the
    /// feedback depends on besides is the same.
    pub(super) fn apart(
        &self,
        plant: &Plant,
        closed: &ClosedLoop,
        needed: &[AutomatonId],
    ) -> BTreeSet<(u32, u32)> {
        let others: Vec<usize> = (0..plant.components)
            .chain(needed.iter().map(|&a| a as usize))
            .filter(|&a| a != self.automaton)
            .collect();
        let key = |entry: u32| others.iter().map(move |&a| closed.entry(entry as usize)[a]);
        let mut order: Vec<u32> = (0..closed.len() as u32).collect();
        order.sort_unstable_by(|&a, &b| key(a).cmp(key(b)));
        let mut apart = BTreeSet::new();
        for group in order.chunk_by(|&a, &b| key(a).eq(key(b))) {
            // The same node always enables the same here, since the feedback depends on nothing else.
            let mut entries: Vec<u32> = group.to_vec();
            entries.sort_unstable_by_key(|&entry| self.of_entry[entry as usize]);
            entries.dedup_by_key(|entry| self.of_entry[*entry as usize]);
            for (i, &a) in entries.iter().enumerate() {
                for &b in &entries[i + 1..] {
                    if !enabled(plant, closed, a).eq(enabled(plant, closed, b)) {
                        apart.insert((self.of_entry[a as usize], self.of_entry[b as usize]));
                    }
                }
            }
        }
        apart
    }
}

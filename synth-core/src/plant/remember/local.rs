//! The closed loop as one group of constraint automata and the components around them see it.

use crate::intern::Rows;
use crate::plant::{AutomatonId, ClosedLoop, EventId, Plant};
use hashbrown::HashSet;
use rustc_hash::FxBuildHasher;

/// The projection of the closed loop to some constraint automata and some components.
///
/// A *sight* is one state of each of these components; a *node* is a sight and a state of each of the automata.
pub(super) struct Local {
    /// Ascending.
    pub(super) components: Vec<AutomatonId>,
    /// The states of sights.
    sights: Rows<u16>,
    /// Per node its sight.
    pub(super) sight_of: Vec<u32>,
    /// Per entry its node.
    pub(super) of_entry: Vec<u32>,
    /// What can happen, ascending: of one source events are distinct.
    pub(super) edges: Vec<Edge>,
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Edge {
    pub(super) source: u32,
    pub(super) event: EventId,
    pub(super) target: u32,
}

impl Local {
    pub(super) fn new(
        plant: &Plant,
        closed: &ClosedLoop,
        automata: &[AutomatonId],
        components: Vec<AutomatonId>,
    ) -> Local {
        let mut sights = Rows::new(components.len());
        let mut nodes: Rows<u32> = Rows::new(1 + automata.len());
        let mut of_entry = Vec::with_capacity(closed.len());
        let mut sight_of = Vec::new();
        let (mut sight, mut node) = (Vec::new(), Vec::new());
        for entry in 0..closed.len() {
            let states = closed.entry(entry);
            sight.clear();
            sight.extend(components.iter().map(|&c| states[c as usize]));
            node.clear();
            node.push(sights.intern(&sight));
            node.extend(automata.iter().map(|&a| u32::from(states[a as usize])));
            let id = nodes.intern(&node);
            if id as usize == sight_of.len() {
                sight_of.push(node[0]);
            }
            of_entry.push(id);
        }
        let mut is_local = vec![false; plant.events.len()];
        for &automaton in components.iter().chain(automata) {
            for &event in &plant.automata[automaton as usize].alphabet {
                is_local[event as usize] = true;
            }
        }
        // Automata are deterministic, so a node and an event have one target.
        let mut known: HashSet<(u32, EventId), FxBuildHasher> = HashSet::default();
        let mut edges = Vec::new();
        for (entry, &source) in of_entry.iter().enumerate() {
            for &(event, target) in closed.edges(entry).iter().filter(|(event, _)| is_local[*event as usize])
            {
                if known.insert((source, event)) {
                    edges.push(Edge { source, event, target: of_entry[target as usize] });
                }
            }
        }
        edges.sort_unstable();
        Local { components, sights, sight_of, of_entry, edges }
    }

    /// How many nodes there are.
    pub(super) fn len(&self) -> usize {
        self.sight_of.len()
    }

    /// The states of a sight.
    pub(super) fn sight(&self, sight: u32) -> &[u16] {
        self.sights.get(sight)
    }
}

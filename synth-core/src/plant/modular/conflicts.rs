//! Whether modules conflict: each keeps a way to its marked states, but all together might not.
//!
//! Modules without automata in common cannot conflict, so clusters of modules are looked at one by one; a cluster of one
//! module cannot either, nor one in which all states are marked.

use super::super::moves::{Candidates, Moves, marks};
use super::super::packing::Packing;
use super::super::product::initial;
use super::super::{EventId, Plant};
use super::part::Part;
use super::scope::{Scope, clusters, union};
use super::{ModularError, Module};
use crate::explore::{LimitReached, Limits};
use crate::intern::Rows;

/// So many states of a cluster are looked at where no limit is given.
const MOST_STATES: usize = 1 << 18;

/// Explores the clusters that could conflict; a limit that was reached in one of them is returned.
pub(super) fn check(
    plant: &Plant,
    scopes: &[Scope],
    modules: &[Module],
    limits: &Limits,
) -> Result<Option<LimitReached>, ModularError> {
    let mut unknown = None;
    for cluster in clusters(scopes).into_iter().filter(|cluster| cluster.len() > 1) {
        let scope = union(cluster.iter().map(|&module| &scopes[module]));
        if scope.automata.iter().all(|&id| marks(plant, id).is_none()) {
            continue;
        }
        let part = Part::new(plant, &scope);
        let views = cluster.iter().map(|&module| View::new(&part, &modules[module])).collect();
        match explore(&mut Cluster::new(&part, views), limits) {
            Ok(None) => {}
            Ok(Some(own)) => return Err(ModularError::Conflict(whole(plant, &part, &own))),
            Err(limit) => unknown = unknown.or(Some(limit)),
        }
    }
    Ok(unknown)
}

/// The states of all automata: those of other clusters are where they start.
fn whole(plant: &Plant, part: &Part, own: &[u16]) -> Vec<u16> {
    let mut states = initial(plant);
    for (&automaton, &state) in part.automata.iter().zip(own) {
        states[automaton as usize] = state;
    }
    states
}

/// A module as a cluster sees it.
struct View<'m> {
    module: &'m Module,
    /// Per automaton of the module its place in the cluster.
    places: Vec<usize>,
}

impl<'m> View<'m> {
    fn new(part: &Part, module: &'m Module) -> Self {
        let automata = module.part.automata.iter();
        let places = automata.filter_map(|id| part.automata.binary_search(id).ok()).collect();
        View { module, places }
    }
}

struct Cluster<'c> {
    part: &'c Part,
    views: Vec<View<'c>>,
    /// Per event the views that know it.
    knowing: Vec<Vec<usize>>,
    /// The states of a module's automata; reused.
    own: Vec<u16>,
}

impl<'c> Cluster<'c> {
    fn new(part: &'c Part, views: Vec<View<'c>>) -> Self {
        let knowing = part
            .events
            .iter()
            .map(|&event| (0..views.len()).filter(|&view| views[view].module.knows(event)).collect());
        Cluster { part, knowing: knowing.collect(), views, own: Vec::new() }
    }

    /// Whether some module inhibits an event of the cluster.
    fn inhibits(&mut self, states: &[u16], event: EventId) -> bool {
        let Cluster { part, views, knowing, own } = self;
        let id = part.events[event as usize];
        knowing[event as usize].iter().any(|&view| {
            let View { module, places } = &views[view];
            own.clear();
            own.extend(places.iter().map(|&place| states[place]));
            module.inhibits_in(own, id)
        })
    }
}

/// A state from which no marked one can be reached, if there is one.
fn explore(cluster: &mut Cluster<'_>, limits: &Limits) -> Result<Option<Vec<u16>>, LimitReached> {
    let part = cluster.part;
    let plant = &part.plant;
    let most = if limits.states == Limits::default().states { MOST_STATES } else { limits.states };
    let moves = Moves::constrained(plant);
    let packing = Packing::new(plant.automata.iter().map(|automaton| automaton.states.len()));
    let mut rows = Rows::new(packing.words());
    let mut row = vec![0; packing.words()];
    let mut states = initial(plant);
    packing.pack(&states, &mut row);
    rows.intern(&row);
    let mut candidates = Candidates::default();
    let mut edges: Vec<(u32, u32)> = Vec::new();
    let mut reaches = Vec::new();
    let mut source = 0;
    while (source as usize) < rows.len() {
        let memory = rows.memory() + edges.capacity() * size_of::<(u32, u32)>();
        for (what, limit, reached) in
            [("states", most, rows.len() > most), ("memory", limits.memory, memory > limits.memory)]
        {
            if reached {
                let (states, explored, edges) = (rows.len(), source as usize, edges.len());
                return Err(LimitReached { what, limit, states, explored, edges, memory });
            }
        }
        packing.unpack(rows.get(source), &mut states);
        reaches.push(moves.marked(&states));
        moves.collect(&states, &mut candidates);
        for (candidate, changes) in candidates.iter() {
            if candidate.forbidden || cluster.inhibits(&states, candidate.event) {
                continue;
            }
            row.copy_from_slice(rows.get(source));
            for &(automaton, next) in changes {
                packing.set(&mut row, automaton, next);
            }
            edges.push((rows.intern(&row), source));
        }
        source += 1;
    }
    edges.sort_unstable();
    let mut work: Vec<u32> = (0..source).filter(|&state| reaches[state as usize]).collect();
    while let Some(target) = work.pop() {
        let first = edges.partition_point(|edge| edge.0 < target);
        for &(_, source) in edges[first..].iter().take_while(|edge| edge.0 == target) {
            if !std::mem::replace(&mut reaches[source as usize], true) {
                work.push(source);
            }
        }
    }
    Ok((0..source).find(|&state| !reaches[state as usize]).map(|state| {
        packing.unpack(rows.get(state), &mut states);
        states
    }))
}

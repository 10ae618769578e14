//! What a controller can know: the observer of a projection, as a deterministic machine.
//!
//! Between two scans at most one event that can be seen is taken to happen. A controller notices which controllable events it
//! causes, and in which sight the plant is at each scan. What it must take for the same is the least equivalence in which
//!
//! - an event that it neither causes nor sees does not leave a class, and
//! - from one class, the same controllable event, or uncontrollable ones to the same sight, lead to one class.
//!
//! This is congruence closure, and takes nearly linear time. With all components in sight it is exactly what every observer has to
//! take for the same, as long as the feedback is the same throughout a class: then all members of a class allow the same
//! observations (whatever is uncontrollable and possible in the plant is possible in the closed loop), so classes follow each other
//! as the sets of the subset construction do, of which they are unions.

use super::local::Local;
use crate::plant::{EventId, Plant};
use hashbrown::HashMap;
use rustc_hash::FxBuildHasher;

/// A deterministic machine over observations.
///
/// A *label* is a controllable event by its number, or the number of events plus that of the sight which the plant is seen in.
pub(super) struct Machine {
    /// How many events there are.
    events: u32,
    /// Per state its sight.
    pub(super) sight: Vec<u32>,
    /// The edges of state `i` are at `first[i]..first[i + 1]`.
    first: Vec<u32>,
    /// Labels, ascending in a state, and states that they lead to. What is seen is another sight.
    pub(super) edges: Vec<(u32, u32)>,
    /// Per entry of the closed loop its state.
    pub(super) of_entry: Vec<u32>,
}

/// What an observation is.
pub(super) enum Observation {
    Caused(EventId),
    Seen(u32),
}

impl Machine {
    /// From edges by source, label and target, and from what states stand for.
    fn new(events: u32, sight: Vec<u32>, mut edges: Vec<(u32, u32, u32)>, of_entry: Vec<u32>) -> Machine {
        edges.sort_unstable();
        edges.dedup();
        let mut first = vec![0; sight.len() + 1];
        edges.iter().for_each(|&(source, _, _)| first[source as usize + 1] += 1);
        (1..first.len()).for_each(|i| first[i] += first[i - 1]);
        let edges = edges.into_iter().map(|(_, label, target)| (label, target)).collect();
        Machine { events, sight, first, edges, of_entry }
    }

    pub(super) fn len(&self) -> usize {
        self.sight.len()
    }

    pub(super) fn edges(&self, state: u32) -> &[(u32, u32)] {
        &self.edges[self.first[state as usize] as usize..self.first[state as usize + 1] as usize]
    }

    pub(super) fn observation(&self, label: u32) -> Observation {
        label.checked_sub(self.events).map_or(Observation::Caused(label), Observation::Seen)
    }

    /// With the states of each class as one; classes are numbered without gaps, of one sight, and lead to one class by a label.
    pub(super) fn quotient(&self, class: &[u32]) -> Machine {
        let count = class.iter().max().map_or(0, |most| most + 1);
        let mut sight = vec![0; count as usize];
        let mut edges = Vec::with_capacity(self.edges.len());
        for state in 0..self.len() as u32 {
            let source = class[state as usize];
            sight[source as usize] = self.sight[state as usize];
            edges.extend(self.edges(state).iter().map(|&(label, to)| (source, label, class[to as usize])));
        }
        let of_entry = self.of_entry.iter().map(|&state| class[state as usize]).collect();
        Machine::new(self.events, sight, edges, of_entry)
    }
}

/// The observer of a projection.
pub(super) fn observe(plant: &Plant, local: &Local) -> Machine {
    let mut closure = Closure::new(plant, local);
    closure.close();
    // Where a component is not in sight, members of a class may allow different observations.
    loop {
        let mut targets: HashMap<(u32, u32), u32, FxBuildHasher> = HashMap::default();
        let mut changed = false;
        for i in 0..closure.moves.len() {
            let Move { source, label, target, .. } = closure.moves[i];
            let source = closure.sets.find(source);
            let &mut other = targets.entry((source, label)).or_insert(target);
            changed |= closure.unite(other, target, None);
        }
        if !changed {
            break;
        }
        closure.close();
    }
    closure.machine(local)
}

/// Two entries with different feedback that every observer must take for the same, after a shortest common future of two
/// events, or of one that nobody sees; returns these events, where they lead to, and the two entries. `local` is of all
/// automata, so that its nodes are entries.
pub(super) fn confused(plant: &Plant, local: &Local, enabled: &[u32]) -> Option<Confusion> {
    let mut closure = Closure::new(plant, local);
    closure.close();
    let mut entry_of = vec![0; local.len()];
    local.of_entry.iter().zip(0..).for_each(|(&node, entry)| entry_of[node as usize] = entry);
    let entries = |pair: &Pair| [entry_of[pair.nodes[0] as usize], entry_of[pair.nodes[1] as usize]];
    let differ = |pair: &&Pair| {
        let [a, b] = entries(pair);
        enabled[a] != enabled[b]
    };
    let found = closure.pairs.iter().find(differ)?;
    let mut root = found;
    while let Origin::From(before) = root.origin {
        root = &closure.pairs[before as usize];
    }
    let Origin::Start(events) = root.origin else { return None };
    Some(Confusion { events, start: entries(root), entries: entries(found) })
}

/// What [`confused`] finds.
pub(super) struct Confusion {
    pub(super) events: [EventId; 2],
    pub(super) start: [usize; 2],
    pub(super) entries: [usize; 2],
}

struct Move {
    source: u32,
    label: u32,
    target: u32,
    event: EventId,
}

/// Two nodes that cannot be told apart.
struct Pair {
    nodes: [u32; 2],
    origin: Origin,
}

#[derive(Clone, Copy)]
enum Origin {
    /// By these events from one node.
    Start([EventId; 2]),
    /// By one observation from both nodes of an earlier pair.
    From(u32),
    /// By one observation from different members of a class.
    Class,
}

struct Closure {
    events: u32,
    /// By source, then label.
    moves: Vec<Move>,
    first: Vec<u32>,
    sets: Sets,
    /// What was united, in this order; the rest follows.
    pairs: Vec<Pair>,
    /// How many pairs were followed.
    followed: usize,
}

impl Closure {
    fn new(plant: &Plant, local: &Local) -> Closure {
        let events = plant.events.len() as u32;
        let mut first = vec![0; local.len() + 1];
        let mut closure = Closure {
            events,
            moves: Vec::with_capacity(local.edges.len()),
            first: Vec::new(),
            sets: Sets { parent: (0..local.len() as u32).collect() },
            pairs: Vec::new(),
            followed: 0,
        };
        for edge in &local.edges {
            first[edge.source as usize + 1] += 1;
            let label = match plant.events[edge.event as usize].controllable {
                true => edge.event,
                false => events + local.sight_of[edge.target as usize],
            };
            let &super::local::Edge { source, event, target } = edge;
            closure.moves.push(Move { source, label, target, event });
        }
        (1..first.len()).for_each(|i| first[i] += first[i - 1]);
        closure.moves.sort_by_key(|it| (it.source, it.label));
        closure.first = first;
        for i in 0..closure.moves.len() {
            let Move { source, label, target, event } = closure.moves[i];
            if label == events + local.sight_of[source as usize] {
                closure.unite(source, target, Some(Origin::Start([event; 2])));
            }
            if let Some(&Move { source: other, label: same, target: second, event: also }) =
                closure.moves.get(i + 1)
                && (source, label) == (other, same)
            {
                closure.unite(target, second, Some(Origin::Start([event, also])));
            }
        }
        closure
    }

    /// Whether they were not one before.
    fn unite(&mut self, a: u32, b: u32, origin: Option<Origin>) -> bool {
        let united = self.sets.unite(a, b);
        if united {
            self.pairs.push(Pair { nodes: [a, b], origin: origin.unwrap_or(Origin::Class) });
        }
        united
    }

    /// Unites what pairs lead to.
    fn close(&mut self) {
        while let Some(&Pair { nodes: [a, b], .. }) = self.pairs.get(self.followed) {
            let origin = Origin::From(self.followed as u32);
            self.followed += 1;
            let (mut i, mut j) = (self.first[a as usize] as usize, self.first[b as usize] as usize);
            let (end_of_a, end_of_b) =
                (self.first[a as usize + 1] as usize, self.first[b as usize + 1] as usize);
            while i < end_of_a && j < end_of_b {
                let (x, y) = (&self.moves[i], &self.moves[j]);
                match x.label.cmp(&y.label) {
                    std::cmp::Ordering::Less => i += 1,
                    std::cmp::Ordering::Greater => j += 1,
                    std::cmp::Ordering::Equal => {
                        let (x, y) = (x.target, y.target);
                        self.unite(x, y, Some(origin));
                        (i, j) = (i + 1, j + 1);
                    }
                }
            }
        }
    }

    fn machine(mut self, local: &Local) -> Machine {
        let class = numbered((0..local.len() as u32).map(|node| self.sets.find(node)));
        let count = class.iter().max().map_or(0, |most| most + 1);
        let mut sight = vec![0; count as usize];
        class.iter().zip(&local.sight_of).for_each(|(&class, &of)| sight[class as usize] = of);
        let seen = |it: &Move| it.label != self.events + local.sight_of[it.source as usize];
        let edges = self.moves.iter().filter(|it| seen(it));
        let edges =
            edges.map(|it| (class[it.source as usize], it.label, class[it.target as usize])).collect();
        let of_entry = local.of_entry.iter().map(|&node| class[node as usize]).collect();
        Machine::new(self.events, sight, edges, of_entry)
    }
}

/// Numbers without gaps, in the order in which values come first.
pub(super) fn numbered(values: impl Iterator<Item = u32>) -> Vec<u32> {
    let mut numbers: HashMap<u32, u32, FxBuildHasher> = HashMap::default();
    values
        .map(|value| {
            let next = numbers.len() as u32;
            *numbers.entry(value).or_insert(next)
        })
        .collect()
}

/// Disjoint sets of nodes; the root of a set is its least member.
struct Sets {
    parent: Vec<u32>,
}

impl Sets {
    fn find(&mut self, mut node: u32) -> u32 {
        while self.parent[node as usize] != node {
            let above = self.parent[self.parent[node as usize] as usize];
            self.parent[node as usize] = above;
            node = above;
        }
        node
    }

    fn unite(&mut self, a: u32, b: u32) -> bool {
        let (a, b) = (self.find(a), self.find(b));
        self.parent[a.max(b) as usize] = a.min(b);
        a != b
    }
}

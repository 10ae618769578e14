//! The entries of a feedback as a decision diagram over states of components.
//!
//! A million entries are mostly the same few choices again and again: entries in lexicographic order are a tree with one
//! level a component, and equal subtrees become one node. Formulas are computed once a node instead of once an entry.

use super::remember::Remembered;
use super::{ClosedLoop, EventId, Plant};
use hashbrown::HashMap;
use rustc_hash::FxBuildHasher;

/// What is enabled, by states of components and codes of memory.
pub(super) struct Entries {
    /// Per component its nodes: the states that lead on, and where to. After the last come leaves.
    pub(super) levels: Vec<Vec<Vec<(u16, u32)>>>,
    /// Per leaf the codes of all memory, and the set of events that are enabled with them.
    pub(super) leaves: Vec<Vec<(Vec<u32>, u32)>>,
    /// Sets of controllable events, ascending.
    pub(super) enabled: Vec<Vec<EventId>>,
    /// The node of the first level.
    pub(super) root: u32,
}

/// Two entries that no formula can tell apart, though something different is enabled.
pub(super) type Clash = [usize; 2];

impl Entries {
    pub(super) fn new(plant: &Plant, closed: &ClosedLoop, memory: &[Remembered]) -> Result<Self, Clash> {
        let mut builder = Builder {
            plant,
            closed,
            memory,
            nodes: vec![Interner::default(); plant.components],
            leaves: Interner::default(),
            enabled: Interner::default(),
            events: Vec::new(),
        };
        let root = builder.node(0, 0, closed.len())?;
        Ok(Entries {
            levels: builder.nodes.into_iter().map(|level| level.items).collect(),
            leaves: builder.leaves.items,
            enabled: builder.enabled.items,
            root,
        })
    }
}

/// Numbers for lists, in the order in which they come.
#[derive(Clone)]
struct Interner<T> {
    items: Vec<Vec<T>>,
    numbers: HashMap<Vec<T>, u32, FxBuildHasher>,
}

impl<T> Default for Interner<T> {
    fn default() -> Self {
        Interner { items: Vec::new(), numbers: HashMap::default() }
    }
}

impl<T: Clone + Eq + std::hash::Hash> Interner<T> {
    fn number(&mut self, item: &[T]) -> u32 {
        if let Some(&known) = self.numbers.get(item) {
            return known;
        }
        let number = self.items.len() as u32;
        self.items.push(item.to_vec());
        self.numbers.insert(item.to_vec(), number);
        number
    }
}

struct Builder<'a> {
    plant: &'a Plant,
    closed: &'a ClosedLoop,
    memory: &'a [Remembered],
    nodes: Vec<Interner<(u16, u32)>>,
    leaves: Interner<(Vec<u32>, u32)>,
    enabled: Interner<EventId>,
    /// Reused.
    events: Vec<EventId>,
}

impl Builder<'_> {
    /// The node of the entries from `first` to `last`, which agree in the components before `level`.
    fn node(&mut self, level: usize, mut first: usize, last: usize) -> Result<u32, Clash> {
        if level == self.plant.components {
            return self.leaf(first, last);
        }
        let mut branches = Vec::new();
        while first < last {
            let state = self.closed.entry(first)[level];
            let next = self.end(level, state, first, last);
            branches.push((state, self.node(level + 1, first, next)?));
            first = next;
        }
        Ok(self.nodes[level].number(&branches))
    }

    /// Where the states of a component become greater than `state`.
    fn end(&self, level: usize, state: u16, mut first: usize, mut last: usize) -> usize {
        while first < last {
            let middle = first.midpoint(last);
            if self.closed.entry(middle)[level] <= state {
                first = middle + 1;
            } else {
                last = middle;
            }
        }
        first
    }

    fn leaf(&mut self, first: usize, last: usize) -> Result<u32, Clash> {
        let mut cases: Vec<(Vec<u32>, u32, usize)> = (first..last)
            .map(|entry| {
                let codes = self.memory.iter().map(|memory| memory.codes[entry]).collect();
                (codes, self.enabled_in(entry), entry)
            })
            .collect();
        cases.sort_unstable();
        cases.dedup_by(|a, b| (&a.0, a.1) == (&b.0, b.1));
        if let Some(pair) = cases.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            let (a, b) = (pair[0].2, pair[1].2);
            return Err([a.min(b), a.max(b)]);
        }
        let cases: Vec<(Vec<u32>, u32)> =
            cases.into_iter().map(|(codes, enabled, _)| (codes, enabled)).collect();
        Ok(self.leaves.number(&cases))
    }

    fn enabled_in(&mut self, entry: usize) -> u32 {
        self.events.clear();
        let edges = self.closed.edges(entry).iter().map(|&(event, _)| event);
        self.events.extend(edges.filter(|&event| self.plant.events[event as usize].controllable));
        self.enabled.number(&self.events)
    }
}

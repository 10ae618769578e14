//! The product as a graph: what cycles are judged by, in flat arrays.

use crate::game::YIELD;
use crate::playout::EventId;
use crate::successors::{SetId, reserve};
use std::ops::Range;

/// Nodes by numbers in the order of discovery, the initial one first, with the edges that leave them.
#[derive(Debug)]
pub(super) struct Graph {
    /// Per node: the keys that are open.
    pub(super) open: Vec<SetId>,
    /// Per node: whose turn it is, and whether nothing may happen.
    pub(super) rest: Vec<Rest>,
    /// Offsets into the edges, one more than there are nodes.
    first: Vec<u32>,
    /// Per edge: where it leads.
    pub(super) target: Vec<u32>,
    pub(super) steps: Steps,
}

/// What happens on the edges.
#[derive(Debug, Default)]
pub(super) struct Steps {
    /// Per edge: its event or [`YIELD`].
    event: Vec<EventId>,
    /// Per edge: the keys that it discharges.
    pub(super) discharged: Vec<SetId>,
}

impl Steps {
    /// The next edges: events, and what they discharge.
    pub(super) fn add(&mut self, steps: impl ExactSizeIterator<Item = (EventId, SetId)>) {
        reserve(&mut self.event, steps.len());
        reserve(&mut self.discharged, steps.len());
        for (event, discharged) in steps {
            self.event.push(event);
            self.discharged.push(discharged);
        }
    }
}

/// What can happen in a node beside its edges.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Rest {
    /// The environment has the turn.
    pub(super) environment: bool,
    /// It may stay silent.
    pub(super) silent: bool,
}

const NONE: u32 = u32::MAX;

impl Graph {
    pub(super) fn new() -> Self {
        let (open, rest, target, steps) = Default::default();
        Graph { open, rest, first: vec![0], target, steps }
    }

    /// The number of nodes whose edges are known.
    pub(super) fn nodes(&self) -> usize {
        self.open.len()
    }

    /// The next node; its edges have been added.
    pub(super) fn add_node(&mut self, open: SetId, rest: Rest) {
        push(&mut self.open, open);
        push(&mut self.rest, rest);
        push(&mut self.first, self.target.len() as u32);
    }

    /// Edges of the next node: where they lead. What happens on them is added to `steps`, in the same order.
    pub(super) fn add_edges(&mut self, targets: impl ExactSizeIterator<Item = u32>) {
        reserve(&mut self.target, targets.len());
        self.target.extend(targets);
    }

    /// The edges that leave a node.
    pub(super) fn edges_of(&self, node: u32) -> Range<u32> {
        self.first[node as usize]..self.first[node as usize + 1]
    }

    /// Where edges come from: offsets into the second list, one more than there are nodes, and the nodes from which edges lead
    /// to a node.
    pub(super) fn sources(&self) -> (Vec<u32>, Vec<u32>) {
        // Shifted by one, so that counting up in each place makes the offsets.
        let mut first = vec![0; self.nodes() + 2];
        self.target.iter().for_each(|&target| first[target as usize + 2] += 1);
        for node in 2..first.len() {
            first[node] += first[node - 1];
        }
        let mut sources = vec![0; self.target.len()];
        for node in 0..self.nodes() as u32 {
            for edge in self.edges_of(node) {
                let place = &mut first[self.target[edge as usize] as usize + 1];
                sources[*place as usize] = node;
                *place += 1;
            }
        }
        first.pop();
        (first, sources)
    }

    /// The event of an edge, none for a yield.
    pub(super) fn event(&self, edge: u32) -> Option<EventId> {
        Some(self.steps.event[edge as usize]).filter(|&event| event != YIELD)
    }

    /// The edges of a shortest play into a node: those by which nodes were discovered.
    pub(super) fn play(&self, node: u32) -> Vec<u32> {
        let mut came = vec![(NONE, NONE); node as usize + 1];
        for source in 0..self.nodes() as u32 {
            for edge in self.edges_of(source) {
                let target = self.target[edge as usize];
                if target != 0 && target <= node && came[target as usize].1 == NONE {
                    came[target as usize] = (source, edge);
                }
            }
        }
        let mut play = Vec::new();
        let mut here = node;
        while here != 0 {
            let (source, edge) = came[here as usize];
            play.push(edge);
            here = source;
        }
        play.reverse();
        play
    }
}

fn push<T>(values: &mut Vec<T>, value: T) {
    reserve(values, 1);
    values.push(value);
}

//! What can starve at all? A quick answer for many goals at once, one bit for each.
//!
//! A goal starves on a walk that goes on for ever through nodes where it is open, on edges that do not discharge it. Nodes from
//! which none goes on are struck out, for as long as that is worth it. An edge from a node to itself on which nothing but
//! time passes, while an assumption is open, is no way to go on: alone it is not fair, and in company it adds nothing.
//! So all cycles remain on which the goal starves and that are fair; a good strategy leaves nothing at all as a rule.
//!
//! A bad strategy leaves much, but there a walk that takes each node's edges in turn soon closes a fair cycle.

use super::fairness::{Fairness, Group};
use super::graph::Graph;
use crate::parallel::sum_backwards;
use rustc_hash::FxHashMap;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Nodes are looked at again as long as one in so many is struck out; beyond, a search for components takes less time.
const WORTH: usize = 32;

/// Steps of a walk.
const STEPS: usize = 1 << 12;

/// The goals that may starve in the plays of a graph.
pub(super) struct Starving<'a, G> {
    fairness: &'a Fairness<'a>,
    graph: &'a G,
    group: &'a Group,
    /// The goals that starve on unfair cycles, too.
    strict: usize,
    /// The goals that starve in a node where the play may rest; they are known, and struck out everywhere.
    pub(super) resting: usize,
    /// Per node the goals that have not been struck out.
    nodes: Vec<AtomicUsize>,
}

impl<'a, G: Graph> Starving<'a, G> {
    pub(super) fn new(fairness: &'a Fairness<'a>, graph: &'a G, group: &'a Group, strict: usize) -> Self {
        let nodes = 0..graph.nodes() as u32;
        let open =
            |node: u32| if graph.is_reached(node) { group.open[graph.state(node) as usize] } else { 0 };
        let rests = |node: &u32| fairness.rests.contains(graph.state(*node) as usize);
        let resting = nodes.clone().filter(rests).fold(0, |resting, node| resting | open(node));
        let nodes = nodes.map(|node| AtomicUsize::new(open(node))).collect();
        Starving { fairness, graph, group, strict, resting, nodes }
    }

    /// Strikes out what cannot go on; the result does not say how much of it.
    pub(super) fn strike_out(&mut self, threads: usize) {
        let resting = self.resting;
        let ones = |node: &mut AtomicUsize| {
            *node.get_mut() &= !resting;
            node.get_mut().count_ones() as usize
        };
        let mut left: usize = self.nodes.iter_mut().map(ones).sum();
        while left > 0 {
            let struck = sum_backwards(self.nodes.len(), threads, |node| self.strike(node as u32));
            left -= struck;
            if struck <= left / WORTH {
                break;
            }
        }
    }

    /// The goals that starve somewhere.
    pub(super) fn any(&mut self) -> usize {
        self.nodes.iter_mut().fold(0, |any, node| any | *node.get_mut())
    }

    /// Whether a goal may starve from a node on.
    pub(super) fn contains(&self, node: u32, bit: usize) -> bool {
        self.get(node) >> bit & 1 == 1
    }

    /// The nodes from which a goal may starve.
    pub(super) fn of(&self, bit: usize) -> impl DoubleEndedIterator<Item = u32> {
        (0..self.nodes.len() as u32).filter(move |&node| self.contains(node, bit))
    }

    /// The goals that starve on an edge if they do so at both its ends.
    #[inline]
    pub(super) fn spared(&self, edge: usize) -> usize {
        let Some(inner) = &self.fairness.inner else { return usize::MAX };
        let edge = self.graph.of_game(edge);
        if inner.contains(edge) {
            self.group.spares[self.fairness.game.action[edge] as usize]
        } else {
            usize::MAX
        }
    }

    #[inline]
    fn get(&self, node: u32) -> usize {
        self.nodes[node as usize].load(Ordering::Relaxed)
    }

    /// The goals that may starve after an edge that leaves a node.
    #[inline]
    fn after(&self, node: u32, edge: usize) -> usize {
        let target = self.graph.target(edge);
        let after = self.get(target) & self.spared(edge);
        if target == node && self.fairness.is_idle(self.graph.state(node), self.graph.of_game(edge)) {
            after & self.strict
        } else {
            after
        }
    }

    /// Strikes out of a node what none of its edges keeps; how much that was.
    fn strike(&self, node: u32) -> usize {
        let before = self.get(node);
        if before == 0 {
            return 0;
        }
        let mut kept = 0;
        for edge in self.graph.edges_of(node) {
            kept |= before & self.after(node, edge);
            if kept == before {
                return 0;
            }
        }
        self.nodes[node as usize].store(kept, Ordering::Relaxed);
        (before & !kept).count_ones() as usize
    }

    /// A walk on which a goal starves, as its edges with their nodes, that comes back to where it began; `None` if none is found
    /// quickly. It takes the edges of a node in turn, and back from where none goes on.
    pub(super) fn closed_walk(&self, bit: usize) -> Option<Vec<(u32, usize)>> {
        let steps = STEPS.min(self.nodes.len());
        // Behind most others there is little that can still happen only once.
        let mut node = self.of(bit).next_back()?;
        // Per node the next edge, if there is any.
        let mut turns: FxHashMap<u32, Option<usize>> = FxHashMap::default();
        let mut walk = Vec::new();
        for step in 0..2 * steps {
            if step >= steps
                && turns.contains_key(&node)
                && let Some(first) = walk.iter().position(|&(before, _)| before == node)
            {
                return Some(walk.split_off(first));
            }
            let edges = self.graph.edges_of(node);
            let turn = turns.get(&node).map_or(edges.start, |turn| turn.unwrap_or(edges.end));
            let goes_on = |&edge: &usize| {
                self.after(node, edge) >> bit & 1 == 1 && turns.get(&self.graph.target(edge)) != Some(&None)
            };
            let edge = (turn..edges.end).chain(edges.start..turn).find(goes_on);
            turns.insert(node, edge.map(|edge| edge + 1));
            node = match edge {
                Some(edge) => {
                    walk.push((node, edge));
                    self.graph.target(edge)
                }
                None => walk.pop()?.0,
            };
        }
        None
    }
}

//! What can starve at all? A quick answer for many goals at once, one bit for each.
//!
//! A goal starves on a walk that goes on for ever through nodes where it is open, without discharging it. Nodes from which
//! none goes on are struck out until nothing changes. An edge from a node to itself that discharges no assumption, while one is
//! open, is no way to go on: alone it is not fair, and to a longer cycle it adds nothing. That keeps every fair cycle on which the goal
//! starves, and what leads there; a good controller seldom leaves anything.

use super::graph::{Graph, Rest};
use crate::parallel::sum_backwards;
use crate::successors::SetId;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// Goals that are looked at together.
pub(super) const GOALS: usize = u64::BITS as usize;

/// So often are all nodes looked at that some goal can starve from, before it is found out which ones to look at again. One time
/// takes a few nanoseconds a node, and a few dozen are enough but for long chains against the numbers; to find out which ones
/// takes as long as a hundred.
const SWEEPS: usize = 64;

/// Per node the goals, as bits, that can starve from there on.
///
/// `open` says per set of keys which goals are in it. The goals of `inner` are open in the system's turn instead, and nothing
/// discharges them. `assumes` says per set whether an assumption is in it, so that to stay in silence is not fair. `threads` as in
/// [`parallel::share`](crate::parallel::share): the result is the greatest of its kind, whatever is looked at first.
pub(super) fn starving(
    graph: &Graph,
    open: &[u64],
    inner: u64,
    assumes: &[bool],
    threads: usize,
) -> Vec<u64> {
    let nodes = graph.open.iter().zip(&graph.rest);
    let opens = |(&set, rest): (&SetId, &Rest)| open[set as usize] | if rest.environment { 0 } else { inner };
    let starving: Vec<AtomicU64> = nodes.map(|node| AtomicU64::new(opens(node))).collect();
    let search = Search { graph, open, assumes, starving: &starving };
    let round = |_| sum_backwards(graph.nodes(), threads, |node| usize::from(search.strike(node) != 0));
    if (0..SWEEPS).map(round).all(|struck| struck != 0) {
        search.follow(threads);
    }
    starving.into_iter().map(AtomicU64::into_inner).collect()
}

struct Search<'a> {
    graph: &'a Graph,
    open: &'a [u64],
    assumes: &'a [bool],
    /// Per node the goals that have not been struck out.
    starving: &'a [AtomicU64],
}

impl Search<'_> {
    fn get(&self, node: usize) -> u64 {
        self.starving[node].load(Ordering::Relaxed)
    }

    /// Strikes out of a node what none of its edges keeps; which goals these were.
    fn strike(&self, node: usize) -> u64 {
        let before = self.get(node);
        let assumes = self.assumes[self.graph.open[node] as usize];
        if before == 0 || self.graph.rest[node].silent && !assumes {
            return 0;
        }
        let mut after = 0;
        for edge in self.graph.edges_of(node as u32) {
            let target = self.graph.target[edge as usize] as usize;
            let discharged = self.graph.steps.discharged[edge as usize] as usize;
            if target == node && assumes && !self.assumes[discharged] {
                continue;
            }
            after |= before & !self.open[discharged] & self.get(target);
            if after == before {
                return 0;
            }
        }
        self.starving[node].store(after, Ordering::Relaxed);
        before & !after
    }

    /// Looks at nodes for as long as something was struck out of one that an edge of theirs leads to.
    fn follow(&self, threads: usize) {
        let (first, sources) = self.graph.sources();
        let waits: Vec<AtomicBool> = (0..self.graph.nodes()).map(|_| AtomicBool::new(true)).collect();
        let waits = |node: usize| &waits[node];
        // Whoever sees that a node waits sees what was struck out before, by all that made it wait: each swaps, so that none of
        // them hides another's release.
        let look = |node: usize| {
            if !waits(node).load(Ordering::Relaxed) || !waits(node).swap(false, Ordering::Acquire) {
                return 0;
            }
            let struck = self.strike(node);
            let mut some_wait = false;
            if struck != 0 {
                for &source in &sources[first[node] as usize..first[node + 1] as usize] {
                    if self.get(source as usize) & struck != 0 {
                        waits(source as usize).swap(true, Ordering::Release);
                        some_wait = true;
                    }
                }
            }
            usize::from(some_wait)
        };
        while sum_backwards(self.graph.nodes(), threads, look) != 0 {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::collection::vec;
    use proptest::prelude::{any, prop_assert_eq, proptest};

    proptest! {
        /// A goal starves from a node on if a walk there has as many steps as there are nodes, or ends where it may rest.
        #[test]
        fn what_starves_has_long_walks(
            nodes in vec((0..4u32, any::<bool>(), any::<bool>(), vec((0..4u32, 0..12u32), 0..4)), 1..12),
            open in vec(0..8u64, 4),
            assumes in vec(any::<bool>(), 4),
        ) {
            const INNER: u64 = 8;
            let mut graph = Graph::new();
            for (set, environment, silent, edges) in &nodes {
                graph.steps.add(edges.iter().map(|&(discharged, _)| (0, discharged)));
                graph.add_edges(edges.iter().map(|&(_, target)| target % nodes.len() as u32));
                graph.add_node(*set, Rest { environment: *environment, silent: *silent });
            }
            let start = |node: usize| {
                open[graph.open[node] as usize] | if graph.rest[node].environment { 0 } else { INNER }
            };
            let all = 0..nodes.len();
            let mut walks: Vec<u64> = all.clone().map(start).collect();
            for _ in all.clone() {
                let longer = |node: usize| {
                    let rests = graph.rest[node].silent && !assumes[graph.open[node] as usize];
                    let adds = |edge: &usize| {
                        let discharged = graph.steps.discharged[*edge] as usize;
                        graph.target[*edge] as usize != node
                            || !assumes[graph.open[node] as usize]
                            || assumes[discharged]
                    };
                    let edges = graph.edges_of(node as u32).map(|edge| edge as usize).filter(adds);
                    let on = edges.fold(0, |on, edge| {
                        on | walks[graph.target[edge] as usize] & !open[graph.steps.discharged[edge] as usize]
                    });
                    start(node) & if rests { u64::MAX } else { on }
                };
                walks = all.clone().map(longer).collect();
            }
            prop_assert_eq!(&starving(&graph, &open, INNER, &assumes, 1), &walks);
            // Long chains against the numbers are left to following them.
            let starving: Vec<AtomicU64> = (0..nodes.len()).map(|node| AtomicU64::new(start(node))).collect();
            Search { graph: &graph, open: &open, assumes: &assumes, starving: &starving }.follow(1);
            prop_assert_eq!(starving.into_iter().map(AtomicU64::into_inner).collect::<Vec<u64>>(), walks);
        }
    }
}

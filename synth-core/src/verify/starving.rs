//! What can starve at all? A quick answer for many goals at once, one bit for each.
//!
//! A goal starves on a walk that goes on for ever through nodes where it is open, without discharging it. Nodes from which
//! none goes on are struck out until nothing changes. That keeps every cycle on which the goal starves, fair or not, and what
//! leads there; a good controller seldom leaves more than cycles on which some assumption starves, too.

use super::graph::{Graph, Rest};
use crate::successors::SetId;

/// Goals that are looked at together.
pub(super) const GOALS: usize = u64::BITS as usize;

/// Per node the goals, as bits, that can starve from there on.
///
/// `open` says per set of keys which goals are in it. The goals of `inner` are open in the system's turn instead, and nothing
/// discharges them. `assumes` says per set whether an assumption is in it, so that to stay in silence is not fair.
pub(super) fn starving(graph: &Graph, open: &[u64], inner: u64, assumes: &[bool]) -> Vec<u64> {
    let nodes = || graph.open.iter().zip(&graph.rest);
    let opens = |(&set, rest): (&SetId, &Rest)| open[set as usize] | if rest.environment { 0 } else { inner };
    let mut starving: Vec<u64> = nodes().map(opens).collect();
    let goes_on = |(&set, rest): (&SetId, &Rest)| !rest.silent || assumes[set as usize];
    // Whether a node must be looked at; those that may stay in silence never lose anything.
    let mut waits: Vec<bool> = nodes().map(goes_on).collect();
    let may_lose = waits.clone();
    let (first, sources) = graph.sources();
    // Most successors have higher numbers, so each round begins at the end; what one says to those behind it, the next one hears.
    let mut is_last = false;
    while !is_last {
        is_last = true;
        for node in (0..graph.nodes()).rev() {
            if !std::mem::take(&mut waits[node]) {
                continue;
            }
            let before = starving[node];
            let mut after = 0;
            for edge in graph.edges_of(node as u32) {
                if after == before {
                    break;
                }
                let discharged = open[graph.discharged[edge as usize] as usize];
                after |= before & starving[graph.target[edge as usize] as usize] & !discharged;
            }
            if after == before {
                continue;
            }
            starving[node] = after;
            for &source in &sources[first[node] as usize..first[node + 1] as usize] {
                let source = source as usize;
                if starving[source] & before & !after != 0 && may_lose[source] {
                    waits[source] = true;
                    is_last &= source < node;
                }
            }
        }
    }
    starving
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
                for &(discharged, target) in edges {
                    graph.add_edge(0, discharged, target % nodes.len() as u32);
                }
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
                    let edges = graph.edges_of(node as u32).map(|edge| edge as usize);
                    let on = edges.fold(0, |on, edge| {
                        on | walks[graph.target[edge] as usize] & !open[graph.discharged[edge] as usize]
                    });
                    start(node) & if rests { u64::MAX } else { on }
                };
                walks = all.clone().map(longer).collect();
            }
            prop_assert_eq!(starving(&graph, &open, INNER, &assumes), walks);
        }
    }
}

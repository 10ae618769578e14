//! What can starve at all? A quick answer for many goals at once, one bit for each.
//!
//! A goal starves on a walk that goes on for ever through nodes where it is open, without discharging it. Nodes from which
//! none goes on are struck out until nothing changes. That keeps every cycle on which the goal starves, fair or not, and what
//! leads there; a good controller seldom leaves more than cycles on which some assumption starves, too.

use super::graph::Graph;

/// Goals that are looked at together.
pub(super) const GOALS: usize = u64::BITS as usize;

/// Per node the goals, as bits, that can starve from there on.
///
/// `open` says per set of keys which goals are in it. The goals of `inner` are open in the system's turn instead, and nothing
/// discharges them. `assumes` says per set whether an assumption is in it, so that to stay in silence is not fair.
pub(super) fn starving(graph: &Graph, open: &[u64], inner: u64, assumes: &[bool]) -> Vec<u64> {
    let mut starving: Vec<u64> = Vec::with_capacity(graph.nodes());
    // Most successors have higher numbers.
    let mut left: Vec<u32> = Vec::new();
    for (node, (&set, rest)) in (0..).zip(graph.open.iter().zip(&graph.rest)) {
        let goals = open[set as usize] | if rest.environment { 0 } else { inner };
        starving.push(goals);
        if goals != 0 && (!rest.silent || assumes[set as usize]) {
            left.push(node);
        }
    }
    left.reverse();
    loop {
        let mut changed = false;
        left.retain(|&node| {
            let before = starving[node as usize];
            let mut after = 0;
            for edge in graph.edges_of(node) {
                let discharged = open[graph.discharged[edge as usize] as usize];
                after |= before & starving[graph.target[edge as usize] as usize] & !discharged;
                if after == before {
                    return true;
                }
            }
            starving[node as usize] = after;
            changed = true;
            after != 0
        });
        if !changed {
            return starving;
        }
    }
}

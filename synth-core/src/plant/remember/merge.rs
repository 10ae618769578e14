//! Uniting what need not be told apart.

use std::collections::BTreeSet;

use super::local::Local;

/// Per node its class: nodes of one sight, none of which have to be told apart, whose successors by an event are in one class.
///
/// Greedy, in order of the nodes: each pair is united, together with all that this entails, unless that would unite what must
/// stay apart.
pub(super) fn merge(local: &Local, apart: &BTreeSet<(u32, u32)>) -> Vec<u32> {
    let nodes = local.len() as u32;
    let mut sets = Sets { parent: (0..nodes).collect() };
    for a in 0..nodes {
        for b in a + 1..nodes {
            if local.sight_of(a) == local.sight_of(b)
                && sets.find(a) != sets.find(b)
                && let Some(united) = sets.unite(local, apart, a, b)
            {
                sets = united;
            }
        }
    }
    let mut number = vec![u32::MAX; nodes as usize];
    let mut classes = 0;
    (0..nodes)
        .map(|node| {
            let root = sets.find(node) as usize;
            if number[root] == u32::MAX {
                number[root] = classes;
                classes += 1;
            }
            number[root]
        })
        .collect()
}

/// Disjoint sets of nodes; the root of a set is its least member.
#[derive(Clone)]
struct Sets {
    parent: Vec<u32>,
}

impl Sets {
    fn find(&self, node: u32) -> u32 {
        let mut root = node;
        while self.parent[root as usize] != root {
            root = self.parent[root as usize];
        }
        root
    }

    fn members(&self, root: u32) -> Vec<u32> {
        (root..self.parent.len() as u32).filter(|&node| self.find(node) == root).collect()
    }

    /// With the sets of two nodes united, and those of their successors, and so on; `None` if this cannot be.
    fn unite(&self, local: &Local, apart: &BTreeSet<(u32, u32)>, a: u32, b: u32) -> Option<Sets> {
        let mut sets = self.clone();
        let mut open = vec![(a, b)];
        while let Some((a, b)) = open.pop() {
            let (a, b) = (sets.find(a), sets.find(b));
            if a == b {
                continue;
            }
            let (left, right) = (sets.members(a), sets.members(b));
            for &x in &left {
                for &y in &right {
                    if apart.contains(&(x.min(y), x.max(y))) {
                        return None;
                    }
                    open.extend(shared(local, x, y));
                }
            }
            sets.parent[a.max(b) as usize] = a.min(b);
        }
        Some(sets)
    }
}

/// Where the same events lead two nodes of one sight: again to nodes of one sight each, since components are deterministic.
fn shared(local: &Local, x: u32, y: u32) -> impl Iterator<Item = (u32, u32)> {
    local.successors(x).filter_map(move |from_x| {
        let mut of_y = local.successors(y);
        of_y.find(|from_y| from_y.event == from_x.event).map(|from_y| (from_x.target, from_y.target))
    })
}

//! Shortest paths in a graph whose nodes are numbered breadth first.

/// One shortest path from node 0 to every node that can be reached.
pub struct ShortestPaths<'g> {
    first: &'g [u32],
    /// Per node: the edge by which it was found, or [`NONE`].
    into: Vec<u32>,
}

const NONE: u32 = u32::MAX;

impl<'g> ShortestPaths<'g> {
    /// Of a graph with so many nodes, numbered breadth first from 0. The edges of node `n` are `first[n]..first[n + 1]`; the
    /// last nodes may have no entry, and then have no edges. Targets that are no node are passed over.
    #[must_use]
    pub fn new(nodes: usize, first: &'g [u32], target: &[u32]) -> Self {
        // So the first edge into a node lies on a shortest path.
        let mut into = vec![NONE; nodes];
        for (edge, &target) in target.iter().enumerate().filter(|(_, target)| **target != 0) {
            if let Some(entry) = into.get_mut(target as usize)
                && *entry == NONE
            {
                *entry = edge as u32;
            }
        }
        ShortestPaths { first, into }
    }

    /// The edges of the path to `node`; none if it is node 0, or cannot be reached.
    #[must_use]
    pub fn to(&self, node: u32) -> Vec<usize> {
        let mut path = Vec::new();
        let mut edge = self.into[node as usize];
        while edge != NONE {
            path.push(edge as usize);
            let source = self.first.partition_point(|&first| first <= edge) - 1;
            edge = self.into[source];
        }
        path.reverse();
        path
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_edge_into_a_node_is_on_a_shortest_path() {
        // 0 → 1, 2; 1 → 0, 3; 2 → 3, and something else; 3 → 4 and 5 were not looked at.
        let (first, target) = ([0, 2, 4, 6, 7], [1, 2, 0, 3, 3, 99, 4]);
        let paths = ShortestPaths::new(6, &first, &target);
        let to: Vec<Vec<usize>> = (0..6).map(|node| paths.to(node)).collect();
        assert_eq!(to, [vec![], vec![0], vec![1], vec![0, 3], vec![0, 3, 6], vec![]]);
    }
}

//! Tarjan's strongly connected components of a part of a strategy's graph, without recursion and with arrays that are
//! allocated once.

use super::Strategy;

/// A part of a strategy's graph.
pub(super) trait Part {
    /// Whether the node belongs to it.
    fn has_node(&self, node: u32) -> bool;
    /// Whether the edge belongs to it if both its ends do.
    fn has_edge(&self, edge: usize) -> bool;
}

/// The search for components.
pub(super) struct Components<'a> {
    strategy: &'a Strategy,
    /// Per node: when it was found, from 1; 0 before.
    found: Vec<u32>,
    /// Per node: the least `found` known to be reachable, of nodes that have no component yet.
    low: Vec<u32>,
    /// Per node: its component, from 1; 0 before.
    component: Vec<u32>,
    /// Nodes without a component, in the order in which they were found.
    pending: Vec<u32>,
    /// The path from the root: a node and its next edge.
    path: Vec<(u32, u32)>,
    /// The nodes found in this search.
    touched: Vec<u32>,
}

impl<'a> Components<'a> {
    pub(super) fn new(strategy: &'a Strategy) -> Self {
        let nodes = strategy.nodes();
        Components {
            strategy,
            found: vec![0; nodes],
            low: vec![0; nodes],
            component: vec![0; nodes],
            pending: Vec::new(),
            path: Vec::new(),
            touched: Vec::new(),
        }
    }

    /// Whether a component of the part satisfies `holds`, which is given its nodes and the component of each node
    /// (complete for nodes of this and earlier components, and 0 for others). The search begins at each of `roots` that
    /// belongs to the part.
    pub(super) fn any(
        &mut self,
        part: &impl Part,
        roots: impl Iterator<Item = u32>,
        mut holds: impl FnMut(&[u32], &[u32]) -> bool,
    ) -> bool {
        for node in self.touched.drain(..) {
            self.found[node as usize] = 0;
            self.component[node as usize] = 0;
        }
        self.pending.clear();
        self.path.clear();
        let (mut time, mut components) = (0, 0);
        for root in roots {
            if self.found[root as usize] > 0 || !part.has_node(root) {
                continue;
            }
            self.find(root, &mut time);
            while let Some((node, next)) = self.path.last_mut() {
                let edge = *next as usize;
                if edge < self.strategy.edges_of(*node).end {
                    *next += 1;
                    let (node, target) = (*node as usize, self.strategy.target[edge]);
                    if !part.has_node(target) || !part.has_edge(edge) {
                        continue;
                    }
                    if self.found[target as usize] == 0 {
                        self.find(target, &mut time);
                    } else if self.component[target as usize] == 0 {
                        self.low[node] = self.low[node].min(self.found[target as usize]);
                    }
                    continue;
                }
                let node = *node;
                self.path.pop();
                let low = self.low[node as usize];
                if let Some(&(parent, _)) = self.path.last() {
                    self.low[parent as usize] = self.low[parent as usize].min(low);
                }
                if low == self.found[node as usize] {
                    components += 1;
                    let first = self.pending.iter().rposition(|&other| other == node).unwrap_or(0);
                    for &member in &self.pending[first..] {
                        self.component[member as usize] = components;
                    }
                    if holds(&self.pending[first..], &self.component) {
                        return true;
                    }
                    self.pending.truncate(first);
                }
            }
        }
        false
    }

    fn find(&mut self, node: u32, time: &mut u32) {
        *time += 1;
        self.found[node as usize] = *time;
        self.low[node as usize] = *time;
        self.pending.push(node);
        self.touched.push(node);
        self.path.push((node, self.strategy.first[node as usize]));
    }
}

//! Tarjan's strongly connected components of a part of a [`Graph`], without recursion and with arrays that are allocated
//! once.

use super::graph::Graph;

/// A part of a graph.
pub(super) trait Part {
    /// Its nodes.
    fn nodes(&self) -> impl Iterator<Item = u32>;
    /// Whether the edge belongs to it if both its ends do.
    fn has_edge(&self, edge: usize) -> bool;
}

/// A component of a part.
#[derive(Clone, Copy)]
pub(super) struct Component<'a> {
    /// Its nodes: one at least.
    pub(super) nodes: &'a [u32],
    /// It has edges: there are several nodes, or the only one has an edge to itself.
    pub(super) is_cyclic: bool,
    /// Per node of the graph: a number, the same for all nodes of one component and different for nodes of this component,
    /// earlier ones, and others.
    pub(super) number: &'a [u32],
}

/// The nodes that do not belong to the part; components are numbered downwards from here.
const OUTSIDE: u32 = u32::MAX;

/// The search for components.
pub(super) struct Components<'a, G> {
    graph: &'a G,
    /// Per node: 0 if it has not been found yet, its place in `pending`, from 1, while it is there, and then the number of its
    /// component, above all places. So one look tells all about a node.
    number: Vec<u32>,
    /// Nodes without a component, in the order in which they were found.
    pending: Vec<u32>,
    /// The path from the root.
    path: Vec<Step>,
}

/// A node on the path.
struct Step {
    /// Its place in `pending`.
    place: u32,
    /// The least place known to be reachable.
    low: u32,
    /// Its edges that have not been followed yet.
    next: u32,
    end: u32,
    /// One of its edges leads back to it.
    returns: bool,
}

impl<'a, G: Graph> Components<'a, G> {
    pub(super) fn new(graph: &'a G) -> Self {
        Components { graph, number: vec![0; graph.nodes()], pending: Vec::new(), path: Vec::new() }
    }

    /// Whether a component of the part satisfies `holds`. A component comes after those that it leads to.
    pub(super) fn any(&mut self, part: &impl Part, mut holds: impl FnMut(Component<'_>) -> bool) -> bool {
        self.pending.clear();
        self.path.clear();
        self.number.fill(OUTSIDE);
        part.nodes().for_each(|node| self.number[node as usize] = 0);
        let mut component = OUTSIDE;
        for root in part.nodes() {
            if self.number[root as usize] > 0 {
                continue;
            }
            self.find(root);
            while let Some(step) = self.path.last_mut() {
                if let Some(found) = step.advance(self.graph, part, &self.number) {
                    self.find(found);
                    continue;
                }
                let &mut Step { place, low, returns, .. } = step;
                self.path.pop();
                if let Some(before) = self.path.last_mut() {
                    before.low = before.low.min(low);
                }
                if low == place {
                    component -= 1;
                    let nodes = &self.pending[place as usize - 1..];
                    nodes.iter().for_each(|&node| self.number[node as usize] = component);
                    let is_cyclic = returns || nodes.len() > 1;
                    if holds(Component { nodes, is_cyclic, number: &self.number }) {
                        return true;
                    }
                    self.pending.truncate(place as usize - 1);
                }
            }
        }
        false
    }

    fn find(&mut self, node: u32) {
        self.pending.push(node);
        let place = self.pending.len() as u32;
        self.number[node as usize] = place;
        let edges = self.graph.edges_of(node);
        let (next, end) = (edges.start as u32, edges.end as u32);
        self.path.push(Step { place, low: place, next, end, returns: false });
    }
}

impl Step {
    /// Follows edges until one leads to a node that has not been found yet.
    fn advance(&mut self, graph: &impl Graph, part: &impl Part, number: &[u32]) -> Option<u32> {
        while self.next < self.end {
            let edge = self.next as usize;
            self.next += 1;
            let target = graph.target(edge);
            let place = number[target as usize];
            if place <= self.low && part.has_edge(edge) {
                if place == 0 {
                    return Some(target);
                }
                self.returns |= place == self.place;
                self.low = place;
            }
        }
        None
    }
}

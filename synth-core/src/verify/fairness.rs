//! Cycles of the product on which every assumption is kept and some guarantee starves.
//!
//! For one guarantee key, only nodes where it is open and edges that do not discharge it matter. A strongly connected
//! part of what is left can be walked for ever, all of it; if that walk is fair to every assumption key, the
//! environment wins. If it is not fair to one, no part of it is: an assumption key that is open in all its nodes
//! and discharged on none of its edges stays so in every part. So each strongly connected component is judged once,
//! as soon as it is found.

use super::graph::Graph;
use super::product::Product;
use super::starving::{GOALS, starving};
use super::{Refutation, VerifyError};
use crate::parallel;
use crate::playout::KeyId;
use crate::successors::SetId;
use std::collections::VecDeque;

const NONE: u32 = u32::MAX;

/// Nodes times goals that are worth another thread.
const LEAST_SHARE: usize = 1 << 12;

/// What must not starve: a guarantee key, or, if it is none, the end of a super step.
type Goal = Option<KeyId>;

/// Checks every guarantee key and that super steps end. `threads` as in [`parallel::share`].
pub(super) fn check(product: &Product<'_>, threads: usize) -> Result<(), VerifyError> {
    let sets = product.sets();
    let keys = product.open_keys(sets);
    let (assumptions, guarantees): (Vec<KeyId>, Vec<KeyId>) =
        keys.iter().partition(|&&key| product.is_assumed(key));
    let mut assumed = vec![vec![false; sets as usize]; assumptions.len()];
    for set in 0..sets {
        for key in product.keys(set) {
            if let Ok(index) = assumptions.binary_search(&key) {
                assumed[index][set as usize] = true;
            }
        }
    }
    let goals: Vec<Goal> = guarantees.into_iter().map(Some).chain([None]).collect();
    for goals in goals.chunks(GOALS) {
        check_some(product, &assumed, sets, goals, threads)?;
    }
    Ok(())
}

/// Checks a word of goals.
fn check_some(
    product: &Product<'_>,
    assumed: &[Vec<bool>],
    sets: SetId,
    goals: &[Goal],
    threads: usize,
) -> Result<(), VerifyError> {
    let graph = &product.graph;
    // Per key, and of what is no key, the bit that stands for it.
    let (mut bits, mut inner) = (Vec::new(), 0);
    for (bit, &goal) in goals.iter().enumerate() {
        match goal {
            Some(key) => {
                bits.resize(bits.len().max(key as usize + 1), 0);
                bits[key as usize] = 1 << bit;
            }
            None => inner = 1 << bit,
        }
    }
    let bit = |key: KeyId| bits.get(key as usize).copied().unwrap_or(0);
    let goals_in = |set| product.keys(set).fold(0, |goals, key| goals | bit(key));
    let open: Vec<u64> = (0..sets).map(goals_in).collect();
    let assumes: Vec<bool> = (0..open.len()).map(|set| assumed.iter().any(|is_in| is_in[set])).collect();
    let starving = starving(graph, &open, inner, &assumes, threads);
    let any = starving.iter().fold(0, |any, goals| any | goals);
    let suspects: Vec<u32> = (0..goals.len() as u32).filter(|bit| any >> bit & 1 == 1).collect();
    let found = parallel::find_first(&suspects, LEAST_SHARE / graph.nodes().max(1), threads, |&bit| {
        Search::new(graph, assumed, &starving, &open, bit).run()
    });
    found.map_or(Ok(()), |(index, cycle)| Err(refutation(product, goals[suspects[index] as usize], &cycle)))
}

fn refutation(product: &Product<'_>, goal: Goal, found: &Cycle) -> VerifyError {
    let reason = match goal {
        Some(key) => format!("an obligation of guarantee `{}` is never met", product.scenario_of(key)),
        None => "a super step never ends".to_owned(),
    };
    let cycle = found.edges.iter().map(|&edge| product.edge_text(edge)).collect();
    VerifyError::Refuted(Refutation { reason, play: product.play(found.start), cycle })
}

/// A cycle that must not be.
struct Cycle {
    start: u32,
    /// None, if the environment simply stays silent.
    edges: Vec<u32>,
}

/// Strongly connected components by Tarjan's algorithm with an explicit stack.
struct Search<'a> {
    graph: &'a Graph,
    /// Per assumption key that is open somewhere, and per set of keys: whether it is in there.
    assumed: &'a [Vec<bool>],
    /// Per node: the goals that can starve from there on.
    starving: &'a [u64],
    /// Per set of keys: the goals that are in there.
    open: &'a [u64],
    /// The goal, as a number of one bit.
    goal: u64,
    /// Per node: its number in the order of discovery, the least one that it reaches, and its component. [`NONE`]
    /// before it has one.
    number: Vec<u32>,
    low: Vec<u32>,
    component: Vec<u32>,
    /// Nodes that have no component yet.
    waiting: Vec<u32>,
    /// Nodes on the way, each with the number of its edges that have not been followed.
    path: Vec<(u32, u32)>,
}

impl<'a> Search<'a> {
    fn new(
        graph: &'a Graph,
        assumed: &'a [Vec<bool>],
        starving: &'a [u64],
        open: &'a [u64],
        bit: u32,
    ) -> Self {
        Search {
            graph,
            assumed,
            starving,
            open,
            goal: 1 << bit,
            number: vec![NONE; graph.nodes()],
            low: vec![0; graph.nodes()],
            component: vec![NONE; graph.nodes()],
            waiting: Vec::new(),
            path: Vec::new(),
        }
    }

    /// Looks for a fair cycle through nodes that matter on edges that matter.
    fn run(&mut self) -> Option<Cycle> {
        let (mut counter, mut components) = (0, 0);
        for root in 0..self.graph.nodes() as u32 {
            if self.number[root as usize] != NONE || !self.matters(root) {
                continue;
            }
            self.discover(root, &mut counter);
            while let Some(&mut (node, ref mut left)) = self.path.last_mut() {
                if *left > 0 {
                    *left -= 1;
                    let edge = self.graph.edges_of(node).start + *left;
                    self.look(node, edge, &mut counter);
                    continue;
                }
                self.path.pop();
                let low = self.low[node as usize];
                if let Some(&(parent, _)) = self.path.last() {
                    self.low[parent as usize] = self.low[parent as usize].min(low);
                }
                if low == self.number[node as usize] {
                    let found = self.close(node, components);
                    if found.is_some() {
                        return found;
                    }
                    components += 1;
                }
            }
        }
        None
    }

    fn discover(&mut self, node: u32, counter: &mut u32) {
        self.number[node as usize] = *counter;
        self.low[node as usize] = *counter;
        *counter += 1;
        self.waiting.push(node);
        let edges = self.graph.edges_of(node);
        self.path.push((node, edges.end - edges.start));
    }

    fn look(&mut self, node: u32, edge: u32, counter: &mut u32) {
        let next = self.graph.target[edge as usize];
        if !self.avoids(edge) || !self.matters(next) {
            return;
        }
        if self.number[next as usize] == NONE {
            self.discover(next, counter);
        } else if self.component[next as usize] == NONE {
            let low = &mut self.low[node as usize];
            *low = (*low).min(self.number[next as usize]);
        }
    }

    /// A component is complete: the nodes that wait from `root` on.
    fn close(&mut self, root: u32, component: u32) -> Option<Cycle> {
        let start = self.waiting.iter().rposition(|&node| node == root).unwrap_or_default();
        for index in start..self.waiting.len() {
            self.component[self.waiting[index] as usize] = component;
        }
        let members = &self.waiting[start..];
        if self.is_cycle(members, component) && self.is_fair(members, component) {
            return Some(self.cycle(members, component));
        }
        self.waiting.truncate(start);
        None
    }

    /// Whether a node is one of those that are looked at.
    fn matters(&self, node: u32) -> bool {
        self.starving[node as usize] & self.goal != 0
    }

    /// Whether an edge does not discharge the key.
    fn avoids(&self, edge: u32) -> bool {
        self.open[self.graph.steps.discharged[edge as usize] as usize] & self.goal == 0
    }

    /// The edges from a node of a component that stay in it.
    fn inside(&self, node: u32, component: u32) -> impl Iterator<Item = u32> {
        self.graph.edges_of(node).filter(move |&edge| {
            self.avoids(edge) && self.component[self.graph.target[edge as usize] as usize] == component
        })
    }

    fn is_cycle(&self, members: &[u32], component: u32) -> bool {
        members.len() > 1
            || self.graph.rest[members[0] as usize].silent
            || self.inside(members[0], component).next().is_some()
    }

    fn is_fair(&self, members: &[u32], component: u32) -> bool {
        self.assumed.iter().all(|assumed| {
            members.iter().any(|&node| {
                !self.is_open(node, assumed)
                    || self.inside(node, component).any(|edge| self.discharges(edge, assumed))
            })
        })
    }

    fn is_open(&self, node: u32, key: &[bool]) -> bool {
        key[self.graph.open[node as usize] as usize]
    }

    fn discharges(&self, edge: u32, key: &[bool]) -> bool {
        key[self.graph.steps.discharged[edge as usize] as usize]
    }

    /// A walk around a component that is fair to every assumption.
    fn cycle(&self, members: &[u32], component: u32) -> Cycle {
        // Nodes are numbered breadth first: the least one has a shortest play.
        let start = members.iter().copied().min().unwrap_or_default();
        let mut cycle = Vec::new();
        let mut here = start;
        for assumed in self.assumed {
            let (walk, end) = self.walk(here, component, &|node, edge| match edge {
                None => !self.is_open(node, assumed),
                Some(edge) => self.discharges(edge, assumed),
            });
            cycle.extend(walk);
            here = end;
        }
        let back = |node, edge: Option<u32>| edge.is_none() && node == start;
        if here != start {
            cycle.extend(self.walk(here, component, &back).0);
        } else if cycle.is_empty() && !self.graph.rest[start as usize].silent {
            // No assumption asks for a move: any way around will do.
            if let Some(edge) = self.inside(start, component).next() {
                cycle.push(edge);
                cycle.extend(self.walk(self.graph.target[edge as usize], component, &back).0);
            }
        }
        Cycle { start, edges: cycle }
    }

    /// A shortest walk inside the component to a node, or over an edge, that is wanted; its edges and its end.
    fn walk(&self, from: u32, component: u32, wanted: &dyn Fn(u32, Option<u32>) -> bool) -> (Vec<u32>, u32) {
        let mut came: Vec<(u32, u32)> = Vec::new();
        let mut queue = VecDeque::from([(from, NONE)]);
        let mut seen = std::collections::BTreeSet::from([from]);
        let trace = |came: &[(u32, u32)], mut at: u32| {
            let mut edges = Vec::new();
            while at != NONE {
                let (edge, before) = came[at as usize];
                edges.push(edge);
                at = before;
            }
            edges.reverse();
            edges
        };
        while let Some((node, via)) = queue.pop_front() {
            if wanted(node, None) {
                return (trace(&came, via), node);
            }
            for edge in self.inside(node, component) {
                let target = self.graph.target[edge as usize];
                came.push((edge, via));
                let via = came.len() as u32 - 1;
                if wanted(node, Some(edge)) {
                    return (trace(&came, via), target);
                }
                if seen.insert(target) {
                    queue.push_back((target, via));
                }
            }
        }
        (Vec::new(), from)
    }
}

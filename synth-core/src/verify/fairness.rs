//! Cycles of the product on which every assumption is kept and some guarantee starves.
//!
//! For one guarantee key, only nodes where it is open and edges that do not discharge it matter. A strongly connected
//! part of what is left can be walked for ever, all of it; if that walk is fair to every assumption key, the
//! environment wins. If it is not fair to one, no part of it is: an assumption key that is open in all its nodes
//! and discharged on none of its edges stays so in every part. So each strongly connected component is judged once,
//! as soon as it is found.

use super::product::Product;
use super::{Refutation, VerifyError};
use crate::playout::KeyId;
use std::collections::VecDeque;

const NONE: u32 = u32::MAX;

/// Checks every guarantee key and that super steps end.
pub(super) fn check(product: &Product<'_>) -> Result<(), VerifyError> {
    let keys = product.open_keys();
    let assumed = keys.iter().filter(|&&key| product.is_assumed(key));
    let mut search = Search {
        product,
        assumed: assumed.map(|&key| product.containing(key)).collect(),
        avoided: None,
        number: vec![NONE; product.nodes()],
        low: vec![0; product.nodes()],
        component: vec![NONE; product.nodes()],
        waiting: Vec::new(),
        path: Vec::new(),
    };
    for key in keys.into_iter().filter(|&key| !product.is_assumed(key)) {
        search.avoided = Some((key, product.containing(key)));
        search.run()?;
    }
    search.avoided = None;
    search.run()
}

/// Strongly connected components by Tarjan's algorithm with an explicit stack.
struct Search<'a> {
    product: &'a Product<'a>,
    /// Per assumption key that is open somewhere, and per set of keys: whether it is in there.
    assumed: Vec<Vec<bool>>,
    /// The guarantee key, and the sets that it is in; none is the one for super steps.
    avoided: Option<(KeyId, Vec<bool>)>,
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

impl Search<'_> {
    /// Looks for a fair cycle through nodes that matter on edges that matter.
    fn run(&mut self) -> Result<(), VerifyError> {
        self.number.fill(NONE);
        self.component.fill(NONE);
        let (mut counter, mut components) = (0, 0);
        for root in 0..self.product.nodes() as u32 {
            if self.number[root as usize] != NONE || !self.matters(root) {
                continue;
            }
            self.discover(root, &mut counter);
            while let Some(&mut (node, ref mut left)) = self.path.last_mut() {
                if *left > 0 {
                    *left -= 1;
                    let edge = self.product.edges_of(node).start + *left;
                    self.look(node, edge, &mut counter);
                    continue;
                }
                self.path.pop();
                let low = self.low[node as usize];
                if let Some(&(parent, _)) = self.path.last() {
                    self.low[parent as usize] = self.low[parent as usize].min(low);
                }
                if low == self.number[node as usize] {
                    self.close(node, components)?;
                    components += 1;
                }
            }
        }
        Ok(())
    }

    fn discover(&mut self, node: u32, counter: &mut u32) {
        self.number[node as usize] = *counter;
        self.low[node as usize] = *counter;
        *counter += 1;
        self.waiting.push(node);
        let edges = self.product.edges_of(node);
        self.path.push((node, edges.end - edges.start));
    }

    fn look(&mut self, node: u32, edge: u32, counter: &mut u32) {
        let next = self.product.target[edge as usize];
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
    fn close(&mut self, root: u32, component: u32) -> Result<(), VerifyError> {
        let start = self.waiting.iter().rposition(|&node| node == root).unwrap_or_default();
        for index in start..self.waiting.len() {
            self.component[self.waiting[index] as usize] = component;
        }
        let members = &self.waiting[start..];
        if self.is_cycle(members, component) && self.is_fair(members, component) {
            return Err(self.refutation(members, component));
        }
        self.waiting.truncate(start);
        Ok(())
    }

    /// Whether a node is one of those that are looked at.
    fn matters(&self, node: u32) -> bool {
        match &self.avoided {
            Some((_, contains)) => contains[self.product.open[node as usize] as usize],
            None => !self.product.environment[node as usize],
        }
    }

    /// Whether an edge does not discharge the key.
    fn avoids(&self, edge: u32) -> bool {
        match &self.avoided {
            Some((_, contains)) => !contains[self.product.discharged[edge as usize] as usize],
            None => true,
        }
    }

    /// The edges from a node of a component that stay in it.
    fn inside(&self, node: u32, component: u32) -> impl Iterator<Item = u32> {
        self.product.edges_of(node).filter(move |&edge| {
            self.avoids(edge) && self.component[self.product.target[edge as usize] as usize] == component
        })
    }

    fn is_cycle(&self, members: &[u32], component: u32) -> bool {
        members.len() > 1
            || self.product.silent[members[0] as usize]
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
        key[self.product.open[node as usize] as usize]
    }

    fn discharges(&self, edge: u32, key: &[bool]) -> bool {
        key[self.product.discharged[edge as usize] as usize]
    }

    /// A play into the component and a walk around it that is fair to every assumption.
    fn refutation(&self, members: &[u32], component: u32) -> VerifyError {
        // Nodes are numbered breadth first: the least one has a shortest play.
        let start = members.iter().copied().min().unwrap_or_default();
        let mut cycle = Vec::new();
        let mut here = start;
        for assumed in &self.assumed {
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
        } else if cycle.is_empty() && !self.product.silent[start as usize] {
            // No assumption asks for a move: any way around will do.
            if let Some(edge) = self.inside(start, component).next() {
                cycle.push(self.product.edge_text(edge));
                cycle.extend(self.walk(self.product.target[edge as usize], component, &back).0);
            }
        }
        let reason = match &self.avoided {
            Some((key, _)) => {
                format!("an obligation of guarantee `{}` is never met", self.product.scenario_of(*key))
            }
            None => "a super step never ends".to_owned(),
        };
        VerifyError::Refuted(Refutation { reason, play: self.product.play(start), cycle })
    }

    /// A shortest walk inside the component to a node, or over an edge, that is wanted; its texts and its end.
    fn walk(
        &self,
        from: u32,
        component: u32,
        wanted: &dyn Fn(u32, Option<u32>) -> bool,
    ) -> (Vec<String>, u32) {
        let mut came: Vec<(u32, u32)> = Vec::new();
        let mut queue = VecDeque::from([(from, NONE)]);
        let mut seen = std::collections::BTreeSet::from([from]);
        let trace = |came: &[(u32, u32)], mut at: u32| {
            let mut texts = Vec::new();
            while at != NONE {
                let (edge, before) = came[at as usize];
                texts.push(self.product.edge_text(edge));
                at = before;
            }
            texts.reverse();
            texts
        };
        while let Some((node, via)) = queue.pop_front() {
            if wanted(node, None) {
                return (trace(&came, via), node);
            }
            for edge in self.inside(node, component) {
                let target = self.product.target[edge as usize];
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

//! Cycles of the product on which every assumption is kept and some guarantee starves.
//!
//! For one guarantee key, only nodes where it is open and edges that do not discharge it matter. A strongly connected
//! part of what is left can be walked for ever, all of it; if that walk is fair to every assumption key, the
//! environment wins. If it is not fair to one, no part of it is: an assumption key that is open in all its nodes
//! and discharged on none of its edges stays so in every part. So each strongly connected component is judged once.

use super::product::{Edge, Product};
use super::{Refutation, VerifyError};
use crate::playout::KeyId;
use std::collections::VecDeque;

const NONE: u32 = u32::MAX;

/// Checks every guarantee key and that super steps end.
pub(super) fn check(product: &Product<'_>) -> Result<(), VerifyError> {
    let mut nodes_of_key: Vec<Vec<u32>> = vec![Vec::new(); product.key_count()];
    for (node, open) in product.open.iter().enumerate() {
        for &key in open {
            nodes_of_key[key as usize].push(node as u32);
        }
    }
    let assumed: Vec<KeyId> = (0..product.key_count() as KeyId)
        .filter(|&key| product.is_assumed(key) && !nodes_of_key[key as usize].is_empty())
        .collect();
    let mut search = Search { product, assumed, place: vec![NONE; product.nodes()] };
    for (key, nodes) in nodes_of_key.iter().enumerate() {
        let key = key as KeyId;
        if !product.is_assumed(key) {
            search.starves(nodes, Some(key))?;
        }
    }
    let system: Vec<u32> =
        (0..product.nodes() as u32).filter(|&node| !product.environment[node as usize]).collect();
    search.starves(&system, None)
}

struct Search<'a> {
    product: &'a Product<'a>,
    assumed: Vec<KeyId>,
    /// Per node of the product: its index in the part that is looked at, or [`NONE`].
    place: Vec<u32>,
}

impl Search<'_> {
    /// Looks for a fair cycle through `nodes` that avoids edges which discharge `key`.
    fn starves(&mut self, nodes: &[u32], key: Option<KeyId>) -> Result<(), VerifyError> {
        for (place, &node) in nodes.iter().enumerate() {
            self.place[node as usize] = place as u32;
        }
        let component = self.components(nodes, key);
        let mut members: Vec<Vec<u32>> = Vec::new();
        for (&node, &component) in nodes.iter().zip(&component) {
            if members.len() <= component as usize {
                members.resize(component as usize + 1, Vec::new());
            }
            members[component as usize].push(node);
        }
        let starving = members.iter().find(|members| {
            let inside = |target| self.same(&component, members[0], target);
            self.is_cycle(members, key, &inside) && self.is_fair(members, key, &inside)
        });
        let result = match starving {
            None => Ok(()),
            Some(members) => {
                let inside = |target| self.same(&component, members[0], target);
                Err(self.refutation(members, key, &inside))
            }
        };
        for &node in nodes {
            self.place[node as usize] = NONE;
        }
        result
    }

    fn same(&self, component: &[u32], node: u32, target: u32) -> bool {
        let (a, b) = (self.place[node as usize], self.place[target as usize]);
        b != NONE && component[a as usize] == component[b as usize]
    }

    fn edges(&self, node: u32, key: Option<KeyId>) -> impl Iterator<Item = &Edge> {
        let edges = self.product.edges[node as usize].iter();
        edges.filter(move |edge| key.is_none_or(|key| edge.discharged.binary_search(&key).is_err()))
    }

    fn is_cycle(&self, members: &[u32], key: Option<KeyId>, inside: &dyn Fn(u32) -> bool) -> bool {
        members.len() > 1
            || self.product.silent[members[0] as usize]
            || self.edges(members[0], key).any(|edge| inside(edge.target))
    }

    fn is_fair(&self, members: &[u32], key: Option<KeyId>, inside: &dyn Fn(u32) -> bool) -> bool {
        self.assumed.iter().all(|&assumed| {
            members.iter().any(|&node| {
                !self.is_open(node, assumed)
                    || self
                        .edges(node, key)
                        .any(|edge| inside(edge.target) && edge.discharged.binary_search(&assumed).is_ok())
            })
        })
    }

    fn is_open(&self, node: u32, key: KeyId) -> bool {
        self.product.open[node as usize].binary_search(&key).is_ok()
    }

    /// Strongly connected components by Tarjan's algorithm with an explicit stack: per place, its component.
    fn components(&self, nodes: &[u32], key: Option<KeyId>) -> Vec<u32> {
        let successors = |place: usize| -> Vec<u32> {
            let targets = self.edges(nodes[place], key).map(|edge| self.place[edge.target as usize]);
            targets.filter(|&target| target != NONE).collect()
        };
        let mut number = vec![NONE; nodes.len()];
        let mut low = vec![0; nodes.len()];
        let mut component = vec![NONE; nodes.len()];
        let (mut counter, mut components) = (0, 0);
        let mut open: Vec<u32> = Vec::new();
        for root in 0..nodes.len() {
            if number[root] != NONE {
                continue;
            }
            let mut path: Vec<(usize, Vec<u32>)> = vec![(root, successors(root))];
            number[root] = counter;
            low[root] = counter;
            counter += 1;
            open.push(root as u32);
            while let Some((place, rest)) = path.last_mut() {
                let place = *place;
                if let Some(next) = rest.pop() {
                    let next = next as usize;
                    if number[next] == NONE {
                        number[next] = counter;
                        low[next] = counter;
                        counter += 1;
                        open.push(next as u32);
                        path.push((next, successors(next)));
                    } else if component[next] == NONE {
                        low[place] = low[place].min(number[next]);
                    }
                    continue;
                }
                path.pop();
                if let Some(&(parent, _)) = path.last() {
                    low[parent] = low[parent].min(low[place]);
                }
                if low[place] == number[place] {
                    while let Some(member) = open.pop() {
                        component[member as usize] = components;
                        if member as usize == place {
                            break;
                        }
                    }
                    components += 1;
                }
            }
        }
        component
    }

    /// A play into the component and a walk around it that is fair to every assumption.
    fn refutation(&self, members: &[u32], key: Option<KeyId>, inside: &dyn Fn(u32) -> bool) -> VerifyError {
        // Nodes are numbered breadth first: the least one has a shortest play.
        let start = members.iter().copied().min().unwrap_or_default();
        let mut cycle = Vec::new();
        let mut here = start;
        for &assumed in &self.assumed {
            let (walk, end) = self.walk(here, key, inside, &|node, edge| match edge {
                None => !self.is_open(node, assumed),
                Some(edge) => edge.discharged.binary_search(&assumed).is_ok(),
            });
            cycle.extend(walk);
            here = end;
        }
        if here != start {
            cycle.extend(self.walk(here, key, inside, &|node, edge| edge.is_none() && node == start).0);
        } else if cycle.is_empty() && !self.product.silent[start as usize] {
            // No assumption asks for a move: any way around will do.
            if let Some(edge) = self.edges(start, key).find(|edge| inside(edge.target)) {
                cycle.push(self.product.edge_text(edge));
                let back = |node, edge: Option<&Edge>| edge.is_none() && node == start;
                cycle.extend(self.walk(edge.target, key, inside, &back).0);
            }
        }
        let reason = match key {
            Some(key) => {
                format!("an obligation of guarantee `{}` is never met", self.product.scenario_of(key))
            }
            None => "a super step never ends".to_owned(),
        };
        VerifyError::Refuted(Refutation { reason, play: self.product.play(start), cycle })
    }

    /// A shortest walk inside the component to a node, or over an edge, that is wanted; its texts and its end.
    fn walk(
        &self,
        from: u32,
        key: Option<KeyId>,
        inside: &dyn Fn(u32) -> bool,
        wanted: &dyn Fn(u32, Option<&Edge>) -> bool,
    ) -> (Vec<String>, u32) {
        let mut came: Vec<(u32, u32, String)> = Vec::new();
        let mut queue = VecDeque::from([(from, NONE)]);
        let mut seen = std::collections::BTreeSet::from([from]);
        let trace = |came: &[(u32, u32, String)], mut at: u32| {
            let mut texts = Vec::new();
            while at != NONE {
                let (_, before, text) = &came[at as usize];
                texts.push(text.clone());
                at = *before;
            }
            texts.reverse();
            texts
        };
        while let Some((node, via)) = queue.pop_front() {
            if wanted(node, None) {
                return (trace(&came, via), node);
            }
            for edge in self.edges(node, key).filter(|edge| inside(edge.target)) {
                came.push((edge.target, via, self.product.edge_text(edge)));
                let via = came.len() as u32 - 1;
                if wanted(node, Some(edge)) {
                    return (trace(&came, via), edge.target);
                }
                if seen.insert(edge.target) {
                    queue.push_back((edge.target, via));
                }
            }
        }
        (Vec::new(), from)
    }
}

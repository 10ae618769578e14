//! Who wins (section 5): the textbook's triply nested fixpoint for generalised reactivity of rank 1.
//!
//! Every edge is a node of its own between two states, so that acceptance on steps becomes acceptance on nodes.
//! Piterman, Pnueli and Sa'ar 2006: the winning nodes are
//! `νZ. ⋀j μY. ⋁i νX. (Gj ∧ ◇Z) ∨ ◇Y ∨ (¬Ai ∧ ◇X)`, where `◇S` are the nodes from which the system can force the next
//! node to lie in `S`.

use super::explore::{Graph, Owner};
use std::collections::BTreeSet;
use synth_core::syntax::ast::ScenarioKind;

/// A set of nodes.
type Set = Vec<bool>;

/// The graph with edges as nodes: first the states, then the edges.
struct Arena {
    successors: Vec<Vec<usize>>,
    /// The system chooses the successor; nodes of edges have one successor, so nobody chooses there.
    is_system: Vec<bool>,
    /// Reaching these is winning.
    won: Set,
}

impl Arena {
    fn new(graph: &Graph) -> Arena {
        let states = graph.nodes.len();
        let mut successors = vec![Vec::new(); states];
        for (index, edge) in graph.edges.iter().enumerate() {
            successors[edge.from].push(states + index);
            successors.push(vec![edge.to]);
        }
        for (index, node) in graph.nodes.iter().enumerate() {
            if node.silent {
                successors[index].push(index);
            }
        }
        let mut is_system = vec![false; successors.len()];
        let mut won = vec![false; successors.len()];
        for (index, node) in graph.nodes.iter().enumerate() {
            is_system[index] = matches!(node.owner, Owner::Turn(case) if case.is_system());
            won[index] = node.owner == Owner::Won;
        }
        Arena { successors, is_system, won }
    }

    /// `◇set` for one node. Nobody wins from a node without successors, unless it is won.
    fn can_force(&self, node: usize, set: &Set) -> bool {
        let mut successors = self.successors[node].iter();
        if self.is_system[node] {
            successors.any(|&next| set[next])
        } else {
            !self.successors[node].is_empty() && successors.all(|&next| set[next])
        }
    }

    /// The nodes that satisfy `wanted`, and those that are won.
    fn nodes(&self, wanted: impl Fn(usize) -> bool) -> Set {
        (0..self.successors.len()).map(|node| self.won[node] || wanted(node)).collect()
    }
}

/// For each state whether the system wins from it.
#[must_use]
pub fn solve(graph: &Graph) -> Vec<bool> {
    let arena = Arena::new(graph);
    let states = graph.nodes.len();
    let size = arena.successors.len();
    let fair = |key: usize| -> Set {
        let states = graph.nodes.iter().map(|node| !node.open.contains(&key));
        states.chain(graph.edges.iter().map(|edge| edge.discharged.contains(&key))).collect()
    };
    let assumptions: Vec<Set> = match graph.keys_of(ScenarioKind::Assumption) {
        // No assumption is one that always holds.
        keys if keys.is_empty() => vec![vec![true; size]],
        keys => keys.into_iter().map(fair).collect(),
    };
    let mut guarantees: Vec<Set> = graph.keys_of(ScenarioKind::Guarantee).into_iter().map(fair).collect();
    guarantees.push(
        (0..size)
            .map(|node| {
                node < states && matches!(graph.nodes[node].owner, Owner::Turn(case) if !case.is_system())
            })
            .collect(),
    );
    // Equal sets say the same.
    let assumptions: BTreeSet<Set> = assumptions.into_iter().collect();
    let guarantees: BTreeSet<Set> = guarantees.into_iter().collect();

    let mut z = vec![true; size];
    loop {
        let before = z.clone();
        for guarantee in &guarantees {
            z = least(&arena, &assumptions, guarantee, &z);
        }
        if z == before {
            z.truncate(states);
            return z;
        }
    }
}

/// `μY. ⋁i νX. …` for one guarantee.
fn least(arena: &Arena, assumptions: &BTreeSet<Set>, guarantee: &Set, z: &Set) -> Set {
    let mut y = vec![false; z.len()];
    loop {
        let start =
            arena.nodes(|node| guarantee[node] && arena.can_force(node, z) || arena.can_force(node, &y));
        let before = y.clone();
        for assumption in assumptions {
            let x = greatest(arena, assumption, &start);
            for (y, x) in y.iter_mut().zip(x) {
                *y |= x;
            }
        }
        if y == before {
            return y;
        }
    }
}

/// `νX. start ∨ (¬A ∧ ◇X)`.
fn greatest(arena: &Arena, assumption: &Set, start: &Set) -> Set {
    let mut x = arena.nodes(|node| start[node] || !assumption[node]);
    loop {
        let next = arena.nodes(|node| start[node] || !assumption[node] && arena.can_force(node, &x));
        if next == x {
            return x;
        }
        x = next;
    }
}

//! Products of automata, explored on the fly.
//!
//! Events that several automata name happen in all of them at once, others in one alone. Only what can be reached is
//! looked at: components and constraints are followed together, so a product is no larger than what both leave of it. The
//! product of the components alone is counted, not kept, and counted by parts: components that share no event, not even
//! through others, move independently, so the sizes of such groups are multiplied.

use super::moves::{Candidates, Moves};
use super::packing::Packing;
use super::{AutomatonId, EventId, Plant};
use crate::explore::{LimitReached, Limits};
use crate::intern::Rows;

/// Edges have `u32` offsets; one state adds fewer than the rest.
const MOST_EDGES: usize = (u32::MAX - (1 << 24)) as usize;

/// A group of components larger than this is not counted.
const MOST_COUNTED: usize = 1 << 24;

/// What a product is explored for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Scope {
    /// All that can happen.
    All,
    /// What nobody can prevent, until the first bad state is met; states behind it have no edges yet.
    Uncontrollable,
}

/// The reachable part of the product of components and constraints. State 0 is the initial one; others follow breadth first.
#[derive(Debug)]
pub(super) struct Product<'p> {
    pub(super) moves: Moves<'p>,
    pub(super) packing: Packing,
    pub(super) rows: Rows<u64>,
    /// The edges of state `s` are at `first[s]..first[s + 1]`.
    pub(super) first: Vec<u32>,
    pub(super) event: Vec<EventId>,
    pub(super) target: Vec<u32>,
    /// States in which something bad holds or cannot be prevented, ascending. They have no edges.
    pub(super) bad: Vec<u32>,
    /// States in which all automata are marked, ascending; empty if [`Moves::all_marked`].
    pub(super) marked: Vec<u32>,
}

impl<'p> Product<'p> {
    /// Explores from these states of the automata; what lies behind bad states is not looked at.
    pub(super) fn explore(
        plant: &'p Plant,
        start: &[u16],
        scope: Scope,
        limits: &Limits,
    ) -> Result<Self, LimitReached> {
        let moves = Moves::constrained(plant);
        let (packing, rows) = store(plant, &moves, start);
        let mut product = Product {
            moves,
            packing,
            rows,
            first: vec![0],
            event: Vec::new(),
            target: Vec::new(),
            bad: Vec::new(),
            marked: Vec::new(),
        };
        product.run(plant, scope, limits)?;
        Ok(product)
    }

    fn run(&mut self, plant: &Plant, scope: Scope, limits: &Limits) -> Result<(), LimitReached> {
        let mut states = vec![0; plant.automata.len()];
        let mut row = vec![0; self.packing.words()];
        let mut candidates = Candidates::default();
        let all_marked = self.moves.all_marked();
        let mut state = 0;
        while (state as usize) < self.rows.len() {
            self.check(limits)?;
            self.packing.unpack(self.rows.get(state), &mut states);
            self.moves.collect(&states, &mut candidates);
            if self.moves.violates(&states) || cannot_be_prevented(plant, &candidates) {
                self.bad.push(state);
                if scope == Scope::Uncontrollable {
                    self.first.push(self.target.len() as u32);
                    break;
                }
            } else {
                if !all_marked && self.moves.marked(&states) {
                    self.marked.push(state);
                }
                for (candidate, changes) in candidates.iter() {
                    let controllable = plant.events[candidate.event as usize].controllable;
                    if candidate.forbidden || controllable && scope == Scope::Uncontrollable {
                        continue;
                    }
                    row.copy_from_slice(self.rows.get(state));
                    for &(automaton, next) in changes {
                        self.packing.set(&mut row, automaton, next);
                    }
                    self.event.push(candidate.event);
                    self.target.push(self.rows.intern(&row));
                }
            }
            self.first.push(self.target.len() as u32);
            state += 1;
        }
        self.check(limits)
    }

    fn check(&self, limits: &Limits) -> Result<(), LimitReached> {
        let (what, limit) = if self.rows.len() > limits.states {
            ("states", limits.states)
        } else if self.target.len() > MOST_EDGES {
            ("edges", MOST_EDGES)
        } else if self.memory() > limits.memory {
            ("memory", limits.memory)
        } else {
            return Ok(());
        };
        Err(LimitReached {
            what,
            limit,
            states: self.rows.len(),
            explored: self.first.len() - 1,
            edges: self.target.len(),
            memory: self.memory(),
        })
    }

    /// Bytes in use, with what the fixpoint will need: a source for every edge, four numbers for every state.
    fn memory(&self) -> usize {
        self.rows.memory()
            + (self.target.capacity() + self.event.capacity() + self.target.len()) * size_of::<u32>()
            + (self.first.capacity() + 4 * self.first.len()) * size_of::<u32>()
    }

    /// The positions of a state's edges.
    pub(super) fn edges_of(&self, state: u32) -> std::ops::Range<usize> {
        self.first[state as usize] as usize..self.first[state as usize + 1] as usize
    }

    /// The automata's states.
    pub(super) fn states(&self, state: u32) -> Vec<u16> {
        let mut states = vec![0; self.moves.automata.len()];
        self.packing.unpack(self.rows.get(state), &mut states);
        states
    }
}

/// Whether something forbids an event that happens by itself.
fn cannot_be_prevented(plant: &Plant, candidates: &Candidates) -> bool {
    candidates.all.iter().any(|one| one.forbidden && !plant.events[one.event as usize].controllable)
}

/// A store of rows in which the first is these states of the automata.
fn store(plant: &Plant, moves: &Moves<'_>, start: &[u16]) -> (Packing, Rows<u64>) {
    let packing = Packing::new(moves.automata.iter().map(|&id| plant.automata[id as usize].states.len()));
    let mut row = vec![0; packing.words()];
    packing.pack(start, &mut row);
    let mut rows = Rows::new(packing.words());
    rows.intern(&row);
    (packing, rows)
}

/// Where the automata start.
pub(super) fn initial(plant: &Plant) -> Vec<u16> {
    plant.automata.iter().map(|automaton| automaton.initial as u16).collect()
}

/// How many states and transitions the reachable product of the components has; `None` if this is beyond 64 bits, or beyond
/// 16 million states or the limits in a group of components that share events.
pub(super) fn count(plant: &Plant, limits: &Limits) -> Option<(u64, u64)> {
    let (mut states, mut transitions) = (1_u64, 0_u64);
    for group in groups(plant) {
        let (s, t) = count_group(plant, group, limits)?;
        // A transition of either side happens in every state of the other.
        transitions = transitions.checked_mul(s)?.checked_add(t.checked_mul(states)?)?;
        states = states.checked_mul(s)?;
    }
    Some((states, transitions))
}

/// Components that share events, directly or through others, each group in ascending order.
pub(super) fn groups(plant: &Plant) -> Vec<Vec<AutomatonId>> {
    let mut leader: Vec<usize> = (0..plant.components).collect();
    let mut names: Vec<Option<usize>> = vec![None; plant.events.len()];
    for component in 0..plant.components {
        for &event in &plant.automata[component].alphabet {
            let other = *names[event as usize].get_or_insert(component);
            let (a, b) = (leader[other], leader[component]);
            leader.iter_mut().filter(|leader| **leader == a || **leader == b).for_each(|l| *l = a.min(b));
        }
    }
    let mut groups = vec![Vec::new(); plant.components];
    for (component, &leader) in (0..).zip(&leader) {
        groups[leader].push(component);
    }
    groups.retain(|group| !group.is_empty());
    groups
}

fn count_group(plant: &Plant, group: Vec<AutomatonId>, limits: &Limits) -> Option<(u64, u64)> {
    let start: Vec<u16> = group.iter().map(|&id| plant.automata[id as usize].initial as u16).collect();
    let moves = Moves::new(plant, group);
    let (packing, mut rows) = store(plant, &moves, &start);
    let mut states = start;
    let mut row = vec![0; packing.words()];
    let mut candidates = Candidates::default();
    let (mut state, mut transitions) = (0, 0);
    while (state as usize) < rows.len() {
        if rows.len() > MOST_COUNTED.min(limits.states) || rows.memory() > limits.memory {
            return None;
        }
        packing.unpack(rows.get(state), &mut states);
        moves.collect(&states, &mut candidates);
        for (_, changes) in candidates.iter() {
            row.copy_from_slice(rows.get(state));
            for &(automaton, next) in changes {
                packing.set(&mut row, automaton, next);
            }
            rows.intern(&row);
        }
        transitions += candidates.all.len() as u64;
        state += 1;
    }
    Some((rows.len() as u64, transitions))
}

//! The supremal controllable, nonblocking state feedback.
//!
//! Which states have to go, in rounds. In round 1: the bad ones, and those from which no marked state can be reached; in each
//! later one: those whose ways to marked states lead through what has gone. In every round also those from which an
//! uncontrollable event leads to one that has gone. What is left when a round finds nothing is the largest set that a feedback
//! can keep the plant in (Ramadge and Wonham, "The control of discrete event systems", Proceedings of the IEEE 1989, section
//! V; on states: Wonham, "Notes on control of discrete-event systems", chapter 7).
//!
//! A round is linear in the edges that it looks at, and later rounds look at few: every state knows its next state on some
//! way to a marked one, so only states whose way is cut have to find another.

use super::moves::Candidates;
use super::product::{Product, Scope, count, initial};
use super::refusal::Unavoidable;
use super::{ClosedLoop, Plant};
use crate::diagnostic::{Code, Diagnostic};
use crate::explore::{LimitReached, Limits};

/// Why there is no closed loop.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum SuperviseError {
    /// A limit was reached.
    Limit(LimitReached),
    /// An automaton has more states than the 65,536 that can be numbered.
    TooLarge(Box<Diagnostic>),
    /// No feedback keeps the constraints: from the initial state, this cannot be avoided.
    Refused(Box<Unavoidable>),
}

/// Finds the supremal controllable, nonblocking feedback of a plant.
///
/// # Errors
/// A limit, an automaton that is too large, or no feedback exists.
pub fn supervise(plant: &Plant, limits: &Limits) -> Result<ClosedLoop, SuperviseError> {
    Ok(Synthesis::new(plant, limits)?.closed_loop(limits))
}

/// What was explored for a feedback, and what became of each state: kept by who wants to know [why](Self::why) an event is
/// inhibited.
#[derive(Debug)]
pub struct Synthesis<'p> {
    pub(super) plant: &'p Plant,
    pub(super) product: Product<'p>,
    pub(super) fates: Vec<Fate>,
}

impl<'p> Synthesis<'p> {
    /// Explores, and removes what has to go.
    ///
    /// # Errors
    /// As [`supervise`].
    pub fn new(plant: &'p Plant, limits: &Limits) -> Result<Self, SuperviseError> {
        check_sizes(plant)?;
        let product =
            Product::explore(plant, &initial(plant), Scope::All, limits).map_err(SuperviseError::Limit)?;
        let fates = fates(&product, plant);
        if fates[0].is_gone() {
            return Err(SuperviseError::Refused(Box::new(Unavoidable::find(plant, &product, &fates, 0))));
        }
        Ok(Synthesis { plant, product, fates })
    }

    /// The plant under the feedback; the states of the components alone are counted within the limits.
    #[must_use]
    pub fn closed_loop(&self, limits: &Limits) -> ClosedLoop {
        close(self.plant, &self.product, &self.fates, count(self.plant, limits))
    }
}

/// States are numbered by 16 bits.
fn check_sizes(plant: &Plant) -> Result<(), SuperviseError> {
    const MOST: usize = 1 << u16::BITS;
    match plant.automata.iter().find(|automaton| automaton.states.len() > MOST) {
        None => Ok(()),
        Some(automaton) => Err(SuperviseError::TooLarge(Box::new(
            Diagnostic::error(
                Code::AutomatonTooLarge,
                automaton.span,
                format!("`{}` has {} states", automaton.name, automaton.states.len()),
            )
            .label(format!("an automaton can have {MOST} states"))
            .help("split it into several automata, with the events in which they act together in each"),
        ))),
    }
}

/// What becomes of a state: it stays (0), or it goes in some round (from 1), on its own account or by what follows it.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(super) struct Fate(u32);

impl Fate {
    fn gone(round: u32, by_itself: bool) -> Self {
        Fate(round << 1 | u32::from(by_itself))
    }

    pub(super) fn is_gone(self) -> bool {
        self.0 != 0
    }

    /// In which round it goes; 0 if it stays.
    pub(super) fn round(self) -> u32 {
        self.0 >> 1
    }

    /// Bad, or without a way to a marked state; else an uncontrollable event leads to one that goes in the same round.
    pub(super) fn by_itself(self) -> bool {
        self.0 & 1 == 1
    }
}

/// The fate of every state.
pub(super) fn fates(product: &Product<'_>, plant: &Plant) -> Vec<Fate> {
    let uncontrollable = Backwards::new(product, |edge| !is_controllable(plant, product, edge));
    let controllable = if product.moves.all_marked() {
        // Every state that stays is its own marked state: nobody looks for a way.
        Backwards::none(product)
    } else {
        Backwards::new(product, |edge| is_controllable(plant, product, edge))
    };
    let mut removal = Removal {
        product,
        backwards: [uncontrollable, controllable],
        fates: vec![Fate::default(); product.rows.len()],
        way: vec![NOWHERE; product.rows.len()],
        round: 1,
    };
    removal.find_ways();
    let mut gone: Vec<u32> =
        (0..product.rows.len() as u32).filter(|&state| removal.way[state as usize] == NOWHERE).collect();
    while !gone.is_empty() {
        removal.remove(&mut gone);
        let cut = removal.cut_off(&gone);
        removal.find_other_ways(&cut);
        gone.clear();
        gone.extend(cut.into_iter().filter(|&state| removal.way[state as usize] == NOWHERE));
        removal.round += 1;
    }
    removal.fates
}

fn is_controllable(plant: &Plant, product: &Product<'_>, edge: usize) -> bool {
    plant.events[product.event[edge] as usize].controllable
}

/// Of a state that has no way to a marked one, or none any more.
const NOWHERE: u32 = u32::MAX;

struct Removal<'a> {
    product: &'a Product<'a>,
    /// By uncontrollable edges, by controllable ones.
    backwards: [Backwards; 2],
    fates: Vec<Fate>,
    /// Per state the next one on some way to a marked state, itself if it is marked.
    way: Vec<u32>,
    round: u32,
}

impl Removal<'_> {
    /// Finds ways for all states that have one.
    fn find_ways(&mut self) {
        let mut queue: Vec<u32> = if self.product.moves.all_marked() {
            let mut bad = self.product.bad.iter().peekable();
            let states = 0..self.product.rows.len() as u32;
            states.filter(|state| bad.next_if(|&bad| bad == state).is_none()).collect()
        } else {
            self.product.marked.clone()
        };
        for &state in &queue {
            self.way[state as usize] = state;
        }
        self.spread(&mut queue);
    }

    /// Gives a way to all states before these that have none; afterwards the queue has them all.
    fn spread(&mut self, queue: &mut Vec<u32>) {
        let mut next = 0;
        while let Some(&state) = queue.get(next) {
            next += 1;
            for backwards in &self.backwards {
                for &source in backwards.of(state) {
                    let way = &mut self.way[source as usize];
                    if *way == NOWHERE && !self.fates[source as usize].is_gone() {
                        *way = state;
                        queue.push(source);
                    }
                }
            }
        }
    }

    /// Removes states that go by themselves, and those that they take with them, which are added.
    fn remove(&mut self, gone: &mut Vec<u32>) {
        for &state in &*gone {
            self.fates[state as usize] = Fate::gone(self.round, true);
        }
        let mut next = 0;
        while let Some(&state) = gone.get(next) {
            next += 1;
            for &source in self.backwards[0].of(state) {
                let fate = &mut self.fates[source as usize];
                if !fate.is_gone() {
                    *fate = Fate::gone(self.round, false);
                    gone.push(source);
                }
            }
        }
    }

    /// Takes their ways from the states whose ways lead through what has gone, and returns these states.
    fn cut_off(&mut self, gone: &[u32]) -> Vec<u32> {
        let mut cut = Vec::new();
        for &state in gone {
            self.way[state as usize] = NOWHERE;
            self.cut_before(state, &mut cut);
        }
        let mut next = 0;
        while let Some(&state) = cut.get(next) {
            next += 1;
            self.cut_before(state, &mut cut);
        }
        cut
    }

    fn cut_before(&mut self, state: u32, cut: &mut Vec<u32>) {
        for backwards in &self.backwards {
            for &source in backwards.of(state) {
                let way = &mut self.way[source as usize];
                if *way == state && !self.fates[source as usize].is_gone() {
                    *way = NOWHERE;
                    cut.push(source);
                }
            }
        }
    }

    /// Gives new ways to those of the states that have one.
    fn find_other_ways(&mut self, cut: &[u32]) {
        let mut queue = Vec::new();
        for &state in cut {
            let targets = &self.product.target[self.product.edges_of(state)];
            if let Some(&target) = targets.iter().find(|&&target| self.way[target as usize] != NOWHERE) {
                self.way[state as usize] = target;
                queue.push(state);
            }
        }
        self.spread(&mut queue);
    }
}

/// Some edges of a product, turned around.
struct Backwards {
    first: Vec<u32>,
    source: Vec<u32>,
}

impl Backwards {
    /// The edges that are chosen (a counting sort by target).
    fn new(product: &Product<'_>, chosen: impl Fn(usize) -> bool) -> Self {
        // `first[t + 1]` is where the next edge into `t` goes, and so ends as the start of `t + 1`.
        let mut first = vec![0; product.rows.len() + 2];
        for (edge, &target) in product.target.iter().enumerate() {
            first[target as usize + 2] += u32::from(chosen(edge));
        }
        for state in 2..first.len() {
            first[state] += first[state - 1];
        }
        let mut source = vec![0; first[first.len() - 1] as usize];
        for state in 0..product.rows.len() as u32 {
            for edge in product.edges_of(state).filter(|&edge| chosen(edge)) {
                let next = &mut first[product.target[edge] as usize + 1];
                source[*next as usize] = state;
                *next += 1;
            }
        }
        Backwards { first, source }
    }

    /// No edges.
    fn none(product: &Product<'_>) -> Self {
        Backwards { first: vec![0; product.rows.len() + 1], source: Vec::new() }
    }

    fn of(&self, state: u32) -> &[u32] {
        &self.source[self.first[state as usize] as usize..self.first[state as usize + 1] as usize]
    }
}

/// What can be reached of the states that stay, in order of the automata's states.
fn close(plant: &Plant, product: &Product<'_>, fates: &[Fate], counted: Option<(u64, u64)>) -> ClosedLoop {
    let entries = entries(product, fates);
    let mut number = vec![0; product.rows.len()];
    for (entry, &state) in (0..).zip(&entries) {
        number[state as usize] = entry;
    }
    let automata = plant.automata.len();
    let mut closed = ClosedLoop {
        plant: counted,
        constrained: (product.rows.len() as u64, product.target.len() as u64),
        automata,
        states: Vec::with_capacity(automata * entries.len()),
        initial: number[0],
        first: vec![0],
        edges: Vec::new(),
        first_inhibited: vec![0],
        inhibited: Vec::new(),
    };
    let mut states = vec![0; automata];
    let mut candidates = Candidates::default();
    for &state in &entries {
        product.packing.unpack(product.rows.get(state), &mut states);
        closed.states.extend_from_slice(&states);
        let start = closed.edges.len();
        for edge in product.edges_of(state) {
            let target = product.target[edge] as usize;
            if !fates[target].is_gone() {
                closed.edges.push((product.event[edge], number[target]));
            }
        }
        closed.edges[start..].sort_unstable();
        closed.first.push(closed.edges.len() as u32);
        let enabled = &closed.edges[start..];
        product.moves.collect(&states, &mut candidates);
        let start = closed.inhibited.len();
        let allowed = candidates.all.iter().map(|candidate| candidate.event);
        closed.inhibited.extend(allowed.filter(|&event| {
            plant.events[event as usize].controllable
                && enabled.binary_search_by_key(&event, |edge| edge.0).is_err()
        }));
        closed.inhibited[start..].sort_unstable();
        closed.first_inhibited.push(closed.inhibited.len() as u32);
    }
    closed
}

/// The states that can be reached where only controllable events are inhibited, ordered.
fn entries(product: &Product<'_>, fates: &[Fate]) -> Vec<u32> {
    let mut reached = vec![false; product.rows.len()];
    reached[0] = true;
    let mut entries = vec![0];
    let mut next = 0;
    while let Some(&state) = entries.get(next) {
        next += 1;
        for &target in &product.target[product.edges_of(state)] {
            if !fates[target as usize].is_gone() && !reached[target as usize] {
                reached[target as usize] = true;
                entries.push(target);
            }
        }
    }
    // Rows compare as the states do.
    entries.sort_unstable_by(|&a, &b| product.rows.get(a).cmp(product.rows.get(b)));
    entries
}

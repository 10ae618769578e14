//! Which states can become one.

use super::mealy::{Mealy, NOWHERE, Row};

/// More are not looked for.
const MOST_CLIQUES: usize = 32;
/// Words that it may look at for one choice.
const MOST_COUNTED: usize = 300_000;

/// A symmetric relation over states as a matrix of bits.
#[derive(Debug)]
pub(super) struct Matrix {
    words: usize,
    bits: Vec<u64>,
}

impl Matrix {
    fn new(states: usize) -> Self {
        let words = states.div_ceil(64);
        Matrix { words, bits: vec![0; words * states] }
    }

    pub(super) fn row(&self, state: u32) -> &[u64] {
        &self.bits[state as usize * self.words..][..self.words]
    }

    pub(super) fn contains(&self, a: u32, b: u32) -> bool {
        self.bits[a as usize * self.words + b as usize / 64] >> (b % 64) & 1 == 1
    }

    /// Adds a pair; whether it is new.
    fn insert(&mut self, a: u32, b: u32) -> bool {
        let new = !self.contains(a, b);
        self.bits[a as usize * self.words + b as usize / 64] |= 1 << (b % 64);
        self.bits[b as usize * self.words + a as usize / 64] |= 1 << (a % 64);
        new
    }
}

/// The pairs of states that some sequence of specified events tells apart.
///
/// Found backwards: first the pairs with different answers to one event, then those that an event leads to such a pair.
/// Every pair is met once, with the pairs of predecessors under each event.
pub(super) fn incompatible(mealy: &Mealy) -> Matrix {
    let mut matrix = Matrix::new(mealy.states());
    let mut open = Vec::new();
    // Per event the states with a row: only these can differ in it.
    let mut specified: Vec<Vec<(u32, Row)>> = vec![Vec::new(); mealy.events as usize];
    for state in 0..mealy.states() as u32 {
        for &row in mealy.rows_of(state) {
            specified[row.event as usize].push((state, row));
        }
    }
    for rows in &mut specified {
        rows.sort_unstable_by_key(|(_, row)| row.answer);
        for &(a, row) in rows.iter() {
            let other = rows.partition_point(|(_, other)| other.answer <= row.answer);
            for &(b, _) in &rows[other..] {
                if matrix.insert(a, b) {
                    open.push((a, b));
                }
            }
        }
    }
    let into = Predecessors::new(mealy);
    while let Some((a, b)) = open.pop() {
        let (mut left, mut right) = (into.of(a), into.of(b));
        while let (Some(&(event, _)), Some(&(other, _))) = (left.first(), right.first()) {
            let ends = |edges: &[(u32, u32)], event| edges.partition_point(|edge| edge.0 <= event);
            let (here, there) = (ends(left, event.min(other)), ends(right, event.min(other)));
            for &(_, p) in &left[..here] {
                for &(_, q) in &right[..there] {
                    if matrix.insert(p, q) {
                        open.push((p, q));
                    }
                }
            }
            (left, right) = (&left[here..], &right[there..]);
        }
    }
    matrix
}

/// Per state the events that lead there, and from where.
struct Predecessors {
    first: Vec<u32>,
    /// By state, then by event.
    edges: Vec<(u32, u32)>,
}

impl Predecessors {
    fn new(mealy: &Mealy) -> Self {
        let mut edges: Vec<(u32, (u32, u32))> = Vec::with_capacity(mealy.rows.len());
        for state in 0..mealy.states() as u32 {
            let rows = mealy.rows_of(state).iter().filter(|row| row.next != NOWHERE);
            edges.extend(rows.map(|row| (row.next, (row.event, state))));
        }
        edges.sort_unstable();
        let mut first = vec![0; mealy.states() + 1];
        for (state, _) in &edges {
            first[*state as usize + 1] += 1;
        }
        for i in 1..first.len() {
            first[i] += first[i - 1];
        }
        Predecessors { first, edges: edges.into_iter().map(|(_, edge)| edge).collect() }
    }

    fn of(&self, state: u32) -> &[(u32, u32)] {
        &self.edges[self.first[state as usize] as usize..self.first[state as usize + 1] as usize]
    }
}

/// Sets of states of which any two are incompatible: no machine has fewer states than the largest. Found greedily, from several states on: next comes the
/// candidate with most other candidates that it is incompatible with, as long as that is quickly counted. `effort` multiplies what is quick.
pub(super) fn cliques(matrix: &Matrix, states: usize, effort: usize) -> Vec<Vec<u32>> {
    let degree = |state: u32| matrix.row(state).iter().map(|word| word.count_ones()).sum::<u32>();
    let mut order: Vec<u32> = (0..states as u32).collect();
    order.sort_by_cached_key(|&state| std::cmp::Reverse(degree(state)));
    let mut first: Vec<u32> = Vec::new();
    for &state in &order {
        if first.iter().all(|&other| matrix.contains(state, other)) {
            first.push(state);
        }
    }
    let mut cliques = vec![first];
    let mut work = 0;
    for &start in &order {
        if work > MOST_WORK * effort || cliques.len() == MOST_CLIQUES {
            break;
        }
        let mut candidates = matrix.row(start).to_vec();
        let mut clique = vec![start];
        loop {
            let left: Vec<u32> =
                order.iter().copied().filter(|&s| candidates[s as usize / 64] >> (s % 64) & 1 == 1).collect();
            work += states;
            let shared = |state: u32| {
                candidates.iter().zip(matrix.row(state)).map(|(a, b)| (a & b).count_ones()).sum::<u32>()
            };
            // The first of the order has the highest degree, if counting would take too long.
            let next = if left.len() * matrix.words <= MOST_COUNTED * effort {
                work += left.len() * matrix.words;
                left.iter().copied().min_by_key(|&state| std::cmp::Reverse(shared(state)))
            } else {
                left.first().copied()
            };
            let Some(next) = next else { break };
            clique.push(next);
            candidates.iter_mut().zip(matrix.row(next)).for_each(|(word, other)| *word &= other);
        }
        cliques.push(clique);
    }
    cliques
}

/// Words that the search for a clique may look at, before its last start.
const MOST_WORK: usize = 4_000_000;

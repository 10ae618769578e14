//! Merging in large machines: whole classes at once, without knowing what is incompatible.
//!
//! States are visited breadth first. One that is in no class yet is merged with a class that was visited before, and with
//! it what follows both under the same events, as far as that goes without different answers; otherwise all of it is
//! taken back. Few classes are tried in large machines, so that the time is nearly linear.

use super::mealy::{Mealy, NOWHERE, Row};

/// Classes that are tried for a state of a large machine.
const TRIES: usize = 48;
/// The same for machines of which all pairs can be compared.
const MANY_TRIES: usize = 2048;
/// Merges that one merge may entail.
const MOST_MERGES: usize = 4096;

struct Fold {
    parent: Vec<u32>,
    size: Vec<u32>,
    /// Per root the rows of its class; targets are states of theirs.
    rows: Vec<Vec<Row>>,
    /// Per root whether a state of its class was visited.
    settled: Vec<bool>,
    /// What the merges since the last decision have changed.
    log: Vec<Merge>,
    /// Classes that are tried for a state.
    tries: usize,
}

/// Who became whose child, and what the parent had before.
struct Merge {
    child: u32,
    parent: u32,
    rows: Vec<Row>,
    settled: bool,
}

/// The classes, of reachable states; that of the initial one is the first.
pub(super) fn fold(mealy: &Mealy) -> Vec<Vec<u32>> {
    let states = mealy.states() as u32;
    let mut fold = Fold {
        parent: (0..states).collect(),
        size: vec![1; states as usize],
        rows: (0..states).map(|state| mealy.rows_of(state).to_vec()).collect(),
        settled: vec![false; states as usize],
        log: Vec::new(),
        tries: if mealy.states() > super::MOST_COMPARED { TRIES } else { MANY_TRIES },
    };
    // Per event the classes that were visited and specify it, latest last.
    let mut visited: Vec<Vec<u32>> = vec![Vec::new(); mealy.events as usize];
    let mut met = vec![false; states as usize];
    let mut queue = vec![mealy.initial];
    met[mealy.initial as usize] = true;
    let mut head = 0;
    while let Some(&state) = queue.get(head) {
        head += 1;
        let root = fold.root(state);
        if !fold.settled[root as usize] {
            let candidates = fold.candidates(mealy.rows_of(state), &visited);
            if !candidates.into_iter().any(|class| fold.merge(class, root)) {
                fold.settled[root as usize] = true;
                for row in mealy.rows_of(state) {
                    visited[row.event as usize].push(root);
                }
            }
        }
        for row in mealy.rows_of(state).iter().filter(|row| row.next != NOWHERE) {
            if !std::mem::replace(&mut met[row.next as usize], true) {
                queue.push(row.next);
            }
        }
    }
    let mut class = vec![NOWHERE; states as usize];
    let mut members: Vec<Vec<u32>> = Vec::new();
    for &state in &queue {
        let class = &mut class[fold.root(state) as usize];
        if *class == NOWHERE {
            *class = members.len() as u32;
            members.push(Vec::new());
        }
        members[*class as usize].push(state);
    }
    members
}

impl Fold {
    fn root(&self, mut state: u32) -> u32 {
        while self.parent[state as usize] != state {
            state = self.parent[state as usize];
        }
        state
    }

    /// Classes that specify an event of these rows, those visited last.
    fn candidates(&self, rows: &[Row], visited: &[Vec<u32>]) -> Vec<u32> {
        let latest = |row: &Row| visited[row.event as usize].iter().rev().take(self.tries);
        let mut candidates: Vec<u32> = rows.iter().flat_map(latest).map(|&class| self.root(class)).collect();
        candidates.sort_unstable();
        candidates.dedup();
        candidates.truncate(self.tries);
        candidates
    }

    /// Merges two classes and all that follows from it; whether that is possible. If not, nothing has changed.
    fn merge(&mut self, a: u32, b: u32) -> bool {
        let mut open = vec![(a, b)];
        while let Some((a, b)) = open.pop() {
            let (a, b) = (self.root(a), self.root(b));
            if a == b {
                continue;
            }
            if self.log.len() == MOST_MERGES || !self.unite(a, b, &mut open) {
                self.undo();
                return false;
            }
        }
        self.log.clear();
        true
    }

    fn unite(&mut self, a: u32, b: u32, open: &mut Vec<(u32, u32)>) -> bool {
        let (mut left, mut right) =
            (self.rows[a as usize].iter().peekable(), self.rows[b as usize].iter().peekable());
        let mut rows = Vec::with_capacity(left.len() + right.len());
        loop {
            let row = match (left.peek(), right.peek()) {
                (None, None) => break,
                (Some(l), Some(r)) if l.event == r.event => {
                    if l.answer != r.answer {
                        return false;
                    }
                    if l.next != NOWHERE {
                        open.push((l.next, r.next));
                    }
                    right.next();
                    left.next()
                }
                (Some(l), Some(r)) if l.event < r.event => left.next(),
                (Some(_), None) => left.next(),
                _ => right.next(),
            };
            rows.extend(row);
        }
        let (child, parent) = if self.size[a as usize] < self.size[b as usize] { (a, b) } else { (b, a) };
        self.parent[child as usize] = parent;
        self.size[parent as usize] += self.size[child as usize];
        let rows = std::mem::replace(&mut self.rows[parent as usize], rows);
        self.log.push(Merge { child, parent, rows, settled: self.settled[parent as usize] });
        self.settled[parent as usize] |= self.settled[child as usize];
        true
    }

    fn undo(&mut self) {
        while let Some(Merge { child, parent, rows, settled }) = self.log.pop() {
            self.parent[child as usize] = child;
            self.size[parent as usize] -= self.size[child as usize];
            self.rows[parent as usize] = rows;
            self.settled[parent as usize] = settled;
        }
    }
}

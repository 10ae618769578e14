//! Controller extraction: one command at most for every entry.
//!
//! A feedback permits, a controller has to decide. Two things can go wrong then: commands that follow each other without
//! end (a valve is opened and shut and opened), and decisions that never lead to a marked state although others would.
//!
//! **An end.** Of the enabled commands, the first in order of the file among those with which the fewest commands follow
//! until none is possible and the plant has the turn. If there is no such end, chains are cut where the plant has the turn
//! although commands are possible, and if there is not even that, in marked entries.
//!
//! **Towards a mark.** Every entry has a distance to the marked ones, in events of either side. Where the choice would never
//! lead to a mark, commands that increase the distance count no more, except in marked entries, and the choice is made again.

use super::super::moves::marks;
use super::super::{AutomatonId, ClosedLoop, EventId, Plant};
use std::collections::VecDeque;

/// By entry the command that the controller gives there, if any, and the entry to which it leads.
#[must_use]
pub fn choose(plant: &Plant, closed: &ClosedLoop) -> Vec<Option<(EventId, u32)>> {
    let marked = marked(plant, closed);
    let far = distances(closed, &marked, |_, _| true);
    let mut extraction = Extraction { plant, closed, marked, far, careful: vec![false; closed.len()] };
    loop {
        let chosen = extraction.choose();
        let blocked = extraction.blocked(&chosen);
        if blocked.is_empty() {
            return chosen;
        }
        if blocked.iter().all(|&entry| extraction.careful[entry]) {
            extraction.careful.fill(true);
        }
        for entry in blocked {
            extraction.careful[entry] = true;
        }
    }
}

struct Extraction<'a> {
    plant: &'a Plant,
    closed: &'a ClosedLoop,
    /// Per entry.
    marked: Vec<bool>,
    /// Per entry the distance to the nearest marked one.
    far: Vec<u32>,
    /// Per entry, whether commands that lead away from marked entries do not count.
    careful: Vec<bool>,
}

impl Extraction<'_> {
    fn controllable(&self, event: EventId) -> bool {
        self.plant.events[event as usize].controllable
    }

    fn counts(&self, source: usize, (event, target): (EventId, u32)) -> bool {
        let leads_away = self.far[target as usize] > self.far[source];
        self.controllable(event) && (!self.careful[source] || self.marked[source] || !leads_away)
    }

    /// Whether the plant has the turn.
    fn waits(&self, entry: usize) -> bool {
        self.closed.edges(entry).iter().any(|edge| !self.controllable(edge.0))
    }

    fn has_commands(&self, entry: usize) -> bool {
        self.closed.edges(entry).iter().any(|edge| self.controllable(edge.0))
    }

    /// Whether no way to a mark is lost by waiting: all entries in which chains may be cut are like that.
    fn may_wait(&self, entry: usize) -> bool {
        let nearer = |&(event, target): &(EventId, u32)| {
            !self.controllable(event) && self.far[target as usize] < self.far[entry]
        };
        self.marked[entry] || self.closed.edges(entry).iter().any(nearer)
    }

    /// The choice, with commands that count.
    ///
    /// Every entry comes to an end. One that may not wait has a command that leads nearer, which always counts; such
    /// commands end where one may wait; and who may wait is an end, if not of an earlier kind.
    fn choose(&self) -> Vec<Option<(EventId, u32)>> {
        let ends: [&dyn Fn(usize) -> bool; 3] = [
            &|entry| self.waits(entry) && !self.has_commands(entry),
            &|entry| self.waits(entry) && self.may_wait(entry),
            &|entry| !self.waits(entry) && self.marked[entry],
        ];
        let closed = self.closed;
        let mut chosen = vec![None; closed.len()];
        let mut decided = vec![false; closed.len()];
        for is_end in ends {
            let sources: Vec<bool> =
                (0..closed.len()).map(|entry| !decided[entry] && is_end(entry)).collect();
            let length =
                distances(closed, &sources, |source, edge| !decided[source] && self.counts(source, edge));
            for entry in (0..closed.len()).filter(|&entry| length[entry] != FAR) {
                decided[entry] = true;
                let mut edges = closed.edges(entry).iter().copied();
                chosen[entry] =
                    edges.find(|&edge| self.counts(entry, edge) && length[edge.1 as usize] < length[entry]);
            }
        }
        chosen
    }

    /// The entries from which no mark is reached if commands are always faster than the plant.
    fn blocked(&self, chosen: &[Option<(EventId, u32)>]) -> Vec<usize> {
        let happens = |source: usize, edge: (EventId, u32)| match chosen[source] {
            Some(command) => edge == command,
            None => !self.controllable(edge.0),
        };
        let reached = distances(self.closed, &self.marked, happens);
        (0..reached.len()).filter(|&entry| reached[entry] == FAR).collect()
    }
}

/// By entry, whether all automata are in marked states.
fn marked(plant: &Plant, closed: &ClosedLoop) -> Vec<bool> {
    let marks: Vec<_> = (0..plant.automata.len()).map(|id| marks(plant, id as AutomatonId)).collect();
    (0..closed.len())
        .map(|entry| {
            let mut states = closed.entry(entry).iter().zip(&marks);
            states.all(|(&state, marks)| marks.as_ref().is_none_or(|marks| marks[state as usize]))
        })
        .collect()
}

/// No way leads there.
const FAR: u32 = u32::MAX;

/// By entry, how many of the edges that count lead to the nearest source; [`FAR`] if they lead to none.
fn distances(
    closed: &ClosedLoop,
    sources: &[bool],
    counts: impl Fn(usize, (EventId, u32)) -> bool,
) -> Vec<u32> {
    // `first[t + 1]` is where the next edge into `t` goes, and so ends as the start of `t + 1`.
    let mut first = vec![0_u32; closed.len() + 2];
    let each = |visit: &mut dyn FnMut(usize, u32)| {
        for entry in 0..closed.len() {
            for &edge in closed.edges(entry).iter().filter(|&&edge| counts(entry, edge)) {
                visit(entry, edge.1);
            }
        }
    };
    each(&mut |_, target| first[target as usize + 2] += 1);
    for entry in 2..first.len() {
        first[entry] += first[entry - 1];
    }
    let mut before = vec![0; first[first.len() - 1] as usize];
    each(&mut |source, target| {
        let next = &mut first[target as usize + 1];
        before[*next as usize] = source;
        *next += 1;
    });
    let mut distance: Vec<u32> = sources.iter().map(|&source| if source { 0 } else { FAR }).collect();
    let mut queue: VecDeque<usize> = (0..closed.len()).filter(|&entry| sources[entry]).collect();
    while let Some(entry) = queue.pop_front() {
        for &source in &before[first[entry] as usize..first[entry + 1] as usize] {
            if distance[source] == FAR {
                distance[source] = distance[entry] + 1;
                queue.push_back(source);
            }
        }
    }
    distance
}

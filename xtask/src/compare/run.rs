//! The run of events that every machine is given, and what must come out.

use super::subject::{Row, Subject};

/// Events of a run.
pub(super) const EVENTS: usize = 10_000;

/// Events, and the digest of the answers.
pub(super) struct Run {
    /// Numbers of the events.
    pub(super) events: Vec<u8>,
    pub(super) digest: u32,
    /// Events that were refused.
    pub(super) refused: usize,
    /// Rows that were taken once at least.
    pub(super) taken: usize,
}

impl Run {
    /// Three events of four go to the nearest row that has not been taken, and take it; the fourth is any.
    pub(super) fn new(subject: &Subject) -> Run {
        let mut random = Random(1);
        let mut taken = vec![false; subject.rows.len()];
        let mut run = Run { events: Vec::with_capacity(EVENTS), digest: START, refused: 0, taken: 0 };
        let mut state = 0;
        // Events on the way to the nearest row, the last one first.
        let mut way = Vec::new();
        for _ in 0..EVENTS {
            let event = if random.below(4) > 0 {
                if way.is_empty() {
                    way = way_to_new(subject, state, &taken);
                }
                let rows = subject.rows_of(state);
                way.pop().unwrap_or_else(|| rows[random.below(rows.len() as u32) as usize].event)
            } else {
                way.clear();
                random.below(subject.events.len() as u32)
            };
            run.events.push(event as u8);
            let first = subject.rows.partition_point(|row| row.source < state);
            match subject.rows_of(state).iter().position(|row| row.event == event) {
                Some(row) => {
                    taken[first + row] = true;
                    run.add(1);
                    for code in subject.codes(&subject.rows[first + row]) {
                        run.add_code(code);
                    }
                    state = subject.rows[first + row].target;
                }
                None => {
                    run.add(0);
                    run.refused += 1;
                }
            }
        }
        run.taken = taken.iter().filter(|taken| **taken).count();
        run
    }

    /// As `Option` of a command is hashed.
    fn add_code(&mut self, code: u8) {
        self.add(u32::from(code != 0));
        if code != 0 {
            self.add(code.into());
        }
    }

    /// As in `firmware/player`.
    fn add(&mut self, word: u32) {
        self.digest = (self.digest.rotate_left(5) ^ word).wrapping_mul(0x9E37_79B9);
    }
}

const START: u32 = 1;

/// Events from a state to the nearest row that has not been taken, and that row's; the last one first. None if all have
/// been taken that can be reached.
fn way_to_new(subject: &Subject, from: u32, taken: &[bool]) -> Vec<u32> {
    // The row by which each state is reached.
    let mut reached_by = vec![None; subject.states as usize];
    let mut queue = vec![from];
    let mut at = 0;
    while let Some(&state) = queue.get(at) {
        at += 1;
        let first = subject.rows.partition_point(|row| row.source < state);
        for (number, row) in (first..).zip(subject.rows_of(state)) {
            if !taken[number] {
                let mut way = vec![row.event];
                let mut state = state;
                while let (true, Some(row)) = (state != from, reached_by[state as usize]) {
                    let row: &Row = &subject.rows[row];
                    way.push(row.event);
                    state = row.source;
                }
                return way;
            }
            if row.target != from && reached_by[row.target as usize].is_none() {
                reached_by[row.target as usize] = Some(number);
                queue.push(row.target);
            }
        }
    }
    Vec::new()
}

/// A linear congruence, of which the upper half is used.
struct Random(u32);

impl Random {
    fn below(&mut self, bound: u32) -> u32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        ((self.0 >> 16) * bound) >> 16
    }
}

#[cfg(test)]
mod tests {
    use super::{EVENTS, Run, Subject};

    #[test]
    fn every_row_of_a_small_machine_is_taken() {
        let run = Run::new(&Subject::new(500));
        assert_eq!((run.events.len(), run.taken), (EVENTS, 500));
        assert!(run.refused > EVENTS / 10 && run.refused < EVENTS / 3, "{} refused", run.refused);
    }

    #[test]
    fn another_machine_has_another_digest() {
        let mut subject = Subject::new(50);
        let before = Run::new(&subject).digest;
        for step in &mut subject.steps {
            step.codes[0] ^= 3;
        }
        assert_ne!(Run::new(&subject).digest, before);
    }
}

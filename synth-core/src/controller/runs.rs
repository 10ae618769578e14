//! Tables as runs of consecutive states: what the sources of a mapping function say, in fewer numbers.
//!
//! The published layout lists every source. Where states are numbered well (see [`super::number()`]), the sources of an
//! event are a few runs of consecutive numbers, and the rows of a run follow each other: it suffices to know the first
//! state of each run and the row that it begins with. The states in which super steps are due break into runs wherever the
//! commands change, so that codes are told once a run.

use super::tables::{Mapping, Tables};

/// All mapping functions of a controller in one, those of events first, that of the super steps last.
///
/// To follow mapping `m` from a state: find the last run of `first[m]..first[m + 1]` whose `state` is not above it; its
/// row is `row[run] + state - self.state[run]`, if that is below `row[run + 1]` (otherwise there is none); the state after
/// it is `base[m] + target[row]`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Runs {
    /// Per mapping its first run; one more entry ends the last. Length: events + 2.
    pub first: Vec<u32>,
    /// Per run its first state; ascending within a mapping.
    pub state: Vec<u32>,
    /// Per run its first row; one more entry ends the last.
    pub row: Vec<u32>,
    /// Per mapping its least target, 0 if it is empty. Length: events + 1.
    pub base: Vec<u32>,
    /// Per row its target less the mapping's base.
    pub target: Vec<u32>,
    /// Per component, per run of the super steps, the code that is commanded, 0 for none.
    pub codes: Vec<Vec<u32>>,
}

impl Runs {
    /// Breaks the mappings into as few runs as their states' numbers allow.
    #[must_use]
    pub fn of(tables: &Tables) -> Runs {
        let mut runs = Runs {
            first: Vec::with_capacity(tables.events.len() + 2),
            state: Vec::new(),
            row: Vec::new(),
            base: Vec::with_capacity(tables.events.len() + 1),
            target: Vec::new(),
            codes: Vec::new(),
        };
        for table in &tables.events {
            runs.push(&table.mapping, |_| false);
        }
        let components = &tables.components;
        let changes = |row: usize| components.iter().any(|c| c.codes[row] != c.codes[row - 1]);
        let steps = runs.push(&tables.super_steps, changes);
        runs.codes = components.iter().map(|c| steps.iter().map(|&row| c.codes[row]).collect()).collect();
        runs.first.push(runs.state.len() as u32);
        runs.row.push(runs.target.len() as u32);
        runs
    }

    /// The run with which the super steps begin.
    #[must_use]
    pub fn super_steps(&self) -> u32 {
        self.first[self.base.len() - 1]
    }

    /// The number of runs of a mapping.
    ///
    /// # Panics
    ///
    /// If there is no such mapping.
    #[must_use]
    pub fn count(&self, mapping: usize) -> u32 {
        self.first[mapping + 1] - self.first[mapping]
    }

    /// Adds a mapping, with a new run where its sources leave out a state or `breaks` says so of a row. Returns the rows
    /// of the mapping that begin runs.
    fn push(&mut self, mapping: &Mapping, breaks: impl Fn(usize) -> bool) -> Vec<usize> {
        self.first.push(self.state.len() as u32);
        let before = self.target.len();
        let base = mapping.target.iter().copied().min().unwrap_or(0);
        self.base.push(base);
        let mut begun = Vec::new();
        for (row, (&source, &target)) in mapping.source.iter().zip(&mapping.target).enumerate() {
            if row == 0 || mapping.source[row - 1] + 1 != source || breaks(row) {
                begun.push(row);
                self.state.push(source);
                self.row.push((before + row) as u32);
            }
            self.target.push(target - base);
        }
        begun
    }
}

#[cfg(test)]
mod tests {
    use super::super::fixtures::{controller, controllers};
    use super::super::tables::Provenance;
    use super::super::{Controller, number};
    use super::*;
    use proptest::prelude::*;

    fn tables(controller: &Controller) -> Tables {
        Tables::new("S", controller, Provenance::default())
    }

    #[test]
    fn gaps_and_other_codes_begin_a_run() {
        let lines =
            "0: a 5, b 1 \n 1: a 4 \n 2: b 6 \n 3: a 5 \n 4! arm.go 1 \n 5! arm.go 2 \n 6! press.go 2";
        let runs = Runs::of(&tables(&controller(lines)));
        assert_eq!(runs.first, [0, 2, 4, 6]);
        assert_eq!(runs.state, [0, 3, 0, 2, 4, 6]);
        assert_eq!(runs.row, [0, 2, 3, 4, 5, 7, 8]);
        assert_eq!(runs.base, [4, 1, 1]);
        assert_eq!(runs.target, [1, 0, 1, 0, 5, 0, 1, 1]);
        assert_eq!(runs.codes, [[1, 0], [0, 1]]);
        assert_eq!((runs.super_steps(), runs.count(2)), (4, 2));
    }

    #[test]
    fn nothing_has_no_runs() {
        let runs = Runs::of(&tables(&controller("0: ")));
        assert_eq!((&runs.first[..], &runs.row[..], &runs.base[..]), (&[0, 0][..], &[0][..], &[0][..]));
    }

    /// As the documentation of [`Runs`] says.
    fn follow(runs: &Runs, mapping: usize, state: u32) -> Option<(usize, u32)> {
        let all = runs.first[mapping] as usize..runs.first[mapping + 1] as usize;
        let run = all.rev().find(|&run| runs.state[run] <= state)?;
        let row = runs.row[run] + state - runs.state[run];
        (row < runs.row[run + 1]).then(|| (run, runs.base[mapping] + runs.target[row as usize]))
    }

    proptest! {
        #[test]
        fn they_say_the_same_as_the_tables(controller in controllers(12), numbered in any::<bool>()) {
            let tables = tables(&if numbered { number(controller) } else { controller });
            let runs = Runs::of(&tables);
            let mappings = tables.events.iter().map(|table| &table.mapping).chain([&tables.super_steps]);
            for (index, mapping) in mappings.enumerate() {
                for state in 0..tables.states {
                    let row = mapping.source.binary_search(&state).ok();
                    let found = follow(&runs, index, state);
                    prop_assert_eq!(found.map(|(_, target)| target), row.map(|row| mapping.target[row]));
                    if let (Some((run, _)), Some(row), true) = (found, row, index == tables.events.len()) {
                        for (component, codes) in tables.components.iter().zip(&runs.codes) {
                            prop_assert_eq!(codes[run - runs.super_steps() as usize], component.codes[row]);
                        }
                    }
                }
            }
        }
    }
}

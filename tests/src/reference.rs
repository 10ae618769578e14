//! The three ways to step a controller, as the contract writes them: no search, no bits, no cleverness.

use std::collections::BTreeSet;

use synth_core::controller::tables::{Mapping, Tables};

/// One command code per component, 0 for none.
pub type Codes = Vec<u32>;

/// A transition: the event, or none for a super step, the source and the target.
pub type Transition = (Option<usize>, u32, u32);

/// A controller at work.
#[derive(Debug)]
pub struct Reference<'a> {
    tables: &'a Tables,
    /// The state.
    pub state: u32,
    /// Pending events, as positions in table order.
    pub pending: BTreeSet<usize>,
    /// Every transition so far.
    pub log: Vec<Transition>,
}

impl<'a> Reference<'a> {
    /// In the initial state.
    #[must_use]
    pub fn new(tables: &'a Tables) -> Self {
        Reference { tables, state: tables.initial, pending: BTreeSet::new(), log: Vec::new() }
    }

    /// What it runs.
    #[must_use]
    pub fn tables(&self) -> &'a Tables {
        self.tables
    }

    /// `false` if the event is pending already.
    pub fn raise(&mut self, event: usize) -> bool {
        self.pending.insert(event)
    }

    /// One cycle.
    pub fn cycle(&mut self) -> Codes {
        self.consume();
        match self.due() {
            Some(row) => self.step(row),
            None => vec![0; self.tables.components.len()],
        }
    }

    /// Cycles until nothing is due or a component would get a second command.
    pub fn drain(&mut self) -> Codes {
        let mut all = vec![0; self.tables.components.len()];
        loop {
            self.consume();
            let Some(row) = self.due() else { return all };
            if self.tables.components.iter().zip(&all).any(|(c, &code)| code != 0 && c.codes[row] != 0) {
                return all;
            }
            for (code, new) in all.iter_mut().zip(self.step(row)) {
                *code = (*code).max(new);
            }
        }
    }

    /// One event with its super step, or `None`.
    pub fn react(&mut self, event: usize) -> Option<Codes> {
        let target = self.accepts(event)?;
        self.enter(Some(event), target);
        Some(match self.due() {
            Some(row) => self.step(row),
            None => vec![0; self.tables.components.len()],
        })
    }

    /// Where an event leads, if it fits.
    #[must_use]
    pub fn accepts(&self, event: usize) -> Option<u32> {
        let mapping = &self.tables.events[event].mapping;
        row(mapping, self.state).map(|row| mapping.target[row])
    }

    fn consume(&mut self) {
        let mut changed = true;
        while changed {
            changed = false;
            for event in 0..self.tables.events.len() {
                if !self.pending.contains(&event) {
                    continue;
                }
                if let Some(target) = self.accepts(event) {
                    self.enter(Some(event), target);
                    self.pending.remove(&event);
                    changed = true;
                }
            }
        }
    }

    fn due(&self) -> Option<usize> {
        row(&self.tables.super_steps, self.state)
    }

    fn step(&mut self, row: usize) -> Codes {
        self.enter(None, self.tables.super_steps.target[row]);
        self.tables.components.iter().map(|component| component.codes[row]).collect()
    }

    fn enter(&mut self, event: Option<usize>, target: u32) {
        self.log.push((event, self.state, target));
        self.state = target;
    }
}

fn row(mapping: &Mapping, state: u32) -> Option<usize> {
    mapping.source.iter().position(|&source| source == state)
}

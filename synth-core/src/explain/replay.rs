//! A counter-play, played out once more: what it violates or starves, and what stands in the way.

use super::Blocked;
use crate::model::{Kind, Spec};
use crate::pipeline::Solved;
use crate::playout::{Config, Key, KeyId, Playout, Semantics, Step};
use std::collections::BTreeSet;

/// What a replay shows.
pub(super) struct Findings {
    /// Indices of those that are violated or starve, then of those that block; with duplicates.
    pub(super) scenarios: Vec<usize>,
    pub(super) starved: Option<Key>,
    /// Throughout the loop each event that would meet what starves is blocked.
    pub(super) always_blocked: bool,
    pub(super) blocked: BTreeSet<Blocked>,
}

/// Follows a play once more, in a play-out of its own.
pub(super) struct Replay<'s> {
    pub(super) playout: Playout<'s>,
    pub(super) config: Config,
    pub(super) step: Step,
}

impl<'s> Replay<'s> {
    /// Nothing of this fails where the specification has been explored before, and neither does [`Replay::follow`] with a
    /// play from there.
    pub(super) fn new(spec: &'s Spec, semantics: Semantics) -> Option<Self> {
        let mut playout = Playout::new(spec, semantics).ok()?;
        let config = playout.initial().ok()?;
        Some(Replay { playout, config, step: Step::default() })
    }

    /// In the specification that was solved.
    pub(super) fn of(solved: &Solved<'s>) -> Option<Self> {
        let explored = &solved.explored.playout;
        Self::new(explored.spec(), explored.semantics())
    }

    /// Takes a step; `None` if it violates an assumption. Whose turn it is, is not looked at: that takes a step for every
    /// event that could happen, and the play is known to be one of the specification, as far as assumptions let it.
    pub(super) fn follow(&mut self, text: &str) -> Option<()> {
        let Replay { playout, config, step } = self;
        if text == "yield" {
            config.yielded = true;
            return Some(());
        }
        let event = playout.find_event(text).or_else(|| {
            // Events of the system are known once somebody wants them.
            playout.wanted(config);
            playout.find_event(text)
        })?;
        playout.step(config, event, step);
        if step.error.is_some() || step.violates(playout.spec(), Kind::Assumption) {
            return None;
        }
        std::mem::swap(config, &mut step.config);
        Some(())
    }

    /// The environment's last event violates guarantees.
    pub(super) fn violation(&mut self, last: &str) -> Findings {
        let spec = self.playout.spec();
        let mut scenarios = Vec::new();
        if let Some(event) = self.playout.find_event(last) {
            self.playout.step(&self.config, event, &mut self.step);
            scenarios.append(&mut self.step.violated);
        }
        scenarios.retain(|&scenario| spec.scenarios[scenario].kind == Kind::Guarantee);
        let mut blocked = BTreeSet::new();
        let violated = scenarios.clone();
        for key in self.open() {
            if violated.contains(&self.playout.key(key).scenario) {
                self.is_blocked(key, &mut scenarios, &mut blocked);
            }
        }
        Findings { scenarios, starved: None, always_blocked: false, blocked }
    }

    /// An obligation is never met in the loop.
    pub(super) fn starvation(&mut self, key: &Key, cycle: &[String]) -> Option<Findings> {
        let mut scenarios = vec![key.scenario];
        let mut blocked = BTreeSet::new();
        let mut always_blocked = true;
        for event in cycle.iter().map(Some).chain([None]) {
            let open = self.open();
            let starved = open.iter().find(|&&open| self.playout.key(open) == key);
            let is_blocked = starved.is_some_and(|&key| self.is_blocked(key, &mut scenarios, &mut blocked));
            always_blocked &= is_blocked;
            if let Some(event) = event {
                self.follow(event)?;
            }
        }
        Some(Findings { scenarios, starved: Some(key.clone()), always_blocked, blocked })
    }

    /// The system never lets the environment have its turn.
    pub(super) fn endless(&mut self, cycle: &[String]) -> Option<Findings> {
        let mut scenarios = Vec::new();
        for event in cycle {
            let open = self.open();
            scenarios.extend(self.guarantees_of(&open));
            self.follow(event)?;
        }
        scenarios.sort_unstable();
        Some(Findings { scenarios, starved: None, always_blocked: false, blocked: BTreeSet::new() })
    }

    pub(super) fn open(&self) -> Vec<KeyId> {
        let mut open = Vec::new();
        self.playout.open_keys(&self.config, &mut open);
        open
    }

    /// The guarantees that keys belong to.
    fn guarantees_of(&self, keys: &[KeyId]) -> Vec<usize> {
        let spec = self.playout.spec();
        let scenarios = keys.iter().map(|&key| self.playout.key(key).scenario);
        scenarios.filter(|&scenario| spec.scenarios[scenario].kind == Kind::Guarantee).collect()
    }

    /// Whether the system would have to send something to meet the obligation, and cannot. Notes what stands in the
    /// way of single events also where another one is free.
    fn is_blocked(
        &mut self,
        key: KeyId,
        scenarios: &mut Vec<usize>,
        blocked: &mut BTreeSet<Blocked>,
    ) -> bool {
        let spec = self.playout.spec();
        let attempts = self.playout.attempts(&self.config, key);
        for attempt in attempts.iter().filter(|attempt| attempt.is_blocked()) {
            let by = attempt.forbidden_by.iter().map(|&scenario| spec.scenarios[scenario].name.clone());
            let event = self.playout.event(attempt.event).text.clone();
            blocked.insert(Blocked { event, by: by.collect() });
            scenarios.extend_from_slice(&attempt.forbidden_by);
        }
        !attempts.is_empty() && attempts.iter().all(crate::playout::Attempt::is_blocked)
    }
}

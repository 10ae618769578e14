//! Relaxed scenarios: what a specification would be with some of its scenarios softened (language reference,
//! "Relaxing").
//!
//! To relax is not to delete. The copies of a relaxed scenario are followed, and its messages stay candidates and cause
//! what they cause; only what it *demands* is gone: its violations and its keys do not count. What a relaxed guarantee
//! alone asks for, and what would not be executable if nothing were relaxed, is a further choice that decides no turn.
//!
//! So the system gains by each further guarantee that is relaxed: all its moves stay, and where it was forced it may
//! yield. And nothing that is remembered depends on what is relaxed: one play-out serves any number of explorations.

use super::{KeyId, Playout, Step};
use crate::model::Kind;

impl Playout<'_> {
    /// From now on exactly these scenarios are relaxed, given as indices. What was interned and remembered stays.
    pub fn relax(&mut self, scenarios: impl IntoIterator<Item = usize>) {
        self.relaxed.clear();
        for scenario in scenarios.into_iter().filter(|&scenario| scenario < self.spec.scenarios.len()) {
            self.relaxed.grow_and_insert(scenario);
        }
    }

    /// Whether the scenario with this index is relaxed.
    #[must_use]
    pub fn is_relaxed(&self, scenario: usize) -> bool {
        self.relaxed.contains(scenario)
    }

    /// Drops the keys of relaxed scenarios.
    pub(crate) fn retain_counted(&self, keys: &mut Vec<KeyId>) {
        if !self.relaxed.is_clear() {
            keys.retain(|&key| !self.relaxed.contains(self.keys.get(key).scenario));
        }
    }

    /// Sorts out what does not count of a step.
    pub(super) fn excuse(&self, step: &mut Step) {
        step.excused.clear();
        if !self.relaxed.is_clear() {
            step.excused.extend(step.violated.iter().filter(|&&scenario| self.relaxed.contains(scenario)));
            step.violated.retain(|&scenario| !self.relaxed.contains(scenario));
            self.retain_counted(&mut step.discharged);
        }
    }

    /// Whether a step of the system, or of the environment, is executable only because something is relaxed.
    pub(super) fn is_freed(&self, step: &Step, by_system: bool) -> bool {
        step.excused.iter().any(|&scenario| match self.spec.scenarios[scenario].kind {
            Kind::Assumption => !by_system || !self.semantics.classic,
            Kind::Guarantee => by_system,
            Kind::Existential => false,
        })
    }
}

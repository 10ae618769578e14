//! What stands in the way of an obligation of the system.

use super::events::EventId;
use super::keys::KeyId;
use super::{Config, Playout, Step};
use crate::model::Kind;

/// One event by which the system could meet an obligation, executable or not.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Attempt {
    /// The event.
    pub event: EventId,
    /// Scenarios that forbid it: it is not executable, since its step violates them. Ascending.
    pub forbidden_by: Vec<usize>,
    /// Its channel has no link, so it cannot happen either.
    pub unlinked: bool,
}

impl Attempt {
    /// Whether the event is not executable.
    #[must_use]
    pub fn is_blocked(&self) -> bool {
        self.unlinked || !self.forbidden_by.is_empty()
    }
}

impl Playout<'_> {
    /// The events by which the system could discharge `key` in `config`, if whose turn it is did not matter. None if
    /// the key is not open there or waits for something else than an event of the system.
    pub fn attempts(&mut self, config: &Config, key: KeyId) -> Vec<Attempt> {
        let mut wanted: Vec<EventId> = Vec::new();
        for &copy in &config.copies {
            if self.copies.get(copy).obligations.iter().any(|&(_, open)| open == key) {
                let valuation = (config.valuation, self.valuations.get(config.valuation));
                let offers = self.offers.of(self.spec, &mut self.events, &self.copies, copy, valuation);
                let system = &offers.system;
                wanted.extend(system.iter().filter_map(|(_, event)| event.as_ref().ok()));
            }
        }
        wanted.sort_unstable();
        wanted.dedup();
        let mut step = Step::default();
        let mut attempts = Vec::new();
        for event in wanted {
            self.step(config, event, &mut step);
            if step.discharged.binary_search(&key).is_ok() {
                let counts = |kind| kind == Kind::Guarantee || !self.semantics.classic;
                let kind_of = |scenario: usize| self.spec.scenarios[scenario].kind;
                step.violated.retain(|&scenario| counts(kind_of(scenario)));
                let forbidden_by = std::mem::take(&mut step.violated);
                attempts.push(Attempt { event, forbidden_by, unlinked: !self.is_linked(config, event) });
            }
        }
        attempts
    }
}

//! Events that guarantees ask for, or the environment could send, and that may not happen.

use super::events::EventId;
use super::turn::Urgency;
use super::{Config, Playout, Step};
use crate::game::Turn;
use crate::model::OperationId;

/// An event that is asked for, or could come, when the turn is decided, and violates something.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Transgression {
    /// The event.
    pub event: EventId,
    /// The scenarios that it violates, as indices, ascending; not empty.
    pub violated: Vec<usize>,
}

impl Playout<'_> {
    /// The events that guarantees ask for in `config`, as urgently as the turn there or more so, and that violate
    /// something. `turn` is the turn there; events for which `is_fine` holds are known to violate nothing.
    pub fn transgressions(
        &mut self,
        config: &Config,
        turn: Turn,
        is_fine: impl Fn(EventId) -> bool,
        found: &mut Vec<Transgression>,
    ) {
        let decided_by = match turn {
            Turn::SystemCommitted | Turn::EnvironmentCommitted => Urgency::Committed,
            Turn::SystemUrgent | Turn::EnvironmentUrgent => Urgency::Urgent,
            _ if config.yielded => Urgency::Urgent,
            _ => Urgency::Eventually,
        };
        let wishes = self.wishes(config).system;
        let mut asked: Vec<EventId> = wishes
            .into_iter()
            .filter(|&(urgency, event)| urgency <= decided_by && !is_fine(event))
            .map(|(_, event)| event)
            .collect();
        asked.sort_unstable();
        asked.dedup();
        let mut step = Step::default();
        for event in asked {
            if !self.is_linked(config, event) {
                continue;
            }
            self.step(config, event, &mut step);
            if !step.violated.is_empty() && step.error.is_none() {
                found.push(Transgression { event, violated: std::mem::take(&mut step.violated) });
            }
        }
    }

    /// The spontaneous events of one operation, ascending.
    pub fn spontaneous(&self, operation: OperationId) -> impl Iterator<Item = EventId> {
        self.events.universe().filter(move |&event| {
            let event = self.events.get(event);
            event.spontaneous && event.operation == operation
        })
    }

    /// Those of `events` that the environment does not send in `config` since they violate something. They are its
    /// candidates; events for which `is_fine` holds are known to violate nothing.
    pub fn excluded(
        &mut self,
        config: &Config,
        events: &[EventId],
        is_fine: impl Fn(EventId) -> bool,
        found: &mut Vec<Transgression>,
    ) {
        let mut step = Step::default();
        for &event in events {
            if is_fine(event) || !self.is_linked(config, event) {
                continue;
            }
            self.step(config, event, &mut step);
            if !step.violated.is_empty() && step.error.is_none() {
                found.push(Transgression { event, violated: std::mem::take(&mut step.violated) });
            }
        }
    }
}

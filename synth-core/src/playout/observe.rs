//! Single results together with what they were read from: [`crate::successors`] remembers each for all states that look the
//! same to whoever computed it.

use super::copies::CopyId;
use super::events::EventId;
use super::offers::{self, Offers};
use super::pattern::Matcher;
use super::react::{self, Occasion, Outcome};
use super::step::{apply_effects, has_effects};
use super::{Playout, ValuationId};
use crate::model::{Moment, Reads, SlotId, Snapshot, Value};

/// The attributes before an event and after its effects.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sight<'a> {
    pub(crate) before: &'a [Value],
    pub(crate) after: &'a [Value],
}

impl Playout<'_> {
    /// Whether some scenario mentions this event of the environment.
    pub(crate) fn is_foreseen(&self, event: EventId) -> bool {
        self.events.universe().contains(&event)
    }

    /// Whether a channel is required for the event.
    pub(crate) fn needs_link(&self, event: EventId) -> bool {
        self.events.get(event).links.is_some()
    }

    /// Whether the event assigns anything.
    pub(crate) fn assigns(&self, event: EventId) -> bool {
        has_effects(self.spec, self.events.get(event))
    }

    /// Whether the scenario of a copy has a message or a constraint of the event's operation, sender and receiver. If it has
    /// none, the copy stays where it is but for what settles, and all such events do the same to it.
    pub(crate) fn concerns(&self, event: EventId, copy: CopyId) -> bool {
        let copy = self.copies.get(copy);
        let scenario = &self.spec.scenarios[copy.scenario];
        let reads = Reads::default();
        let matcher = Matcher {
            spec: self.spec,
            event: self.events.get(event),
            attributes: Snapshot { values: &[], moment: Moment::Before, reads: &reads },
            scenario,
            roles: &copy.roles,
            variables: &copy.variables,
        };
        let constraints = scenario.constraints().map(|constraint| &constraint.message);
        scenario.messages().chain(constraints).any(|message| matcher.ends(message))
    }

    /// Runs the effects of an event and appends the slots that they assign; whether there was no mistake.
    pub(crate) fn observe_effects(
        &self,
        event: EventId,
        values: &mut [Value],
        assigned: &mut Vec<SlotId>,
        reads: &Reads,
    ) -> bool {
        apply_effects(self.spec, self.events.get(event), values, reads, assigned).is_none()
    }

    /// What becomes of a copy.
    pub(crate) fn observe_reaction(
        &mut self,
        copy: CopyId,
        event: EventId,
        sight: Sight<'_>,
        reads: &Reads,
    ) -> Outcome {
        let Playout { spec, followed, ref events, ref mut copies, ref mut keys, .. } = *self;
        let Sight { before, after } = sight;
        let valuation = ValuationId::MAX;
        let occasion =
            Occasion { spec, followed, id: event, event: events.get(event), valuation, before, after };
        react::reaction(copies, keys, copy, &occasion, reads)
    }

    /// Which copies the event starts.
    pub(crate) fn observe_starts(&mut self, event: EventId, sight: Sight<'_>, reads: &Reads) -> Outcome {
        let Playout { spec, followed, ref events, ref mut copies, ref mut keys, .. } = *self;
        let Sight { before, after } = sight;
        let valuation = ValuationId::MAX;
        let occasion =
            Occasion { spec, followed, id: event, event: events.get(event), valuation, before, after };
        react::starts(copies, keys, &occasion, reads)
    }

    /// What a copy asks for.
    pub(crate) fn observe_offers(&mut self, copy: CopyId, values: &[Value], reads: &Reads) -> Offers {
        let Playout { spec, ref mut events, ref copies, .. } = *self;
        offers::collect(spec, events, copies, copy, Snapshot { values, moment: Moment::Before, reads })
    }

    /// Whether the sender knows the receiver, where a channel is required.
    pub(crate) fn observe_link(&self, event: EventId, values: &[Value], reads: &Reads) -> bool {
        let event = self.events.get(event);
        let attributes = Snapshot { values, moment: Moment::Before, reads };
        event.links.as_ref().is_none_or(|links| {
            links.iter().any(|&slot| attributes.read(&self.spec.domain, slot) == event.receiver as Value)
        })
    }
}

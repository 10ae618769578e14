//! Why an event can or cannot happen: who wants it, who waits for it, and what it would violate.
//!
//! For people: nothing here is remembered beyond what a step remembers, so it is not for every state of a large
//! game.

use super::copies::CopyId;
use super::events::EventId;
use super::pattern::Matcher;
use super::{Config, Playout};
use crate::game::Turn;
use crate::model::{Kind, NodeKind};
use crate::syntax::Span;
use std::cell::Cell;

/// What makes a step violate a scenario, with its place.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Ground {
    /// This `forbidden` message is in force.
    Forbidden(Span),
    /// The event is another message of the scenario, and this `strict` message or `wait` stands at the cut.
    OutOfOrder(Span),
    /// The condition of this `violation` comes true.
    Condition(Span),
}

impl Ground {
    /// The constraint, or the fragment.
    #[must_use]
    pub fn span(self) -> Span {
        match self {
            Ground::Forbidden(span) | Ground::OutOfOrder(span) | Ground::Condition(span) => span,
        }
    }

    /// What to say of the place.
    #[must_use]
    pub fn describe(self) -> &'static str {
        match self {
            Ground::Forbidden(_) => "forbidden here",
            Ground::OutOfOrder(_) => "this is due first",
            Ground::Condition(_) => "this comes true",
        }
    }
}

/// A scenario that is violated.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Breach {
    pub(super) scenario: usize,
    pub(super) ground: Ground,
}

/// A copy that an event would violate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Objection {
    /// The copy; `None` for one that the event itself starts.
    pub copy: Option<CopyId>,
    /// Index of its scenario.
    pub scenario: usize,
    /// How.
    pub ground: Ground,
}

/// A message at the cut of a copy that an event is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Stake {
    /// The copy.
    pub copy: CopyId,
    /// The fragment.
    pub span: Span,
}

/// What the active copies have to do with an event. Existential scenarios have no say.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Reasons {
    /// Copies that cause the event: a guarantee asks the system for it, or an assumption says that the environment
    /// sends it.
    pub wanted_by: Vec<Stake>,
    /// Copies that move on when it happens, and do not cause it.
    pub awaited_by: Vec<Stake>,
    /// Copies that it would violate, by scenario; of both kinds.
    pub objections: Vec<Objection>,
    /// The copies that it would start and that would then wait.
    pub starts: Vec<CopyId>,
    /// Its channel has no link, so it cannot happen.
    pub unlinked: bool,
}

impl Playout<'_> {
    /// What the active copies of `config` have to do with `event`, whether or not it can happen there.
    pub fn reasons(&mut self, config: &Config, event: EventId) -> Reasons {
        let (objections, starts) = self.breaches(config, event);
        let unlinked = !self.is_linked(config, event);
        let mut reasons = Reasons { objections, starts, unlinked, ..Reasons::default() };
        for id in self.in_text_order(&config.copies) {
            self.stakes(config, event, id, &mut reasons);
        }
        reasons
    }

    /// The objections for which the event is not executable: those of its own side, and of assumptions.
    pub fn refusals<'r>(&self, event: EventId, reasons: &'r Reasons) -> impl Iterator<Item = &'r Objection> {
        let controllable = self.events.get(event).controllable;
        let classic = self.semantics.classic;
        let spec = self.spec;
        reasons.objections.iter().filter(move |objection| match spec.scenarios[objection.scenario].kind {
            Kind::Assumption => !controllable || !classic,
            Kind::Guarantee => controllable,
            Kind::Existential => false,
        })
    }

    fn stakes(&self, config: &Config, event: EventId, id: CopyId, reasons: &mut Reasons) {
        let copy = self.copies.get(id);
        let scenario = &self.spec.scenarios[copy.scenario];
        let event = self.events.get(event);
        let matcher = Matcher {
            spec: self.spec,
            event,
            attributes: self.valuations.get(config.valuation),
            scenario,
            roles: &copy.roles,
            variables: &copy.variables,
            reads_state: &Cell::new(false),
        };
        for &node in &copy.cut {
            let node = &scenario.nodes[usize::from(node)];
            let NodeKind::Message { monitored, modality, message, .. } = &node.kind else { continue };
            if !matcher.is_message(message).unwrap_or(false) {
                continue;
            }
            let causes = match scenario.kind {
                Kind::Assumption => modality.is_some(),
                Kind::Guarantee => modality.is_some() && !monitored && event.controllable,
                Kind::Existential => continue,
            };
            let list = if causes { &mut reasons.wanted_by } else { &mut reasons.awaited_by };
            list.push(Stake { copy: id, span: node.span });
        }
    }
}

/// Why somebody has the turn (language reference, section 4), in a state in which the system has `yielded` or not.
#[must_use]
pub fn turn_reason(turn: Turn, yielded: bool) -> &'static str {
    match turn {
        Turn::SystemCommitted => "a `committed` message of the system can be sent",
        Turn::EnvironmentCommitted => "an assumption says that a `committed` message comes now",
        Turn::SystemUrgent => "an `urgent` or `requested` message of the system can be sent",
        Turn::EnvironmentUrgent => "an assumption says that an `urgent` or `requested` message comes now",
        Turn::SystemEventually => "an `eventually` message of the system can be sent, or the system yields",
        Turn::EnvironmentAny if yielded => "the system has yielded",
        Turn::EnvironmentAny => "the system has nothing to send",
        Turn::Lost => "the environment has violated a guarantee",
        Turn::Won => "the system has violated an assumption",
    }
}

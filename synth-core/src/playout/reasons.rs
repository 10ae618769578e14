//! Why an event can or cannot happen: who wants it, who waits for it, and what it would violate.
//!
//! For people: nothing here is remembered beyond what a step remembers, so it is not for every state of a large
//! game.

use super::copies::CopyId;
use super::events::EventId;
use super::pattern::Matcher;
use super::{Config, Playout};
use crate::game::Turn;
use crate::model::{Kind, Moment, NodeKind, Reads, Snapshot};
use crate::syntax::Span;

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
pub(crate) struct Breach {
    pub(crate) scenario: usize,
    pub(crate) ground: Ground,
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
            attributes: Snapshot {
                values: self.valuations.get(config.valuation),
                moment: Moment::Before,
                reads: &Reads::default(),
            },
            scenario,
            roles: &copy.roles,
            variables: &copy.variables,
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::playout::{Moves, Semantics};
    use crate::testing::spec;

    const WORLD: &str = "specification World {
  domain d {
    class User { }
    class Control { on: bool  press() release() }
    class Lamp { on() off() set(n: 0..=1) }
  }
  object user: User  object control: Control  object lamp: Lamp
  controllable { Control }
  effects { user -> control.press() { control.on = true } }
  collaboration C {
BODY
  }
}";

    /// What an event has to do with the scenarios, in the state after a play: one line each, with the source text of
    /// the place.
    #[track_caller]
    fn check(body: &str, play: &[&str], event: &str, expect: &str) {
        let spec = spec(&WORLD.replace("BODY", body));
        let mut playout = Playout::new(&spec, Semantics::default()).expect("a play-out");
        let mut config = playout.initial().expect("an initial state");
        let mut moves = Moves::default();
        for text in play {
            playout.moves(&config, &mut moves).expect("moves");
            let is_it = |event: Option<EventId>| event.is_some_and(|id| playout.event(id).text == *text);
            let found = moves.moves.iter().find(|one| is_it(one.event));
            config = found.unwrap_or_else(|| panic!("`{text}` cannot happen")).config.clone();
        }
        playout.wanted(&config);
        let event = playout.find_event(event).expect("an event");
        let reasons = playout.reasons(&config, event);
        let source = |span: Span| {
            let line = body.lines().nth(span.start.line as usize - 11).expect("a line of the body");
            let (start, end) = (span.start.column as usize - 1, span.end.column as usize - 1);
            line.chars().take(end).skip(start).collect::<String>()
        };
        let mut lines = Vec::new();
        for (what, stakes) in [("wanted", &reasons.wanted_by), ("awaited", &reasons.awaited_by)] {
            let line = |stake: &Stake| {
                format!("{what} by {}: {}", playout.copy_name(stake.copy), source(stake.span))
            };
            lines.extend(stakes.iter().map(line));
        }
        lines.extend(reasons.starts.iter().map(|&copy| format!("starts {}", playout.copy_name(copy))));
        for objection in &reasons.objections {
            let refuses = playout.refusals(event, &reasons).any(|one| one == objection);
            let (ground, name) = (objection.ground, &spec.scenarios[objection.scenario].name);
            let verb = if refuses { "refused" } else { "violates" };
            lines.push(format!("{verb} {name}, {}: {}", ground.describe(), source(ground.span())));
        }
        assert_eq!(lines.join("\n"), expect);
    }

    #[test]
    fn a_modality_wants_and_its_absence_waits() {
        check(
            "guarantee scenario G { user -> control.press() urgent control -> lamp.on() }\n\
             guarantee scenario H { user -> control.press() control -> lamp.on() control -> lamp.off() }\n\
             guarantee scenario M { user -> control.press() monitored urgent control -> lamp.on() }",
            &["user -> control.press()"],
            "control -> lamp.on()",
            "wanted by C.G: urgent control -> lamp.on()\n\
             awaited by C.H: control -> lamp.on()\n\
             awaited by C.M: monitored urgent control -> lamp.on()",
        );
    }

    #[test]
    fn an_assumption_causes_also_what_is_monitored() {
        check(
            "guarantee scenario G { user -> control.press() eventually user -> control.release() }\n\
             assumption scenario A { user -> control.press() monitored eventually user -> control.release() }",
            &["user -> control.press()"],
            "user -> control.release()",
            "wanted by C.A: monitored eventually user -> control.release()\n\
             awaited by C.G: eventually user -> control.release()",
        );
    }

    #[test]
    fn a_forbidden_message_refuses() {
        check(
            "guarantee scenario G { user -> control.press() urgent control -> lamp.set(1) }\n\
             guarantee scenario F { user -> control.press() user -> control.release() } constraints [ forbidden control -> lamp.set(*) ]",
            &["user -> control.press()"],
            "control -> lamp.set(1)",
            "wanted by C.G: urgent control -> lamp.set(1)\n\
             refused C.F, forbidden here: control -> lamp.set(*)",
        );
    }

    #[test]
    fn a_strict_message_is_due_first() {
        check(
            "guarantee scenario G { user -> control.press() urgent control -> lamp.off() }\n\
             assumption scenario A { user -> control.press() strict control -> lamp.on() control -> lamp.off() }",
            &["user -> control.press()"],
            "control -> lamp.off()",
            "wanted by C.G: urgent control -> lamp.off()\n\
             refused C.A, this is due first: strict control -> lamp.on()",
        );
    }

    #[test]
    fn a_condition_comes_true_in_a_copy_that_the_event_starts() {
        check(
            "guarantee scenario G { user -> control.press() violation [control.on] }",
            &[],
            "user -> control.press()",
            "violates C.G, this comes true: violation [control.on]",
        );
    }

    #[test]
    fn a_copy_that_waits_is_started() {
        check(
            "guarantee scenario G { user -> control.press() user -> control.release() }\n\
             guarantee scenario Over { user -> control.press() wait [control.on] }",
            &[],
            "user -> control.press()",
            "starts C.G",
        );
    }

    #[test]
    fn the_environment_may_violate_a_guarantee() {
        check(
            "guarantee scenario G { user -> control.press() strict user -> control.release() }",
            &["user -> control.press()"],
            "user -> control.press()",
            "starts C.G\nviolates C.G, this is due first: strict user -> control.release()",
        );
    }
}

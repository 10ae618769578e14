//! Play-out: what a state is, what an event does to it, which events can happen and whose turn it is.
//!
//! The language reference, sections 2 to 4, exactly. A state consists of one valuation of the attributes and a set of
//! scenario *copies*; both are interned, so that a [`Config`] is a handful of integers. What one event does to one
//! copy is computed by walking the scenario (`cut`), which is slow and obvious, and then remembered: whatever
//! read no attribute that can change holds in every state, the rest per valuation. In a long exploration a step is
//! a few table look-ups.
//!
//! The stage knows nothing of graphs, games or files; its clients are exploration, verification and `sml play`.

mod attempts;
mod attributes;
mod copies;
mod cut;
mod events;
mod keys;
mod memo;
mod observe;
mod offers;
mod pattern;
mod permute;
mod react;
mod reasons;
mod relax;
mod show;
mod step;
mod transgressions;
mod turn;

pub use attempts::Attempt;
pub use attributes::ValuationId;
#[cfg(feature = "json")]
pub(crate) use copies::variables_read;
pub use copies::{Copy, CopyId};
pub use events::{Event, EventId};
pub use keys::{Key, KeyId};
pub(crate) use observe::Sight;
pub(crate) use offers::Offers;
pub(crate) use react::Outcome;
pub use reasons::{Ground, Objection, Reasons, Stake, turn_reason};
#[cfg(feature = "json")]
pub(crate) use show::bound_name;
pub use step::Step;
pub use transgressions::Transgression;
pub(crate) use turn::Urgency;
pub use turn::{Goal, Move, Moves};

use crate::diagnostic::{Code, Diagnostic};
use crate::model::{Failure, Spec};
use crate::syntax::Span;
use attributes::{Valuations, valuations};
use copies::Copies;
use events::Events;
use fixedbitset::FixedBitSet;
use keys::Keys;
use offers::OfferTable;
use react::Reactions;

/// How to read the winning condition where the publication and this project differ.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Semantics {
    /// The literal GR(1) reading: the system may win by violating an assumption, and the environment is silent only
    /// where it has no event.
    pub classic: bool,
}

/// A state of the play, unpacked.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub struct Config {
    /// The values of all attributes.
    pub valuation: ValuationId,
    /// Active copies, ascending, without duplicates.
    pub copies: Vec<CopyId>,
    /// The system has yielded since the last event.
    pub yielded: bool,
}

/// A mistake that shows only in play-out.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct PlayError {
    /// Which kind.
    pub code: Code,
    /// Where in the specification.
    pub span: Span,
    /// What.
    pub message: String,
}

impl PlayError {
    /// As a diagnostic that shows the play that leads there.
    #[must_use]
    pub fn diagnostic(&self, play: &[String]) -> Diagnostic {
        let diagnostic = Diagnostic::error(self.code, self.span, self.message.clone());
        let help = match self.code {
            Code::PlayOutRange => "widen the range, or see to it that this cannot happen there",
            Code::PlayOutNull => "test for `null` first: `… != null && …`",
            Code::PlayOutLoop => "let the loop wait for a message or for something that changes",
            Code::ViolatedInitially => "begin the scenario with a message",
            _ => "narrow the types of its parameters, or give them `parameter ranges`",
        };
        let diagnostic = diagnostic.help(help);
        match play {
            _ if matches!(self.code, Code::LimitReached | Code::ViolatedInitially) => diagnostic,
            [] => diagnostic.note("this happens in the initial state"),
            _ => diagnostic.note(format!("the shortest play that leads there:\n  {}", play.join("\n  "))),
        }
    }
}

/// Plays one specification out. Holds everything that was interned and remembered so far.
#[derive(Debug)]
pub struct Playout<'s> {
    spec: &'s Spec,
    semantics: Semantics,
    /// The existential scenario whose copies are part of the states.
    followed: Option<usize>,
    /// Scenarios whose demands do not count.
    relaxed: FixedBitSet,
    events: Events,
    valuations: Valuations,
    copies: Copies,
    keys: Keys,
    reactions: Reactions,
    offers: OfferTable,
}

impl<'s> Playout<'s> {
    /// Prepares to play `spec`.
    ///
    /// # Errors
    /// The environment has too many different events.
    pub fn new(spec: &'s Spec, semantics: Semantics) -> Result<Self, PlayError> {
        Ok(Playout {
            spec,
            semantics,
            followed: None,
            relaxed: FixedBitSet::new(),
            events: Events::new(spec)?,
            valuations: valuations(&spec.domain),
            copies: Copies::new(),
            keys: Keys::default(),
            reactions: Reactions::default(),
            offers: OfferTable::default(),
        })
    }

    /// Like [`Playout::new`], but with the copies of one existential scenario in the states. Moves and turns are the
    /// same as without; states that differ only in these copies are apart, and a [`Step`] says when one of them is
    /// completed.
    ///
    /// # Errors
    /// The environment has too many different events.
    pub fn following(spec: &'s Spec, semantics: Semantics, scenario: usize) -> Result<Self, PlayError> {
        Ok(Playout { followed: Some(scenario), ..Self::new(spec, semantics)? })
    }

    /// The specification.
    #[must_use]
    pub fn spec(&self) -> &'s Spec {
        self.spec
    }

    /// The semantics.
    #[must_use]
    pub fn semantics(&self) -> Semantics {
        self.semantics
    }

    /// An event by its id.
    #[must_use]
    pub fn event(&self, event: EventId) -> &Event {
        self.events.get(event)
    }

    /// How many events were met so far; ids are below it.
    #[must_use]
    pub fn event_count(&self) -> usize {
        self.events.len()
    }

    /// The id of the event with this text, if it was met so far.
    #[must_use]
    pub fn find_event(&self, text: &str) -> Option<EventId> {
        self.events.find_text(text)
    }

    /// A copy by its id.
    #[must_use]
    pub fn copy(&self, copy: CopyId) -> &Copy {
        self.copies.get(copy)
    }

    /// How many copies were met so far; ids are below it.
    pub(crate) fn copy_count(&self) -> usize {
        self.copies.len()
    }

    /// The valuation with these values, by slot.
    pub(crate) fn valuation(&mut self, values: &[crate::model::Value]) -> ValuationId {
        self.valuations.intern(values)
    }

    /// A fairness key by its id.
    #[must_use]
    pub fn key(&self, key: KeyId) -> &Key {
        self.keys.get(key)
    }

    /// How many keys were met so far; ids are below it.
    #[must_use]
    pub fn key_count(&self) -> usize {
        self.keys.len()
    }

    /// The attribute values of a valuation, by slot.
    #[must_use]
    pub fn values(&self, valuation: ValuationId) -> &[crate::model::Value] {
        self.valuations.get(valuation)
    }

    /// Appends the keys that are open in `config` to `open`, ascending, without duplicates and those of relaxed
    /// scenarios.
    pub fn open_keys(&self, config: &Config, open: &mut Vec<KeyId>) {
        self.open_of(&config.copies, open);
    }

    /// Appends the keys that some of these copies have open.
    pub(crate) fn open_of(&self, copies: &[CopyId], open: &mut Vec<KeyId>) {
        for &copy in copies {
            open.extend(self.copies.get(copy).obligations.iter().map(|&(_, key)| key));
        }
        open.sort_unstable();
        open.dedup();
        self.retain_counted(open);
    }

    /// Bytes held by the interned parts.
    #[must_use]
    pub fn memory(&self) -> usize {
        self.valuations.memory() + self.copies.memory() + self.reactions.memory() + self.offers.memory()
    }
}

/// What a failed evaluation says to the user.
fn play_error(failure: Failure, fallback: Span) -> PlayError {
    match failure {
        Failure::Null(span) => {
            PlayError { code: Code::PlayOutNull, span, message: "this path leads through `null`".to_owned() }
        }
        Failure::Overflow(span) => PlayError {
            code: Code::PlayOutRange,
            span,
            message: "this value does not fit into 64 bits".to_owned(),
        },
        Failure::Unset => PlayError {
            code: Code::ReadBeforeBound,
            span: fallback,
            message: "this reads a variable or role that has no value".to_owned(),
        },
    }
}

//! The counter-play step by step: who wants each event, and what is wanted but refused.

use super::{Replay, SILENCE};
use crate::game::Turn;
use crate::pipeline::Solved;
use crate::playout::{EventId, Moves, Objection, Playout, Reasons};
use crate::syntax::Span;

/// A step of a counter-play, and what the scenarios have to do with it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct PlayStep {
    /// Its text, `yield`, or [`SILENCE`].
    pub event: String,
    /// Who has the turn, and by which case.
    pub turn: Turn,
    /// The messages that cause it: of guarantees that ask the system for it, or of assumptions that say that the
    /// environment sends it.
    pub wanted_by: Vec<Mention>,
    /// Other events that are wanted here but are not executable, in the order of their texts.
    pub forbidden: Vec<Refusal>,
    /// What it violates: guarantees, at the end of the play.
    pub violates: Vec<Mention>,
    /// It is repeated for ever.
    pub in_loop: bool,
}

/// A scenario and the place in it that matters.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Mention {
    /// `Collaboration.Scenario[role=object,…]`.
    pub scenario: String,
    /// The message, constraint or condition.
    pub place: Span,
    /// What to say of the place.
    pub says: &'static str,
}

/// An event that is wanted and cannot happen.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Refusal {
    /// Its text.
    pub event: String,
    /// What it would violate; empty if its channel has no link.
    pub by: Vec<Mention>,
}

impl Mention {
    /// What an objection is about.
    #[must_use]
    pub fn of(playout: &Playout<'_>, objection: &Objection) -> Self {
        let Objection { copy, scenario, ground } = *objection;
        let scenario = match copy {
            Some(copy) => playout.copy_name(copy),
            None => playout.spec().scenarios[scenario].name.clone(),
        };
        Mention { scenario, place: ground.span(), says: ground.describe() }
    }

    /// Scenario and place, as `place` shows it.
    #[must_use]
    pub fn show(&self, place: &dyn Fn(Span) -> String) -> String {
        format!("{} ({})", self.scenario, place(self.place))
    }
}

/// Plays the play out once more, and then the cycle once; `None` if it is none of this specification.
pub(super) fn annotate(solved: &Solved<'_>, play: &[String], cycle: &[String]) -> Option<Vec<PlayStep>> {
    let (mut replay, mut moves) = (Replay::of(solved)?, Moves::default());
    let play = play.iter().map(|event| (event, false));
    play.chain(cycle.iter().map(|event| (event, true)))
        .map(|(event, in_loop)| {
            let step = step(&mut replay, &mut moves, event, in_loop)?;
            if event != SILENCE {
                replay.follow(event)?;
            }
            Some(step)
        })
        .collect()
}

fn step(replay: &mut Replay<'_>, moves: &mut Moves, text: &str, in_loop: bool) -> Option<PlayStep> {
    let Replay { playout, config, .. } = replay;
    playout.moves(config, moves).ok()?;
    let mut step = PlayStep {
        event: text.to_owned(),
        turn: moves.turn,
        wanted_by: Vec::new(),
        forbidden: Vec::new(),
        violates: Vec::new(),
        in_loop,
    };
    let mut executable = moves.moves.iter().filter_map(|one| one.event);
    if let Some(event) = executable.find(|&event| playout.event(event).text == text) {
        let reasons = playout.reasons(config, event);
        step.wanted_by = wanted_by(playout, &reasons);
        step.violates = mentions(playout, reasons.objections.iter());
    }
    for event in playout.wanted(config) {
        let reasons = playout.reasons(config, event);
        step.forbidden.extend(refusal(playout, event, &reasons));
    }
    Some(step)
}

/// The messages that cause an event, each once.
fn wanted_by(playout: &Playout<'_>, reasons: &Reasons) -> Vec<Mention> {
    let stakes = reasons.wanted_by.iter();
    let mention = stakes.map(|stake| Mention {
        scenario: playout.copy_name(stake.copy),
        place: stake.span,
        says: "wanted here",
    });
    sorted(mention.collect())
}

/// What stands in the way of an event; `None` if nothing does.
#[must_use]
pub fn refusal(playout: &Playout<'_>, event: EventId, reasons: &Reasons) -> Option<Refusal> {
    let by = mentions(playout, playout.refusals(event, reasons));
    let refused = reasons.unlinked || !by.is_empty();
    refused.then(|| Refusal { event: playout.event(event).text.clone(), by })
}

fn mentions<'r>(playout: &Playout<'_>, objections: impl Iterator<Item = &'r Objection>) -> Vec<Mention> {
    sorted(objections.map(|objection| Mention::of(playout, objection)).collect())
}

fn sorted(mut mentions: Vec<Mention>) -> Vec<Mention> {
    mentions.sort_unstable();
    mentions.dedup();
    mentions
}

/// Most events that a step shows as refused, and most scenarios that are named for one thing.
const MOST_SHOWN: usize = 3;

/// A step in lines for people: the event with what wants it, then what it violates and what was refused instead.
pub(super) fn lines(step: &PlayStep, width: usize, place: &dyn Fn(Span) -> String) -> Vec<String> {
    let named = |mentions: &[Mention]| listed(mentions.iter().map(|mention| mention.show(place)), ", ");
    let mut lines = vec![if step.wanted_by.is_empty() {
        step.event.clone()
    } else {
        format!("{:<width$}  ← {}", step.event, named(&step.wanted_by))
    }];
    lines.extend(
        step.violates.iter().map(|mention| format!("    violates {}: {}", mention.show(place), mention.says)),
    );
    let refused = step.forbidden.iter().map(|Refusal { event, by }| match by.as_slice() {
        [] => format!("{event}, which has no channel"),
        by => format!("{event} by {}", named(by)),
    });
    if !step.forbidden.is_empty() {
        lines.push(format!("    refused: {}", listed(refused, "; ")));
    }
    lines
}

/// The first few, and how many more there are.
fn listed(texts: impl ExactSizeIterator<Item = String>, separator: &str) -> String {
    let more = texts.len().saturating_sub(MOST_SHOWN);
    let mut shown = texts.take(MOST_SHOWN).collect::<Vec<_>>().join(separator);
    if more > 0 {
        shown.push_str(&format!("{separator}and {more} more"));
    }
    shown
}

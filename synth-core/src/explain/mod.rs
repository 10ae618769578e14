//! Why a specification is not realizable, in terms of its scenarios.
//!
//! The solver's counter-strategy gives one play that the environment forces ([`counter_play`]). Here it is played
//! out once more to see which scenarios it breaks or starves, and what keeps the system from meeting them. It is one
//! play, not all of them; which guarantees cannot be met whatever the play, is found by relaxing the others (`core`).

mod core;
mod probe;
mod replay;
mod sequence;
mod steps;
mod suggest;

pub use probe::{Budget, Prober, Scenarios};
use replay::{Findings, Replay};
pub use sequence::sequence;
pub use steps::{Mention, PlayStep, Refusal, refusal};
pub use suggest::Suggestion;
use suggest::{Basis, suggest};

use self::core::Core;
use crate::diagnostic::{Code, Diagnostic};
use crate::explore::Limits;
use crate::game::{CounterPlay, Loss, can_meet, counter_play};
use crate::model::{Kind, Spec};
use crate::pipeline::Solved;
use crate::syntax::{FileId, Span};
use std::collections::BTreeSet;

/// What is at the bottom of it; the first that applies.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Cause {
    /// The environment can bring the play to an event of its own that violates a guarantee but no assumption.
    EnvironmentViolates,
    /// The obligation that starves is a message that the system has to send, and throughout the loop each event that
    /// would meet it violates a scenario or has no channel. Nor could the system avoid that: it cannot meet
    /// this obligation even if it violates no guarantee but neglects all other obligations.
    UrgentBlocked,
    /// The system could meet the obligation that starves if it were the only one (without violating any guarantee), or
    /// if all guarantees but its scenario were relaxed. If super steps do not end: the core consists of several
    /// scenarios, so each of them could be met without the others.
    GuaranteesConflict,
    /// None of these: the environment can withhold what the obligation waits for.
    ObligationStarved,
}

impl Cause {
    /// As it stands in outputs.
    #[must_use]
    pub fn as_str(self) -> &'static str {
        match self {
            Cause::EnvironmentViolates => "environment_violates",
            Cause::UrgentBlocked => "urgent_blocked",
            Cause::GuaranteesConflict => "guarantees_conflict",
            Cause::ObligationStarved => "obligation_starved",
        }
    }
}

/// An event that the system would have to send, and what does not let it.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Blocked {
    /// Its text.
    pub event: String,
    /// Names of the scenarios that it would violate; empty if it has no channel.
    pub by: Vec<String>,
}

/// An obligation that is never met.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Starved {
    /// The name of its scenario.
    pub scenario: String,
    /// The message or `wait`.
    pub fragment: Span,
}

/// Why no controller can meet a specification.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Explanation {
    /// What is at the bottom of it.
    pub cause: Cause,
    /// Names of a minimal core of guarantees: with all others relaxed the specification is not realizable, with any one of
    /// these relaxed, too, it is. What is violated or starves in the play comes first.
    pub scenarios: Vec<String>,
    /// The places of their names.
    pub places: Vec<Span>,
    /// The core is known to be minimal. It is not where the search for a smaller one became too costly or met a mistake.
    pub is_minimal: bool,
    /// Names of other scenarios that have a part in the play: they are violated or starve, or block events of the system.
    pub involved: Vec<String>,
    /// Event texts of a play that the environment can force; a yield is `yield`.
    pub play: Vec<String>,
    /// What is then repeated for ever; the single text `silence` if nothing happens any more. Empty if a guarantee is
    /// violated at the end of `play`.
    pub cycle: Vec<String>,
    /// Every step of `play` and `cycle`, and what the scenarios have to do with it.
    pub steps: Vec<PlayStep>,
    /// The obligation that is not met in the loop; `None` if a guarantee is violated, or a super step never ends.
    pub starved: Option<Starved>,
    /// Events of the system that would help but are not allowed where the play ends, in the order of their texts.
    pub blocked: Vec<Blocked>,
    /// Assumptions with any one of which the specification is realizable, one of each shape that was found to help.
    pub suggestions: Vec<Suggestion>,
    /// The place of the message or `wait` that starves, else the name of the first scenario that is violated.
    pub place: Span,
}

impl Explanation {
    /// As a message to the author.
    #[must_use]
    pub fn diagnostic(&self) -> Diagnostic {
        self.diagnostic_with(&|span| match span.file {
            FileId(0) => format!("line {}", span.start.line),
            _ => format!("line {} of an imported file", span.start.line),
        })
    }

    /// As a message to the author that shows the places of the play's annotations in this way.
    #[must_use]
    pub fn diagnostic_with(&self, place: &dyn Fn(Span) -> String) -> Diagnostic {
        let width = self.steps.iter().map(|step| step.event.chars().count()).max().unwrap_or(0);
        let steps = |in_loop: bool| {
            let steps = self.steps.iter().filter(|step| step.in_loop == in_loop);
            steps.flat_map(|step| steps::lines(step, width, place)).collect::<Vec<_>>().join("\n  ")
        };
        let label = match (self.cause, &self.starved) {
            (Cause::EnvironmentViolates, _) => "the environment can violate this",
            (Cause::UrgentBlocked, _) => "this must be sent, and is blocked for ever",
            (Cause::GuaranteesConflict, Some(_)) => "this could be met if it were the only obligation",
            (Cause::ObligationStarved, Some(_)) => "the environment can keep this from ever being met",
            (_, None) => "this can make a super step go on for ever",
        };
        let message = "no controller can meet this specification";
        let mut diagnostic = Diagnostic::error(Code::Unrealizable, self.place, message).label(label);
        for Blocked { event, by } in &self.blocked {
            diagnostic = diagnostic.note(match by.as_slice() {
                [] => format!("`{event}` has no channel there"),
                by => format!("`{event}` is not allowed there, it would violate `{}`", by.join("`, `")),
            });
        }
        diagnostic = self.point_at_core(diagnostic);
        if !self.play.is_empty() {
            let play = steps(false);
            diagnostic = diagnostic.note(format!("the environment can force this play:\n  {play}"));
        }
        if !self.cycle.is_empty() {
            let when = if self.play.is_empty() { "from the start" } else { "and then" };
            let cycle = steps(true);
            diagnostic = diagnostic.note(format!("{when}, for ever:\n  {cycle}"));
        }
        diagnostic.help(match self.suggestions.as_slice() {
            [] => self.help().to_owned(),
            some => {
                let texts: Vec<String> = some.iter().map(Suggestion::as_edit).collect();
                texts.join("\nor ")
            }
        })
    }

    /// What to do if no suggestion was found.
    fn help(&self) -> &'static str {
        match self.cause {
            Cause::EnvironmentViolates => {
                "add the assumption that rules the last event out, or relax the guarantee"
            }
            Cause::UrgentBlocked => {
                "relax the guarantee that blocks the message, or the one that asks for it"
            }
            Cause::GuaranteesConflict => "relax one of the guarantees involved",
            Cause::ObligationStarved if self.starved.is_none() => {
                "let the scenario wait for an event of the environment before it asks again"
            }
            Cause::ObligationStarved => {
                "add the assumption about the environment that is missing, or relax the guarantee"
            }
        }
    }

    /// Adds the core and what else is involved.
    fn point_at_core(&self, mut diagnostic: Diagnostic) -> Diagnostic {
        if self.scenarios.len() > 1 {
            for &place in self.places.iter().filter(|&&place| place != self.place) {
                diagnostic = diagnostic.also(place, "cannot be met together with the others");
            }
            let names = self.scenarios.join("`, `");
            diagnostic = diagnostic.note(if self.is_minimal {
                format!("these cannot be met together, but without any one of them: `{names}`")
            } else {
                format!("these cannot be met together, perhaps not even some of them: `{names}`")
            });
        } else if let Some(only) = self.scenarios.first() {
            diagnostic = diagnostic.note(format!("`{only}` alone cannot be met"));
        }
        if !self.involved.is_empty() {
            diagnostic = diagnostic.note(format!("also involved: `{}`", self.involved.join("`, `")));
        }
        diagnostic
    }
}

/// The text that stands for a loop in which nothing happens.
pub const SILENCE: &str = "silence";

/// Explains why the system cannot win from the initial state; `None` if it can.
///
/// The counter-play costs about as much as solving the game once more, the core and the suggestions each as much as
/// [`Budget`] says: exploring and solving it ten times at most. In practice that is once or twice for each scenario of the
/// core, and once for each assumption that is tried. All explorations for the core together visit no more states than
/// the limits allow, and so do those for suggestions; none takes more memory. With little, the core may be larger than
/// minimal and suggestions may be missing.
#[must_use]
pub fn explain(solved: &Solved<'_>, limits: &Limits) -> Option<Explanation> {
    let CounterPlay { play, cycle, loss } = counter_play(&solved.explored.game, &solved.solution)?;
    let spec = solved.explored.playout.spec();
    let mut replay = Replay::of(solved)?;
    let texts = |edges: &[u32]| {
        edges.iter().map(|&edge| solved.explored.text(edge as usize).to_owned()).collect::<Vec<_>>()
    };
    let (play_edges, cycle_edges) = (play, cycle);
    let (play, mut cycle) = (texts(&play_edges), texts(&cycle_edges));
    let findings = match loss {
        Loss::Violation => {
            let (last, before) = play.split_last()?;
            before.iter().try_for_each(|event| replay.follow(event))?;
            replay.violation(last)
        }
        Loss::Starvation(key) => {
            play.iter().try_for_each(|event| replay.follow(event))?;
            replay.starvation(solved.explored.playout.key(key), &cycle)?
        }
        Loss::Endless => {
            play.iter().try_for_each(|event| replay.follow(event))?;
            replay.endless(&cycle)?
        }
    };
    if cycle.is_empty() && loss != Loss::Violation {
        cycle.push(SILENCE.to_owned());
    }
    let budget = Budget::for_states(solved.explored.game.states()).within(limits);
    let mut prober = Prober::new(spec, solved.explored.playout.semantics(), budget)?.knowing(false);
    let core = core::core(&mut prober, &findings.scenarios);
    let cause = cause(solved, loss, &findings, &core, &mut prober);
    let name = |scenario: &usize| spec.scenarios[*scenario].name.clone();
    let mut seen = BTreeSet::new();
    let involved = findings.scenarios.iter().copied().filter(|&scenario| seen.insert(scenario));
    let (mut scenarios, involved): (Vec<usize>, Vec<usize>) =
        involved.partition(|scenario| core.scenarios.contains(scenario));
    scenarios.extend(core.scenarios.iter().filter(|scenario| !seen.contains(scenario)));
    let first = *findings.scenarios.first()?;
    // The core first, but what the play violates even before that.
    let mut speaking = vec![first];
    speaking.extend(scenarios.iter().chain(&involved).filter(|&&scenario| scenario != first));
    let basis = Basis {
        solved,
        loss,
        play: &play_edges,
        cycle: &cycle_edges,
        starved: findings.starved.as_ref(),
        scenarios: &speaking,
    };
    let suggestions = suggest(&basis, budget);
    let starved = findings.starved.map(|key| Starved {
        scenario: name(&key.scenario),
        fragment: spec.scenarios[key.scenario].nodes[usize::from(key.node)].span,
    });
    let steps = steps::annotate(solved, &play, &cycle)?;
    Some(Explanation {
        cause,
        scenarios: scenarios.iter().map(name).collect(),
        places: scenarios.iter().map(|&scenario| spec.scenarios[scenario].span).collect(),
        is_minimal: core.is_minimal,
        involved: involved.iter().map(name).collect(),
        play,
        cycle,
        steps,
        place: starved.as_ref().map_or(spec.scenarios[first].span, |starved| starved.fragment),
        suggestions,
        starved,
        blocked: findings.blocked.into_iter().collect(),
    })
}

/// The first cause that applies.
fn cause(
    solved: &Solved<'_>,
    loss: Loss,
    findings: &Findings,
    core: &Core,
    prober: &mut Prober<'_>,
) -> Cause {
    let is_conflict = match (loss, &findings.starved) {
        (Loss::Violation, _) => return Cause::EnvironmentViolates,
        (Loss::Starvation(key), _) if can_meet(&solved.explored.game, &[key]) => true,
        (Loss::Starvation(_), _) if findings.always_blocked => return Cause::UrgentBlocked,
        (_, Some(key)) => {
            let is_other = |&scenario: &usize| scenario != key.scenario;
            let others = guarantees(prober.spec()).filter(is_other).collect();
            prober.is_realizable(&others) == Some(true)
        }
        (_, None) => core.is_minimal && core.scenarios.len() > 1,
    };
    if is_conflict { Cause::GuaranteesConflict } else { Cause::ObligationStarved }
}

/// The guarantees, as indices.
fn guarantees(spec: &Spec) -> impl Iterator<Item = usize> {
    (0..spec.scenarios.len()).filter(|&scenario| spec.scenarios[scenario].kind == Kind::Guarantee)
}

#[cfg(test)]
mod tests;

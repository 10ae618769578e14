//! Who would win with some scenarios relaxed, asked again and again.
//!
//! All questions share one play-out, and answers are remembered: since the system gains by each further guarantee that
//! is relaxed, one answer settles many questions. What does not fit the budget, or meets a mistake that the
//! specification as it is does not show, stays unknown.

use crate::explore::{Limits, explore_with};
use crate::game::wins;
use crate::model::{Kind, Spec};
use crate::playout::{Playout, Semantics};
use std::collections::BTreeSet;

/// A set of scenarios, as indices.
pub type Scenarios = BTreeSet<usize>;

/// How much may be explored to answer questions about one game.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Budget {
    /// Most states for one answer.
    each: usize,
    /// Most states for all.
    all: usize,
    /// Most bytes for one answer.
    memory: usize,
    threads: usize,
}

impl Budget {
    /// For a game with so many states: each answer may take four times as many, all together ten times; games of any
    /// size may grow to 100,000 and 400,000, which takes seconds at most.
    #[must_use]
    pub fn for_states(states: usize) -> Self {
        Budget {
            each: states.saturating_mul(4).max(100_000),
            all: states.saturating_mul(10).max(400_000),
            memory: usize::MAX,
            threads: 0,
        }
    }

    /// At most so many states all together, and at most so much memory and so many threads for one answer.
    #[must_use]
    pub fn within(self, limits: &Limits) -> Self {
        let Limits { states, memory, threads } = *limits;
        Budget { each: self.each.min(states), all: self.all.min(states), memory, threads }
    }

    /// The limits of the next exploration.
    pub(super) fn limits(&self) -> Limits {
        Limits { states: self.each.min(self.all), memory: self.memory, threads: self.threads }
    }

    /// So many states have been explored.
    pub(super) fn spend(&mut self, states: usize) {
        self.all = self.all.saturating_sub(states);
    }
}

/// Answers who would win.
#[derive(Debug)]
pub struct Prober<'s> {
    playout: Playout<'s>,
    budget: Budget,
    known: Vec<(Scenarios, Option<bool>)>,
}

impl<'s> Prober<'s> {
    /// Nothing is known yet. `None` if the specification cannot be played at all.
    #[must_use]
    pub fn new(spec: &'s Spec, semantics: Semantics, budget: Budget) -> Option<Self> {
        let playout = Playout::new(spec, semantics).ok()?;
        Some(Prober { playout, budget, known: Vec::new() })
    }

    /// The specification.
    #[must_use]
    pub fn spec(&self) -> &'s Spec {
        self.playout.spec()
    }

    /// Tells what is known from elsewhere: whether the specification is realizable as it is.
    #[must_use]
    pub fn knowing(mut self, realizable: bool) -> Self {
        self.known.push((Scenarios::new(), Some(realizable)));
        self
    }

    /// Whether the specification is realizable with these scenarios relaxed; `None` if that is too costly to find out,
    /// or a play meets a mistake.
    pub fn is_realizable(&mut self, relaxed: &Scenarios) -> Option<bool> {
        if let Some(answer) = self.remembered(relaxed) {
            return answer;
        }
        self.playout.relax(relaxed.iter().copied());
        let limits = self.budget.limits();
        let explored = explore_with(&mut self.playout, &limits);
        let answer = explored.as_ref().ok().map(|(_, game)| wins(game));
        self.budget.spend(explored.map_or(limits.states, |(_, game)| game.states()));
        self.known.push((relaxed.clone(), answer));
        answer
    }

    /// The answer, if it follows from one that was given.
    fn remembered(&self, relaxed: &Scenarios) -> Option<Option<bool>> {
        let follows = |(known, answer): &&(Scenarios, Option<bool>)| {
            let guarantees_only = known
                .symmetric_difference(relaxed)
                .all(|&scenario| self.spec().scenarios[scenario].kind == Kind::Guarantee);
            match answer {
                Some(true) => guarantees_only && known.is_subset(relaxed),
                Some(false) => guarantees_only && known.is_superset(relaxed),
                None => known == relaxed,
            }
        };
        self.known.iter().find(follows).map(|known| known.1)
    }
}

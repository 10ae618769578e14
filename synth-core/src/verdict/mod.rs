//! The verdict alone: who wins from the initial state, found out without exploring more than that takes.
//!
//! States are explored in some order, and always with all their moves. What was found but not explored counts in one
//! game as lost for the system and in another as won (`partial`). A system that wins the first of them has a strategy
//! that stays among explored states, so it wins the whole game; an environment that wins the second one does, too. Keys that
//! are open in no explored state are never open in such a play, so it is fair to them. If neither is so, more is explored, in the end
//! everything, and then both games are the whole one.
//!
//! What is explored next (`agenda`) decides how soon it ends.

mod agenda;
mod partial;

use crate::explain::SILENCE;
use crate::explore::{ExploreError, Explored, Limits};
use crate::game::{CounterPlay, Game, Loss, Solution, Turn, counter_play, solve};
use crate::model::Spec;
use crate::pipeline::Size;
use crate::playout::{Playout, Semantics};
use agenda::{Agenda, Side};
use partial::Partial;

/// So many states are explored at most before the first look at who wins, and before each further look so many times as
/// many. All looks together take about as long as one at everything.
const FIRST_BUDGET: usize = 64;
const GROWTH: usize = 4;

/// Who wins, and what that took.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Verdict {
    /// The system wins from the initial state.
    pub realizable: bool,
    /// States that were found. The losing state, and the won one, do not count.
    pub found: usize,
    /// Those of them whose moves were looked at.
    pub explored: usize,
    /// The moves of these.
    pub transitions: usize,
    /// What was held in the end.
    pub size: Size,
    /// If it is not realizable: a play that the environment can force.
    pub forced: Option<Forced>,
}

/// A play that the environment wins.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Forced {
    /// Event texts; a yield is `yield`.
    pub play: Vec<String>,
    /// What is then repeated for ever; the single text `silence` if nothing happens any more. Empty if a guarantee is
    /// violated at the end of `play`.
    pub cycle: Vec<String>,
}

impl Verdict {
    /// Everything was explored.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.found == self.explored
    }
}

/// Finds out whether a specification is realizable. It does not depend on [`Limits::threads`].
///
/// # Errors
/// A mistake of the specification that a play reaches (only some plays are looked at, and this one need not be the shortest),
/// or a limit.
pub fn verdict(spec: &Spec, semantics: Semantics, limits: &Limits) -> Result<Verdict, ExploreError> {
    let mut playout = Playout::new(spec, semantics).map_err(|error| ExploreError::Play(error, Vec::new()))?;
    let mut partial = Partial::new(&mut playout)?;
    Ok(decide(&mut partial, limits)?.0)
}

/// A game that is part of that of a specification, and in which the system wins.
#[derive(Debug)]
pub struct WinningPart<'s> {
    /// What was explored. States that were found, but not explored, are the losing state.
    pub explored: Explored<'s>,
    /// Where the system wins. Its strategies win the whole game, too.
    pub solution: Solution,
}

/// The same as [`verdict`], and if the specification is realizable, what was explored to know it.
///
/// # Errors
/// As for [`verdict`].
pub fn winning_part<'s>(
    spec: &'s Spec,
    semantics: Semantics,
    limits: &Limits,
) -> Result<(Verdict, Option<WinningPart<'s>>), ExploreError> {
    let mut playout = Playout::new(spec, semantics).map_err(|error| ExploreError::Play(error, Vec::new()))?;
    let mut partial = Partial::new(&mut playout)?;
    let (verdict, won) = decide(&mut partial, limits)?;
    let store = partial.into_store();
    let part = won.map(|(game, solution)| {
        let explored = Explored { playout, store, game };
        WinningPart { explored, solution }
    });
    Ok((verdict, part))
}

/// Explores until the verdict is certain; the game that the system wins, and how.
fn decide(
    partial: &mut Partial<'_, '_>,
    limits: &Limits,
) -> Result<(Verdict, Option<(Game, Solution)>), ExploreError> {
    let mut agenda = Agenda::default();
    let mut budget = FIRST_BUDGET;
    loop {
        // Whether the system wins can only show where all that the environment can do was followed.
        if agenda.follow(Side::System, partial, budget, limits)? {
            let game = partial.game(Turn::Lost);
            let solution = solve(&game);
            if solution.wins(game.initial) {
                return Ok((found(partial, None), Some((game, solution))));
            }
            agenda.note_won(&solution.winning, partial.explored());
        }
        // What an environment with few choices can do shows soon, and is in vain if the system wins.
        agenda.follow(Side::Environment, partial, budget / GROWTH, limits)?;
        let game = partial.game(Turn::Won);
        let solution = solve(&game);
        if let Some(counter) = counter_play(&game, &solution) {
            return Ok((found(partial, Some(forced(partial, &counter))), None));
        }
        agenda.note_lost(&solution.winning, partial.explored());
        budget = budget.saturating_mul(GROWTH);
    }
}

fn forced(partial: &Partial<'_, '_>, counter: &CounterPlay) -> Forced {
    let texts =
        |edges: &[u32]| -> Vec<String> { edges.iter().map(|&edge| partial.text(edge).to_owned()).collect() };
    let mut cycle = texts(&counter.cycle);
    if cycle.is_empty() && counter.loss != Loss::Violation {
        cycle.push(SILENCE.to_owned());
    }
    Forced { play: texts(&counter.play), cycle }
}

fn found(partial: &Partial<'_, '_>, forced: Option<Forced>) -> Verdict {
    Verdict {
        realizable: forced.is_none(),
        found: partial.found(),
        explored: partial.explored(),
        transitions: partial.edges(),
        size: Size {
            states: partial.found(),
            edges: Some(partial.edges()),
            of_states: Some(partial.memory_of_states()),
            of_edges: Some(partial.memory_of_edges()),
        },
        forced,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{spec, world};

    /// States found, those explored, and the play of an environment that wins.
    #[track_caller]
    fn check(body: &str, expect: (usize, usize, &str)) {
        let spec = spec(&world(body));
        let Verdict { found, explored, forced, .. } =
            verdict(&spec, Semantics::default(), &Limits::default()).expect("a verdict");
        let forced =
            forced.map(|Forced { play, cycle }| format!("{} | {}", play.join(", "), cycle.join(", ")));
        assert_eq!((found, explored, &*forced.unwrap_or_default()), expect);
    }

    #[test]
    fn a_system_that_wins_at_once_need_not_yield() {
        check("guarantee scenario G { user -> control.press() eventually control -> lamp.on() }", (3, 2, ""));
    }

    #[test]
    fn an_environment_wins_by_silence() {
        check(
            "guarantee scenario G { user -> control.press() monitored eventually user -> control.release() }",
            (2, 2, "user -> control.press() | silence"),
        );
    }

    #[test]
    fn nothing_is_explored_behind_a_violation() {
        let forbidden = "guarantee scenario F { user -> control.press() user -> control.release() }
            constraints [ forbidden user -> control.press() ]";
        let tick = "guarantee scenario T { user -> control.tick() urgent control -> lamp.on() }";
        check(&format!("{forbidden}\n{tick}"), (4, 3, "user -> control.press(), user -> control.press() | "));
    }
}

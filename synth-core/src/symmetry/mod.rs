//! Who wins, on the game up to permutations of interchangeable objects.
//!
//! Clients that are all alike make exponentially many states, of which most differ only in which client is which. If two objects
//! can change places in the whole specification (`interchangeable`, by comparing `form`s), every state has as many
//! images as there are permutations, and the same happens in all of them. So one is explored for all (`canonical`, `explore`),
//! and the game is solved on these (`solve`), where edges say what becomes of the fairness keys (`quotient`). How many states
//! each stands for is known from the permutations that leave it as it is (`orbit`), so the figures are those of the whole game.
//!
//! Verdict and figures are the same as without. There is no strategy and no play: these would have to be made for each object.

mod canonical;
mod explore;
mod form;
mod interchangeable;
mod orbit;
mod quotient;
mod solve;

use crate::explore::{ExploreError, Limits};
use crate::model::{ObjectId, Spec};
use crate::pipeline::{Figures, Size, Solved, Timings};
use crate::playout::{Playout, Semantics};
use explore::Explored;
use fixedbitset::FixedBitSet;
use interchangeable::Interchangeable;

/// Interchangeable objects of a specification.
#[derive(Debug)]
pub struct Symmetry(Interchangeable);

impl Symmetry {
    /// Finds them. Every object is compared with one of each set of its class, for which the specification is written out once more; where
    /// events of single objects have effects, for all pairs of a sender and a receiver.
    #[must_use]
    pub fn of(spec: &Spec) -> Self {
        Symmetry(Interchangeable::of(spec))
    }

    /// Sets of at least two objects; all objects of a set can change places with one another.
    #[must_use]
    pub fn groups(&self) -> &[Vec<ObjectId>] {
        &self.0.groups
    }
}

/// Who wins, and what was explored for it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Reduced {
    /// The system wins from the initial state.
    pub realizable: bool,
    /// States that were explored, each for all that differ from it only by interchangeable objects. The losing and the won state do
    /// not count.
    pub representatives: usize,
    /// Moves of these.
    pub transitions: usize,
    /// The figures of the whole game; `None` if some state has so many images of itself that not all were compared, or
    /// a number does not fit.
    pub figures: Option<WholeFigures>,
}

impl Reduced {
    /// The same of a game that was explored and solved as a whole.
    #[must_use]
    pub fn unreduced(solved: &Solved<'_>) -> Self {
        let figures = solved.figures();
        Reduced {
            realizable: figures.realizable,
            representatives: solved.explored.store.len(),
            transitions: figures.transitions,
            figures: Some(figures.into()),
        }
    }
}

/// The figures of the whole game, which may be larger than any that could be explored.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
#[expect(missing_docs, reason = "the names are the definition; see the language reference")]
pub struct WholeFigures {
    pub states: u128,
    pub transitions: u128,
    pub system_states: u128,
    pub environment_states: u128,
    pub yielded_states: u128,
    pub idle_states: u128,
    pub winning_states: u128,
    pub assumption_sets: u128,
    pub guarantee_sets: u128,
}

impl From<Figures> for WholeFigures {
    fn from(figures: Figures) -> Self {
        WholeFigures {
            states: figures.states as u128,
            transitions: figures.transitions as u128,
            system_states: figures.system_states as u128,
            environment_states: figures.environment_states as u128,
            yielded_states: figures.yielded_states as u128,
            idle_states: figures.idle_states as u128,
            winning_states: figures.winning_states as u128,
            assumption_sets: figures.assumption_sets as u128,
            guarantee_sets: figures.guarantee_sets as u128,
        }
    }
}

/// Decides a specification up to symmetry.
///
/// # Errors
/// A mistake of the specification that a play reaches, with a shortest play, or a limit; [`Limits::states`] limits
/// representatives.
pub fn decide(
    spec: &Spec,
    semantics: Semantics,
    symmetry: &Symmetry,
    limits: &Limits,
    timings: &mut Timings,
) -> Result<Reduced, ExploreError> {
    let explore = || {
        let playout = Playout::new(spec, semantics);
        let mut playout = playout.map_err(|error| ExploreError::Play(error, Vec::new()))?;
        explore::explore(&mut playout, &symmetry.0, limits)
    };
    let explored = timings.stage("explore", explore)?;
    let game = &explored.game;
    timings.size(Size {
        states: explored.representatives.len(),
        edges: Some(game.target.len()),
        of_states: Some(explored.memory),
        of_edges: Some(game.memory()),
    });
    let winning = timings.stage("solve", || solve::solve(game));
    timings.size(Size::of_nodes(winning.count_ones(..)));
    Ok(Reduced {
        realizable: winning.contains(0),
        representatives: explored.representatives.len(),
        transitions: game.target.len(),
        figures: figures(&explored, &winning),
    })
}

fn figures(explored: &Explored, winning: &FixedBitSet) -> Option<WholeFigures> {
    let Explored { representatives, game, guarantee_keys, assumption_keys, .. } = explored;
    let mut figures = WholeFigures {
        assumption_sets: *assumption_keys as u128,
        guarantee_sets: *guarantee_keys as u128 + 1,
        ..WholeFigures::default()
    };
    for (state, &turn) in game.turn.iter().enumerate() {
        let representative = representatives.get(state);
        // The losing and the won state stand for themselves.
        let orbit = representative.map_or(Some(1), |representative| representative.orbit)?;
        let edges = game.edges_of(state).len() as u128;
        let yielded = representative.is_some_and(|representative| representative.config.yielded);
        for (count, counts) in [
            (&mut figures.states, true),
            (&mut figures.system_states, turn.is_system()),
            (&mut figures.environment_states, turn.is_environment()),
            (&mut figures.yielded_states, yielded),
            (&mut figures.idle_states, turn.is_environment() && edges == 0),
            (&mut figures.winning_states, winning.contains(state)),
        ] {
            *count = count.checked_add(if counts { orbit } else { 0 })?;
        }
        figures.transitions = figures.transitions.checked_add(orbit.checked_mul(edges)?)?;
    }
    Some(figures)
}

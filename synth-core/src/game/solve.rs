//! Solving the GR(1) game: from which states the system can win, and by which moves.
//!
//! With `A_i` and `G_j` for "the play is fair to that key" the system wants `(A_1 ∧ … ∧ A_m) → (G_1 ∧ … ∧ G_n)`
//! without ever entering [`Turn::Lost`](super::Turn::Lost). It wins exactly from the largest region `R`
//!
//! 1. that the environment cannot leave and in which the system can stay ([`Region`] keeps it so), and
//! 2. from all of whose states, for every `j`, the system can force, inside `R`, that `G_j` is accepted once more or
//!    that some `A_i` is never accepted again ([`Pursuit`] decides it).
//!
//! *Winning*: pursue the `G_j` in turn; either all are accepted again and again, or one pursuit never ends, and then
//! some `A_i` is accepted only finitely often. *Largest*: where `Pursuit` leaves a set `W` over, the environment can
//! stay in `W` or be let out of `R`, accepting every `A_i` again and again but `G_j` never; so it wins from `W`
//! and from all states from which it can force the play to `W`. Removing these until nothing is left to remove gives
//! the greatest fixed point of Bloem, Jobstmann, Piterman, Pnueli and Sa'ar, "Synthesis of Reactive(1) Designs"
//! (2012), by removal rather than by iteration, as Chatterjee, Dvořák, Henzinger and Loitzenbauer do in
//! "Conditionally Optimal Algorithms for Generalized Büchi Games" (2016).

use super::{Game, acceptance::Acceptance, predecessors::Predecessors, pursuit::Pursuit, region::Region};
use crate::parallel::take_turns;
use fixedbitset::FixedBitSet;

/// Who wins where, and the moves by which the system does.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Solution {
    /// The states from which the system wins.
    pub winning: FixedBitSet,
    /// Per goal (the guarantees, then the one that super steps end): the edges of system states that make progress
    /// towards it. A winning system state in which the goal's key is open has one at least, others have none.
    pub(super) progress: Vec<FixedBitSet>,
    /// Per winning system state: how many system choices the rest of the super step takes at least.
    pub(super) remaining: Vec<u32>,
    /// Super steps end whatever becomes of the assumptions.
    pub(super) ending: bool,
}

impl Solution {
    /// Whether the system wins from `state`.
    #[must_use]
    pub fn wins(&self, state: u32) -> bool {
        self.winning.contains(state as usize)
    }

    /// Number of states from which the system wins.
    #[must_use]
    pub fn winning_states(&self) -> usize {
        self.winning.count_ones(..)
    }
}

/// Solves the game, on one thread.
///
/// Time is that of a few passes over the edges for each goal in practice, and quadratic in the number of states at
/// worst. Memory beside the game: ten `u32` for a state, two for an edge, one bit for each pair of a key and a
/// state and of a goal and an edge.
#[must_use]
pub fn solve(game: &Game) -> Solution {
    solve_for(game, false, 1)
}

/// As [`solve`], on so many threads, of which more than four have nothing to do; the result does not depend on it. Each takes eight
/// `u32` for a state.
///
/// # Panics
///
/// If there are no threads.
#[must_use]
pub fn solve_on(game: &Game, threads: usize) -> Solution {
    assert!(threads > 0, "somebody has to do it");
    solve_for(game, false, threads)
}

/// Solves the game for a system that wants more: that every super step ends, in plays that are not fair to the
/// assumptions, too.
///
/// By the winning condition alone a super step without end can be won, since it keeps the environment from meeting an
/// assumption; but no controller can do it. A system that wins here needs none. Where it does not, it wins [`solve`]
/// only by super steps without end.
#[must_use]
pub fn solve_ending(game: &Game) -> Solution {
    solve_for(game, true, 1)
}

fn solve_for(game: &Game, ending: bool, threads: usize) -> Solution {
    let predecessors = Predecessors::new(game);
    let assumptions = Acceptance::assumptions(game);
    let goals = Acceptance::goals(game);
    let mut region = Region::new(game, &predecessors);
    let super_steps = goals.len() - 1;
    // What may be avoided instead of meeting a goal.
    let avoidable = |goal: usize| if ending && goal == super_steps { &[] } else { assumptions.as_slice() };
    let mut progress = vec![FixedBitSet::new(); goals.len()];
    let mut settled = vec![false; goals.len()];
    let mut next = 0;
    let mut places: Vec<Place<'_>> = Vec::new();
    loop {
        let rotation = (next..goals.len()).chain(0..next).filter(|&goal| !settled[goal]);
        let together: Vec<usize> = rotation.take(TOGETHER).collect();
        let Some(last) = together.last() else { break };
        next = (last + 1) % goals.len();
        take_turns(&mut places, together.len(), threads, |place, index| {
            let goal = together[index];
            let pursuit = place.pursuit.get_or_insert_with(|| Pursuit::new(game, &predecessors, ending));
            place.last = Some(goal);
            let mut progress = FixedBitSet::new();
            let left = pursuit.run(&goals[goal], avoidable(goal), &region.states, &mut progress);
            place.lost.grow(game.states());
            place.lost.union_with(left);
            place.progress.push((goal, progress));
        });
        let mut lost = FixedBitSet::with_capacity(game.states());
        for place in &mut places {
            lost.union_with(&place.lost);
            place.lost.clear();
            for (goal, found) in place.progress.drain(..) {
                (progress[goal], settled[goal]) = (found, true);
            }
        }
        if lost.is_clear() {
            continue;
        }
        region.remove(game, &predecessors, &lost);
        places.iter_mut().for_each(|place| place.last = None);
        for ((goal, progress), settled) in goals.iter().zip(&progress).zip(&mut settled) {
            *settled = *settled && keeps_progress(game, &predecessors, &region, goal, progress);
        }
    }
    let found = places.iter().position(|place| place.last == Some(super_steps));
    let pursuit = places.swap_remove(found.unwrap_or(0)).pursuit;
    let mut pursuit = pursuit.unwrap_or_else(|| Pursuit::new(game, &predecessors, ending));
    if found.is_none() {
        let progress = &mut progress[super_steps];
        pursuit.run(&goals[super_steps], avoidable(super_steps), &region.states, progress);
    }
    let remaining = pursuit.into_ranks();
    Solution { winning: region.states, progress, remaining, ending }
}

/// So many goals are pursued in the same region, whatever the number of threads, before what they lose is removed. What one of them loses is
/// lost in a smaller region, too.
const TOGETHER: usize = 4;

/// Where a thread pursues goals.
#[derive(Default)]
struct Place<'g> {
    pursuit: Option<Pursuit<'g>>,
    /// The goal that was pursued last, if nothing has been removed from the region since.
    last: Option<usize>,
    /// The states that its goals have lost.
    lost: FixedBitSet,
    /// The progress towards its goals.
    progress: Vec<(usize, FixedBitSet)>,
}

/// Whether what a pursuit found out still holds after the last removal from the region.
///
/// It does if all states that it found to be good and that are still there can still make progress. The moves of the
/// environment need no look: they all remain, and lead to good states.
fn keeps_progress(
    game: &Game,
    predecessors: &Predecessors,
    region: &Region,
    goal: &Acceptance,
    progress: &FixedBitSet,
) -> bool {
    let stays = |edge: usize| region.states.contains(game.target[edge] as usize);
    region.removed.iter().flat_map(|&state| predecessors.of(state)).all(|incoming| {
        let source = incoming.source as usize;
        !game.turn[source].is_system()
            || !region.states.contains(source)
            || !goal.open.contains(source)
            || game.edges_of(incoming.source).any(|edge| progress.contains(edge) && stays(edge))
    })
}

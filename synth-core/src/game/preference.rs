//! Which of the moves that win the system prefers.

use super::{Game, Solution, YIELD};

/// Chooses among moves that win.
#[derive(Clone, Copy)]
pub(super) struct Preference<'a> {
    pub(super) game: &'a Game,
    pub(super) solution: &'a Solution,
}

impl Preference<'_> {
    /// Replaces `candidates` by the moves that win.
    pub(super) fn collect_candidates(self, state: u32, candidates: &mut Vec<usize>) {
        candidates.clear();
        let wins = |&edge: &usize| self.solution.wins(self.game.target[edge]);
        candidates.extend(self.game.edges_of(state).filter(wins));
    }

    /// By an order of the goals: the candidates that make progress towards the first, of these those for the second, and so on.
    pub(super) fn choose(self, order: &[usize], candidates: &mut Vec<usize>) -> Option<usize> {
        for &goal in order {
            if candidates.len() < 2 {
                break;
            }
            let progress = &self.solution.progress[goal];
            if candidates.iter().any(|&edge| progress.contains(edge)) {
                candidates.retain(|&edge| progress.contains(edge));
            }
        }
        // The shorter super step; of these a yield, which sends nothing; of the others the smaller text.
        candidates.iter().copied().min_by_key(|&edge| {
            let target = self.game.target[edge];
            let system = self.game.turn[target as usize].is_system();
            let remaining = if system { self.solution.remaining[target as usize] } else { 0 };
            (remaining, self.game.label(edge) != YIELD, edge)
        })
    }
}

//! What is counted of states and their moves.

use crate::game::Turn;
use crate::successors::{PackedMoves, Successors};

/// Counts of states whose moves are known.
#[derive(Clone, Debug, Default)]
pub(super) struct Counts {
    pub(super) transitions: u64,
    pub(super) system: u64,
    pub(super) environment: u64,
    pub(super) yielded: u64,
    pub(super) idle: u64,
    /// Some edge leads to the losing state, or to the won one.
    pub(super) lost: bool,
    pub(super) won: bool,
    /// Keys that are open somewhere, a bit for each.
    pub(super) open: Vec<u64>,
}

impl Counts {
    /// Counts a state, and appends the rows that it leads to.
    pub(super) fn add(
        &mut self,
        successors: &Successors,
        row: &[u64],
        moves: &PackedMoves,
        rows: &mut Vec<u64>,
    ) {
        let edges = moves.edges();
        self.transitions += edges.len() as u64;
        self.yielded += u64::from(successors.yielded(row));
        if moves.turn.is_system() {
            self.system += 1;
        } else {
            self.environment += 1;
            self.idle += u64::from(edges.is_empty());
        }
        successors.open_too(row, &mut self.open);
        for edge in edges {
            match edge.end {
                None => rows.extend_from_slice(moves.target(edge)),
                Some(Turn::Won) => self.won = true,
                Some(_) => self.lost = true,
            }
        }
    }

    /// Adds what was counted elsewhere.
    pub(super) fn join(&mut self, other: &Counts) {
        self.transitions += other.transitions;
        self.system += other.system;
        self.environment += other.environment;
        self.yielded += other.yielded;
        self.idle += other.idle;
        self.lost |= other.lost;
        self.won |= other.won;
        self.open.resize(self.open.len().max(other.open.len()), 0);
        self.open.iter_mut().zip(&other.open).for_each(|(all, one)| *all |= one);
    }

    pub(super) fn clear(&mut self) {
        *self = Counts::default();
    }
}

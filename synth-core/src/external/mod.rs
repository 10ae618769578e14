//! Exploration beyond memory: all reachable states, counted, with files for what does not fit.
//!
//! It is breadth first, by layers of states that are equally far from the initial one, and finds out late what was known
//! before: the rows that a layer leads to are collected, sorted (`order`) and written in runs (`segment`) as large as memory
//! allows; when the layer is expanded the runs are merged (`merge`), and what is left after all earlier states (`visited`)
//! were taken away is the next layer. A table of rows that were found lately (`recent`) keeps most duplicates from being
//! written at all. States found so far are kept in a few files whose lengths at least double, so each state is
//! written a logarithmic number of times; blocks in which nothing is looked for are not read.
//!
//! The successor function is the one of [`explore`](crate::explore), on several threads (`expand`). What it does not know is
//! learned in the order of the rows (`tables`), batches have a fixed length, and a layer's order is that of its rows.
//! So neither threads nor memory nor interruptions show in what is found, not even in file contents at the end of a
//! layer. Layers are kept: a mistake of the specification is shown with a shortest play to it, which is looked for
//! backwards.
//!
//! A `checkpoint` names the files that hold what was found, counted and learned. It is replaced, never changed, after the files
//! that it names are safe, and files that it names are removed only after it was replaced. So an exploration that was stopped,
//! or ended by whatever else, goes on from the last one.

mod bytes;
mod checkpoint;
mod counts;
mod error;
mod expand;
mod folder;
mod merge;
mod order;
mod recent;
mod search;
mod segment;
mod tables;
mod visited;

pub use checkpoint::Origin;
pub use error::{ExternalError, Progress};

use crate::explore::{ExploreError, Limits};
use crate::model::{Kind, Spec};
use crate::playout::{Playout, Semantics};
use search::Search;
use std::path::Path;

/// How large the explored game is; counted as in [`Figures`](crate::pipeline::Figures).
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
#[expect(missing_docs, reason = "the names are the definition; see the language reference")]
pub struct Census {
    pub states: u64,
    pub transitions: u64,
    pub system_states: u64,
    pub environment_states: u64,
    pub yielded_states: u64,
    pub idle_states: u64,
    pub assumption_sets: u64,
    pub guarantee_sets: u64,
    /// The most steps that a state is away from the initial one, at least.
    pub depth: u64,
    /// Words of 64 bits that a packed state has.
    pub words: usize,
    /// Bytes of the files that hold the states.
    pub bytes: u64,
}

impl Census {
    /// About how many bytes it takes to explore and to solve the game in memory.
    #[must_use]
    pub fn memory_to_solve(&self) -> u64 {
        // Row, index and graph; predecessors, ranks and choices of the solver; a bit for each key. Of an edge: graph and
        // predecessors, and a bit for each goal.
        let of_state =
            8 * self.words as u64 + 6 + 10 + 32 + (self.assumption_sets + self.guarantee_sets) / 8 + 1;
        let of_edge = 8 + 8 + self.guarantee_sets / 8 + 1;
        // Vectors that grow are not quite full.
        (self.states * of_state + self.transitions * of_edge) / 8 * 9
    }
}

/// How much is held in memory, and for how long. No result depends on it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Budget {
    /// Bytes of rows that are remembered to know them again.
    pub recent: usize,
    /// Bytes of rows that are sorted at once.
    pub candidates: usize,
    /// States that are explored between two checkpoints.
    pub checkpoint: u64,
}

impl Budget {
    /// For so many bytes of memory. No more than pays is used, and a vector that grows may hold twice as much as it needs.
    #[must_use]
    pub fn of(memory: usize) -> Budget {
        let most = 1 << 30;
        Budget { recent: (memory / 4).min(most), candidates: (memory / 8).min(most), checkpoint: 1 << 22 }
    }

    /// Rows of so many words that are remembered at most.
    fn recent(self, words: usize) -> usize {
        self.recent / (words * size_of::<u64>())
    }
}

/// What is explored where.
pub struct Task<'t> {
    /// Made if need be. Nobody else may use it meanwhile.
    pub folder: &'t Path,
    /// Which exploration it is. If it was begun in the folder, it is gone on with; if it was finished there, its results are
    /// returned.
    pub origin: &'t Origin,
    /// How much is held in memory.
    pub budget: Budget,
    /// Asked now and then whether to stop.
    pub stop: &'t dyn Fn() -> bool,
}

/// Explores a specification with files in a folder. The limit of memory is for what is held in memory: the budget, and what is
/// known of steps.
///
/// # Errors
/// See [`ExternalError`].
pub fn explore(
    spec: &Spec,
    semantics: Semantics,
    limits: &Limits,
    task: &Task<'_>,
) -> Result<Census, ExternalError> {
    let playout = Playout::new(spec, semantics);
    let mut playout =
        playout.map_err(|error| ExternalError::Explore(ExploreError::Play(error, Vec::new())))?;
    let mut search = Search::open(&mut playout, limits, task)?;
    search.run()?;
    let (words, bytes) = search.size();
    let counts = &search.standing.counts;
    Ok(Census {
        states: search.standing.states(),
        transitions: counts.transitions,
        system_states: counts.system,
        environment_states: counts.environment,
        yielded_states: counts.yielded,
        idle_states: counts.idle,
        assumption_sets: search.open_keys(Kind::Assumption) as u64,
        guarantee_sets: search.open_keys(Kind::Guarantee) as u64 + 1,
        depth: search.standing.layers.len() as u64 - 1,
        words,
        bytes,
    })
}

//! The states found so far, packed to bits, with the function that finds their successors.

use super::moves::Miss;
use super::{Learned, PackedMoves, PackedRows, SetId, Successors, UNKNOWN_SET, hash_row, learn};
use crate::model::Value;
use crate::playout::{Config, CopyId, EventId, KeyId, PlayError, Playout};

/// Index of a state, in order of discovery.
pub type StateId = u32;

/// All states found so far. When a field of their rows becomes too narrow, all of them are packed anew, which happens
/// about as often as there are bits in a row.
#[derive(Debug)]
pub struct StateStore {
    pub(crate) successors: Successors,
    pub(crate) rows: PackedRows,
}

impl StateStore {
    /// Holds one state, with id 0.
    #[must_use]
    pub fn new(playout: &Playout<'_>, initial: &Config) -> Self {
        let mut successors = Successors::new(playout);
        let row = successors.pack_first(playout, initial);
        let mut rows = PackedRows::new(successors.layout().bytes(), 0);
        rows.intern(hash_row(&row), &row);
        StateStore { successors, rows }
    }

    /// Number of states; ids are below it.
    #[must_use]
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Never: there is an initial state.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Bytes held.
    #[must_use]
    pub fn memory(&self) -> usize {
        self.rows.memory() + self.successors.memory()
    }

    /// Bits that carry information in a row.
    #[must_use]
    pub fn bits(&self) -> u32 {
        self.successors.layout().bits()
    }

    /// Unpacks a state that was found in this play-out.
    pub fn load(&self, playout: &mut Playout<'_>, state: StateId, config: &mut Config) {
        let mut row = Vec::new();
        let row = self.rows.get(state, &mut row);
        self.successors.load(playout, row, &mut Vec::new(), config);
    }

    /// Whether the system has yielded since the last event.
    #[must_use]
    pub fn yielded(&self, state: StateId) -> bool {
        self.successors.yielded(self.rows.get(state, &mut Vec::new()))
    }

    /// The copies of a state, ascending, into a cleared list.
    pub fn copies(&self, state: StateId, copies: &mut Vec<CopyId>) {
        copies.clear();
        self.successors.copies(self.rows.get(state, &mut Vec::new()), copies);
    }

    /// The values of all attributes in a state, by slot, into a cleared list.
    pub fn values(&self, playout: &Playout<'_>, state: StateId, values: &mut Vec<Value>) {
        self.successors.values(playout, self.rows.get(state, &mut Vec::new()), values);
    }

    /// Finds the moves of a state.
    ///
    /// # Errors
    /// Those of [`Playout::moves`].
    pub fn moves(
        &mut self,
        playout: &mut Playout<'_>,
        state: StateId,
        out: &mut PackedMoves,
    ) -> Result<(), (Option<EventId>, PlayError)> {
        let mut narrow = Vec::new();
        let mut row = Vec::new();
        while self.successors.moves(self.rows.get(state, &mut row), out).is_err() {
            if self.learn(playout, state, &mut narrow, out)? == Learned::Moves {
                break;
            }
            self.widen(&narrow);
            narrow.clear();
        }
        if out.open == UNKNOWN_SET {
            out.open = self.successors.open_set(self.rows.get(state, &mut row));
        }
        Ok(())
    }

    /// What [`Playout::owed`] gives for a state that was found in this play-out.
    pub(crate) fn owed(&self, playout: &mut Playout<'_>, state: StateId) -> Vec<EventId> {
        let mut config = Config::default();
        self.load(playout, state, &mut config);
        playout.owed(&config)
    }

    /// The same without a play-out, into a cleared list; `row` is overwritten.
    ///
    /// # Errors
    /// What it follows from is not known.
    pub(crate) fn known_owed(
        &self,
        state: StateId,
        row: &mut Vec<u64>,
        owed: &mut Vec<EventId>,
    ) -> Result<(), Miss> {
        self.successors.owed(self.rows.get(state, row), owed)
    }

    /// How many sets of fairness keys were met so far; ids are below it.
    #[must_use]
    pub fn sets(&self) -> SetId {
        self.successors.key_sets().len() as SetId
    }

    /// The fairness keys of a set that moves name, ascending.
    pub fn keys(&self, set: SetId) -> impl Iterator<Item = KeyId> + Clone + use<'_> {
        self.successors.key_sets().members(set)
    }

    /// Whether a fairness key is in a set that moves name.
    #[must_use]
    pub fn contains(&self, set: SetId, key: KeyId) -> bool {
        self.successors.key_sets().contains(set, key)
    }

    /// Finds the moves of a state and keeps what they follow from, unless rows have no room for `narrow`.
    ///
    /// # Errors
    /// Those of [`Playout::moves`].
    pub(crate) fn learn(
        &mut self,
        playout: &mut Playout<'_>,
        state: StateId,
        narrow: &mut Vec<(u32, u32)>,
        out: &mut PackedMoves,
    ) -> Result<Learned, (Option<EventId>, PlayError)> {
        learn(&mut self.successors, playout, self.rows.get(state, &mut Vec::new()), narrow, out)
    }

    /// The id of a state that a move leads to, new or not.
    pub fn intern(&mut self, row: &[u64]) -> StateId {
        self.rows.intern(hash_row(row), row)
    }

    /// Keeps these states, numbered anew in this order.
    pub(crate) fn select(&mut self, states: &[StateId]) {
        self.rows = self.rows.selected(states);
    }

    /// Gives up what only new states take.
    pub(crate) fn close(&mut self) {
        self.rows.close();
    }

    /// Packs all rows anew, with room for these values of fields.
    pub(crate) fn widen(&mut self, narrow: &[(u32, u32)]) {
        let layout = self.successors.widened(narrow);
        let empty = PackedRows::new(layout.bytes(), 0);
        let rows = std::mem::replace(&mut self.rows, empty);
        self.rows = rows.converted(self.successors.layout(), &layout);
        self.successors.set_layout(layout);
    }
}

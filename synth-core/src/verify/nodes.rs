//! The nodes of the product found so far, packed.

use crate::intern::Rows;
use crate::playout::{Config, EventId, KeyId, PlayError, Playout};
use crate::successors::{Learned, PackedMoves, SetId, Successors, learn};

/// Where a controller is: its state, and the next event of the super step that is due there.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Control {
    pub(super) state: u32,
    pub(super) position: u32,
}

impl Control {
    pub(super) fn word(self) -> u64 {
        u64::from(self.state) << 32 | u64::from(self.position)
    }

    fn of_word(word: u64) -> Self {
        Control { state: (word >> 32) as u32, position: word as u32 }
    }
}

/// A node's row is that of its state of the specification, with one more word for the controller.
pub(super) struct Nodes {
    pub(super) successors: Successors,
    rows: Rows<u64>,
}

impl Nodes {
    /// Holds the initial node, which is 0.
    pub(super) fn new(playout: &Playout<'_>, config: &Config, control: Control) -> Self {
        let mut successors = Successors::new(playout);
        let mut row = successors.pack_first(playout, config);
        row.push(control.word());
        let mut rows = Rows::new(row.len());
        rows.intern(&row);
        Nodes { successors, rows }
    }

    pub(super) fn len(&self) -> usize {
        self.rows.len()
    }

    /// Words of a row.
    pub(super) fn words(&self) -> usize {
        self.rows.width()
    }

    /// The row of the state, and where the controller is.
    pub(super) fn get(&self, node: u32) -> (&[u64], Control) {
        let (control, state) = self.rows.get(node).split_last().unwrap_or((&0, &[]));
        (state, Control::of_word(*control))
    }

    /// The node with this row, if it is known.
    pub(super) fn find(&self, row: &[u64]) -> Option<u32> {
        self.rows.find(row)
    }

    /// The node with this row, new or not.
    pub(super) fn intern(&mut self, row: &[u64]) -> u32 {
        self.rows.intern(row)
    }

    /// The moves of a node's state, asked of play-out where the tables do not give them. Values that rows have no room for are
    /// appended to `narrow`; then the moves are not known yet.
    pub(super) fn learn(
        &mut self,
        playout: &mut Playout<'_>,
        node: u32,
        narrow: &mut Vec<(u32, u32)>,
        moves: &mut PackedMoves,
    ) -> Result<Learned, (Option<EventId>, PlayError)> {
        let words = self.words();
        let row = &self.rows.get(node)[..words - 1];
        learn(&mut self.successors, playout, row, narrow, moves)
    }

    /// The keys of a set, ascending.
    pub(super) fn keys(&self, set: SetId) -> impl Iterator<Item = KeyId> + use<'_> {
        self.successors.key_sets().members(set)
    }

    /// The set of the keys that are open in a node.
    pub(super) fn open_keys(&mut self, node: u32) -> SetId {
        let words = self.words();
        self.successors.open_set(&self.rows.get(node)[..words - 1])
    }

    /// Packs all rows anew, with room for these values of fields.
    pub(super) fn widen(&mut self, narrow: &[(u32, u32)]) {
        let old = self.successors.layout().clone();
        let layout = self.successors.widened(narrow);
        let mut rows = Rows::new(layout.words() + 1);
        let mut row = Vec::new();
        for node in 0..self.len() as u32 {
            let (state, control) = self.get(node);
            row.clear();
            row.resize(layout.words(), 0);
            layout.convert(&old, state, &mut row);
            row.push(control.word());
            rows.intern(&row);
        }
        self.rows = rows;
        self.successors.set_layout(layout);
    }
}

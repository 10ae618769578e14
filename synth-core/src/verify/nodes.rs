//! The nodes of the product found so far, packed.

use crate::playout::{Config, EventId, KeyId, PlayError, Playout};
use crate::successors::{Known, Learned, PackedMoves, PackedRows, SetId, Successors, hash_row, learn};

/// Where a controller is: its state, and the next event of the super step that is due there.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Control {
    pub(super) state: u32,
    pub(super) position: u32,
}

/// A node's row is that of its state of the specification, with one more word for the controller, of which no more bytes are
/// held than controllers like this take.
pub(super) struct Nodes {
    pub(super) successors: Successors,
    pub(super) rows: PackedRows,
    /// The bits of the last word that hold the controller's state; the position is above them.
    state_bits: u32,
}

/// Bits of numbers up to this one.
fn bits(most: u32) -> u32 {
    u32::BITS - most.leading_zeros()
}

impl Nodes {
    /// Holds the initial node, which is 0. No controller's state and position are beyond those of `most`.
    pub(super) fn new(playout: &Playout<'_>, config: &Config, control: Control, most: Control) -> Self {
        let mut successors = Successors::new(playout);
        let mut row = successors.pack_first(playout, config);
        let state_bits = bits(most.state);
        let tail = (state_bits + bits(most.position)).div_ceil(u8::BITS).max(1);
        let rows = PackedRows::new(successors.layout().bytes(), tail as usize);
        let mut nodes = Nodes { successors, rows, state_bits };
        row.push(nodes.word(control));
        nodes.rows.intern(hash_row(&row), &row);
        nodes
    }

    pub(super) fn len(&self) -> usize {
        self.rows.len()
    }

    /// The last word of a node's row.
    pub(super) fn word(&self, control: Control) -> u64 {
        u64::from(control.position) << self.state_bits | u64::from(control.state)
    }

    /// The row of the state, and where the controller is.
    pub(super) fn get<'r>(&self, node: u32, row: &'r mut Vec<u64>) -> (&'r [u64], Control) {
        let (&word, state) = self.rows.get(node, row).split_last().unwrap_or((&0, &[]));
        let position = word >> self.state_bits;
        let control = word ^ position << self.state_bits;
        (state, Control { state: control as u32, position: position as u32 })
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
        let mut row = Vec::new();
        let (state, _) = self.get(node, &mut row);
        learn(&mut self.successors, playout, state, narrow, moves)
    }

    /// The keys of a set, ascending.
    pub(super) fn keys(&self, set: SetId) -> impl Iterator<Item = KeyId> + use<'_> {
        self.successors.key_sets().members(set)
    }

    /// What has numbers by now.
    pub(super) fn known(&self) -> Known<'_> {
        Known { rows: &self.rows, sets: self.successors.key_sets_builder() }
    }

    /// Packs all rows anew, with room for these values of fields.
    pub(super) fn widen(&mut self, narrow: &[(u32, u32)]) {
        let layout = self.successors.widened(narrow);
        let rows = std::mem::replace(&mut self.rows, PackedRows::new(0, 0));
        self.rows = rows.converted(self.successors.layout(), &layout);
        self.successors.set_layout(layout);
    }
}

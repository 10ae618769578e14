//! The successor function on packed states: what [`Playout`](crate::playout::Playout) says of a state, without walking anything.
//!
//! A row has one field for each attribute that effects can change, one bit for `yielded`, and one field for every
//! *slot*: the copies of one scenario with one role binding (`groups`). Fields hold small numbers, and what play-out would
//! compute is kept by these: what an event does to a group of copies, what it starts and assigns, what a group asks for.
//! Where the attributes matter, a decision tree (`trees`) tests those that play-out looked at, in the order in which it
//! did, so that the number of results does not grow with the number of valuations. `moves` puts the results
//! together, exactly as [`Playout::moves`](crate::playout::Playout::moves) does.
//!
//! Most events concern few slots (`concerns`). A group that an event does not concern can only be let go on by new values of
//! attributes, whatever the event is, so there is one tree for all these events; and since the copies of a state have
//! settled under its attributes, nobody looks at it unless an attribute changes.
//!
//! Finding the moves is a pure function of a row and these tables. It may find that something is not known yet; then
//! `learn` asks play-out, whose results are the definition. Mistakes of a specification are never tabulated:
//! where one might show, play-out plays the state.

mod block;
mod concerns;
mod groups;
mod layout;
mod learn;
mod moves;
mod rows;
mod sets;
mod store;
mod tables;
mod trees;
mod wishes;

pub(crate) use block::{Block, Found, Head, InOrder, Known, Reader, next_batch};
pub(crate) use layout::Layout;
pub(crate) use learn::{Learned, learn};
pub use moves::{Edge, PackedMoves};
pub(crate) use rows::{PackedRows, hash_row, reserve};
pub use sets::SetId;
pub use store::{StateId, StateStore};
pub(crate) use tables::Successors;

/// Stands for a set of keys that has no number yet.
pub(crate) const UNKNOWN_SET: SetId = SetId::MAX;

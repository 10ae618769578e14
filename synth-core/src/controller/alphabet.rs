//! The events behind a game's edge labels.

use super::Event;

/// An event of the alphabet and the side it belongs to.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Letter {
    /// The event.
    pub event: Event,
    /// Sent by the system.
    pub controllable: bool,
    /// A system event whose receiver is not controllable: it is a command to that component.
    pub commands: bool,
}

/// Events by the ids that label a game's edges; not every one need occur on an edge.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Alphabet {
    /// Indexed by event id.
    pub letters: Vec<Letter>,
}

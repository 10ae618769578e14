//! What edges carry, interned: few different pairs of an event and the keys that it discharges, shared by many edges.

use crate::intern::Indexed;

/// All distinct actions.
#[derive(Clone, Debug, Default)]
pub struct Actions {
    label: Vec<u32>,
    discharged: Vec<u32>,
}

impl Actions {
    /// Number of actions; ids are below it.
    #[must_use]
    pub fn len(&self) -> usize {
        self.label.len()
    }

    /// Whether there is none: no edge was met.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.label.is_empty()
    }

    /// Event id or [`YIELD`](super::YIELD).
    #[must_use]
    pub fn label(&self, action: u32) -> u32 {
        self.label[action as usize]
    }

    /// The labels of all actions, with repetitions.
    pub fn labels(&self) -> impl Iterator<Item = u32> {
        self.label.iter().copied()
    }

    /// The set (of [`Game::key_sets`](super::Game::key_sets)) of keys that are discharged.
    #[must_use]
    pub fn discharged(&self, action: u32) -> u32 {
        self.discharged[action as usize]
    }

    /// The sets of keys of all actions, with repetitions.
    pub fn discharged_sets(&self) -> impl Iterator<Item = u32> {
        self.discharged.iter().copied()
    }
}

/// Collects actions while a game is explored.
#[derive(Debug, Default)]
pub struct ActionsBuilder(Indexed<(u32, u32)>);

impl ActionsBuilder {
    /// The id of an action.
    pub fn intern(&mut self, label: u32, discharged: u32) -> u32 {
        self.0.intern((label, discharged)).0
    }

    /// The label of an action met before.
    #[must_use]
    pub fn label(&self, action: u32) -> u32 {
        self.0.get(action).0
    }

    /// The finished actions.
    #[must_use]
    pub fn finish(self) -> Actions {
        self.actions()
    }

    /// The actions so far.
    #[must_use]
    pub fn actions(&self) -> Actions {
        let pairs = (0..self.0.len() as u32).map(|action| *self.0.get(action));
        let (label, discharged) = pairs.unzip();
        Actions { label, discharged }
    }
}

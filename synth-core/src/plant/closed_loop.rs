//! The plant under its supremal controllable, nonblocking feedback.

use super::{AutomatonId, EventId, Plant};

/// All states that are reachable under the feedback, and what is enabled and inhibited in each.
///
/// *Entries*, as the states of a feedback are called, are in lexicographic order of their automata's states, those of the
/// components first.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ClosedLoop {
    /// States of the reachable product of the components, and its transitions; `None` if they are too many to be counted,
    /// which synthesis does not mind.
    pub plant: Option<(u64, u64)>,
    /// The same with the constraints: bad states are counted, with what leads to them, but not what lies behind them.
    pub constrained: (u64, u64),
    /// How many automata an entry has a state of.
    pub automata: usize,
    /// The states of entry `i` are at `automata * i..automata * (i + 1)`.
    pub states: Vec<u16>,
    /// The entry of the initial states.
    pub initial: u32,
    /// The edges of entry `i` are at `first[i]..first[i + 1]`; one more entry ends the last.
    pub first: Vec<u32>,
    /// Events, ascending in an entry, and the entries that they lead to.
    pub edges: Vec<(EventId, u32)>,
    /// What is inhibited in entry `i` is at `first_inhibited[i]..first_inhibited[i + 1]`.
    pub first_inhibited: Vec<u32>,
    /// Controllable events that the components allow and the feedback does not, ascending in an entry.
    pub inhibited: Vec<EventId>,
}

impl ClosedLoop {
    /// How many entries there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.first.len() - 1
    }

    /// Never: the initial state is an entry.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The states of an entry, one an automaton.
    #[must_use]
    pub fn entry(&self, entry: usize) -> &[u16] {
        &self.states[self.automata * entry..self.automata * (entry + 1)]
    }

    /// What can happen in an entry.
    #[must_use]
    pub fn edges(&self, entry: usize) -> &[(EventId, u32)] {
        &self.edges[self.first[entry] as usize..self.first[entry + 1] as usize]
    }

    /// What the feedback inhibits in an entry.
    #[must_use]
    pub fn inhibited(&self, entry: usize) -> &[EventId] {
        &self.inhibited[self.first_inhibited[entry] as usize..self.first_inhibited[entry + 1] as usize]
    }

    /// The constraint automata that carry memory, ascending: those whose state differs in entries in which all components
    /// are in the same states.
    #[must_use]
    pub fn memory(&self, plant: &Plant) -> Vec<AutomatonId> {
        let components = |entry: usize| &self.entry(entry)[..plant.components];
        let mut remembers = vec![false; self.automata];
        // In lexicographic order, entries with the same states of components are neighbours.
        for entry in (1..self.len()).filter(|&entry| components(entry - 1) == components(entry)) {
            let states = self.entry(entry - 1).iter().zip(self.entry(entry));
            for (remembers, (before, after)) in remembers.iter_mut().zip(states) {
                *remembers |= before != after;
            }
        }
        (0..self.automata as AutomatonId).filter(|&automaton| remembers[automaton as usize]).collect()
    }
}

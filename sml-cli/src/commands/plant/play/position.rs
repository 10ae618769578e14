//! Where a play of a closed loop is.

use synth_core::plant::{AutomatonId, ClosedLoop, EventId, Plant, Synthesis};

/// An entry, and how the play came to it.
pub(super) struct Position<'a> {
    pub(super) plant: &'a Plant,
    pub(super) closed: &'a ClosedLoop,
    synthesis: &'a Synthesis<'a>,
    entry: usize,
    /// Events, and the entries in which they happened.
    past: Vec<(EventId, usize)>,
}

/// What becomes of an event.
pub(super) enum Verdict {
    /// It can happen.
    Enabled,
    /// The components allow it and the feedback does not, for this reason.
    Inhibited(String),
    /// These components know the event, and do not allow it; if there are none, no component knows it.
    Impossible(Vec<(AutomatonId, u32)>),
}

impl Verdict {
    /// As a sentence.
    pub(super) fn text(&self, event: EventId, plant: &Plant) -> String {
        let event = &plant.events[event as usize];
        let name = &event.name;
        match self {
            Verdict::Enabled if event.controllable => format!("the feedback enables `{name}`"),
            Verdict::Enabled => format!("`{name}` can happen by itself"),
            Verdict::Inhibited(why) => format!("`{name}` is inhibited: {why}"),
            Verdict::Impossible(by) if by.is_empty() => {
                format!("`{name}` never happens: it is on no edge of a component")
            }
            Verdict::Impossible(by) => {
                let states = by.iter().map(|&(automaton, state)| {
                    let automaton = &plant.automata[automaton as usize];
                    format!("`{}.{}`", automaton.name, automaton.states[state as usize].name)
                });
                format!("`{name}` is on no edge of {}", states.collect::<Vec<_>>().join(" and of "))
            }
        }
    }
}

impl<'a> Position<'a> {
    /// The initial entry.
    pub(super) fn new(plant: &'a Plant, closed: &'a ClosedLoop, synthesis: &'a Synthesis<'a>) -> Self {
        Position { plant, closed, synthesis, entry: closed.initial as usize, past: Vec::new() }
    }

    /// The states of all automata.
    pub(super) fn states(&self) -> &'a [u16] {
        self.closed.entry(self.entry)
    }

    /// What can happen.
    pub(super) fn enabled(&self) -> impl Iterator<Item = EventId> + 'a {
        self.closed.edges(self.entry).iter().map(|&(event, _)| event)
    }

    /// What the feedback inhibits.
    pub(super) fn inhibited(&self) -> &'a [EventId] {
        self.closed.inhibited(self.entry)
    }

    /// The events that have happened.
    pub(super) fn past(&self) -> impl Iterator<Item = EventId> {
        self.past.iter().map(|&(event, _)| event)
    }

    /// Lets an event happen, or says why it cannot.
    pub(super) fn step(&mut self, event: EventId) -> Result<(), Verdict> {
        let edge = self.closed.edges(self.entry).iter().find(|edge| edge.0 == event);
        let &(_, target) = edge.ok_or_else(|| self.verdict(event))?;
        self.past.push((event, self.entry));
        self.entry = target as usize;
        Ok(())
    }

    /// Takes events back; nothing is done unless so many have happened.
    pub(super) fn back(&mut self, events: usize) -> bool {
        let Some(left) = self.past.len().checked_sub(events) else { return false };
        if let Some(&(_, entry)) = self.past.get(left) {
            self.entry = entry;
        }
        self.past.truncate(left);
        true
    }

    /// What becomes of an event.
    pub(super) fn verdict(&self, event: EventId) -> Verdict {
        if self.enabled().any(|enabled| enabled == event) {
            return Verdict::Enabled;
        }
        if let Some(why) = self.synthesis.why(self.closed, self.entry, event) {
            return Verdict::Inhibited(why.text(self.plant));
        }
        let components = (0..).zip(&self.plant.automata[..self.plant.components]).zip(self.states());
        let without_edge = components.filter_map(|((id, automaton), &state)| {
            let knows = automaton.alphabet.binary_search(&event).is_ok();
            let allows = || automaton.states[state as usize].edges.iter().any(|edge| edge.event == event);
            (knows && !allows()).then_some((id, u32::from(state)))
        });
        Verdict::Impossible(without_edge.collect())
    }
}

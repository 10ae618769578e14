//! The controller, made ready for look-ups by what play-out calls its events.

use super::nodes::Control;
use crate::controller::{Controller, SuperStep};
use crate::playout::{EventId, Playout};
use rustc_hash::FxHashMap;

/// Stands for an event that the controller does not know.
const NONE: u32 = u32::MAX;

/// States whose rows are collected together.
const NEAR: usize = 1 << 10;

/// The controller by states.
pub(super) struct Machine<'a> {
    controller: &'a Controller,
    /// Offsets into `rows`, one more than there are states.
    first: Vec<u32>,
    /// Per state, ascending by event: the event's index and the target.
    rows: Vec<(u32, u32)>,
    /// Per state: its super step, or [`NONE`].
    due: Vec<u32>,
    events: FxHashMap<&'a str, u32>,
    commands: FxHashMap<&'a str, u32>,
    /// Per event of play-out: its index among the controller's events and commands.
    letters: Vec<(u32, u32)>,
    /// Per command: what play-out calls it, if it has met it.
    met: Vec<Option<EventId>>,
}

impl<'a> Machine<'a> {
    pub(super) fn new(controller: &'a Controller) -> Self {
        let states = controller.states as usize;
        let mut first = vec![0; states + 1];
        for &(source, _) in controller.environment.iter().flatten() {
            first[source as usize + 1] += 1;
        }
        for state in 0..states {
            first[state + 1] += first[state];
        }
        let mut next = first.clone();
        let mut rows = vec![(NONE, NONE); first[states] as usize];
        // So many states at a time that their rows stay near, whichever event they are of.
        let mut mappings: Vec<_> = controller.environment.iter().map(|mapping| mapping.iter()).collect();
        for end in (0..states + NEAR).step_by(NEAR).skip(1) {
            for (event, mapping) in (0..).zip(&mut mappings) {
                while let Some(&(source, target)) =
                    mapping.as_slice().first().filter(|row| (row.0 as usize) < end)
                {
                    mapping.next();
                    let place = &mut next[source as usize];
                    rows[*place as usize] = (event, target);
                    *place += 1;
                }
            }
        }
        let mut due = vec![NONE; states];
        for (index, step) in controller.super_steps.iter().enumerate() {
            due[step.source as usize] = index as u32;
        }
        let by_text = |events: &'a [crate::controller::Event]| {
            events.iter().enumerate().map(|(index, event)| (event.text.as_str(), index as u32)).collect()
        };
        let (events, commands) = (by_text(&controller.events), by_text(&controller.commands));
        let met = vec![None; controller.commands.len()];
        Machine { controller, first, rows, due, events, commands, letters: Vec::new(), met }
    }

    /// Takes note of events that play-out has met since.
    pub(super) fn keep_up(&mut self, playout: &Playout<'_>) {
        for event in self.letters.len()..playout.event_count() {
            let text = playout.event(event as EventId).text.as_str();
            let find = |by_text: &FxHashMap<&str, u32>| by_text.get(text).copied().unwrap_or(NONE);
            let (letter, command) = (find(&self.events), find(&self.commands));
            self.letters.push((letter, command));
            if let Some(met) = self.met.get_mut(command as usize) {
                *met = Some(event as EventId);
            }
        }
    }

    /// What no state and no position of the controller is beyond.
    pub(super) fn most(&self) -> Control {
        let lengths = self.controller.super_steps.iter().map(|step| step.events.len() as u32);
        let longest = lengths.max().unwrap_or(0);
        Control { state: self.controller.states.saturating_sub(1), position: longest.saturating_sub(1) }
    }

    /// The super step that is due in a state.
    pub(super) fn due(&self, state: u32) -> Option<SuperStep<'a>> {
        let row = self.due[state as usize];
        (row != NONE).then(|| self.controller.super_steps.row(row as usize))
    }

    /// The command that comes next, if one is due and play-out has met it.
    pub(super) fn next(&self, control: Control) -> Option<EventId> {
        let command = *self.due(control.state)?.events.get(control.position as usize)?;
        self.met[command as usize]
    }

    /// The events that a state accepts, to be asked for one after the other.
    pub(super) fn accepts(&self, state: u32) -> Accepts<'_> {
        Accepts { letters: &self.letters, rows: self.rows_of(state), next: 0 }
    }

    fn rows_of(&self, state: u32) -> &[(u32, u32)] {
        &self.rows[self.first[state as usize] as usize..self.first[state as usize + 1] as usize]
    }

    /// The text of the first event that a state accepts.
    pub(super) fn accepted(&self, state: u32) -> Option<&'a str> {
        let &(event, _) = self.rows_of(state).first()?;
        Some(&self.controller.events[event as usize].text)
    }

    pub(super) fn command_text(&self, command: u32) -> &'a str {
        &self.controller.commands[command as usize].text
    }

    /// Whether an event of play-out is this command.
    pub(super) fn is_command(&self, event: EventId, command: u32) -> bool {
        self.letters.get(event as usize).is_some_and(|&(_, letter)| letter == command)
    }
}

/// What a state accepts. Events mostly come in the order of their texts, as its rows do.
pub(super) struct Accepts<'m> {
    letters: &'m [(u32, u32)],
    rows: &'m [(u32, u32)],
    next: usize,
}

impl Accepts<'_> {
    /// The state behind an event of play-out, if the controller accepts it.
    pub(super) fn target(&mut self, event: EventId) -> Option<u32> {
        let &(wanted, _) = self.letters.get(event as usize)?;
        if self.rows.get(self.next).is_none_or(|&(event, _)| event != wanted) {
            self.next = self.rows.binary_search_by_key(&wanted, |&(event, _)| event).ok()?;
        }
        let (_, target) = self.rows[self.next];
        self.next += 1;
        Some(target)
    }
}

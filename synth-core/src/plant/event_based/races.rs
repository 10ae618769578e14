//! What a scan cannot tell: batches of events that are taken in another order than that in which they happened.
//!
//! A scan sees which events have come since the last one, not in which order. The controller takes them in table order,
//! round by round, as each fits. Mostly this comes to the same: events of different parts of a plant do not mind their
//! order, and one that is only possible after another waits for it. What is left are races, and they are found by trying:
//! from every entry, every batch that can happen, each event once.
//!
//! Uncontrollable events that share no automaton, not even through others, cannot race, so each group of those that do is
//! looked at alone, and the same states of its automata only once.

use super::super::{ClosedLoop, EventId, Plant};
use super::{choose, text};
use crate::diagnostic::{Code, Diagnostic};
use crate::intern::Indexed;
use crate::syntax::Span;
use std::collections::BTreeSet;

/// Events of one scan that the controller cannot follow.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Race {
    /// Where it begins.
    pub entry: u32,
    /// What happens, in this order. The controller takes it for something else. If the last is controllable, it is the
    /// command that the controller gives before it knows of the event in front of it, which is not possible behind it.
    pub events: Vec<EventId>,
}

impl Race {
    /// What it is about, in a sentence.
    #[must_use]
    pub fn text(&self, plant: &Plant) -> String {
        let name = |id: &EventId| format!("`{}`", plant.events[*id as usize].name);
        match &*self.events {
            [event, command] if plant.events[*command as usize].controllable => {
                format!("{}, seen only after {} was given, fits nowhere any more", name(event), name(command))
            }
            events => {
                let names: Vec<String> = events.iter().map(name).collect();
                format!("{} in this order in one scan are taken for something else", names.join(", "))
            }
        }
    }
}

impl Race {
    /// As a warning at the event by which it is noticed.
    fn diagnostic(&self, plant: &Plant, closed: &ClosedLoop) -> Diagnostic {
        let is_uncontrollable = |id: &&EventId| !plant.events[**id as usize].controllable;
        let span = self.events.iter().rfind(is_uncontrollable).map(|&id| plant.events[id as usize].span);
        let states = plant.state_names(closed.entry(self.entry as usize));
        Diagnostic::warning(Code::Race, span.unwrap_or_default(), self.text(plant))
            .note(format!("for example from {}", states.join(", ")))
            .help("see to it that they never come within one scan")
    }
}

/// The races of a closed loop.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Races {
    /// Shortest ones: of a race, nothing longer is told. Each list of events comes once, with an entry.
    pub found: Vec<Race>,
    /// Batches of so many events or more were not all tried, because they are too many; `None` if all were.
    pub untried: Option<usize>,
}

impl Races {
    /// As warnings, in the order of places.
    #[must_use]
    pub fn diagnostics(&self, plant: &Plant, closed: &ClosedLoop) -> Vec<Diagnostic> {
        let mut all: Vec<Diagnostic> = self.found.iter().map(|race| race.diagnostic(plant, closed)).collect();
        all.sort_by_key(|one| one.span.start);
        all.extend(self.untried.map(|size| {
            let message = format!("batches of {size} events or more a scan are too many to try all of them");
            Diagnostic::warning(Code::Race, Span::default(), message)
                .help("see to it that fewer events come within one scan")
        }));
        all
    }
}

/// So many batches of a group of events are tried.
const MOST_BATCHES: usize = 1 << 20;

/// Batches are bits.
const MOST_EVENTS: usize = u64::BITS as usize;

/// Finds the races.
#[must_use]
pub fn races(plant: &Plant, closed: &ClosedLoop) -> Races {
    let mut races = Races::default();
    for group in groups(plant) {
        Group::new(plant, group).try_all(closed, &mut races);
    }
    // What happens before the order matters is no part of the race.
    let all: BTreeSet<&[EventId]> = races.found.iter().map(|race| &*race.events).collect();
    let shortest = |race: &Race| !(1..race.events.len()).any(|from| all.contains(&race.events[from..]));
    let mut found: Vec<Race> = races.found.iter().filter(|race| shortest(race)).cloned().collect();
    found.extend(commands(plant, closed));
    Races { found, ..races }
}

/// Events that are not possible any more behind a command that may be given before they are seen.
fn commands(plant: &Plant, closed: &ClosedLoop) -> Vec<Race> {
    let mut told = BTreeSet::new();
    let mut found = Vec::new();
    for (entry, chosen) in choose(plant, closed).into_iter().enumerate() {
        let Some((command, target)) = chosen else { continue };
        for &(event, _) in
            closed.edges(entry).iter().filter(|edge| !plant.events[edge.0 as usize].controllable)
        {
            let later = closed.edges(target as usize).binary_search_by_key(&event, |edge| edge.0);
            if later.is_err() && told.insert((event, command)) {
                found.push(Race { entry: entry as u32, events: vec![event, command] });
            }
        }
    }
    found
}

/// The uncontrollable events that components name, in groups that share no automaton.
fn groups(plant: &Plant) -> Vec<Vec<EventId>> {
    let mut group: Vec<EventId> = (0..plant.events.len() as EventId).collect();
    let happens = |id: EventId| !plant.events[id as usize].controllable && text(plant, id).is_some();
    for automaton in &plant.automata {
        let mut shared = automaton.alphabet.iter().copied().filter(|&id| happens(id));
        let Some(first) = shared.next() else { continue };
        for id in shared {
            let (from, to) = (group[id as usize], group[first as usize]);
            group.iter_mut().filter(|group| **group == from).for_each(|group| *group = to);
        }
    }
    let all: Vec<EventId> = (0..plant.events.len() as EventId).filter(|&id| happens(id)).collect();
    let leaders: BTreeSet<EventId> = all.iter().map(|&id| group[id as usize]).collect();
    let members = |leader| all.iter().copied().filter(|&id| group[id as usize] == leader).collect();
    leaders.into_iter().map(members).collect()
}

/// Uncontrollable events and the automata that name them.
struct Group<'p> {
    plant: &'p Plant,
    /// In table order.
    events: Vec<EventId>,
    /// Ascending.
    automata: Vec<usize>,
}

/// A batch that can happen.
struct Batch {
    states: Vec<u16>,
    /// Places in [`Group::events`].
    events: u64,
    /// The batch without the last event, and the place of that; none for the empty batch.
    last: Option<(usize, usize)>,
}

impl<'p> Group<'p> {
    fn new(plant: &'p Plant, mut events: Vec<EventId>) -> Self {
        events.sort_by_key(|&id| text(plant, id).map(|event| event.text));
        let names = |automaton: usize| {
            let alphabet = &plant.automata[automaton].alphabet;
            events.iter().any(|id| alphabet.binary_search(id).is_ok())
        };
        let automata = (0..plant.automata.len()).filter(|&automaton| names(automaton)).collect();
        Group { plant, events, automata }
    }

    fn try_all(&self, closed: &ClosedLoop, races: &mut Races) {
        let mut starts: Indexed<Vec<u16>> = Indexed::default();
        let mut told = BTreeSet::new();
        let mut tried = 0;
        for entry in 0..closed.len() {
            let states: Vec<u16> =
                self.automata.iter().map(|&automaton| closed.entry(entry)[automaton]).collect();
            if starts.intern(states.clone()).1 {
                self.try_from(entry, &states, &mut tried, &mut told, races);
            }
        }
    }

    /// Tries the batches that can happen from some states, the small ones first.
    fn try_from(
        &self,
        entry: usize,
        start: &[u16],
        tried: &mut usize,
        told: &mut BTreeSet<Vec<EventId>>,
        races: &mut Races,
    ) {
        let mut known = BTreeSet::from([(0, start.to_vec())]);
        let mut batches = vec![Batch { states: start.to_vec(), events: 0, last: None }];
        let mut next = 0;
        while next < batches.len() {
            for place in 0..self.events.len() {
                let Batch { ref states, events, .. } = batches[next];
                if events >> place & 1 == 1 {
                    continue;
                }
                let Some(states) = self.after(states, place) else { continue };
                let size = events.count_ones() as usize + 1;
                if *tried == MOST_BATCHES || place == MOST_EVENTS - 1 && self.events.len() > MOST_EVENTS {
                    races.untried = Some(races.untried.map_or(size, |other| other.min(size)));
                    break;
                }
                let events = events | 1 << place;
                if !known.insert((events, states.clone())) {
                    continue;
                }
                *tried += 1;
                let batch = Batch { states, events, last: Some((next, place)) };
                if self.taken(start, events).as_ref() == Some(&batch.states) {
                    batches.push(batch);
                    continue;
                }
                let order = self.order(&batches, &batch);
                if told.insert(order.clone()) {
                    races.found.push(Race { entry: entry as u32, events: order });
                }
            }
            next += 1;
        }
    }

    /// The states after an event, if it is possible.
    fn after(&self, states: &[u16], place: usize) -> Option<Vec<u16>> {
        let event = self.events[place];
        let mut after = states.to_vec();
        for (state, &automaton) in after.iter_mut().zip(&self.automata) {
            let automaton = &self.plant.automata[automaton];
            if automaton.alphabet.binary_search(&event).is_ok() {
                let edges = &automaton.states[*state as usize].edges;
                *state = edges[edges.binary_search_by_key(&event, |edge| edge.event).ok()?].target as u16;
            }
        }
        Some(after)
    }

    /// Where the controller comes to with these events pending, if it takes them all.
    fn taken(&self, start: &[u16], mut pending: u64) -> Option<Vec<u16>> {
        let mut states = start.to_vec();
        loop {
            let before = pending;
            for place in 0..self.events.len() {
                if pending >> place & 1 == 1
                    && let Some(after) = self.after(&states, place)
                {
                    states = after;
                    pending &= !(1 << place);
                }
            }
            if pending == before {
                return (pending == 0).then_some(states);
            }
        }
    }

    fn order(&self, batches: &[Batch], batch: &Batch) -> Vec<EventId> {
        let mut order = Vec::new();
        let mut last = batch.last;
        while let Some((before, place)) = last {
            order.push(self.events[place]);
            last = batches[before].last;
        }
        order.reverse();
        order
    }
}

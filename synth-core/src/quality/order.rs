//! Pairs of events of the environment that may come in one scan, and whose order makes a difference.
//!
//! A scan shows *that* inputs have changed, not which changed first. So a programmable controller takes the events that
//! are pending in table order, whatever their order was. That is looked at here in the controlled system: in every state in
//! which either of two events can come, one is taken with the super step that answers it, and then the other. What
//! each component is told, and the state at the end, must not depend on which is first. Two states are the same if no
//! environment can tell them apart (they are one in the minimised controller), or if they differ only in what the
//! controller remembers.
//!
//! Not every pair can meet. If the assumptions exclude either event after the other, both never come together. And
//! where the environment must go on with a certain event before anything else (turns 2 and 4), what is pending just
//! waits: such a run counts as part of the event before.

use super::plays::note;
use super::reads::{could_be, patterns};
use crate::controller::{Controller, SuperStep};
use crate::diagnostic::{Code, Diagnostic};
use crate::explore::Explored;
use crate::game::{Strategy, Turn};
use crate::syntax::Span;
use std::collections::BTreeSet;

/// More pairs than these are not shown.
const MOST_SHOWN: usize = 5;

/// More pairs than these are not looked at. Differences are found breadth first, so those with the shortest plays come
/// first.
const MOST_PAIRS: usize = 1_000_000;

/// Longer runs of the environment are not followed.
const LONGEST_RUN: usize = 64;

/// One warning for each pair of operations, with a shortest play. `controller` is the minimised strategy.
pub(super) fn differences(
    explored: &Explored<'_>,
    strategy: &Strategy,
    controller: &Controller,
) -> Vec<Diagnostic> {
    let system = Controlled::new(explored, strategy, controller);
    let (places, mut found) = search(&system);
    let more = found.len().saturating_sub(MOST_SHOWN);
    found.truncate(MOST_SHOWN);
    let mut warnings: Vec<Diagnostic> =
        found.into_iter().map(|difference| warning(&system, &places, difference)).collect();
    if more > 0
        && let Some(last) = warnings.pop()
    {
        warnings.push(last.note(format!("{more} more pairs of events are not shown")));
    }
    warnings
}

/// A state in which the controller waits for events, and a node of the strategy that it stands for.
#[derive(Clone, Copy)]
struct Place {
    state: u32,
    node: u32,
}

/// A place that was found, and how: the index of the place before, and the event.
type Found = (Place, Option<(usize, u32)>);

struct Difference {
    /// Index of the place.
    place: usize,
    events: [u32; 2],
    how: String,
}

fn search(system: &Controlled<'_>) -> (Vec<Found>, Vec<Difference>) {
    let mut differences = Vec::new();
    let mut known: BTreeSet<[(&str, &str); 2]> = BTreeSet::new();
    let (mut pairs, mut told) = (0, [Vec::new(), Vec::new()]);
    let initial = Place { state: system.controller.initial, node: 0 };
    let begin = system.settle(initial, &mut Vec::new());
    let mut seen = vec![false; system.controller.states as usize];
    seen[begin.state as usize] = true;
    let mut places: Vec<Found> = vec![(begin, None)];
    let mut next = 0;
    while let Some(&(place, _)) = places.get(next) {
        let accepted = &system.accepted[place.state as usize];
        for (index, &(first, _)) in accepted.iter().enumerate() {
            if let Some(target) = system.take(place, first, &mut Vec::new())
                && !std::mem::replace(&mut seen[target.state as usize], true)
            {
                places.push((target, Some((next, first))));
            }
            for &(second, _) in &accepted[index + 1..] {
                let mut kinds = [first, second].map(|event| system.kind(event));
                kinds.sort_unstable();
                if known.contains(&kinds) {
                    continue;
                }
                if pairs == MOST_PAIRS {
                    return (places, differences);
                }
                pairs += 1;
                if let Some(how) = system.compare(place, first, second, &mut told) {
                    known.insert(kinds);
                    differences.push(Difference { place: next, events: [first, second], how });
                }
            }
        }
        next += 1;
    }
    (places, differences)
}

/// The controlled system: controller and strategy, which do the same.
struct Controlled<'a> {
    explored: &'a Explored<'a>,
    strategy: &'a Strategy,
    controller: &'a Controller,
    /// Per state of the controller: events and where they lead, ascending.
    accepted: Vec<Vec<(u32, u32)>>,
    due: Vec<Option<SuperStep<'a>>>,
    /// Per event of the controller: its label in the game.
    label: Vec<Option<u32>>,
    /// Per command: the component that is told, or [`NONE`].
    component: Vec<u32>,
}

const NONE: u32 = u32::MAX;

impl<'a> Controlled<'a> {
    fn new(explored: &'a Explored<'a>, strategy: &'a Strategy, controller: &'a Controller) -> Self {
        let mut accepted = vec![Vec::new(); controller.states as usize];
        for (event, rows) in controller.environment.iter().enumerate() {
            for &(source, target) in rows {
                accepted[source as usize].push((event as u32, target));
            }
        }
        let mut due = vec![None; controller.states as usize];
        for step in &controller.super_steps {
            due[step.source as usize] = Some(step);
        }
        let label = controller.events.iter().map(|event| explored.playout.find_event(&event.text)).collect();
        let mut component = vec![NONE; controller.commands.len()];
        for (index, each) in controller.components.iter().enumerate() {
            each.commands.iter().for_each(|&command| component[command as usize] = index as u32);
        }
        Controlled { explored, strategy, controller, accepted, due, label, component }
    }

    fn text(&self, event: u32) -> &'a str {
        &self.controller.events[event as usize].text
    }

    /// Events of one kind differ in sender and arguments.
    fn kind(&self, event: u32) -> (&'a str, &'a str) {
        let event = &self.controller.events[event as usize];
        (&event.receiver, &event.operation)
    }

    fn game_state(&self, node: u32) -> u32 {
        self.strategy.state[node as usize]
    }

    fn turn(&self, node: u32) -> Turn {
        self.explored.game.turn[self.game_state(node) as usize]
    }

    /// The edge of an event of the environment. Edges are in the order of their labels where it has the turn.
    fn edge(&self, node: u32, label: u32) -> Option<usize> {
        let edges = self.strategy.edges_of(node);
        let label_of = |edge: &u32| self.explored.game.label(*edge as usize);
        let found = self.strategy.edge[edges.clone()].binary_search_by_key(&label, label_of).ok()?;
        Some(edges.start + found)
    }

    /// Does what the system does until it waits for events.
    fn settle(&self, mut place: Place, commands: &mut Vec<u32>) -> Place {
        // Super steps of a controller that can be made end.
        while let Some(step) = self.due[place.state as usize] {
            commands.extend(step.events);
            place.state = step.target;
        }
        while self.turn(place.node).is_system()
            && let Some(edge) = self.strategy.edges_of(place.node).next()
        {
            place.node = self.strategy.target[edge];
        }
        place
    }

    /// Takes an event and does what answers it; `None` if it is not accepted.
    fn take(&self, place: Place, event: u32, commands: &mut Vec<u32>) -> Option<Place> {
        let accepted = &self.accepted[place.state as usize];
        let row = accepted.binary_search_by_key(&event, |row| row.0).ok()?;
        let label = self.label[event as usize]?;
        let edge = self.edge(place.node, label)?;
        let target = Place { state: accepted[row].1, node: self.strategy.target[edge] };
        Some(self.settle(target, commands))
    }

    /// Goes on with what the environment must do next, as far as that is one event, or up to one that is waited for.
    fn run(&self, mut place: Place, until: Option<u32>, commands: &mut Vec<u32>) -> Place {
        for _ in 0..LONGEST_RUN {
            let is_forced =
                matches!(self.turn(place.node), Turn::EnvironmentCommitted | Turn::EnvironmentUrgent);
            let [(event, _)] = self.accepted[place.state as usize][..] else { break };
            if !is_forced || Some(event) == until {
                break;
            }
            let Some(next) = self.take(place, event, commands) else { break };
            place = next;
        }
        place
    }

    /// Takes two events in this order: where that leads, and what the components are told, one component after the other.
    fn both(&self, place: Place, first: u32, second: u32, told: &mut Vec<u32>) -> Option<Place> {
        told.clear();
        let place = self.take(place, first, told)?;
        let place = self.run(place, Some(second), told);
        let place = self.take(place, second, told)?;
        let place = self.run(place, None, told);
        // Messages within the system are nobody's commands.
        told.retain(|&command| self.component[command as usize] != NONE);
        told.sort_by_key(|&command| self.component[command as usize]);
        Some(place)
    }

    /// How the two orders differ, if they do.
    fn compare(&self, place: Place, first: u32, second: u32, told: &mut [Vec<u32>; 2]) -> Option<String> {
        let (first_text, second_text) = (self.text(first), self.text(second));
        let only = |one: &str, other: &str| {
            Some(format!("after `{one}` the controller takes `{other}`, but not the other way round"))
        };
        let [told, others] = told;
        match (self.both(place, first, second, told), self.both(place, second, first, others)) {
            (None, None) => None,
            (Some(_), None) => only(first_text, second_text),
            (None, Some(_)) => only(second_text, first_text),
            (Some(_), Some(_)) if told != others => Some(format!(
                "with `{first_text}` first the controller orders {}; with `{second_text}` first, {}",
                self.list(told),
                self.list(others)
            )),
            (Some(end), Some(other)) => {
                let differ =
                    end.state != other.state && self.game_state(end.node) != self.game_state(other.node);
                differ
                    .then(|| "the commands are the same, but the system is in another state then".to_owned())
            }
        }
    }

    fn list(&self, told: &[u32]) -> String {
        let commands = told.iter().map(|&command| &self.controller.commands[command as usize].text);
        let texts: Vec<String> = commands.map(|text| format!("`{text}`")).collect();
        if texts.is_empty() { "nothing".to_owned() } else { texts.join(", ") }
    }

    /// The play of the strategy to a place.
    fn play(&self, places: &[Found], mut place: usize) -> Vec<String> {
        let mut events = Vec::new();
        while let Some((before, event)) = places[place].1 {
            events.push(event);
            place = before;
        }
        let mut play = Vec::new();
        let mut node = 0;
        loop {
            let edge = if self.turn(node).is_system() {
                self.strategy.edges_of(node).next()
            } else {
                let event = events.pop().and_then(|event| self.label[event as usize]);
                event.and_then(|event| self.edge(node, event))
            };
            let Some(edge) = edge else { return play };
            play.push(self.explored.text(self.strategy.edge[edge] as usize).to_owned());
            node = self.strategy.target[edge];
        }
    }

    /// The first message that an event can be.
    fn message(&self, event: u32) -> Option<Span> {
        let playout = &self.explored.playout;
        let (spec, event) = (playout.spec(), playout.event(self.label[event as usize]?));
        let messages = spec.scenarios.iter().flat_map(|s| patterns(s).map(move |message| (s, message)));
        let mut matching = messages.filter(|(scenario, message)| could_be(spec, scenario, message, event));
        matching.next().map(|(_, message)| message.span)
    }
}

fn warning(system: &Controlled<'_>, places: &[Found], difference: Difference) -> Diagnostic {
    let Difference { place, events, how } = difference;
    let [first, second] = events.map(|event| system.text(event));
    let [span, other] = events.map(|event| system.message(event).unwrap_or_default());
    let message = format!("the order of `{first}` and `{second}` makes a difference");
    let mut warning = Diagnostic::warning(Code::OrderMatters, span, message);
    if other != span {
        warning = warning.label(format!("`{first}`")).also(other, format!("`{second}`"));
    }
    warning
        .note(how)
        .note(format!("if both come in one scan, `{first}` is taken first"))
        .note(note(&system.play(places, place)))
        .help("make sure that this order is right, or that both cannot come within one cycle time")
}

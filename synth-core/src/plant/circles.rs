//! Commands that undo each other: controllable events that lead back to where they began, while nothing of the plant is
//! waited for. A program gives them again and again, perhaps all within one scan.

use super::{ClosedLoop, EventId, Plant};
use crate::diagnostic::{Code, Diagnostic};
use std::collections::VecDeque;

/// A warning for each circle of commands. Of circles that have an event in common, one is told.
pub(super) fn warnings(plant: &Plant, closed: &ClosedLoop, found: &mut Vec<Diagnostic>) {
    let counts: Vec<bool> = plant.events.iter().map(|event| event.controllable).collect();
    let mut commands = Commands { closed, counts };
    while let Some(somewhere) = commands.on_a_circle() {
        let circle = commands.shortest_circle(somewhere);
        for &event in &circle {
            commands.counts[event as usize] = false;
        }
        found.push(warning(plant, closed, somewhere, &circle));
    }
}

fn warning(plant: &Plant, closed: &ClosedLoop, entry: usize, circle: &[EventId]) -> Diagnostic {
    let name = |event: EventId| format!("`{}`", plant.events[event as usize].name);
    let first = circle.iter().copied().min().unwrap_or_default();
    // An event that leads back to where it began is no circle, so there are two at least.
    let (last, others) = circle.split_last().expect("a circle has events");
    let others: Vec<String> = others.iter().map(|&event| name(event)).collect();
    let message = format!("{} and {} undo each other without end", others.join(", "), name(*last));
    let mut warning = Diagnostic::warning(Code::Circle, plant.events[first as usize].span, message);
    for &event in circle.iter().filter(|&&event| event != first) {
        warning = warning.also(plant.events[event as usize].span, "is given in turn with it");
    }
    warning
        .note(format!("for example from {}", plant.state_names(closed.entry(entry)).join(", ")))
        .help("let one of them wait for an input, or forbid it by a constraint")
}

/// The closed loop with the events that count, without those that change nothing.
struct Commands<'a> {
    closed: &'a ClosedLoop,
    /// By event.
    counts: Vec<bool>,
}

impl Commands<'_> {
    fn edges(&self, entry: usize) -> impl Iterator<Item = (EventId, usize)> {
        let edges = self.closed.edges(entry).iter().map(|&(event, target)| (event, target as usize));
        edges.filter(move |&(event, target)| self.counts[event as usize] && target != entry)
    }

    /// An entry to which its commands lead back, by a search in depth; `None` if there is none.
    fn on_a_circle(&self) -> Option<usize> {
        #[derive(Clone, Copy, PartialEq)]
        enum Seen {
            Not,
            OnThePath,
            Done,
        }
        let mut seen = vec![Seen::Not; self.closed.len()];
        for start in 0..self.closed.len() {
            if seen[start] != Seen::Not {
                continue;
            }
            seen[start] = Seen::OnThePath;
            let mut path = vec![(start, self.edges(start))];
            while let Some((entry, edges)) = path.last_mut() {
                match edges.next() {
                    None => {
                        seen[*entry] = Seen::Done;
                        path.pop();
                    }
                    Some((_, target)) => match seen[target] {
                        Seen::Done => {}
                        Seen::OnThePath => return Some(target),
                        Seen::Not => {
                            seen[target] = Seen::OnThePath;
                            path.push((target, self.edges(target)));
                        }
                    },
                }
            }
        }
        None
    }

    /// The fewest commands that lead from an entry on a circle back to it.
    fn shortest_circle(&self, start: usize) -> Vec<EventId> {
        let mut reached: Vec<Option<(usize, EventId)>> = vec![None; self.closed.len()];
        let mut queue = VecDeque::from([start]);
        while let Some(entry) = queue.pop_front().filter(|_| reached[start].is_none()) {
            for (event, target) in self.edges(entry) {
                if reached[target].is_none() {
                    reached[target] = Some((entry, event));
                    queue.push_back(target);
                }
            }
        }
        let mut circle = Vec::new();
        let mut entry = start;
        while let Some((before, event)) = reached[entry] {
            circle.push(event);
            entry = before;
            if entry == start {
                break;
            }
        }
        circle.reverse();
        circle
    }
}

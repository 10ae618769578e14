//! Commands that a controller could give and never does, because it gives others first or waits for the plant.

use super::super::{ClosedLoop, EventId, Plant};
use super::choose;
use crate::diagnostic::{Code, Diagnostic};

/// A warning for each controllable event that the feedback enables and the extracted controller never gives, in the order of the
/// file. What is enabled nowhere is told by [`never_enabled`](super::super::never_enabled).
#[must_use]
pub fn never_given(plant: &Plant, closed: &ClosedLoop) -> Vec<Diagnostic> {
    let chosen = choose(plant, closed);
    let reached = reached(plant, closed, &chosen);
    let mut given = vec![false; plant.events.len()];
    for &(event, _) in
        (0..closed.len()).filter(|&entry| reached[entry]).filter_map(|entry| chosen[entry].as_ref())
    {
        given[event as usize] = true;
    }
    let mut enabled: Vec<Option<usize>> = vec![None; plant.events.len()];
    for entry in (0..closed.len()).rev() {
        for &(event, _) in closed.edges(entry) {
            // One that the controller comes to says most.
            let better = reached[entry] || enabled[event as usize].is_none_or(|other| !reached[other]);
            if better {
                enabled[event as usize] = Some(entry);
            }
        }
    }
    let candidates = (0..).zip(plant.events.iter().zip(given));
    let never = candidates.filter(|(_, (event, given))| event.controllable && !given);
    never
        .filter_map(|(id, _)| Some((id, enabled[id as usize]?)))
        .map(|(id, entry)| warning(plant, closed, id, entry, reached[entry].then_some(chosen[entry])))
        .collect()
}

/// By entry, whether the controller can come there.
fn reached(plant: &Plant, closed: &ClosedLoop, chosen: &[Option<(EventId, u32)>]) -> Vec<bool> {
    let mut reached = vec![false; closed.len()];
    reached[closed.initial as usize] = true;
    let mut pending = vec![closed.initial as usize];
    while let Some(entry) = pending.pop() {
        let happens = |edge: &&(EventId, u32)| {
            !plant.events[edge.0 as usize].controllable || chosen[entry].as_ref() == Some(*edge)
        };
        for &(_, target) in closed.edges(entry).iter().filter(happens) {
            if !std::mem::replace(&mut reached[target as usize], true) {
                pending.push(target as usize);
            }
        }
    }
    reached
}

/// `choice` is what the controller does in the entry, if it ever comes there.
fn warning(
    plant: &Plant,
    closed: &ClosedLoop,
    event: EventId,
    entry: usize,
    choice: Option<Option<(EventId, u32)>>,
) -> Diagnostic {
    let name = |event: EventId| &plant.events[event as usize].name;
    let place = plant.state_names(closed.entry(entry)).join(", ");
    let (reason, help) = match choice {
        Some(Some((other, _))) => (
            format!("where it is possible, `{}` is given instead", name(other)),
            format!("say by a constraint when `{}` has to wait", name(other)),
        ),
        Some(None) => (
            "where it is possible, nothing is given".to_owned(),
            "let an event of the plant, say a button, ask for it".to_owned(),
        ),
        None => (
            "the controller never comes to where it is possible".to_owned(),
            "look at the commands that would lead there, or remove the event".to_owned(),
        ),
    };
    Diagnostic::warning(
        Code::NeverGiven,
        plant.events[event as usize].span,
        format!("`{}` is never given", name(event)),
    )
    .note(format!("{reason}: for example in {place}"))
    .help(help)
}

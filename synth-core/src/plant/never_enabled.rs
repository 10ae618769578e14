//! Controllable events that the feedback enables nowhere, and why.

use super::refusal::{Source, forbidding};
use super::{ClosedLoop, EventId, Plant, Synthesis, Why};
use crate::diagnostic::{Code, Diagnostic};
use crate::explore::Limits;

/// Up to so many states what would follow an event is explored again, to tell what is wrong with it.
const MOST_EXPLAINED: u64 = 20_000;

/// A warning for each controllable event that some automaton names and no entry enables, with the reason, in the order of the
/// file. It concerns controllers of every kind.
#[must_use]
pub fn never_enabled(plant: &Plant, closed: &ClosedLoop) -> Vec<Diagnostic> {
    let mut enabled = vec![false; plant.events.len()];
    for &(event, _) in &closed.edges {
        enabled[event as usize] = true;
    }
    let named = |event: EventId| plant.automata.iter().any(|it| it.alphabet.binary_search(&event).is_ok());
    let events = (0..).zip(&plant.events).zip(enabled);
    // What no automaton names is told of anyway.
    let never = events.filter(|((id, event), enabled)| !enabled && event.controllable && named(*id));
    never.map(|((id, _), _)| warning(plant, closed, id)).collect()
}

fn warning(plant: &Plant, closed: &ClosedLoop, event: EventId) -> Diagnostic {
    let name = &plant.events[event as usize].name;
    let message = format!("`{name}` is never enabled");
    let warning = Diagnostic::warning(Code::NeverEnabled, plant.events[event as usize].span, message);
    let inhibited: Vec<usize> =
        (0..closed.len()).filter(|&entry| closed.inhibited(entry).binary_search(&event).is_ok()).collect();
    match inhibited.first() {
        None => impossible(plant, closed, event, warning),
        Some(_) => everywhere_inhibited(plant, closed, event, &inhibited, warning),
    }
}

/// The components are never where they allow it.
fn impossible(plant: &Plant, closed: &ClosedLoop, event: EventId, mut warning: Diagnostic) -> Diagnostic {
    let components = plant.automata[..plant.components].iter().enumerate();
    let actors: Vec<_> = components.filter(|(_, it)| it.alphabet.binary_search(&event).is_ok()).collect();
    if actors.is_empty() {
        return warning.note("no component names it").help("add its edges to a component, or remove it");
    }
    for &(number, component) in &actors {
        let mut visited = vec![false; component.states.len()];
        (0..closed.len()).for_each(|entry| visited[closed.entry(entry)[number] as usize] = true);
        let sources = component
            .states
            .iter()
            .zip(visited)
            .filter(|(state, _)| state.edges.iter().any(|edge| edge.event == event));
        let (mut names, mut is_visited) = (Vec::new(), false);
        for (state, visited) in sources {
            is_visited |= visited;
            names.push((format!("`{}`", state.name), state.span));
        }
        if is_visited {
            continue;
        }
        if let Some(&(_, span)) = names.first() {
            warning = warning.also(span, "never reached");
        }
        let names: Vec<String> = names.into_iter().map(|(name, _)| name).collect();
        warning = warning.note(format!(
            "`{}` never gets to {} under the feedback",
            component.name,
            names.join(" or ")
        ));
    }
    if warning.notes.is_empty() {
        warning = warning.note("the components that take part are never all where it is possible");
    }
    warning.help("look at what leads there, or remove the event")
}

fn everywhere_inhibited(
    plant: &Plant,
    closed: &ClosedLoop,
    event: EventId,
    inhibited: &[usize],
    mut warning: Diagnostic,
) -> Diagnostic {
    let mut sources: Vec<(Source, usize)> = Vec::new();
    let mut ahead = Vec::new();
    for &entry in inhibited {
        let forbidding = forbidding(plant, closed.entry(entry), event);
        if forbidding.is_empty() {
            ahead.push(entry);
        }
        for source in forbidding {
            match sources.iter_mut().find(|(known, _)| *known == source) {
                Some((_, count)) => *count += 1,
                None => sources.push((source, 1)),
            }
        }
    }
    warning = warning.note(match inhibited.len() {
        1 => "it is possible in one entry, and inhibited there".to_owned(),
        all => format!("it is possible in {all} entries, and inhibited in all of them"),
    });
    for (source, count) in sources {
        warning = warning.also(source.span(plant), format!("forbids it in {count} of them"));
    }
    if let Some(&entry) = ahead.first() {
        let mut note = format!("in {} of them because of what would follow", ahead.len());
        if closed.constrained.0 <= MOST_EXPLAINED
            && let Some(Why::Unavoidable(unavoidable)) = explained(plant, closed, entry, event)
        {
            note = format!("{note}, such as: {}", unavoidable.text(plant));
        }
        warning = warning.note(note);
    }
    warning.help("weaken the constraints, or remove the event")
}

fn explained(plant: &Plant, closed: &ClosedLoop, entry: usize, event: EventId) -> Option<Why> {
    Synthesis::new(plant, &Limits::default()).ok()?.why(closed, entry, event)
}

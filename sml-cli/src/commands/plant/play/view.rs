//! What a play of a closed loop looks like, for people and for programs.

use super::position::{Position, Verdict};
use crate::options::Format;
use serde::Serialize;
use serde_json::{Value as Json, json};
use synth_core::plant::{EventId, Plant};

/// An event in JSON; the first four members are those of a play of a specification.
#[derive(Serialize)]
struct Line<'a> {
    event: &'a str,
    turn: &'static str,
    /// The feedback lets nothing violate a constraint.
    violated: [&'static str; 0],
    enabled: Vec<&'a str>,
    inhibited: Vec<&'a str>,
}

fn name(plant: &Plant, event: EventId) -> &str {
    &plant.events[event as usize].name
}

fn names(plant: &Plant, events: impl IntoIterator<Item = EventId>) -> Vec<&str> {
    events.into_iter().map(|event| name(plant, event)).collect()
}

/// Who causes an event.
fn turn(plant: &Plant, event: EventId) -> &'static str {
    if plant.events[event as usize].controllable { "system" } else { "environment" }
}

/// The last event.
pub(super) fn event(position: &Position<'_>, event: EventId, format: Format) -> String {
    let plant = position.plant;
    let (event, turn) = (name(plant, event), turn(plant, event));
    if format == Format::Text {
        return format!("{turn}: {event}\n");
    }
    let enabled = names(plant, position.enabled());
    let inhibited = names(plant, position.inhibited().iter().copied());
    let line = Line { event, turn, violated: [], enabled, inhibited };
    format!("{}\n", serde_json::to_string(&line).expect("strings always serialize"))
}

/// The states of all automata: `Injector.I2B Barrel.BE`.
pub(super) fn states(position: &Position<'_>) -> Vec<String> {
    position.plant.state_names(position.states())
}

/// The state, what can happen, and what is inhibited and why.
pub(super) fn state(position: &Position<'_>) -> String {
    let plant = position.plant;
    let mut text = format!("{}\n", states(position).join(" "));
    let enabled: Vec<EventId> = position.enabled().collect();
    let all = enabled.iter().chain(position.inhibited());
    let width = all.map(|&event| name(plant, event).len()).max().unwrap_or(0);
    for (number, &event) in (1..).zip(&enabled) {
        let by = if plant.events[event as usize].controllable { "enabled" } else { "by itself" };
        text.push_str(&format!("  {number:>2}  {:<width$}  {by}\n", name(plant, event)));
    }
    for &event in position.inhibited() {
        let why = match position.verdict(event) {
            Verdict::Inhibited(why) => format!("inhibited: {why}"),
            _ => "inhibited".to_owned(),
        };
        text.push_str(&format!("   -  {:<width$}  {why}\n", name(plant, event)));
    }
    if enabled.is_empty() {
        text.push_str("  nothing can happen\n");
    }
    text
}

/// The same for programs.
pub(super) fn state_json(position: &Position<'_>) -> String {
    let plant = position.plant;
    let each = plant.automata.iter().zip(position.states());
    let states: serde_json::Map<String, Json> = each
        .map(|(automaton, &state)| (automaton.name.clone(), json!(automaton.states[state as usize].name)))
        .collect();
    let inhibited: Vec<Json> = position.inhibited().iter().map(|&event| why_json(position, event)).collect();
    let document =
        json!({ "state": states, "enabled": names(plant, position.enabled()), "inhibited": inhibited });
    format!("{document}\n")
}

/// Why an event can happen or cannot.
pub(super) fn why(position: &Position<'_>, event: EventId, format: Format) -> String {
    match format {
        Format::Text => format!("{}\n", position.verdict(event).text(event, position.plant)),
        Format::Json => format!("{}\n", why_json(position, event)),
    }
}

fn why_json(position: &Position<'_>, event: EventId) -> Json {
    let verdict = position.verdict(event);
    json!({
        "event": name(position.plant, event),
        "can_happen": matches!(verdict, Verdict::Enabled),
        "inhibited": matches!(verdict, Verdict::Inhibited(_)),
        "why": verdict.text(event, position.plant),
    })
}

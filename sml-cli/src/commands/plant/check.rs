//! `sml check` of a plant: verdict, figures, warnings, and why there is no feedback.

use super::{Controlled, control};
use crate::failure::{Exit, Failure};
use crate::input::Given;
use crate::options::Format;
use crate::output;
use crate::session::{ReadPlant, Session};
use serde::Serialize;
use serde_json::Value as Json;
use synth_core::diagnostic::{Diagnostic, render, to_json};
use synth_core::pipeline;
use synth_core::plant::{ClosedLoop, Options};
use synth_core::quality::Policy;

/// Figures are null if there is no feedback; those of the plant also if its states are too many to be counted.
#[derive(Serialize)]
struct Document {
    version: u32,
    realizable: bool,
    plant_states: Option<u64>,
    plant_transitions: Option<u64>,
    constrained_states: Option<u64>,
    constrained_transitions: Option<u64>,
    entries: Option<usize>,
    diagnostics: Json,
}

pub(in crate::commands) fn run(
    given: &Given,
    policy: &Policy,
    session: &mut Session,
) -> Result<Exit, Failure> {
    let ReadPlant { loaded, plant, warnings } = session.plant(given)?;
    let (closed, mut diagnostics) = match control(&plant, Options::default(), session) {
        Ok(Controlled { closed, .. }) => (Some(closed), Vec::new()),
        Err(pipeline::Failure::Refused(why)) => (None, vec![*why]),
        Err(failure) => return Err(Failure::of(&failure, &loaded)),
    };
    diagnostics.extend(match &closed {
        Some(closed) => session.warnings_of_plant(warnings, &plant, closed),
        None => warnings,
    });
    policy.apply(&mut diagnostics);
    output::print(&match session.format() {
        Format::Json => json(closed.as_ref(), to_json(&diagnostics, &loaded.sources)),
        Format::Text => {
            let shown = render(&diagnostics, &loaded.sources, session.color(&std::io::stdout()));
            shown + &text(&plant.name, closed.as_ref())
        }
    })?;
    let is_denied = |one: &Diagnostic| policy.denies(one);
    let denied = diagnostics.iter().any(is_denied);
    Ok(if closed.is_some() && !denied { Exit::Done } else { Exit::No })
}

fn json(closed: Option<&ClosedLoop>, diagnostics: Json) -> String {
    let (plant_states, plant_transitions) = closed.and_then(|closed| closed.plant).unzip();
    let (constrained_states, constrained_transitions) = closed.map(|closed| closed.constrained).unzip();
    let document = Document {
        version: 1,
        realizable: closed.is_some(),
        plant_states,
        plant_transitions,
        constrained_states,
        constrained_transitions,
        entries: closed.map(ClosedLoop::len),
        diagnostics,
    };
    format!("{}\n", serde_json::to_string(&document).expect("strings and numbers always serialize"))
}

fn text(name: &str, closed: Option<&ClosedLoop>) -> String {
    let Some(closed) = closed else { return format!("{name}: not realizable\n") };
    let mut text = format!("{name}: realizable\n");
    let (states, transitions) = closed.plant.unzip();
    for (name, count) in [
        ("plant states", states),
        ("plant transitions", transitions),
        ("constrained states", Some(closed.constrained.0)),
        ("constrained transitions", Some(closed.constrained.1)),
        ("entries", Some(closed.len() as u64)),
    ] {
        let count = count.map_or_else(|| "too many".to_owned(), |count| count.to_string());
        text.push_str(&format!("  {name:<23} {count:>10}\n"));
    }
    text
}

//! `sml check` of a plant: verdict, figures, warnings, and why there is no feedback.

use super::explanation::Explanation;
use super::follow::Follow;
use super::{Controlled, control};
use crate::failure::{Exit, Failure};
use crate::input::Given;
use crate::options::Format;
use crate::output;
use crate::session::{ReadPlant, Session};
use serde::Serialize;
use serde_json::Value as Json;
use synth_core::controller::Level;
use synth_core::diagnostic::{Diagnostic, render, to_json};
use synth_core::pipeline::{self, Refused};
use synth_core::plant::{ClosedLoop, Options};
use synth_core::quality::Policy;

/// Figures are null if there is no feedback; those of the plant also if its states are too many to be counted.
#[derive(Serialize)]
struct Document<'p> {
    version: u32,
    realizable: bool,
    plant_states: Option<u64>,
    plant_transitions: Option<u64>,
    constrained_states: Option<u64>,
    constrained_transitions: Option<u64>,
    entries: Option<usize>,
    diagnostics: Json,
    #[serde(skip_serializing_if = "Option::is_none")]
    explanation: Option<Explanation<'p>>,
}

pub(in crate::commands) fn run(
    given: &Given,
    policy: &Policy,
    follow: Option<Follow>,
    session: &mut Session,
) -> Result<Exit, Failure> {
    let ReadPlant { sources, plant, warnings, .. } = session.plant(given)?;
    let found = if Follow::events(follow) {
        session.follow(&plant, Level::default()).map(|followed| {
            let found = followed.warnings(&plant);
            (followed.closed, found)
        })
    } else {
        control(&plant, Options::default(), session).map(|Controlled { closed, .. }| {
            let found = session.warnings_of_plant(Vec::new(), &plant, &closed);
            (closed, found)
        })
    };
    let (closed, mut diagnostics, refused) = match found {
        Ok((closed, found)) => {
            let mut all = [warnings, found].concat();
            all.sort_by_key(|warning| warning.span.start);
            (Some(closed), all, None)
        }
        Err(pipeline::Failure::Refused(refused)) => {
            let Refused { diagnostic, unavoidable } = *refused;
            (None, [vec![diagnostic], warnings].concat(), Some(unavoidable))
        }
        Err(failure) => return Err(Failure::of(&failure, &sources)),
    };
    policy.apply(&mut diagnostics);
    output::print(&match session.format() {
        Format::Json => {
            let explanation = refused.as_ref().map(|unavoidable| Explanation::new(&plant, unavoidable));
            json(closed.as_ref(), to_json(&diagnostics, &sources), explanation)
        }
        Format::Text => {
            let shown = render(&diagnostics, &sources, session.color(&std::io::stdout()));
            shown + &text(&plant.name, closed.as_ref())
        }
    })?;
    let is_denied = |one: &Diagnostic| policy.denies(one);
    let denied = diagnostics.iter().any(is_denied);
    Ok(if closed.is_some() && !denied { Exit::Done } else { Exit::No })
}

fn json(closed: Option<&ClosedLoop>, diagnostics: Json, explanation: Option<Explanation<'_>>) -> String {
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
        explanation,
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

//! `sml check --verdict`: who wins, and how much was explored to know it.

use crate::failure::{Exit, Failure};
use crate::options::Format;
use crate::output;
use crate::session::Session;
use serde::Serialize;
use synth_core::diagnostic::counted;
use synth_core::syntax::Loaded;
use synth_core::verdict::{Forced, Verdict};

#[derive(Serialize)]
struct Document<'a> {
    version: u32,
    realizable: bool,
    complete: bool,
    found_states: usize,
    explored_states: usize,
    explored_transitions: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    explanation: Option<Play<'a>>,
}

#[derive(Serialize)]
struct Play<'a> {
    play: &'a [String],
    r#loop: &'a [String],
}

/// Decides a specification, and prints the verdict.
pub(super) fn run(loaded: &Loaded, session: &mut Session) -> Result<Exit, Failure> {
    let spec = session.specification(loaded)?;
    let verdict = session.verdict(loaded, &spec)?;
    output::print(&match session.format() {
        Format::Json => json(&verdict),
        Format::Text => text(&spec.name, &verdict),
    })?;
    Ok(if verdict.realizable { Exit::Done } else { Exit::No })
}

fn json(verdict: &Verdict) -> String {
    let explanation = verdict.forced.as_ref().map(|Forced { play, cycle }| Play { play, r#loop: cycle });
    let document = Document {
        version: 1,
        realizable: verdict.realizable,
        complete: verdict.is_complete(),
        found_states: verdict.found,
        explored_states: verdict.explored,
        explored_transitions: verdict.transitions,
        explanation,
    };
    format!("{}\n", serde_json::to_string(&document).expect("strings and numbers always serialize"))
}

fn text(name: &str, verdict: &Verdict) -> String {
    let found = counted(verdict.found, "state");
    let explored = if verdict.is_complete() {
        format!("all {found} were explored")
    } else {
        format!("{found} were found, and {} of these explored", verdict.explored)
    };
    let realizable = if verdict.realizable { "realizable" } else { "not realizable" };
    let mut text = format!("{name}: {realizable}; {explored}\n");
    if let Some(Forced { play, cycle }) = &verdict.forced {
        for (title, events) in
            [("the environment can force this play:", play), ("what is then repeated for ever:", cycle)]
        {
            if !events.is_empty() {
                text.push_str(&format!("{title}\n  {}\n", events.join("\n  ")));
            }
        }
        text.push_str("`sml check` without `--verdict` says why\n");
    }
    text
}

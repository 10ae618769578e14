//! `sml check`: verdict, figures, warnings, and why a specification is not realizable.

use crate::failure::{Exit, Failure};
use crate::options::Format;
use crate::output;
use crate::session::Session;
use serde::Serialize;
use serde_json::Value as Json;
use std::path::PathBuf;
use synth_core::diagnostic::{Diagnostic, Severity, render, to_json};
use synth_core::model::Spec;
use synth_core::pipeline::{Figures, Solved};
use synth_core::syntax::Loaded;

/// Arguments of `sml check`.
#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    /// The specification; `-` is stdin
    file: PathBuf,
    /// Fail if there is a warning
    #[arg(long)]
    deny_warnings: bool,
}

#[derive(Serialize)]
struct Document<'a> {
    version: u32,
    realizable: bool,
    states: usize,
    transitions: usize,
    system_states: usize,
    environment_states: usize,
    yielded_states: usize,
    idle_states: usize,
    winning_states: usize,
    assumption_sets: usize,
    guarantee_sets: usize,
    existential: &'a [Existential],
    diagnostics: Json,
    #[serde(skip_serializing_if = "Option::is_none")]
    explanation: Option<&'a Explanation>,
}

/// What becomes of an existential scenario.
#[derive(Serialize)]
struct Existential {
    scenario: String,
    reachable: bool,
    possible: bool,
    witness: Vec<String>,
}

/// Why no controller can meet the specification.
#[derive(Serialize)]
struct Explanation {
    cause: &'static str,
    scenarios: Vec<String>,
    play: Vec<String>,
    r#loop: Vec<String>,
}

/// All that there is to say.
struct Report {
    figures: Figures,
    existential: Vec<Existential>,
    diagnostics: Vec<Diagnostic>,
    explanation: Option<Explanation>,
}

pub(super) fn run(arguments: &Arguments, session: &mut Session) -> Result<Exit, Failure> {
    let loaded = session.load(&arguments.file)?;
    let spec = session.specification(&loaded)?;
    let mut solved = session.solve(&loaded, &spec)?;
    let report = examine(&spec, &mut solved);
    output::print(&match session.format() {
        Format::Json => json(&report, &loaded),
        Format::Text => text(&report, &spec, &loaded, session.color(&std::io::stdout())),
    })?;
    let denied =
        arguments.deny_warnings && report.diagnostics.iter().any(|d| d.severity == Severity::Warning);
    Ok(if report.figures.realizable && !denied { Exit::Done } else { Exit::No })
}

fn examine(spec: &Spec, solved: &mut Solved<'_>) -> Report {
    let _ = spec;
    Report { figures: solved.figures(), existential: Vec::new(), diagnostics: Vec::new(), explanation: None }
}

fn json(report: &Report, loaded: &Loaded) -> String {
    let Report { figures, existential, diagnostics, explanation } = report;
    let document = Document {
        version: 1,
        realizable: figures.realizable,
        states: figures.states,
        transitions: figures.transitions,
        system_states: figures.system_states,
        environment_states: figures.environment_states,
        yielded_states: figures.yielded_states,
        idle_states: figures.idle_states,
        winning_states: figures.winning_states,
        assumption_sets: figures.assumption_sets,
        guarantee_sets: figures.guarantee_sets,
        existential,
        diagnostics: to_json(diagnostics, &loaded.sources),
        explanation: explanation.as_ref(),
    };
    format!("{}\n", serde_json::to_string(&document).expect("strings and numbers always serialize"))
}

fn text(report: &Report, spec: &Spec, loaded: &Loaded, color: bool) -> String {
    let Report { figures, existential, diagnostics, explanation } = report;
    let mut text = render(diagnostics, &loaded.sources, color);
    text.push_str(&format!(
        "{}: {}\n",
        spec.name,
        if figures.realizable { "realizable" } else { "not realizable" }
    ));
    for (name, count) in [
        ("states", figures.states),
        ("transitions", figures.transitions),
        ("system states", figures.system_states),
        ("environment states", figures.environment_states),
        ("yielded states", figures.yielded_states),
        ("idle states", figures.idle_states),
        ("winning states", figures.winning_states),
        ("assumption sets", figures.assumption_sets),
        ("guarantee sets", figures.guarantee_sets),
    ] {
        text.push_str(&format!("  {name:<18} {count:>10}\n"));
    }
    for Existential { scenario, reachable, possible, witness } in existential {
        let verdict = match (reachable, possible) {
            (true, _) => "happens in the controlled system",
            (false, true) => "can happen in some winning play, but not with this controller",
            (false, false) => "can happen in no winning play",
        };
        text.push_str(&format!("`{scenario}` {verdict}\n"));
        text.push_str(&events("for example:", witness));
    }
    if let Some(Explanation { cause, scenarios, play, r#loop }) = explanation {
        text.push_str(&format!("because: {cause} (`{}`)\n", scenarios.join("`, `")));
        text.push_str(&events("the environment can force this play:", play));
        text.push_str(&events("and then for ever:", r#loop));
    }
    text
}

/// A titled list; nothing if it is empty.
fn events(title: &str, texts: &[String]) -> String {
    if texts.is_empty() { String::new() } else { format!("  {title}\n    {}\n", texts.join("\n    ")) }
}

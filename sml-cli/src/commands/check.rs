//! `sml check`: verdict, figures, warnings, and why a specification is not realizable.

mod spill;
mod steps;
mod symmetry;
mod verdict;

use super::plant::{self, follow::Follow};
use crate::failure::{Exit, Failure};
use crate::options::Format;
use crate::session::Session;
use crate::warnings::Warnings;
use crate::{input, output};
use serde::Serialize;
use serde_json::Value as Json;
use std::fmt::Display;
use std::path::PathBuf;
use synth_core::controller::Level;
use synth_core::diagnostic::{Diagnostic, render, to_json};
use synth_core::existential::Existential;
use synth_core::explain::Explanation;
use synth_core::model::{Kind, Spec};
use synth_core::pipeline::{Figures, Solved};
use synth_core::symmetry::WholeFigures;
use synth_core::syntax::{Loaded, Sources};

/// Arguments of `sml check`.
#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    /// The specification or plant; `-` is stdin
    file: PathBuf,
    #[command(flatten)]
    warnings: Warnings,
    /// If the specification is unrealizable: write the play that shows it as a Mermaid sequence diagram, `-` is stdout
    #[arg(long, value_name = "OUT")]
    sequence: Option<PathBuf>,
    /// Explore with files in this folder, in as little memory as `--max-memory` says; go on with what was begun there.
    /// Who wins is found out only if memory suffices for that
    #[arg(long, value_name = "DIR")]
    spill: Option<PathBuf>,
    /// Only say whether the specification is realizable, and explore no more than that takes: neither figures nor warnings
    #[arg(long, conflicts_with_all = ["deny", "deny_warnings", "allow", "sequence", "spill", "follow"])]
    verdict: bool,
    /// Explore one state for all that differ only by objects that can change places: verdict and figures are those of the whole game,
    /// but there are neither warnings nor an explanation
    #[arg(long, conflicts_with_all = ["deny", "deny_warnings", "allow", "sequence", "spill", "verdict", "follow"])]
    symmetry: bool,
    /// Plants: what the controller goes by; `states` otherwise
    #[arg(long, value_enum)]
    follow: Option<Follow>,
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
    existential: Vec<Scenario<'a>>,
    diagnostics: Json,
    #[serde(skip_serializing_if = "Option::is_none")]
    explanation: Option<Because<'a>>,
}

#[derive(Serialize)]
struct Scenario<'a> {
    scenario: &'a str,
    reachable: bool,
    possible: bool,
    witness: &'a [String],
}

#[derive(Serialize)]
struct Because<'a> {
    cause: &'a str,
    /// The core.
    scenarios: &'a [String],
    minimal: bool,
    involved: &'a [String],
    play: &'a [String],
    r#loop: &'a [String],
    suggestions: Vec<&'a str>,
    steps: Vec<steps::Step<'a>>,
}

/// All that there is to say.
struct Report {
    figures: Figures,
    existential: Vec<Existential>,
    diagnostics: Vec<Diagnostic>,
    explanation: Option<Explanation>,
}

pub(super) fn run(arguments: &Arguments, session: &mut Session) -> Result<Exit, Failure> {
    let drawing = arguments.sequence.as_deref();
    let drawn_to_stdout = drawing.is_some_and(input::is_stdin);
    if drawn_to_stdout && session.format() == Format::Json {
        return Err(Failure::usage("`--sequence -` and `--format json` cannot both go to stdout"));
    }
    output::refuse(drawing, &arguments.file)?;
    let given = input::given(&arguments.file)?;
    if given.is_plant {
        plant::refuse(&[
            ("--sequence", drawing.is_some()),
            ("--spill", arguments.spill.is_some()),
            ("--verdict", arguments.verdict),
            ("--symmetry", arguments.symmetry),
        ])?;
        return plant::check::run(&given, &arguments.warnings.policy(), arguments.follow, session);
    }
    plant::follow::refuse(arguments.follow)?;
    let loaded = session.parse(&given);
    if arguments.verdict {
        return verdict::run(&loaded, session);
    }
    if arguments.symmetry {
        return symmetry::run(&loaded, session);
    }
    let spec = session.specification(&loaded)?;
    if let Some(folder) = &arguments.spill {
        let census = spill::explore(folder, &loaded, &spec, session)?;
        let memory = session.limits().memory;
        if census.memory_to_solve() > memory as u64 {
            return spill::report(&census, &spec, memory, session);
        }
    }
    let mut solved = session.solve(&loaded, &spec)?;
    let policy = arguments.warnings.policy();
    let mut report = examine(&loaded, &spec, &mut solved, session)?;
    report.diagnostics.extend(session.all_warnings(&loaded, &mut solved)?);
    policy.apply(&mut report.diagnostics);
    if let Some(path) = drawing {
        steps::draw(path, report.explanation.as_ref(), &loaded)?;
    }
    match session.format() {
        Format::Json => output::print(&json(&report, &loaded))?,
        Format::Text if drawn_to_stdout => {
            output::note(text(&report, &spec, &loaded, session.color(&std::io::stderr())).trim_end());
        }
        Format::Text => output::print(&text(&report, &spec, &loaded, session.color(&std::io::stdout())))?,
    }
    let denied = report.diagnostics.iter().any(|one| policy.denies(one));
    Ok(if report.figures.realizable && !denied { Exit::Done } else { Exit::No })
}

fn examine(
    loaded: &Loaded,
    spec: &Spec,
    solved: &mut Solved<'_>,
    session: &mut Session,
) -> Result<Report, Failure> {
    let explanation = session.explain(solved);
    let place = |span| loaded.sources.place(span);
    let mut diagnostics: Vec<Diagnostic> =
        explanation.iter().map(|explanation| explanation.diagnostic_with(&place)).collect();
    let existential = if spec.scenarios.iter().any(|scenario| scenario.kind == Kind::Existential) {
        let controller = if explanation.is_none() {
            match session.synthesize(loaded, solved, &session.options(Level::default())) {
                Ok(verified) => Some(verified.controller),
                Err(failure) => {
                    diagnostics.extend(failure.wrong()?);
                    None
                }
            }
        } else {
            None
        };
        session.existential(loaded, spec, solved, controller.as_ref())?
    } else {
        Vec::new()
    };
    Ok(Report { figures: solved.figures(), existential, diagnostics, explanation })
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
        existential: existential.iter().map(scenario).collect(),
        diagnostics: to_json(diagnostics, &loaded.sources),
        explanation: explanation.as_ref().map(|explanation| because(explanation, &loaded.sources)),
    };
    format!("{}\n", serde_json::to_string(&document).expect("strings and numbers always serialize"))
}

fn scenario(existential: &Existential) -> Scenario<'_> {
    let Existential { scenario, reachable, possible, witness } = existential;
    Scenario { scenario, reachable: *reachable, possible: *possible, witness }
}

fn because<'a>(explanation: &'a Explanation, sources: &'a Sources) -> Because<'a> {
    let Explanation { cause, scenarios, is_minimal, involved, play, cycle, .. } = explanation;
    let suggestions = explanation.suggestions.iter().map(|suggestion| suggestion.text.as_str()).collect();
    Because {
        cause: cause.as_str(),
        scenarios,
        minimal: *is_minimal,
        involved,
        play,
        r#loop: cycle,
        suggestions,
        steps: steps::steps(explanation, sources),
    }
}

/// Rows of a name and a number.
fn rows<N: Display>(rows: impl IntoIterator<Item = (&'static str, N)>) -> String {
    rows.into_iter().map(|(name, count)| format!("  {name:<18} {count:>10}\n")).collect()
}

/// The figures of a game.
fn whole(figures: &WholeFigures) -> String {
    rows([
        ("states", figures.states),
        ("transitions", figures.transitions),
        ("system states", figures.system_states),
        ("environment states", figures.environment_states),
        ("yielded states", figures.yielded_states),
        ("idle states", figures.idle_states),
        ("winning states", figures.winning_states),
        ("assumption sets", figures.assumption_sets),
        ("guarantee sets", figures.guarantee_sets),
    ])
}

/// The diagnostics hold the explanation, too.
fn text(report: &Report, spec: &Spec, loaded: &Loaded, color: bool) -> String {
    let Report { figures, existential, diagnostics, .. } = report;
    let mut text = render(diagnostics, &loaded.sources, color);
    text.push_str(&format!(
        "{}: {}\n",
        spec.name,
        if figures.realizable { "realizable" } else { "not realizable" }
    ));
    text.push_str(&whole(&(*figures).into()));
    for Existential { scenario, reachable, possible, witness } in existential {
        let verdict = match (reachable, possible) {
            (true, _) => "happens in the controlled system",
            (false, true) => "can happen in some winning play, but not with this controller",
            (false, false) => "can happen in no winning play",
        };
        text.push_str(&format!("`{scenario}` {verdict}\n"));
        if !witness.is_empty() {
            text.push_str(&format!("  for example:\n    {}\n", witness.join("\n    ")));
        }
    }
    text
}

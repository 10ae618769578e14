//! `sml supervise`: state feedback as figures, a table and formulas.

use super::rungs::Rungs;
use super::{Controlled, control, modular};
use crate::failure::{Exit, Failure, nowhere};
use crate::options::Format;
use crate::session::{ReadPlant, Session};
use crate::warnings::{self, Warnings};
use crate::{input, output};
use std::path::PathBuf;
use synth_core::diagnostic::{Code, counted};
use synth_core::plant::{Plant, Realization, StateFeedback, write_json};

/// Arguments of `sml supervise`.
#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    /// The plant; `-` is stdin
    file: PathBuf,
    /// Where to write; stdout otherwise
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    #[command(flatten)]
    rungs: Rungs,
    #[command(flatten)]
    warnings: Warnings,
}

pub(in crate::commands) fn run(arguments: &Arguments, session: &mut Session) -> Result<Exit, Failure> {
    let Arguments { file, output, rungs, warnings } = arguments;
    output::refuse(output.as_deref(), file)?;
    let given = input::given(file)?;
    if !given.begins_a_plant() {
        return Err(no_plant(&given.name));
    }
    let ReadPlant { sources, plant, warnings: found, .. } = session.plant(&given)?;
    if rungs.is_modular() {
        let supervised = session.control_modular(&plant, rungs.options());
        let supervised = supervised.map_err(|failure| Failure::of(&failure, &sources))?;
        let found = [found, supervised.modular.warnings()].concat();
        warnings::show(found, &warnings.policy(), &sources, session)?;
        let text = match session.format() {
            Format::Json => modular::json(&plant, &supervised),
            Format::Text => modular::text(&plant, &supervised),
        };
        output::product(output.as_deref(), &text)?;
        return Ok(Exit::Done);
    }
    let controlled = control(&plant, rungs.options(), session);
    let controlled = controlled.map_err(|failure| Failure::of(&failure, &sources))?;
    let found = session.warnings_of_plant(found, &plant, &controlled.closed);
    warnings::show(found, &warnings.policy(), &sources, session)?;
    let text = match session.format() {
        Format::Json => json(&plant, &controlled),
        Format::Text => text(&plant, &controlled),
    };
    output::product(output.as_deref(), &text)?;
    Ok(Exit::Done)
}

/// A file of another kind.
fn no_plant(name: &str) -> Failure {
    let message = format!("`{name}` is no plant, and this is for plants");
    let error = nowhere(Code::Usage, message);
    Failure::new(
        Exit::Wrong,
        error
            .help("write `sml check` or `sml synth` for a specification; a plant begins with `plant Name {`"),
    )
}

/// Also what `sml export --target json` writes.
pub(super) fn json(plant: &Plant, controlled: &Controlled) -> String {
    let mut bytes = Vec::new();
    let realization = controlled.feedback.as_ref().map(|feedback| Realization::new(plant, feedback));
    write_json(plant, &controlled.closed, realization.as_ref(), &mut bytes).expect("memory takes all");
    String::from_utf8(bytes).expect("JSON is text")
}

fn text(plant: &Plant, controlled: &Controlled) -> String {
    let closed = &controlled.closed;
    let formulas = formulas(plant, controlled.feedback.as_ref());
    format!("{}\n{}\n{formulas}", closed.figures(), closed.table(plant))
}

/// The formulas, and what the program costs.
pub(super) fn formulas(plant: &Plant, feedback: Option<&StateFeedback>) -> String {
    let Some(StateFeedback { formulas, program }) = feedback else {
        return "no formulas: the plant declares no inputs and outputs\n".to_owned();
    };
    let formulas = formulas.iter().map(|formula| {
        let event = &plant.events[formula.event as usize].name;
        format!("{event}: {}\n", formula.words(program))
    });
    let mut text: String = formulas.collect();
    let figures = program.figures();
    text.push_str(&format!(
        "\n{}, {} in an instruction list, at most {} on the stack\n",
        counted(figures.rungs, "rung"),
        counted(figures.instructions, "instruction"),
        counted(figures.stack_depth, "Boolean"),
    ));
    text
}

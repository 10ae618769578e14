//! `sml export` of a plant: its program of rungs, diagrams, or the feedback as JSON.

use super::follow::{Follow, Followed, follow};
use super::rungs::Rungs;
use super::{Controlled, control, modular, refuse_given, supervise};
use crate::commands::export::{Arguments, Layout, Target};
use crate::failure::{Exit, Failure, nowhere};
use crate::input::Given;
use crate::options::Format;
use crate::session::{ReadPlant, Session};
use crate::{output, warnings};
use clap::ValueEnum;
use serde::Serialize;
use std::path::Path;
use synth_core::controller::tables::Provenance;
use synth_core::diagnostic::{Code, counted};
use synth_core::emit::scan::{Source, ladder, list};
use synth_core::emit::st::plcopen;
use synth_core::emit::{automata, rust, st};
use synth_core::plant::{ClosedLoop, Figures, Plant, Program};

/// Options of `sml export` that mean something to plants only.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(crate) struct Options {
    #[command(flatten)]
    rungs: Rungs,
    /// Plants: what the controller goes by; `states` otherwise
    #[arg(long, value_enum)]
    follow: Option<Follow>,
    /// Diagrams of plants: what is drawn; `automata` otherwise
    #[arg(long, value_enum)]
    of: Option<Drawn>,
}

/// What a diagram shows.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Drawn {
    /// Components and constraint automata
    Automata,
    /// These, and the plant under its feedback
    Loop,
    /// The rungs; SVG only
    Ladder,
}

impl Options {
    /// Refuses all of them, for a specification.
    pub(in crate::commands) fn refuse(self) -> Result<(), Failure> {
        let follow = ("--follow", self.follow.is_some());
        refuse_given(self.of_states().chain([follow]), "a specification")
    }

    /// The options that mean nothing to controllers that follow events.
    fn of_states(self) -> impl Iterator<Item = (&'static str, bool)> {
        self.rungs.given().into_iter().chain([("--of", self.of.is_some())])
    }

    fn words(self) -> String {
        let of = match self.of {
            Some(Drawn::Loop) => " --of loop",
            Some(Drawn::Ladder) => " --of ladder",
            Some(Drawn::Automata) | None => "",
        };
        format!("{of}{}", self.rungs.words())
    }
}

/// How a target is written.
enum Writer {
    /// Of the rungs.
    Program(Box<dyn Fn(&Source<'_>) -> String>),
    /// Of automata, and the closed loop if asked for.
    Diagram(fn(&Plant, Option<&ClosedLoop>) -> String),
    /// All that is known.
    Json,
}

pub(in crate::commands) fn run(
    arguments: &Arguments,
    given: &Given,
    session: &mut Session,
) -> Result<Exit, Failure> {
    let Arguments { target, plant: options, .. } = arguments;
    if Follow::events(options.follow) {
        return of_events(arguments, given, session);
    }
    refuse_given(arguments.of_tables(), "rungs; `--follow events` makes tables")?;
    let writer = writer(arguments)?;
    arguments.checks_something()?;
    output::refuse(arguments.output.as_deref(), &arguments.file)?;
    let read = session.plant(given)?;
    if options.rungs.is_modular() {
        return of_modules(arguments, &writer, &read, session);
    }
    let ReadPlant { sources, plant, warnings, provenance } = read;
    let controlled = match writer {
        Writer::Diagram(_) => session.feedback(&plant).map(|closed| Controlled { closed, feedback: None }),
        Writer::Program(_) | Writer::Json => control(&plant, options.rungs.options(), session),
    };
    let controlled = controlled.map_err(|failure| Failure::of(&failure, &sources))?;
    let warnings = session.warnings_of_plant(warnings, &plant, &controlled.closed);
    warnings::show(warnings, &arguments.warnings.policy(), &sources, session)?;
    let provenance = Provenance { options: options.words(), ..provenance };
    let text = session.stage("emit", || match &writer {
        Writer::Program(write) => {
            let feedback = controlled.feedback.as_ref().ok_or_else(|| no_signals(&plant.name, *target))?;
            let (program, events) = (&feedback.program, &plant.events[..]);
            Ok(write(&Source { program, events, provenance: &provenance }))
        }
        Writer::Diagram(draw) => Ok(draw(&plant, closed(*options, &controlled.closed)?)),
        Writer::Json => Ok(supervise::json(&plant, &controlled)),
    })?;
    let figures = controlled.feedback.map(|feedback| feedback.program.figures());
    write(arguments, &text, figures, session)
}

/// Writes the product, or compares it with what is there.
fn write(
    arguments: &Arguments,
    text: &str,
    figures: Option<Figures>,
    session: &Session,
) -> Result<Exit, Failure> {
    if arguments.check {
        arguments.compare(text)?.failure()?;
    } else {
        output::product(arguments.output.as_deref(), text)?;
    }
    if let Some(path) = arguments.file_written() {
        report(arguments, path, text, figures, session)?;
    }
    Ok(Exit::Done)
}

/// The program of modules.
fn of_modules(
    arguments: &Arguments,
    writer: &Writer,
    read: &ReadPlant,
    session: &mut Session,
) -> Result<Exit, Failure> {
    let Arguments { target, plant: options, .. } = arguments;
    let ReadPlant { sources, plant, warnings, provenance } = read;
    if matches!(writer, Writer::Diagram(_)) {
        return Err(Failure::usage(format!("`--modular` means nothing to target `{target}`")));
    }
    let supervised = session.control_modular(plant, options.rungs.options());
    let supervised = supervised.map_err(|failure| Failure::of(&failure, sources))?;
    let warnings = [&warnings[..], &supervised.modular.warnings()].concat();
    warnings::show(warnings, &arguments.warnings.policy(), sources, session)?;
    let provenance = Provenance { options: options.words(), ..provenance.clone() };
    let program = supervised.feedback.as_ref().map(|feedback| &feedback.program);
    let text = session.stage("emit", || match writer {
        Writer::Program(write) => {
            let program = program.ok_or_else(|| no_signals(&plant.name, *target))?;
            Ok(write(&Source { program, events: &plant.events, provenance: &provenance }))
        }
        _ => Ok(modular::json(plant, &supervised)),
    })?;
    write(arguments, &text, program.map(Program::figures), session)
}

/// The controller that follows events.
fn of_events(arguments: &Arguments, given: &Given, session: &mut Session) -> Result<Exit, Failure> {
    refuse_given(arguments.plant.of_states(), "a controller that follows events")?;
    refuse_given([("--monitor", arguments.monitor)], "a controller that follows events")?;
    no_rungs(arguments.target)?;
    let layout = Layout::new(arguments)?;
    let mut read = session.plant(given)?;
    let options = arguments.general_options(session);
    let Followed { controller, tables, warnings } = follow(&mut read, layout.level, &options, session)?;
    warnings::show(warnings, &arguments.warnings.policy(), &read.sources, session)?;
    layout.write(&tables, &controller, session)
}

/// Refuses targets of rungs.
pub(in crate::commands) fn no_rungs(target: Target) -> Result<(), Failure> {
    match target {
        Target::Ladder | Target::Il | Target::Svg => Err(Failure::usage(format!(
            "target `{target}` shows rungs, and a controller that follows events has tables"
        ))),
        _ => Ok(()),
    }
}

fn writer(arguments: &Arguments) -> Result<Writer, Failure> {
    let Arguments { target, plant: Options { of, .. }, .. } = arguments;
    let xml = arguments.xml();
    let program = |write: fn(&Source<'_>) -> String| Ok(Writer::Program(Box::new(write)));
    let is_diagram = matches!(target, Target::Dot | Target::Mermaid | Target::Svg);
    if of.is_some() && !is_diagram || *of == Some(Drawn::Ladder) && *target != Target::Svg {
        let word = of
            .and_then(|of| of.to_possible_value())
            .map_or_else(String::new, |value| value.get_name().to_owned());
        return Err(Failure::usage(format!("`--of {word}` means nothing to target `{target}`")));
    }
    match target {
        Target::Case => Err(no_tables(*target)),
        Target::Html => Err(Failure::unsupported(&format!("--target {target}"))),
        Target::Ladder => program(ladder::text),
        Target::Il => program(list::text),
        Target::Rust => program(rust::scan::text),
        Target::Plcopen => {
            Ok(Writer::Program(Box::new(move |source| plcopen::ladder::document(source, xml.dialect()))))
        }
        Target::Iec | Target::Codesys | Target::Twincat | Target::Siemens => {
            let dialect = target.structured_text(xml).unwrap_or_default();
            Ok(Writer::Program(Box::new(move |source| st::scan::text(source, dialect))))
        }
        Target::Svg if *of == Some(Drawn::Ladder) => program(ladder::drawing),
        Target::Svg => Ok(Writer::Diagram(automata::svg)),
        Target::Dot => Ok(Writer::Diagram(automata::dot)),
        Target::Mermaid => Ok(Writer::Diagram(automata::mermaid)),
        Target::Json => Ok(Writer::Json),
    }
}

/// The closed loop, if it is to be drawn and can be.
fn closed(options: Options, closed: &ClosedLoop) -> Result<Option<&ClosedLoop>, Failure> {
    if options.of != Some(Drawn::Loop) {
        return Ok(None);
    }
    if closed.len() > automata::MAX_ENTRIES {
        let (entries, most) = (closed.len(), automata::MAX_ENTRIES);
        let message = format!("the closed loop has {entries} entries, and at most {most} are drawn");
        return Err(Failure::new(Exit::Wrong, nowhere(Code::Unfit, message)));
    }
    Ok(Some(closed))
}

/// A target that lays out tables.
pub(super) fn no_tables(target: Target) -> Failure {
    let message =
        format!("target `{target}` is a layout of tables, and a controller that reads states has none");
    Failure::usage(message)
}

/// A target of rungs, for a plant without a signal.
pub(super) fn no_signals(plant: &str, target: Target) -> Failure {
    let message =
        format!("`{plant}` declares no inputs and outputs, so there are no rungs to write as `{target}`");
    Failure::new(
        Exit::Wrong,
        nowhere(Code::Unfit, message)
            .help("declare inputs and outputs, and formulas of states over them; or try `--follow events`"),
    )
}

/// Beside an output that is a file.
#[derive(Serialize)]
struct Document {
    version: u32,
    target: String,
    lines: usize,
    bytes: usize,
    /// None where there is no program, or none is asked for; likewise the others.
    instructions: Option<usize>,
    stack_depth: Option<usize>,
    rungs: Option<usize>,
}

fn report(
    arguments: &Arguments,
    path: &Path,
    text: &str,
    figures: Option<Figures>,
    session: &Session,
) -> Result<(), Failure> {
    let (lines, bytes) = (text.lines().count(), text.len());
    match session.format() {
        Format::Json => {
            let document = Document {
                version: 1,
                target: arguments.target.to_string(),
                lines,
                bytes,
                instructions: figures.map(|figures| figures.instructions),
                stack_depth: figures.map(|figures| figures.stack_depth),
                rungs: figures.map(|figures| figures.rungs),
            };
            let json = serde_json::to_string(&document).expect("strings and numbers always serialize");
            return output::print(&format!("{json}\n"));
        }
        Format::Text if arguments.check => {}
        Format::Text => {
            let (lines, bytes) = (counted(lines, "line"), counted(bytes, "byte"));
            output::note(&format!("{}: {lines}, {bytes}", path.display()));
        }
    }
    Ok(())
}

//! `sml export`: the controller in the language of a target.

mod figures;
pub(super) mod stale;
mod templates;

use super::plant;
use crate::failure::{Exit, Failure, nowhere};
use crate::options::{Format, Minimize};
use crate::session::Session;
use crate::warnings::{self, Warnings};
use crate::{input, output};
use clap::ValueEnum;
use stale::Found;
use std::fmt;
use std::path::{Path, PathBuf};
use synth_core::controller::json::to_json;
use synth_core::controller::tables::{Provenance, Tables};
use synth_core::controller::{Controller, Level};
use synth_core::diagnostic::Code;
use synth_core::emit::st::plcopen;
use synth_core::emit::template::Template;
use synth_core::emit::{dot, mermaid, rust, shell, st};
use synth_core::pipeline::provenance;

/// Arguments of `sml export`.
#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    /// The specification or plant; `-` is stdin
    pub(super) file: PathBuf,
    /// What to write
    #[arg(long, value_name = "T")]
    pub(super) target: Target,
    /// Where to write; stdout otherwise
    #[arg(short, long, value_name = "PATH")]
    pub(super) output: Option<PathBuf>,
    /// Write nothing; fail if PATH is not what would be written, or a template in DIR is missing or stale
    #[arg(long)]
    pub(super) check: bool,
    /// Also write templates of secondaries into this folder, those that are not there yet
    #[arg(long, value_name = "DIR")]
    templates: Option<PathBuf>,
    #[command(flatten)]
    minimize: Minimize,
    #[command(flatten)]
    pub(super) warnings: Warnings,
    #[command(flatten)]
    pub(super) plant: plant::export::Options,
    /// Rust: how the row of a state is found: `auto`, `search`, `runs` or `comb`
    #[arg(long, value_name = "ENGINE")]
    engine: Option<rust::Engine>,
    #[command(flatten)]
    text: StructuredText,
}

/// Options of Structured Text.
#[derive(Debug, clap::Args)]
struct StructuredText {
    #[command(flatten)]
    xml: Xml,
    /// Structured Text: an input raises its event when it becomes TRUE, or in every call in which it is
    #[arg(long, value_enum)]
    trigger: Option<Trigger>,
    /// Structured Text: what becomes of events that fit nowhere
    #[arg(long, value_enum)]
    unexpected: Option<Unexpected>,
    /// Structured Text: the integer types of states
    #[arg(long, value_enum)]
    integers: Option<Integers>,
    /// Structured Text: a call does all super steps that are due, up to a second command to a component
    #[arg(long)]
    drain: bool,
    /// Structured Text: how the tables hold transitions
    #[arg(long, value_enum)]
    encoding: Option<Encoding>,
    /// Structured Text: one more output, `owed`: which events the environment owes
    #[arg(long)]
    owed: bool,
    /// Structured Text: state and pending events survive a power cycle, unless the tables are others afterwards
    #[arg(long)]
    retain: bool,
}

/// Options of PLCopen XML.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(crate) struct Xml {
    /// PLCopen XML: whose Structured Text it holds; `iec` otherwise
    #[arg(long, value_enum)]
    dialect: Option<Dialect>,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Dialect {
    Iec,
    Codesys,
}

impl Xml {
    /// Refuses a dialect for a target that has none to choose.
    pub(crate) fn fits(self, target: Target) -> Result<(), Failure> {
        match self.dialect {
            Some(_) if target != Target::Plcopen => {
                Err(Failure::usage(format!("`--dialect` means nothing to target `{target}`")))
            }
            _ => Ok(()),
        }
    }

    pub(super) fn dialect(self) -> plcopen::Dialect {
        match self.dialect {
            Some(Dialect::Codesys) => plcopen::Dialect::Codesys,
            Some(Dialect::Iec) | None => plcopen::Dialect::Iec,
        }
    }
}

/// What can be written; some are to come.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub(crate) enum Target {
    Rust,
    Iec,
    Codesys,
    Twincat,
    Siemens,
    Case,
    Plcopen,
    Ladder,
    Il,
    Dot,
    Mermaid,
    Svg,
    Html,
    Json,
}

impl Target {
    /// Whose Structured Text it is.
    pub(crate) fn structured_text(self, xml: Xml) -> Option<st::Target> {
        match self {
            Target::Iec => Some(st::Target::Iec),
            Target::Codesys => Some(st::Target::Codesys),
            Target::Twincat => Some(st::Target::Twincat),
            Target::Siemens => Some(st::Target::Siemens),
            Target::Case => Some(st::Target::Case),
            Target::Plcopen => Some(xml.dialect().target()),
            _ => None,
        }
    }
}

impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.to_possible_value().as_ref().map_or("", |value| value.get_name()))
    }
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Trigger {
    Edge,
    Level,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Unexpected {
    Keep,
    Drop,
    Fault,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Integers {
    Unsigned,
    Signed,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Encoding {
    /// One array of targets, and runs of consecutive states
    Runs,
    /// Two arrays per event, as published
    Rows,
}

/// Makes the text of a target, or says why the target cannot hold the controller.
type Writer = fn(&Tables, &Controller, &Options) -> Result<String, String>;

/// Options of all targets.
struct Options {
    rust: rust::Options,
    text: st::Options,
}

pub(super) fn run(arguments: &Arguments, session: &mut Session) -> Result<Exit, Failure> {
    let xml = arguments.text.xml;
    xml.fits(arguments.target)?;
    let given = input::given(&arguments.file)?;
    if given.is_plant {
        return plant::export::run(arguments, &given, session);
    }
    arguments.plant.refuse()?;
    let structured_text = arguments.target.structured_text(xml);
    let write = writer(arguments.target, xml)?;
    if structured_text.is_none() && arguments.text.is_given() {
        return Err(Failure::usage(format!(
            "options of Structured Text mean nothing to target `{}`",
            arguments.target
        )));
    }
    if arguments.target != Target::Rust && arguments.engine.is_some() {
        return Err(Failure::usage(format!("`--engine` means nothing to target `{}`", arguments.target)));
    }
    if arguments.target == Target::Case && arguments.text.encoding.is_some() {
        return Err(Failure::usage("target `case` has no tables that `--encoding` could mean".to_owned()));
    }
    if arguments.templates.is_some() && structured_text.is_none() && arguments.target != Target::Rust {
        return Err(Failure::usage(format!("there are no templates for target `{}`", arguments.target)));
    }
    arguments.checks_something()?;
    let level = arguments.minimize.level().map_err(Failure::unsupported)?;
    output::refuse(arguments.output.as_deref(), &arguments.file)?;
    let loaded = session.parse(&given);
    let spec = session.specification(&loaded)?;
    let mut solved = session.solve(&loaded, &spec)?;
    let controller = session.synthesize(&loaded, &mut solved, level)?.controller;
    let policy = arguments.warnings.policy();
    let warnings = session.warnings_beside(&loaded, &mut solved, &policy)?;
    warnings::show(warnings, &policy, &loaded, session)?;
    let provenance = Provenance { options: arguments.general_options(session), ..provenance(&loaded, &spec) };
    let tables = Tables::new(&spec.name, &controller, provenance);
    let rust = rust::Options { engine: arguments.engine.unwrap_or_default(), ..rust::Options::default() };
    let options = Options { rust, text: arguments.text.options(structured_text.unwrap_or_default()) };
    let unfit = |why| Failure::new(Exit::Wrong, nowhere(Code::Unfit, why));
    let text = session.stage("emit", || write(&tables, &controller, &options)).map_err(unfit)?;
    let secondaries = match &arguments.templates {
        Some(folder) => {
            Some((folder, templates::of(arguments.target, &tables, &options.text).map_err(unfit)?))
        }
        None => None,
    };
    if arguments.check {
        check(arguments, &text, secondaries)?;
    } else {
        // The product comes last: if anything fails, it stays as it was.
        if let Some((folder, secondaries)) = &secondaries {
            templates::refuse(arguments.output.as_deref(), folder, secondaries)?;
            templates::write(folder, secondaries, session)?;
        }
        output::product(arguments.output.as_deref(), &text)?;
    }
    if let Some(path) = arguments.file_written() {
        match session.format() {
            Format::Json => {
                let options = structured_text.map(|_| &options.text);
                output::print(&figures::json(arguments.target, &text, &tables, options))?;
            }
            Format::Text if arguments.check => {}
            Format::Text => output::note(&figures::line(&path.display().to_string(), &text, &tables)),
        }
    }
    Ok(Exit::Done)
}

fn writer(target: Target, xml: Xml) -> Result<Writer, Failure> {
    Ok(match target {
        Target::Rust => |tables, _, options| Ok(rust::text(tables, &options.rust)),
        Target::Plcopen => match xml.dialect() {
            plcopen::Dialect::Iec => {
                |tables, _, options| document(tables, plcopen::Dialect::Iec, &options.text)
            }
            plcopen::Dialect::Codesys => {
                |tables, _, options| document(tables, plcopen::Dialect::Codesys, &options.text)
            }
        },
        target if target.structured_text(xml).is_some() => {
            |tables, _, options| st::text(tables, &options.text).map_err(|unfit| unfit.to_string())
        }
        Target::Dot => |tables, _, _| Ok(dot::text(tables)),
        Target::Mermaid => |tables, _, _| Ok(mermaid::text(tables)),
        Target::Json => |_, controller, _| Ok(to_json(controller)),
        other => return Err(Failure::unsupported(&format!("--target {other}"))),
    })
}

fn document(tables: &Tables, dialect: plcopen::Dialect, options: &st::Options) -> Result<String, String> {
    plcopen::document(tables, dialect, options).map_err(|unfit| unfit.to_string())
}

/// `--check`: whether everything is there and up to date.
fn check(
    arguments: &Arguments,
    text: &str,
    secondaries: Option<(&PathBuf, Vec<Template>)>,
) -> Result<(), Failure> {
    let mut found = arguments.compare(text)?;
    if let Some((folder, secondaries)) = secondaries {
        templates::check(&mut found, folder, &secondaries)?;
    }
    found.failure()
}

impl Arguments {
    /// The options that mean nothing to plants, and whether they are given.
    pub(super) fn of_specifications(&self) -> [(&'static str, bool); 10] {
        let StructuredText { trigger, unexpected, integers, drain, encoding, owed, retain, .. } = &self.text;
        [
            ("--templates", self.templates.is_some()),
            ("--minimize", self.minimize.is_given()),
            ("--engine", self.engine.is_some()),
            ("--trigger", trigger.is_some()),
            ("--unexpected", unexpected.is_some()),
            ("--integers", integers.is_some()),
            ("--drain", *drain),
            ("--encoding", encoding.is_some()),
            ("--owed", *owed),
            ("--retain", *retain),
        ]
    }

    pub(super) fn checks_something(&self) -> Result<(), Failure> {
        if self.check && self.file_written().is_none() && self.templates.is_none() {
            return Err(Failure::usage(
                "`--check` needs something to check: a file of `--output`, or `--templates`",
            ));
        }
        Ok(())
    }

    /// Whose Structured Text PLCopen XML holds.
    pub(super) fn xml(&self) -> Xml {
        self.text.xml
    }

    /// What the product is written to, unless that is stdout.
    pub(super) fn file_written(&self) -> Option<&Path> {
        self.output.as_deref().filter(|path| path.as_os_str() != "-")
    }

    /// What is wrong with the file of the product; nothing if there is none.
    pub(super) fn compare(&self, text: &str) -> Result<Found, Failure> {
        let mut found = Found::default();
        if let Some(path) = self.file_written() {
            stale::compare(&mut found, path, text, || {
                let output = shell::quoted(&path.display().to_string());
                let file = shell::input(&input::name(&self.file));
                format!("run `sml export {file} --target {} -o {output}` with the same options", self.target)
            })?;
        }
        Ok(found)
    }

    /// The options that are not a target's own, as far as they change what is written.
    fn general_options(&self, session: &Session) -> String {
        let classic = if session.semantics().classic { " --classic" } else { "" };
        let level = match self.minimize.level() {
            Ok(Level::None) => " --minimize none",
            _ => "",
        };
        let folder = self.templates.as_ref().map(|folder| shell::quoted(&folder.display().to_string()));
        let templates = folder.map(|folder| format!(" --templates {folder}")).unwrap_or_default();
        format!("{classic}{level}{templates}")
    }
}

impl StructuredText {
    fn is_given(&self) -> bool {
        self.trigger.is_some()
            || self.unexpected.is_some()
            || self.integers.is_some()
            || self.drain
            || self.encoding.is_some()
            || self.owed
            || self.retain
    }

    fn options(&self, target: st::Target) -> st::Options {
        st::Options {
            target,
            trigger: match self.trigger {
                Some(Trigger::Level) => st::Trigger::Level,
                Some(Trigger::Edge) | None => st::Trigger::Edge,
            },
            integers: match self.integers {
                Some(Integers::Signed) => st::Integers::Signed,
                Some(Integers::Unsigned) | None => st::Integers::Unsigned,
            },
            drain: self.drain,
            unexpected: match self.unexpected {
                Some(Unexpected::Drop) => st::Unexpected::Drop,
                Some(Unexpected::Fault) => st::Unexpected::Fault,
                Some(Unexpected::Keep) | None => st::Unexpected::Keep,
            },
            encoding: match self.encoding {
                Some(Encoding::Rows) => st::Encoding::Rows,
                Some(Encoding::Runs) | None => st::Encoding::Runs,
            },
            owed: self.owed,
            retain: self.retain,
        }
    }
}

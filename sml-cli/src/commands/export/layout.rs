//! Tables in the language of a target: the way that controllers of specifications and those that follow the events of a plant
//! share.

use super::stale::Found;
use super::target::{Target, Xml};
use super::{Arguments, figures, templates};
use crate::failure::{Exit, Failure, nowhere};
use crate::options::Format;
use crate::output;
use crate::session::Session;
use std::path::PathBuf;
use synth_core::controller::json::{monitor_to_json, to_json_at};
use synth_core::controller::tables::Tables;
use synth_core::controller::{Controller, Level};
use synth_core::diagnostic::Code;
use synth_core::emit::st::plcopen;
use synth_core::emit::template::Template;
use synth_core::emit::{dot, mermaid, rust, st};

/// Makes the text of a target, or says why the target cannot hold the controller.
type Writer = fn(&Tables, &Controller, &Options) -> Result<String, String>;

/// Options of all targets.
struct Options {
    rust: rust::Options,
    text: st::Options,
    /// For JSON, which says it.
    level: Level,
}

/// How tables are written.
pub(in crate::commands) struct Layout<'a> {
    arguments: &'a Arguments,
    write: Writer,
    options: Options,
    /// How the controller is made smaller.
    pub(in crate::commands) level: Level,
}

impl<'a> Layout<'a> {
    /// Refuses options that mean nothing to the target.
    pub(in crate::commands) fn new(arguments: &'a Arguments) -> Result<Self, Failure> {
        let Arguments { target, text, engine, templates, .. } = arguments;
        let usage = |message: String| Err(Failure::usage(message));
        let structured_text = target.structured_text(text.xml);
        let write = writer(*target, text.xml)?;
        if structured_text.is_none() && text.is_given() {
            return usage(format!("options of Structured Text mean nothing to target `{target}`"));
        }
        if *target != Target::Rust && engine.is_some() {
            return usage(format!("`--engine` means nothing to target `{target}`"));
        }
        if *target == Target::Case && text.encoding.is_some() {
            return usage("target `case` has no tables that `--encoding` could mean".to_owned());
        }
        if templates.is_some() && structured_text.is_none() && *target != Target::Rust {
            return usage(format!("there are no templates for target `{target}`"));
        }
        if arguments.monitor && text.owed() {
            return usage(
                "`--owed` means nothing to a monitor: what is owed is for the controller to say".to_owned(),
            );
        }
        arguments.checks_something()?;
        let level = arguments.minimize.level();
        if level == Level::Ordered && structured_text.is_some() {
            return usage(format!(
                "target `{target}` reads all inputs of a scan at once, and `--minimize ordered` needs events one at a time; \
                 `--minimize assume` is for that"
            ));
        }
        output::refuse(arguments.output.as_deref(), &arguments.file)?;
        let rust = rust::Options { engine: engine.unwrap_or_default(), ordered: level == Level::Ordered };
        let options = Options {
            rust,
            text: text.options(structured_text.unwrap_or_default()),
            level: if arguments.monitor { Level::default() } else { level },
        };
        Ok(Layout { arguments, write, options, level })
    }

    /// Writes the product and what goes with it, or compares it with what is there; says how large it is.
    pub(in crate::commands) fn write(
        &self,
        tables: &Tables,
        controller: &Controller,
        session: &mut Session,
    ) -> Result<Exit, Failure> {
        let Layout { arguments, write, options, .. } = self;
        let unfit = |why| Failure::new(Exit::Wrong, nowhere(Code::Unfit, why));
        let text = session.stage("emit", || write(tables, controller, options)).map_err(unfit)?;
        let secondaries = match &arguments.templates {
            Some(folder) => {
                Some((folder, templates::of(arguments.target, tables, &options.text).map_err(unfit)?))
            }
            None => None,
        };
        if arguments.check {
            self.check(&text, secondaries)?.failure()?;
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
                    let is_text = arguments.target.structured_text(arguments.text.xml).is_some();
                    let options = is_text.then_some(&options.text);
                    output::print(&figures::json(arguments.target, &text, tables, options))?;
                }
                Format::Text if arguments.check => {}
                Format::Text => output::note(&figures::line(&path.display().to_string(), &text, tables)),
            }
        }
        Ok(Exit::Done)
    }

    /// `--check`: what is missing or not up to date.
    fn check(&self, text: &str, secondaries: Option<(&PathBuf, Vec<Template>)>) -> Result<Found, Failure> {
        let mut found = self.arguments.compare(text)?;
        if let Some((folder, secondaries)) = secondaries {
            templates::check(&mut found, folder, &secondaries)?;
        }
        Ok(found)
    }
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
        Target::Json => |tables, controller, options| {
            Ok(match tables.provenance.monitor {
                true => monitor_to_json(controller),
                false => to_json_at(controller, options.level),
            })
        },
        other => return Err(Failure::unsupported(&format!("--target {other}"))),
    })
}

fn document(tables: &Tables, dialect: plcopen::Dialect, options: &st::Options) -> Result<String, String> {
    plcopen::document(tables, dialect, options).map_err(|unfit| unfit.to_string())
}

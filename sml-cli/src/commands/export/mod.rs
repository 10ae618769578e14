//! `sml export`: the controller in the language of a target.

mod figures;
mod layout;
mod specification;
pub(super) mod stale;
mod structured_text;
mod target;
mod templates;

pub(super) use layout::Layout;
pub(crate) use target::{Target, Xml};

use super::plant;
use crate::failure::{Exit, Failure};
use crate::input;
use crate::options::Minimize;
use crate::session::Session;
use crate::warnings::Warnings;
use stale::Found;
use std::path::{Path, PathBuf};
use structured_text::StructuredText;
use synth_core::emit::{rust, shell};

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
    /// Write the monitor of the controller instead: which events are expected, without commands
    #[arg(long, conflicts_with_all = ["minimize", "no_minimize", "templates"])]
    pub(super) monitor: bool,
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

pub(super) fn run(arguments: &Arguments, session: &mut Session) -> Result<Exit, Failure> {
    arguments.text.xml.fits(arguments.target)?;
    let given = input::given(&arguments.file)?;
    if given.is_plant {
        return plant::export::run(arguments, &given, session);
    }
    arguments.plant.refuse()?;
    specification::run(arguments, &given, session)
}

impl Arguments {
    /// The options that mean nothing to targets without tables, and whether they are given.
    pub(super) fn of_tables(&self) -> impl Iterator<Item = (&'static str, bool)> {
        let others = [
            ("--templates", self.templates.is_some()),
            ("--minimize", self.minimize.is_given()),
            ("--monitor", self.monitor),
            ("--engine", self.engine.is_some()),
        ];
        others.into_iter().chain(self.text.given())
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
    pub(super) fn general_options(&self, session: &Session) -> String {
        let classic = if session.semantics().classic { " --classic" } else { "" };
        let level = if self.monitor { " --monitor".to_owned() } else { self.minimize.level().option() };
        let folder = self.templates.as_ref().map(|folder| shell::quoted(&folder.display().to_string()));
        let templates = folder.map(|folder| format!(" --templates {folder}")).unwrap_or_default();
        format!("{classic}{level}{templates}")
    }
}

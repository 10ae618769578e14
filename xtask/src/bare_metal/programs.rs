//! The programs, and how they are built.

use super::folders::Folders;
use super::target::Target;
use super::toolchain::Toolchain;
use crate::failure::Result;
use crate::process;
use measured::{play, tours};
use production_cell::production_cell::Controller;
use production_cell::random::Random;
use std::fmt::Write as _;
use std::path::PathBuf;

/// A program of the firmware's workspace.
pub(crate) struct Program {
    /// Its package.
    pub(crate) name: &'static str,
    /// Beginnings of the targets that it is for.
    targets: &'static [&'static str],
    /// What it writes when it runs on this machine.
    pub(crate) on_host: Option<fn() -> String>,
    /// Whether what it writes is a log of defmt.
    pub(crate) logs: bool,
    /// What is counted and read.
    pub(crate) steps: Steps,
}

/// Functions that are counted and read.
pub(crate) enum Steps {
    /// None.
    None,
    /// Every operation of a module of `measured`.
    Operations(&'static str),
    /// `accepts`, of every module in `measured::engines`.
    LookUps,
}

impl Steps {
    /// What a function is called in the figures, if it is one of them.
    pub(crate) fn label<'f>(&self, function: &'f str) -> Option<&'f str> {
        let path = function.strip_prefix("measured::")?;
        let label = match self {
            Steps::None => return None,
            Steps::Operations(module) => path.strip_prefix(module)?.strip_prefix("::")?,
            Steps::LookUps => path.strip_prefix("engines::")?.strip_suffix("::accepts")?,
        };
        (!label.contains([':', '<'])).then_some(label)
    }
}

const ARM: &[&str] = &["thumb"];
const EVERY: &[&str] = &["thumb", "riscv32"];

pub(crate) const ALL: &[Program] = &[
    Program { name: "cell", targets: EVERY, on_host: Some(cell), logs: false, steps: Steps::None },
    Program {
        name: "trace",
        targets: EVERY,
        on_host: Some(played::<measured::cell::Controller>),
        logs: false,
        steps: Steps::Operations("cell"),
    },
    Program {
        name: "thousand",
        targets: EVERY,
        on_host: Some(played::<measured::line::Controller>),
        logs: false,
        steps: Steps::Operations("line"),
    },
    Program { name: "look-up", targets: EVERY, on_host: Some(toured), logs: false, steps: Steps::LookUps },
    Program { name: "interrupts", targets: ARM, on_host: None, logs: false, steps: Steps::None },
    Program { name: "inline", targets: EVERY, on_host: None, logs: false, steps: Steps::None },
    Program { name: "embassy-task", targets: ARM, on_host: None, logs: false, steps: Steps::None },
    Program { name: "log", targets: EVERY, on_host: None, logs: true, steps: Steps::None },
    Program {
        name: "rtic-application",
        targets: &["thumbv7m"],
        on_host: None,
        logs: false,
        steps: Steps::None,
    },
];

impl Program {
    pub(crate) fn is_for(&self, target: &Target) -> bool {
        self.targets.iter().any(|beginning| target.triple.starts_with(beginning))
    }

    /// Compiles it and says where it is.
    pub(crate) fn build(&self, folders: &Folders, toolchain: &Toolchain, target: &Target) -> Result<PathBuf> {
        process::text(toolchain.cargo(folders, "build").args(["--package", self.name]))?;
        Ok(folders.build().join(target.triple).join("release").join(self.name))
    }
}

fn played<C: measured::Steps>() -> String {
    format!("{}\n", play::<C>())
}

fn toured() -> String {
    tours().map(|(name, tour)| format!("{name}: {}\n", tour())).collect()
}

/// As many items as the program has.
fn cell() -> String {
    let mut text = String::new();
    let report = production_cell::run(&mut Controller::new(), 100, Random::new(1), &mut |line| {
        text.push_str(&line);
        text.push('\n');
    });
    let _ = writeln!(text, "\n{report}");
    text
}

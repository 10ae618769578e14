//! The programs, and how they are built.

use super::folders::Folders;
use super::target::Target;
use super::toolchain::Toolchain;
use crate::failure::Result;
use crate::process;
use measured::{Steps, play};
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
    /// The module whose functions are counted and read.
    pub(crate) steps: Option<&'static str>,
}

const ARM: &[&str] = &["thumb"];
const EVERY: &[&str] = &["thumb", "riscv32"];

pub(crate) const ALL: &[Program] = &[
    Program { name: "cell", targets: EVERY, on_host: Some(cell), steps: None },
    Program {
        name: "trace",
        targets: EVERY,
        on_host: Some(played::<measured::cell::Controller>),
        steps: Some("measured::cell::"),
    },
    Program {
        name: "thousand",
        targets: EVERY,
        on_host: Some(played::<measured::line::Controller>),
        steps: Some("measured::line::"),
    },
    Program { name: "interrupts", targets: ARM, on_host: None, steps: None },
    Program { name: "inline", targets: EVERY, on_host: None, steps: None },
    Program { name: "embassy-task", targets: ARM, on_host: None, steps: None },
    Program { name: "rtic-application", targets: &["thumbv7m"], on_host: None, steps: None },
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

fn played<C: Steps>() -> String {
    format!("{}\n", play::<C>())
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

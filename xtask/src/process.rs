//! Other programs, run to their end.

use crate::failure::{At, Failure, Result};
use std::env;
use std::path::PathBuf;
use std::process::{Command, Output};

/// Runs a program whatever it exits with.
pub(crate) fn output(command: &mut Command) -> Result<Output> {
    let name = command.get_program().to_string_lossy().into_owned();
    command.output().doing(format_args!("run `{name}`"))
}

/// Runs a program that must succeed, and returns what it writes to its standard output.
pub(crate) fn text(command: &mut Command) -> Result<String> {
    let Output { status, stdout, stderr } = output(command)?;
    if status.success() {
        return Ok(String::from_utf8_lossy(&stdout).into_owned());
    }
    let name = command.get_program().to_string_lossy();
    let arguments: Vec<_> = command.get_args().map(|argument| argument.to_string_lossy()).collect();
    let said = String::from_utf8_lossy(&stderr);
    Err(Failure::new(format!("`{name} {}` failed ({status}):\n{}", arguments.join(" "), said.trim_end())))
}

/// Where a program is, if `PATH` has it.
pub(crate) fn find(name: &str) -> Option<PathBuf> {
    let path = env::var_os("PATH")?;
    env::split_paths(&path).map(|folder| folder.join(name)).find(|file| file.is_file())
}

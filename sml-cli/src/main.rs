//! The command `sml`: a thin face of `synth-core`.
//!
//! [`options`] says what can be asked, [`commands`] answers, one module per subcommand. Files come in through
//! [`input`], products go out through [`output`], and whatever goes wrong is a [`failure::Failure`], which knows its
//! exit code. [`session`] runs the stages of the pipeline and keeps the time.

mod commands;
mod failure;
mod input;
mod interrupt;
mod memory;
mod options;
mod output;
mod session;
mod timings;
mod warnings;

use clap::Parser as _;
use failure::{Exit, Failure};
use options::{Cli, Format};
use std::ffi::OsString;
use std::process::ExitCode;

fn main() -> ExitCode {
    std::panic::set_hook(Box::new(|panic| {
        output::note(&format!(
            "error: this is a bug in sml {}, please report it: {panic}",
            env!("CARGO_PKG_VERSION")
        ));
    }));
    let arguments: Vec<OsString> = std::env::args_os().collect();
    match Cli::try_parse_from(&arguments) {
        Ok(Cli { common, command }) => {
            let mut session = session::Session::new(common);
            let result = commands::run(&command, &mut session);
            session.print_timings();
            result
                .unwrap_or_else(|failure| failure.report(session.format(), session.color(&std::io::stderr())))
                .into()
        }
        Err(error) => misused(&error, &arguments).into(),
    }
}

/// Wrong usage, or a question for help or version.
fn misused(error: &clap::Error, arguments: &[OsString]) -> Exit {
    if error.exit_code() == 0 {
        // A reader that has seen enough is no failure.
        let _ = error.print();
        return Exit::Done;
    }
    if asks_for_json(arguments) {
        let text = error.to_string();
        let message = text.lines().next().unwrap_or_default();
        let message = message.strip_prefix("error: ").unwrap_or(message);
        return Failure::usage(message).report(Format::Json, false);
    }
    let _ = error.print();
    Exit::Wrong
}

/// Whether the arguments, which could not be understood as a whole, ask for JSON.
fn asks_for_json(arguments: &[OsString]) -> bool {
    arguments.iter().any(|argument| argument == "--format=json")
        || arguments.windows(2).any(|pair| pair[0] == "--format" && pair[1] == "json")
}

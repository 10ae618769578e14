//! Why a command has nothing to show, and the exit code that says so.

use crate::options::Format;
use crate::output;
use serde_json::{Value as Json, json};
use std::process::ExitCode;
use synth_core::diagnostic::{Code, Diagnostic, counted, render, to_json};
use synth_core::external::{ExternalError, Progress};
use synth_core::pipeline;
use synth_core::syntax::{Pos, Sources, Span};

/// The published exit codes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Exit {
    /// Done, and the answer is yes where one was asked for.
    Done = 0,
    /// Unrealizable, not verified, stale, denied or not executable.
    No = 1,
    /// Wrong content or wrong usage.
    Wrong = 2,
    /// A limit was reached.
    Limit = 3,
    /// A file cannot be opened or written.
    File = 4,
    /// Somebody asked to stop: 128 and the number of the signal of Ctrl-C.
    Interrupted = 130,
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        ExitCode::from(exit as u8)
    }
}

/// What went wrong, ready to be shown.
#[derive(Debug)]
pub(crate) struct Failure {
    exit: Exit,
    diagnostics: Vec<Diagnostic>,
    sources: Sources,
}

impl Failure {
    /// Something that concerns no place in a specification.
    pub(crate) fn new(exit: Exit, diagnostic: Diagnostic) -> Self {
        Failure { exit, diagnostics: vec![diagnostic], sources: Sources::new() }
    }

    /// Something that concerns a place in a specification.
    pub(crate) fn at(exit: Exit, diagnostic: Diagnostic, sources: &Sources) -> Self {
        Failure { exit, diagnostics: vec![diagnostic], sources: sources.clone() }
    }

    /// Several things that concern places in these texts.
    pub(crate) fn all(exit: Exit, diagnostics: Vec<Diagnostic>, sources: Sources) -> Self {
        Failure { exit, diagnostics, sources }
    }

    /// Arguments that make no sense.
    pub(crate) fn usage(message: impl Into<String>) -> Self {
        Failure::new(Exit::Wrong, nowhere(Code::Usage, message).help("see `sml --help`"))
    }

    /// A line that was typed and makes no sense.
    pub(crate) fn line(message: impl Into<String>) -> Self {
        Failure::new(Exit::Wrong, nowhere(Code::Usage, message).help("type `help` for what can be said here"))
    }

    /// What is part of the interface, but not there yet.
    pub(crate) fn unsupported(what: &str) -> Self {
        Failure::new(Exit::Wrong, nowhere(Code::Unsupported, format!("`{what}` is not supported yet")))
    }

    /// An input that is not a specification and is malformed.
    pub(crate) fn malformed(code: Code, path: &str, why: &str) -> Self {
        Failure::new(Exit::Wrong, nowhere(code, format!("`{path}`: {why}")))
    }

    /// As [`Failure::malformed`], at a place of that file, whose text is not shown.
    pub(crate) fn malformed_at(code: Code, path: &str, why: &str, place: Option<Pos>) -> Self {
        let mut sources = Sources::new();
        let file = sources.add(path, "");
        let start = place.unwrap_or_default();
        let span = Span { file, start, end: start };
        let diagnostic = Diagnostic::error(code, span, format!("`{path}`: {why}"));
        Failure { exit: Exit::Wrong, diagnostics: vec![diagnostic], sources }
    }

    /// A file that cannot be opened.
    pub(crate) fn unreadable(path: &str, error: &std::io::Error) -> Self {
        Failure::new(Exit::File, nowhere(Code::Unreadable, format!("`{path}` cannot be read: {error}")))
    }

    /// An output that cannot be written.
    pub(crate) fn unwritable(path: &str, error: &std::io::Error) -> Self {
        Failure::new(Exit::File, nowhere(Code::Unwritable, format!("`{path}` cannot be written: {error}")))
    }

    /// A failure of the pipeline.
    pub(crate) fn of(failure: &pipeline::Failure, sources: &Sources) -> Self {
        use pipeline::Failure as F;
        let exit = match failure {
            F::Wrong(wrong) if wrong.iter().all(|one| one.code == Code::LimitReached) => Exit::Limit,
            F::Wrong(_) => Exit::Wrong,
            F::Limit(_) => Exit::Limit,
            F::Unrealizable(_) | F::Refused(_) | F::Unverified(_) | F::Inconsistent(_) => Exit::No,
        };
        let diagnostics = failure.diagnostics();
        Failure { exit, diagnostics, sources: sources.clone() }
    }

    /// A failure of exploration on disk; `again` is what to do to go on.
    pub(crate) fn of_external(error: ExternalError, sources: &Sources, again: &str) -> Self {
        use ExternalError as E;
        match error {
            E::Explore(error) => Failure::of(&error.into(), sources),
            E::Stopped(progress) => {
                let Progress { states, explored, transitions, layers } = progress;
                let found = format!(
                    "found {}, {explored} of them explored, {}, up to {} from the initial state",
                    counted(states as usize, "state"),
                    counted(transitions as usize, "transition"),
                    counted(layers, "step")
                );
                let error = nowhere(Code::Interrupted, "exploration was interrupted");
                Failure::new(Exit::Interrupted, error.note(found).help(again.to_owned()))
            }
            E::Other(path, what) => {
                let message = format!("`{}` is of {what}", path.display());
                let help = "name another folder, or remove this one to begin anew";
                Failure::new(Exit::Wrong, nowhere(Code::NotResumable, message).help(help))
            }
            E::Damaged(path, what) => {
                let message = format!("`{}` is damaged: {what}", path.display());
                let help = "remove the folder to begin anew";
                Failure::new(Exit::Wrong, nowhere(Code::NotResumable, message).help(help))
            }
            E::Read(path, error) => Failure::unreadable(&path.display().to_string(), &error),
            E::Write(path, error) => Failure::unwritable(&path.display().to_string(), &error),
        }
    }

    /// Its diagnostics as JSON.
    pub(crate) fn json(&self) -> Json {
        to_json(&self.diagnostics, &self.sources)
    }

    /// What is wrong with the specification, if that is what it is about.
    pub(crate) fn wrong(self) -> Result<Vec<Diagnostic>, Failure> {
        if self.exit == Exit::Wrong { Ok(self.diagnostics) } else { Err(self) }
    }

    /// Whether whoever types commands can go on after it: nothing is broken.
    pub(crate) fn can_be_mended(&self) -> bool {
        let ours = |one: &Diagnostic| matches!(one.code, Code::Usage | Code::MalformedScript);
        match self.exit {
            Exit::No | Exit::File => true,
            _ => self.diagnostics.iter().all(ours),
        }
    }

    /// Shows it: JSON on stdout, or text on stderr. A product that went to stdout is none for whoever gets this.
    pub(crate) fn report(&self, format: Format, color: bool) -> Exit {
        self.report_by(output::print, format, color)
    }

    /// The same with another way to print to stdout.
    pub(crate) fn report_by(
        &self,
        print: impl FnOnce(&str) -> Result<(), Failure>,
        format: Format,
        color: bool,
    ) -> Exit {
        match format {
            Format::Json => {
                let document = json!({ "version": 1, "diagnostics": self.json() });
                if let Err(failure) = print(&format!("{document}\n")) {
                    return failure.report(Format::Text, color);
                }
            }
            Format::Text => output::note(render(&self.diagnostics, &self.sources, color).trim_end()),
        }
        self.exit
    }
}

/// An error without a place.
pub(crate) fn nowhere(code: Code, message: impl Into<String>) -> Diagnostic {
    Diagnostic::error(code, Span::default(), message)
}

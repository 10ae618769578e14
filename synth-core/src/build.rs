//! For build scripts: `synth_core::build::compile("specs/cell.sml")` writes `$OUT_DIR/cell.rs`.
//!
//! ```no_run
//! // build.rs
//! synth_core::build::compile("specs/cell.sml");
//! ```
//!
//! ```text
//! // src/main.rs
//! include!(concat!(env!("OUT_DIR"), "/cell.rs"));
//! ```
//!
//! Cargo runs the script again when the specification changes, or a file that it imports. A wrong or unrealizable
//! specification ends the build with the same message that `sml check` prints.

use crate::diagnostic::{Code, Diagnostic, render};
use crate::emit::rust;
use crate::explore::Limits;
use crate::pipeline::{Options, Timings, compile as run};
use crate::syntax::{load, read_bounded};
use std::path::{Path, PathBuf};
use std::{env, fs, io, process};

/// Compiles the specification at `path` (relative to the package) with the default options.
///
/// Does not return if that fails: the message goes to the standard error and the build script ends with status 1.
pub fn compile(path: impl AsRef<Path>) {
    Build::new().compile(path);
}

/// A compilation with options.
#[derive(Clone, Copy, Debug, Default)]
pub struct Build {
    options: Options,
}

impl Build {
    /// With the default options.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// How the controller is made smaller, how the winning condition is read.
    #[must_use]
    pub fn options(mut self, options: Options) -> Self {
        self.options = options;
        self
    }

    /// Gives up with a clear message beyond this many states.
    #[must_use]
    pub fn max_states(mut self, states: usize) -> Self {
        self.options.limits = Limits { states, ..self.options.limits };
        self
    }

    /// As [`compile`].
    pub fn compile(self, path: impl AsRef<Path>) {
        if let Err(message) = self.try_compile(path.as_ref()) {
            eprintln!("{message}");
            process::exit(1);
        }
    }

    fn try_compile(self, path: &Path) -> Result<(), String> {
        let out = folder("OUT_DIR")?;
        let package = folder("CARGO_MANIFEST_DIR")?;
        let shown = path.display().to_string();
        let bytes = read(&package, &shown).map_err(|why| format!("error: {shown} cannot be read: {why}"))?;
        let loaded = load(&shown, &bytes, &mut |path| read(&package, path));
        let tables = run(&loaded, &self.options, &mut Timings::default()).map_err(|failure| {
            let diagnostics: Vec<Diagnostic> = failure.diagnostics().into_iter().map(advise).collect();
            render(&diagnostics, &loaded.sources, false)
        })?;
        let mut name = path.file_stem().unwrap_or(path.as_os_str()).to_owned();
        name.push(".rs");
        let target = out.join(name);
        let text = rust::text(&tables, &rust::Options::default());
        replace(&target, &text).map_err(|why| format!("error: {} cannot be written: {why}", target.display()))
    }
}

/// A build script has no options of a command line.
fn advise(diagnostic: Diagnostic) -> Diagnostic {
    if diagnostic.code != Code::LimitReached {
        return diagnostic;
    }
    diagnostic.help("raise it with `synth_core::build::Build`, or make the specification smaller")
}

fn folder(variable: &str) -> Result<PathBuf, String> {
    let value = env::var_os(variable);
    let why = || format!("error: {variable} is not set: this must be called from a build script");
    value.map(PathBuf::from).ok_or_else(why)
}

/// Reads a file and has Cargo watch it, there or not.
fn read(package: &Path, path: &str) -> Result<Vec<u8>, String> {
    println!("cargo::rerun-if-changed={path}");
    let bytes = fs::File::open(package.join(path)).and_then(read_bounded);
    bytes.map_err(|error| error.to_string())
}

/// Writes the whole file or nothing, and leaves one that is the same alone.
fn replace(target: &Path, text: &str) -> io::Result<()> {
    if fs::read(target).is_ok_and(|old| old == text.as_bytes()) {
        return Ok(());
    }
    let unfinished = target.with_extension("rs.unfinished");
    fs::write(&unfinished, text)?;
    fs::rename(&unfinished, target)
}

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
//! What ends in `.plant` is a plant; its module has a function `scan` and depends on nothing.
//!
//! Cargo runs the script again when the specification changes, or a file that it imports. A wrong or unrealizable
//! specification ends the build with the same message that `sml check` prints. Warnings are shown as Cargo's, in one line
//! each; [`Build::deny`] makes one of them end the build.
//!
//! What was compiled once is not compiled again: modules are [cached](crate::cache) in `$OUT_DIR/sml-cache`, or in the folder
//! that the environment variable `SML_CACHE` names, by all texts, all options and the version of the tool.

use crate::cache::{self, Folder, Key, Store};
use crate::controller::Level;
use crate::controller::tables::{Provenance, Tables};
use crate::diagnostic::{Code, Diagnostic, render};
use crate::emit::rust::{self, Engine};
use crate::emit::scan::Source;
use crate::explore::Limits;
use crate::pipeline::{Failure, Options, Timings, compile_with_warnings as run};
use crate::plant::{self, Plant, event_based};
use crate::quality::{Policy, Warning};
use crate::syntax::{Loaded, Sources, load, read_bounded};
use std::path::{Path, PathBuf};
use std::{env, fs, io, process};

/// Compiles the specification or the plant at `path` (relative to the package) with the default options.
///
/// Does not return if that fails: the message goes to the standard error and the build script ends with status 1.
pub fn compile(path: impl AsRef<Path>) {
    Build::new().compile(path);
}

/// A compilation with options.
#[derive(Clone, Debug, Default)]
pub struct Build {
    options: Options,
    policy: Policy,
    engine: Engine,
    plants: plant::Options,
    follows_events: bool,
}

/// What became of a file: the module, or all that is wrong.
struct Compiled {
    result: Result<Module, Vec<Diagnostic>>,
    sources: Sources,
}

/// What a synthesis results in: a text in Rust and all warnings, or all that is wrong.
type Synthesized = Result<(String, Vec<Diagnostic>), Vec<Diagnostic>>;

/// What a build script has to say.
#[derive(Clone, PartialEq, Eq, Debug)]
struct Module {
    text: String,
    /// One line each.
    warnings: Vec<String>,
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

    /// How the controller is made smaller. With [`Level::Ordered`] its module has the interface for one event at a time only.
    #[must_use]
    pub fn minimize(mut self, level: Level) -> Self {
        self.options.level = level;
        self
    }

    /// Makes the [monitor](mod@crate::controller::monitor) of a specification's controller: `NAME_monitor.rs` with a module
    /// `name_monitor`, which knows which events are expected and gives no commands. [`Build::minimize`] means nothing to it.
    #[must_use]
    pub fn monitor(mut self) -> Self {
        self.options.monitor = true;
        self
    }

    /// How generated code finds the row of a state.
    #[must_use]
    pub fn engine(mut self, engine: Engine) -> Self {
        self.engine = engine;
        self
    }

    /// What program is made of a plant.
    #[must_use]
    pub fn plant_options(mut self, options: plant::Options) -> Self {
        self.plants = options;
        self
    }

    /// The controller of a plant follows events: tables as those of a specification, instead of `scan`. The module then needs
    /// the runtime crate `controller-template`, and [`Build::plant_options`] means nothing.
    #[must_use]
    pub fn follow_events(mut self) -> Self {
        self.follows_events = true;
        self
    }

    /// Gives up with a clear message beyond this many states.
    #[must_use]
    pub fn max_states(mut self, states: usize) -> Self {
        self.options.limits = Limits { states, ..self.options.limits };
        self
    }

    /// Ends the build if there is a warning of this code, such as `SML0090`.
    ///
    /// # Panics
    ///
    /// If it is not the code of a warning.
    #[must_use]
    pub fn deny(mut self, code: &str) -> Self {
        self.policy = self.policy.deny(warning(code));
        self
    }

    /// Ends the build if there is any warning.
    #[must_use]
    pub fn deny_warnings(mut self) -> Self {
        self.policy = self.policy.deny_all();
        self
    }

    /// Does not show warnings of this code, nor end the build because of them.
    ///
    /// # Panics
    ///
    /// If it is not the code of a warning.
    #[must_use]
    pub fn allow(mut self, code: &str) -> Self {
        self.policy = self.policy.allow(warning(code));
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
        let Compiled { result, sources } = self.module(&shown, &bytes, &package, cache(&out).as_ref());
        let Module { text, warnings } = result.map_err(|diagnostics| {
            let diagnostics: Vec<Diagnostic> = diagnostics.into_iter().map(advise).collect();
            render(&diagnostics, &sources, false)
        })?;
        show(&warnings);
        let mut name = path.file_stem().unwrap_or(path.as_os_str()).to_owned();
        name.push(if self.options.monitor { "_monitor.rs" } else { ".rs" });
        let target = out.join(name);
        replace(&target, &text).map_err(|why| format!("error: {} cannot be written: {why}", target.display()))
    }

    fn module(&self, path: &str, bytes: &[u8], package: &Path, cache: Option<&Folder>) -> Compiled {
        if Path::new(path).extension().is_some_and(|extension| extension == "plant") {
            let loaded = plant::Loaded::of_file(path, bytes);
            let result = match &loaded.plant {
                Ok((plant, warnings)) => self.cached(cache, &loaded.sources, || {
                    self.plant(plant, warnings, loaded.provenance.clone())
                }),
                Err(diagnostics) => Err(diagnostics.clone()),
            };
            return Compiled { result, sources: loaded.sources };
        }
        let loaded = load(path, bytes, &mut |path| read(package, path));
        // What cannot be read at all may be shown as if it could.
        let cache = cache.filter(|_| loaded.diagnostics.is_empty());
        let result = self.cached(cache, &loaded.sources, || self.specification(&loaded));
        Compiled { result, sources: loaded.sources }
    }

    /// The module that was made of these sources with these options, of this run or of an earlier one.
    fn cached(
        &self,
        cache: Option<&Folder>,
        sources: &Sources,
        synthesize: impl FnOnce() -> Synthesized,
    ) -> Result<Module, Vec<Diagnostic>> {
        let key = Key::new("build script", self).sources(sources);
        if let Some(module) = cache.and_then(|cache| cache.get(&key)).and_then(Module::of_texts) {
            return Ok(module);
        }
        let (text, warnings) = synthesize()?;
        let module = Module { text, warnings: self.judge(warnings, sources)? };
        if let Some(cache) = cache {
            cache.put(&key, &module.texts());
        }
        Ok(module)
    }

    fn specification(&self, loaded: &Loaded) -> Synthesized {
        // To relax each assumption would cost each build time; `sml check` does it.
        let thorough = self.policy.denies_code(Code::NotNeeded);
        let result = run(loaded, &self.options, thorough, &mut Timings::default());
        let (tables, warnings) = result.map_err(|failure| failure.diagnostics())?;
        let options = rust::Options { engine: self.engine, ordered: self.options.is_ordered() };
        Ok((rust::text(&tables, &options), warnings))
    }

    fn plant(&self, plant: &Plant, warnings: &[Diagnostic], provenance: Provenance) -> Synthesized {
        let module = if self.follows_events {
            self.of_events(plant, provenance)
        } else {
            self.of_states(plant, provenance)
        };
        let (text, more) = module.map_err(|failure| failure.diagnostics())?;
        Ok((text, [warnings, &more].concat()))
    }

    fn of_states(&self, plant: &Plant, provenance: Provenance) -> Result<(String, Vec<Diagnostic>), Failure> {
        let limits = &self.options.limits;
        let supervised = plant::pipeline::control(plant, limits, self.plants, &mut Timings::default())?;
        let provenance = Provenance { options: self.plants.words(), ..provenance };
        let source =
            Source { program: &supervised.feedback.program, events: &plant.events, provenance: &provenance };
        Ok((rust::scan::text(&source), plant::warnings(plant, &supervised.closed)))
    }

    fn of_events(&self, plant: &Plant, provenance: Provenance) -> Result<(String, Vec<Diagnostic>), Failure> {
        let Options { limits, level, .. } = &self.options;
        let followed = plant::pipeline::follow(plant, limits, *level, &mut Timings::default())?;
        let options = " --follow events".to_owned();
        let provenance = event_based::provenance(plant, Provenance { options, ..provenance });
        let tables = Tables::new(&plant.name, &followed.controller, provenance);
        let options = rust::Options { engine: self.engine, ..rust::Options::default() };
        Ok((rust::text(&tables, &options), followed.warnings(plant)))
    }

    /// Warnings as Cargo shows them; or those that are denied, and the others are shown at once.
    fn judge(
        &self,
        mut warnings: Vec<Diagnostic>,
        sources: &Sources,
    ) -> Result<Vec<String>, Vec<Diagnostic>> {
        self.policy.apply(&mut warnings);
        let (denied, shown): (Vec<_>, Vec<_>) =
            warnings.into_iter().partition(|warning| self.policy.denies(warning));
        let lines: Vec<String> = shown.iter().map(|warning| line(warning, sources)).collect();
        if denied.is_empty() {
            return Ok(lines);
        }
        show(&lines);
        Err(denied)
    }
}

impl Module {
    /// As they are cached.
    fn texts(&self) -> Vec<String> {
        [&self.text].into_iter().chain(&self.warnings).cloned().collect()
    }

    fn of_texts(texts: Vec<String>) -> Option<Module> {
        let mut texts = texts.into_iter();
        Some(Module { text: texts.next()?, warnings: texts.collect() })
    }
}

/// Where modules are cached. Cargo keeps the folder of outputs from build to build.
fn cache(out: &Path) -> Option<Folder> {
    match env::var_os(cache::VARIABLE) {
        None => Some(Folder::at(out.join("sml-cache"))),
        Some(path) if path.is_empty() => None,
        Some(path) => Some(Folder::at(path)),
    }
}

fn show(warnings: &[String]) {
    for warning in warnings {
        println!("cargo::warning={warning}");
    }
}

/// A build script has no options of a command line.
fn advise(diagnostic: Diagnostic) -> Diagnostic {
    if diagnostic.code != Code::LimitReached {
        return diagnostic;
    }
    diagnostic.help("raise it with `synth_core::build::Build`, or make what is described smaller")
}

fn warning(code: &str) -> Warning {
    code.parse().unwrap_or_else(|why| panic!("`{code}`: {why}"))
}

/// A warning in one line, as Cargo shows them.
fn line(warning: &Diagnostic, sources: &Sources) -> String {
    let Diagnostic { code, message, span, .. } = warning;
    let (line, column) = (span.start.line.max(1), span.start.column.max(1));
    format!("{}:{line}:{column}: {message} ({code}; `sml check` says more)", sources.path(span.file))
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

#[cfg(test)]
mod tests;

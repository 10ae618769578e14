//! One run of the command: the stages of the pipeline with the options, the clock and the failures of this run.

use crate::failure::{Exit, Failure, nowhere};
use crate::input::Given;
use crate::options::{Color, Common, Format};
use crate::{input, interrupt, memory, output, timings};
use std::io::IsTerminal;
use std::path::Path;
use std::sync::mpsc;
use std::time::Duration;
use synth_core::controller::tables::Provenance;
use synth_core::controller::{Controller, Level};
use synth_core::diagnostic::{Code, Diagnostic, counted};
use synth_core::existential::{Existential, existential};
use synth_core::explain::{Explanation, explain};
use synth_core::explore::{Explored, Limits, explore};
use synth_core::external::{self, Budget, Census, Origin, Task};
use synth_core::model::Spec;
use synth_core::pipeline::{self, Options, Size, Solved, Timings, Verified};
use synth_core::plant::pipeline::{Followed, ModularlySupervised, Supervised};
use synth_core::plant::{self, ClosedLoop, Plant, Synthesis};
use synth_core::playout::Semantics;
use synth_core::quality::{self, Policy};
use synth_core::symmetry::{self, Reduced, Symmetry};
use synth_core::syntax::{Loaded, Sources};
use synth_core::verdict::Verdict;

/// Options and clock.
pub(crate) struct Session {
    common: Common,
    limits: Limits,
    timings: Timings,
}

/// A plant and the text that it comes from.
pub(crate) struct ReadPlant {
    pub(crate) sources: Sources,
    pub(crate) plant: Plant,
    pub(crate) warnings: Vec<Diagnostic>,
    /// Without options.
    pub(crate) provenance: Provenance,
}

impl Session {
    pub(crate) fn new(common: Common) -> Self {
        let limits = common.limits();
        Session { common, limits, timings: Timings::with_peak(memory::peak) }
    }

    pub(crate) fn format(&self) -> Format {
        self.common.format
    }

    /// Whether text on this stream is colored.
    pub(crate) fn color(&self, stream: &impl IsTerminal) -> bool {
        match self.common.color {
            Color::Always => true,
            Color::Never => false,
            Color::Auto => {
                let declined = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
                !declined && stream.is_terminal()
            }
        }
    }

    /// How the winning condition is read.
    pub(crate) fn semantics(&self) -> Semantics {
        self.common.semantics()
    }

    /// How a controller is made, and how far.
    pub(crate) fn options(&self, level: Level) -> Options {
        Options { semantics: self.semantics(), limits: self.limits, level, monitor: false }
    }

    /// A specification, for subcommands that mean nothing to plants.
    pub(crate) fn load(&mut self, path: &Path) -> Result<Loaded, Failure> {
        self.specification_only(&input::given(path)?)
    }

    /// The same of what was read.
    pub(crate) fn specification_only(&mut self, given: &Given) -> Result<Loaded, Failure> {
        if given.is_plant {
            let message = format!("`{}` is a plant, and this is for specifications", given.name);
            let error = nowhere(Code::Usage, message);
            let help = "write `sml check`, `sml supervise`, `sml export` or `sml play` for a plant";
            return Err(Failure::new(Exit::Wrong, error.help(help)));
        }
        Ok(self.parse(given))
    }

    pub(crate) fn parse(&mut self, given: &Given) -> Loaded {
        self.timings.stage("parse", || input::specification(given))
    }

    /// A plant, with what its text is warned of.
    pub(crate) fn plant(&mut self, given: &Given) -> Result<ReadPlant, Failure> {
        if self.semantics().classic {
            return Err(Failure::usage("`--classic` means nothing to a plant"));
        }
        let read = || plant::Loaded::of_file(&given.name, &given.bytes);
        let plant::Loaded { plant, sources, provenance, .. } = self.timings.stage("parse", read);
        match plant {
            Ok((plant, warnings)) => Ok(ReadPlant { sources, plant, warnings, provenance }),
            Err(wrong) => Err(Failure::of(&pipeline::Failure::Wrong(wrong), &sources)),
        }
    }

    /// What a plant is warned of: what its text shows, and what its feedback does.
    pub(crate) fn warnings_of_plant(
        &mut self,
        of_text: Vec<Diagnostic>,
        plant: &Plant,
        closed: &ClosedLoop,
    ) -> Vec<Diagnostic> {
        let mut warnings = of_text;
        warnings.extend(self.timings.stage("warnings", || plant::warnings(plant, closed)));
        warnings.sort_by_key(|warning| warning.span.start);
        warnings
    }

    /// The feedback of a plant, whether or not inputs and outputs show its states.
    pub(crate) fn feedback(&mut self, plant: &Plant) -> Result<ClosedLoop, pipeline::Failure> {
        let limits = self.watched_limits();
        patiently(|| plant::pipeline::feedback(plant, &limits, &mut self.timings))
    }

    /// The same, kept to say why it inhibits what it inhibits.
    pub(crate) fn synthesis<'p>(
        &mut self,
        plant: &'p Plant,
    ) -> Result<(Synthesis<'p>, ClosedLoop), pipeline::Failure> {
        let limits = self.watched_limits();
        let synthesis = patiently(|| plant::pipeline::synthesis(plant, &limits, &mut self.timings))?;
        let closed = self.timings.stage("close", || synthesis.closed_loop(&limits));
        self.timings.size(Size::of_closed_loop(&closed));
        Ok((synthesis, closed))
    }

    /// The feedback of a plant, and the program that does it.
    pub(crate) fn control(
        &mut self,
        plant: &Plant,
        options: plant::Options,
    ) -> Result<Supervised, pipeline::Failure> {
        let limits = self.watched_limits();
        patiently(|| plant::pipeline::control(plant, &limits, options, &mut self.timings))
    }

    /// A supervisor per constraint, and the program that does what all of them want.
    pub(crate) fn control_modular(
        &mut self,
        plant: &Plant,
        options: plant::Options,
    ) -> Result<ModularlySupervised, pipeline::Failure> {
        plant::pipeline::control_modular(plant, &self.watched_limits(), options, &mut self.timings)
    }

    /// The feedback of a plant, and a controller that follows its events.
    pub(crate) fn follow(&mut self, plant: &Plant, level: Level) -> Result<Followed, pipeline::Failure> {
        let limits = self.watched_limits();
        patiently(|| plant::pipeline::follow(plant, &limits, level, &mut self.timings))
    }

    pub(crate) fn specification(&mut self, loaded: &Loaded) -> Result<Spec, Failure> {
        let spec = self.timings.stage("resolve", || pipeline::specification(loaded));
        spec.map_err(|failure| Failure::of(&failure, &loaded.sources))
    }

    /// Explores without asking who wins.
    pub(crate) fn explore<'s>(&mut self, loaded: &Loaded, spec: &'s Spec) -> Result<Explored<'s>, Failure> {
        let options = Options { limits: self.watched_limits(), ..self.options(Level::default()) };
        let explored = self.timings.stage("explore", || explore(spec, options.semantics, &options.limits));
        let explored = explored.map_err(|error| Failure::of(&error.into(), &loaded.sources))?;
        self.timings.size(Size::of_game(&explored));
        let (states, edges) = (explored.game.states(), explored.game.edges());
        self.watch(format!(
            "{} and {} were found; what is made of them needs more",
            counted(states, "state"),
            counted(edges, "transition")
        ));
        Ok(explored)
    }

    /// Explores with files in a folder, unless somebody asks to stop.
    pub(crate) fn census(&mut self, folder: &Path, loaded: &Loaded, spec: &Spec) -> Result<Census, Failure> {
        let Options { semantics, limits, .. } = self.options(Level::default());
        let origin = Origin::new(&loaded.sources, semantics);
        let budget = Budget::of(limits.memory);
        let task = Task { folder, origin: &origin, budget, stop: &interrupt::asked };
        let explore = || external::explore(spec, semantics, &limits, &task);
        let census = self.timings.stage("explore on disk", explore).map_err(|error| {
            let again = format!("run the same command with `--spill {}` to go on", folder.display());
            Failure::of_external(error, &loaded.sources, &again)
        })?;
        self.timings.size(Size {
            states: census.states as usize,
            edges: Some(census.transitions as usize),
            of_states: Some(census.bytes as usize),
            of_edges: None,
        });
        Ok(census)
    }

    /// The same for what counts not all of its memory, or none: from now on the process as a whole is watched.
    fn watched_limits(&self) -> Limits {
        self.watch("what is looked for, or what is made of it, needs more".to_owned());
        self.limits
    }

    fn watch(&self, found: String) {
        memory::watch(self.limits.memory, found, self.format(), self.color(&std::io::stderr()));
    }

    /// When to give up.
    pub(crate) fn limits(&self) -> Limits {
        self.limits
    }

    pub(crate) fn solve<'s>(&mut self, loaded: &Loaded, spec: &'s Spec) -> Result<Solved<'s>, Failure> {
        let explored = self.explore(loaded, spec)?;
        Ok(pipeline::solved(explored, &self.limits, &mut self.timings))
    }

    /// Who wins, and no more.
    pub(crate) fn verdict(&mut self, loaded: &Loaded, spec: &Spec) -> Result<Verdict, Failure> {
        let options = Options { limits: self.watched_limits(), ..self.options(Level::default()) };
        let verdict = pipeline::verdict(spec, &options, &mut self.timings);
        verdict.map_err(|failure| Failure::of(&failure, &loaded.sources))
    }

    /// Who wins, and the size of the game, on one state for all that differ only by interchangeable objects.
    pub(crate) fn decide_reduced(
        &mut self,
        loaded: &Loaded,
        spec: &Spec,
        symmetry: &Symmetry,
    ) -> Result<Reduced, Failure> {
        let limits = self.watched_limits();
        let reduced = symmetry::decide(spec, self.semantics(), symmetry, &limits, &mut self.timings);
        reduced.map_err(|error| Failure::of(&error.into(), &loaded.sources))
    }

    /// As much of the game as the system needs to win; `None` if that was everything.
    pub(crate) fn solve_early<'s>(
        &mut self,
        loaded: &Loaded,
        spec: &'s Spec,
    ) -> Result<(Solved<'s>, Option<Verdict>), Failure> {
        let options = Options { limits: self.watched_limits(), ..self.options(Level::default()) };
        let solved = pipeline::play_and_solve_early(spec, &options, &mut self.timings);
        solved.map_err(|failure| Failure::of(&failure, &loaded.sources))
    }

    pub(crate) fn synthesize(
        &mut self,
        loaded: &Loaded,
        solved: &mut Solved<'_>,
        options: &Options,
    ) -> Result<Verified, Failure> {
        let verified = pipeline::synthesize(solved, options, &mut self.timings);
        verified.map_err(|failure| Failure::of(&failure, &loaded.sources))
    }

    /// The number of nodes of the product, or why the controller does not pass.
    pub(crate) fn verify(
        &mut self,
        spec: &Spec,
        controller: &Controller,
    ) -> Result<usize, pipeline::Failure> {
        let options = Options { limits: self.watched_limits(), ..self.options(Level::default()) };
        self.timings.stage("verify", || pipeline::check(spec, controller, &options))
    }

    /// What becomes of the existential scenarios.
    pub(crate) fn existential(
        &mut self,
        loaded: &Loaded,
        spec: &Spec,
        solved: &Solved<'_>,
        controller: Option<&Controller>,
    ) -> Result<Vec<Existential>, Failure> {
        let options = self.options(Level::default());
        let found = self.timings.stage("existential", || existential(spec, &options, solved, controller));
        found.map_err(|failure| Failure::of(&failure, &loaded.sources))
    }

    /// What a specification is warned of beside a product: what its text shows, and the rest only if that is denied.
    pub(crate) fn warnings_beside(
        &mut self,
        loaded: &Loaded,
        solved: &mut Solved<'_>,
        policy: &Policy,
    ) -> Result<Vec<Diagnostic>, Failure> {
        if policy.denies_plays() {
            return self.all_warnings(loaded, solved);
        }
        Ok(self.timings.stage("warnings", || quality::of_text(loaded, solved.explored.playout.spec())))
    }

    /// Everything that a specification is warned of.
    pub(crate) fn all_warnings(
        &mut self,
        loaded: &Loaded,
        solved: &mut Solved<'_>,
    ) -> Result<Vec<Diagnostic>, Failure> {
        let warnings = pipeline::warnings(loaded, solved, true, &mut self.timings);
        warnings.map_err(|failure| Failure::of(&failure, &loaded.sources))
    }

    /// Why the system cannot win; `None` if it can.
    pub(crate) fn explain(&mut self, solved: &Solved<'_>) -> Option<Explanation> {
        let limits = self.limits;
        self.timings.stage("explain", || explain(solved, &limits))
    }

    /// Runs a stage that is no part of the pipeline.
    pub(crate) fn stage<T>(&mut self, name: &'static str, run: impl FnOnce() -> T) -> T {
        self.timings.stage(name, run)
    }

    /// To stderr, if asked for.
    pub(crate) fn print_timings(&self) {
        if self.common.timings {
            output::note(timings::shown(&self.timings, self.common.format).trim_end());
        }
    }
}

/// Runs what may take long; whoever waits at a terminal is told what could be done about it.
fn patiently<T>(run: impl FnOnce() -> T) -> T {
    const PATIENCE: Duration = Duration::from_secs(10);
    if !std::io::stderr().is_terminal() {
        return run();
    }
    let (done, waiting) = mpsc::channel::<()>();
    let watch = std::thread::spawn(move || {
        if waiting.recv_timeout(PATIENCE) == Err(mpsc::RecvTimeoutError::Timeout) {
            output::note(
                "the product of the plant is large, and still explored; `--max-states` and `--max-memory` end it, \
                 `sml supervise --modular` does without it",
            );
        }
    });
    let result = run();
    drop(done);
    // It does nothing that could fail.
    let _ = watch.join();
    result
}

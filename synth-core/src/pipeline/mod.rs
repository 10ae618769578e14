//! The pipeline: from the text of a specification to verified tables. Each stage is one line of [`compile`],
//! [`play_and_solve`] or [`synthesize`].

mod endless;
mod failure;
mod figures;
mod origin;
mod timings;

pub use failure::{Failure, Refused, Unrealizable};
pub use figures::Figures;
pub use origin::{alphabet, provenance, tables};
pub use timings::{Size, Stage, Timings};

use crate::controller::tables::Tables;
use crate::controller::{
    Controller, EndlessSuperStep, Level, Lists, merge, minimize, minimize_assuming, minimize_on, monitor,
    number, number_on,
};
use crate::diagnostic::{Diagnostic, Severity};
use crate::explain::explain;
use crate::explore::{Explored, Limits, explore};
use crate::game::{Game, Solution, Strategy, extract_on, solve_ending, solve_on};
use crate::model::{Spec, resolve::resolve};
use crate::parallel::{share, threads_for};
use crate::playout::Semantics;
use crate::quality;
use crate::syntax::Loaded;
use crate::verdict::{self, Verdict, WinningPart};
use crate::verify::{batches, verify};
use std::rc::Rc;

/// Nodes of a product have `u32` ids.
const MOST_NODES: usize = u32::MAX as usize - 1;

/// What to do, and how far.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Options {
    /// How the winning condition is read.
    pub semantics: Semantics,
    /// When to give up.
    pub limits: Limits,
    /// How the controller is made smaller.
    pub level: Level,
    /// Instead of a controller, its [monitor](mod@monitor) is made. It is always as small as can be, whatever the level.
    pub monitor: bool,
}

impl Default for Options {
    fn default() -> Self {
        let (semantics, limits) = Default::default();
        Options { semantics, limits, level: Level::Exact, monitor: false }
    }
}

impl Options {
    /// Whether the controller is for one event at a time only.
    #[must_use]
    pub fn is_ordered(&self) -> bool {
        self.level == Level::Ordered && !self.monitor
    }
}

/// An explored and solved specification.
#[derive(Debug)]
pub struct Solved<'s> {
    /// States, edges and what they mean.
    pub explored: Explored<'s>,
    /// Who wins where.
    pub solution: Solution,
    /// A winning strategy, once somebody asked for it: controller and warnings are made from the same.
    strategy: Option<Rc<Strategy>>,
    /// On how many threads it is looked for.
    threads: usize,
}

impl Solved<'_> {
    /// A winning strategy; one in which every super step ends, if there is such a one.
    fn strategy(&mut self, timings: &mut Timings) -> Result<Rc<Strategy>, Failure> {
        if let Some(known) = &self.strategy {
            return Ok(known.clone());
        }
        let search = || winning_strategy(&self.explored.game, &self.solution, self.threads);
        let found = timings.stage("extract", search)?;
        timings.size(Size::of_strategy(&found));
        Ok(self.strategy.insert(Rc::new(found)).clone())
    }
}

/// A controller that passed verification.
#[derive(Debug)]
pub struct Verified {
    /// As asked for: a controller, or its monitor.
    pub controller: Controller,
    /// Its states before it was minimised.
    pub unminimized_states: u32,
    /// Nodes of the product that was verified.
    pub product_nodes: usize,
}

/// The whole way, from files to tables.
///
/// # Errors
/// See [`Failure`].
pub fn compile(loaded: &Loaded, options: &Options, timings: &mut Timings) -> Result<Tables, Failure> {
    let spec = timings.stage("resolve", || specification(loaded))?;
    let mut solved = play_and_solve(&spec, options, timings)?;
    let verified = synthesize(&mut solved, options, timings)?;
    Ok(timings.stage("tables", || tables(loaded, &spec, options, &verified.controller)))
}

/// As [`compile`], with everything that the specification is warned of; `thorough` as for [`warnings`].
///
/// # Errors
/// See [`Failure`].
pub fn compile_with_warnings(
    loaded: &Loaded,
    options: &Options,
    thorough: bool,
    timings: &mut Timings,
) -> Result<(Tables, Vec<Diagnostic>), Failure> {
    let spec = timings.stage("resolve", || specification(loaded))?;
    let mut solved = play_and_solve(&spec, options, timings)?;
    let verified = synthesize(&mut solved, options, timings)?;
    let warnings = warnings(loaded, &mut solved, thorough, timings)?;
    Ok((timings.stage("tables", || tables(loaded, &spec, options, &verified.controller)), warnings))
}

/// The resolved specification, or everything that is wrong with it, the earliest mistake first.
///
/// # Errors
/// [`Failure::Wrong`].
pub fn specification(loaded: &Loaded) -> Result<Spec, Failure> {
    let is_error = |d: &Diagnostic| d.severity == Severity::Error;
    let mut diagnostics = loaded.diagnostics.clone();
    let unread = diagnostics.iter().any(is_error);
    // Names that only a lost piece of text declares would all be unknown.
    if !unread || loaded.declares_all() {
        let (spec, mut found) = resolve(&loaded.files);
        // What seems wrong beside something unreadable may only follow from it.
        let line = |d: &Diagnostic| (d.span.file, d.span.start.line);
        found.retain(|d| !diagnostics.iter().any(|unreadable| line(unreadable) == line(d)));
        diagnostics.extend(found);
        if let Some(spec) = spec.filter(|_| !unread) {
            return Ok(spec);
        }
    }
    diagnostics.sort_by_key(|d| (d.span.file, d.span.start));
    Err(Failure::Wrong(diagnostics))
}

/// Explores the specification and solves its game, whoever wins.
///
/// # Errors
/// A mistake that a play reaches, or a limit.
pub fn play_and_solve<'s>(
    spec: &'s Spec,
    options: &Options,
    timings: &mut Timings,
) -> Result<Solved<'s>, Failure> {
    let explored = timings.stage("explore", || explore(spec, options.semantics, &options.limits));
    let explored = explored?;
    timings.size(Size::of_game(&explored));
    Ok(solved(explored, &options.limits, timings))
}

/// The second half of [`play_and_solve`], whoever wins.
#[must_use]
pub fn solved<'s>(explored: Explored<'s>, limits: &Limits, timings: &mut Timings) -> Solved<'s> {
    let game = &explored.game;
    let threads = solving_threads(game, limits);
    let solution = timings.stage("solve", || solve_on(game, threads));
    timings.size(Size::of_nodes(solution.winning_states()));
    Solved { explored, solution, strategy: None, threads }
}

/// A small game is solved before another thread has begun, and many threads would only wait for memory.
fn solving_threads(game: &Game, limits: &Limits) -> usize {
    const STATES_A_THREAD: usize = 4096;
    threads_for(game.states() / STATES_A_THREAD, limits.threads).min(4)
}

/// Who wins, found out without exploring more than that takes.
///
/// # Errors
/// A mistake that a play reaches, or a limit.
pub fn verdict(spec: &Spec, options: &Options, timings: &mut Timings) -> Result<Verdict, Failure> {
    let verdict = timings.stage("decide", || verdict::verdict(spec, options.semantics, &options.limits))?;
    timings.size(verdict.size);
    Ok(verdict)
}

/// The same as [`play_and_solve`], but if the system wins already in a part of the game, it is only that part, and what finding it took.
/// Where the system does not win, or only by super steps without end, everything is explored in the end.
///
/// # Errors
/// As for [`play_and_solve`].
pub fn play_and_solve_early<'s>(
    spec: &'s Spec,
    options: &Options,
    timings: &mut Timings,
) -> Result<(Solved<'s>, Option<Verdict>), Failure> {
    let search = || verdict::winning_part(spec, options.semantics, &options.limits);
    let (verdict, part) = timings.stage("search", search)?;
    timings.size(verdict.size);
    if let Some(WinningPart { explored, solution }) = part {
        let threads = solving_threads(&explored.game, &options.limits);
        let mut solved = Solved { explored, solution, strategy: None, threads };
        if solved.strategy(timings)?.endless_run(&solved.explored.game).is_none() {
            return Ok((solved, Some(verdict)));
        }
    }
    Ok((play_and_solve(spec, options, timings)?, None))
}

/// A verified controller.
///
/// # Errors
/// The specification is not realizable, or (by a mistake of this project) verification fails.
pub fn synthesize(
    solved: &mut Solved<'_>,
    options: &Options,
    timings: &mut Timings,
) -> Result<Verified, Failure> {
    if !solved.solution.wins(solved.explored.game.initial) {
        return Err(unrealizable(solved, &options.limits, timings));
    }
    let strategy = solved.strategy(timings)?;
    let explored = &mut solved.explored;
    let raw = timings.stage("super steps", || merged(explored, &strategy, options.limits.threads));
    let raw =
        raw.map_err(|endless| Failure::Wrong(vec![endless::diagnostic(explored, &strategy, endless)]))?;
    timings.size(Size::of_controller(&raw));
    if options.monitor {
        return monitored(explored.playout.spec(), options, &raw, timings);
    }
    let unminimized_states = raw.states;
    // Only scans with several events are compared later.
    let kept = (options.level == Level::Assume).then(|| raw.clone());
    let mut controller =
        timings.stage("minimise", || minimize_on(raw, options.level, options.limits.threads));
    timings.size(Size::of_controller(&controller));
    if options.level == Level::Assume {
        let refused = timings.stage("batches", || {
            batches::refused(&mut explored.playout, &controller, most_batches(options))
        })?;
        controller = timings.stage("minimise", || minimize_assuming(&controller, &refused));
        timings.size(Size::of_controller(&controller));
    }
    let controller = timings.stage("number", || number_on(controller, options.limits.threads));
    // What is emitted is verified, so nothing that it was made of need be. The limit on states was kept by exploration; the
    // product has a node of its own for each way into a super step.
    let limits = &options.limits;
    let verify =
        || verify(explored.playout.spec(), options.semantics, &controller, MOST_NODES, limits.threads);
    let product_nodes = timings.stage("verify", verify)?;
    timings.size(Size::of_nodes(product_nodes));
    if let Some(raw) = kept {
        // The product has one event at a time. With several, both do the same; where one comes at a time, what the other one
        // does has just been verified.
        let agree = || batches::agree(&mut explored.playout, &raw, &controller, most_batches(options));
        timings.stage("verify batches", agree)?;
    }
    Ok(Verified { controller, unminimized_states, product_nodes })
}

/// The monitor of a controller that was not minimised, and is verified itself.
fn monitored(
    spec: &Spec,
    options: &Options,
    raw: &Controller,
    timings: &mut Timings,
) -> Result<Verified, Failure> {
    let controller = timings.stage("monitor", || number(monitor(raw)));
    timings.size(Size::of_controller(&controller));
    let verify = || verify(spec, options.semantics, raw, MOST_NODES, options.limits.threads);
    let product_nodes = timings.stage("verify", verify)?;
    timings.size(Size::of_nodes(product_nodes));
    if !timings.stage("verify monitor", || monitor::agrees(&controller, raw)) {
        return Err(Failure::Inconsistent(
            "the monitor expects other events than the controller takes".to_owned(),
        ));
    }
    Ok(Verified { controller, unminimized_states: raw.states, product_nodes })
}

/// So many nodes of plays with several events in a scan fit the limits: a node takes 64 bytes with its place in the index.
fn most_batches(options: &Options) -> usize {
    options.limits.states.min(options.limits.memory / 64).min(MOST_NODES)
}

/// Everything that a specification is warned of, in the order of places. With plays: what exploration shows, and if
/// it is realizable, what a strategy shows. If `thorough`, assumptions are relaxed, too, to see whether they are needed.
///
/// # Errors
/// The solver contradicts itself.
pub fn warnings(
    loaded: &Loaded,
    solved: &mut Solved<'_>,
    thorough: bool,
    timings: &mut Timings,
) -> Result<Vec<Diagnostic>, Failure> {
    let mut warnings = quality::of_text(loaded, solved.explored.playout.spec());
    warnings.extend(timings.stage("warnings of plays", || quality::of_game(&mut solved.explored)));
    if solved.solution.wins(solved.explored.game.initial) {
        let strategy = solved.strategy(timings)?;
        let explored = &mut solved.explored;
        // Without one there is no controlled system to speak of, and that is an error of its own.
        let alphabet = alphabet(&explored.playout);
        let nothing = Lists::empty(explored.game.states());
        let merge = || merge(&explored.game, &strategy, &alphabet, &nothing, 1);
        if let Ok(controller) = timings.stage("super steps", merge) {
            let controller = timings.stage("minimise", || minimize(controller, Level::Exact));
            let of_control = || quality::of_controller(explored, &strategy, &controller, &warnings);
            let of_control = timings.stage("warnings of control", of_control);
            warnings.extend(of_control);
        }
        if thorough {
            let relaxed = timings.stage("relax assumptions", || quality::of_assumptions(explored, &warnings));
            warnings.extend(relaxed);
        }
    }
    quality::sort(&mut warnings);
    Ok(warnings)
}

fn winning_strategy(game: &Game, solution: &Solution, threads: usize) -> Result<Strategy, Failure> {
    let extract = |solution| {
        extract_on(game, solution, threads).map_err(|error| Failure::Inconsistent(error.to_string()))
    };
    let strategy = extract(solution)?;
    // Hardly ever: solving the game twice would be a waste otherwise.
    if strategy.endless_run(game).is_some() {
        let ending = solve_ending(game);
        if ending.wins(game.initial) {
            return extract(&ending);
        }
    }
    Ok(strategy)
}

fn merged(
    explored: &mut Explored<'_>,
    strategy: &Strategy,
    threads: usize,
) -> Result<Controller, EndlessSuperStep> {
    let alphabet = alphabet(&explored.playout);
    let owed = promises(explored, strategy, threads);
    merge(&explored.game, strategy, &alphabet, &owed, threads)
}

/// What the states owe that a strategy comes to, found on several threads as far as that takes no play-out.
fn promises(explored: &mut Explored<'_>, strategy: &Strategy, threads: usize) -> Lists {
    const LEAST: usize = 4096;
    let Explored { playout, store, game } = explored;
    let mut asked = vec![false; game.states()];
    strategy.state.iter().for_each(|&state| asked[state as usize] = true);
    let mut parts: Vec<(Lists, Vec<u32>)> = Vec::new();
    share(&mut parts, 0..store.len() as u32, LEAST, threads, |(promises, unknown), states| {
        let (mut row, mut owed) = (Vec::new(), Vec::new());
        for state in states {
            owed.clear();
            if asked[state as usize] && store.known_owed(state, &mut row, &mut owed).is_err() {
                owed.clear();
                unknown.push(state);
            }
            promises.push(&owed);
        }
    });
    let mut all = Lists::default();
    parts.iter().for_each(|(promises, _)| all.append(promises));
    for &state in parts.iter().flat_map(|(_, unknown)| unknown) {
        all.set(state as usize, &store.owed(playout, state));
    }
    // The losing and the won state owe nothing.
    (store.len()..game.states()).for_each(|_| all.push(&[]));
    all
}

/// Verifies any controller; its product with the specification may have as many nodes as `options` allow states.
///
/// # Errors
/// [`Failure::Unverified`], or a mistake of the specification that a play reaches.
pub fn check(spec: &Spec, controller: &Controller, options: &Options) -> Result<usize, Failure> {
    let Limits { states, threads, .. } = options.limits;
    Ok(verify(spec, options.semantics, controller, states, threads)?)
}

/// Explains that the specification is not realizable, and explores no more for that than was allowed for the game.
fn unrealizable(solved: &Solved<'_>, limits: &Limits, timings: &mut Timings) -> Failure {
    match timings.stage("explain", || explain(solved, limits)) {
        Some(explanation) => {
            let (figures, diagnostic) = (solved.figures(), explanation.diagnostic());
            Failure::Unrealizable(Box::new(Unrealizable { figures, diagnostic, explanation }))
        }
        None => Failure::Inconsistent("the environment wins, but no play shows it".to_owned()),
    }
}

#[cfg(test)]
mod refusals;
#[cfg(test)]
mod tests;

//! The pipeline: from the text of a specification to verified tables. Each stage is one line of [`compile`].

use crate::controller::tables::{Provenance, Requirement, Tables};
use crate::controller::{Alphabet, Controller, EndlessSuperStep, Letter, Level, merge, minimize};
use crate::diagnostic::{Code, Diagnostic, Severity};
use crate::explain::{Explanation, explain};
use crate::explore::{ExploreError, Explored, LimitReached, Limits, explore};
use crate::game::{Game, Solution, Strategy, YIELD, extract, solve, solve_ending};
use crate::model::{Kind, Spec, resolve::resolve};
use crate::playout::{Config, Playout, Semantics};
use crate::syntax::{FileId, Loaded, Pos, Span};
use crate::verify::{Refutation, VerifyError, verify};
use std::time::{Duration, Instant};

/// What to do, and how far.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Options {
    /// How the winning condition is read.
    pub semantics: Semantics,
    /// When to give up.
    pub limits: Limits,
    /// How the controller is made smaller.
    pub level: Level,
}

impl Default for Options {
    fn default() -> Self {
        Options { semantics: Semantics::default(), limits: Limits::default(), level: Level::Exact }
    }
}

/// Why there is no result.
#[derive(Debug)]
pub enum Failure {
    /// The specification is wrong.
    Wrong(Vec<Diagnostic>),
    /// No controller can meet it.
    Unrealizable(Box<Unrealizable>),
    /// A limit was reached.
    Limit(LimitReached),
    /// The controller did not pass verification. This is a mistake of this project, never of the specification.
    Unverified(Refutation),
    /// The solver contradicts itself. This is a mistake of this project, never of the specification.
    Inconsistent(String),
}

impl Failure {
    /// What to tell the author of the specification, the earliest mistake first.
    #[must_use]
    pub fn diagnostics(&self) -> Vec<Diagnostic> {
        let general = |code, message: String| Diagnostic::error(code, Span::default(), message);
        let ours = "this is a mistake of the tool, not of the specification; nothing was written";
        match self {
            Failure::Wrong(diagnostics) => diagnostics.clone(),
            Failure::Unrealizable(unrealizable) => vec![unrealizable.diagnostic.clone()],
            Failure::Limit(limit) => vec![
                general(
                    Code::LimitReached,
                    format!("the limit of {} {} was reached", limit.limit, limit.unit()),
                )
                .note(limit.to_string())
                .help(match limit.what {
                    // No option goes beyond what ids can count.
                    "edges" => "make the specification smaller".to_owned(),
                    what => format!("raise `--max-{what}`, or make the specification smaller"),
                }),
            ],
            Failure::Unverified(refutation) => vec![
                general(Code::VerificationFailed, format!("verification failed: {}", refutation.reason))
                    .note(format!("the play: {}", refutation.play.join("; ")))
                    .note(ours),
            ],
            Failure::Inconsistent(why) => {
                vec![
                    general(Code::VerificationFailed, format!("the solver contradicts itself: {why}"))
                        .note(ours),
                ]
            }
        }
    }
}

impl From<ExploreError> for Failure {
    fn from(error: ExploreError) -> Self {
        match error {
            ExploreError::Play(mistake, play) => Failure::Wrong(vec![mistake.diagnostic(&play)]),
            ExploreError::Limit(limit) => Failure::Limit(limit),
        }
    }
}

/// What is known of a specification that no controller can meet.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Unrealizable {
    /// The size of the game.
    pub figures: Figures,
    /// Why, as a message.
    pub diagnostic: Diagnostic,
    /// Why, as data.
    pub explanation: Explanation,
}

/// Time spent in the stages so far, in order.
#[derive(Clone, Debug, Default)]
pub struct Timings(pub Vec<(&'static str, Duration)>);

impl Timings {
    /// Runs one stage.
    pub fn stage<T>(&mut self, name: &'static str, run: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let result = run();
        self.0.push((name, start.elapsed()));
        result
    }
}

/// The size of the game; how each is counted is fixed, so that implementations can be compared.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
#[expect(missing_docs, reason = "the names are the definition; see the language reference")]
pub struct Figures {
    pub realizable: bool,
    pub states: usize,
    pub transitions: usize,
    pub system_states: usize,
    pub environment_states: usize,
    pub yielded_states: usize,
    pub idle_states: usize,
    pub winning_states: usize,
    pub assumption_sets: usize,
    pub guarantee_sets: usize,
}

/// An explored and solved specification.
#[derive(Debug)]
pub struct Solved<'s> {
    /// States, edges and what they mean.
    pub explored: Explored<'s>,
    /// Who wins where.
    pub solution: Solution,
}

/// A controller that passed verification.
#[derive(Debug)]
pub struct Verified {
    /// As asked for.
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
    Ok(timings.stage("tables", || Tables::new(&spec.name, &verified.controller, provenance(loaded, &spec))))
}

/// The resolved specification, or everything that is wrong with it, the earliest mistake first.
///
/// # Errors
/// [`Failure::Wrong`].
pub fn specification(loaded: &Loaded) -> Result<Spec, Failure> {
    let is_error = |d: &Diagnostic| d.severity == Severity::Error;
    let mut diagnostics = loaded.diagnostics.clone();
    // Names that only a lost piece of text declares would all be unknown.
    if !diagnostics.iter().any(is_error) {
        let (spec, found) = resolve(&loaded.files);
        diagnostics.extend(found);
        if let Some(spec) = spec {
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
    let solution = timings.stage("solve", || solve(&explored.game));
    Ok(Solved { explored, solution })
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
        return Err(unrealizable(solved, timings));
    }
    let Solved { explored, solution } = solved;
    let strategy = timings.stage("extract", || strategy(&explored.game, solution))?;
    let raw = timings.stage("super steps", || merged(explored, &strategy));
    let raw =
        raw.map_err(|endless| Failure::Wrong(vec![endless_super_step(explored, &strategy, endless)]))?;
    let controller = timings.stage("minimise", || minimize(&raw, options.level));
    let spec = explored.playout.spec();
    // Where nothing was merged, both are the same but for numbers.
    if controller.states < raw.states {
        timings.stage("verify unminimised", || check(spec, &raw, options))?;
    }
    let product_nodes = timings.stage("verify", || check(spec, &controller, options))?;
    Ok(Verified { controller, unminimized_states: raw.states, product_nodes })
}

/// A winning strategy; one in which every super step ends, if there is such a one.
fn strategy(game: &Game, solution: &Solution) -> Result<Strategy, Failure> {
    let extract =
        |solution| extract(game, solution).map_err(|error| Failure::Inconsistent(error.to_string()));
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

fn merged(explored: &mut Explored<'_>, strategy: &Strategy) -> Result<Controller, EndlessSuperStep> {
    let alphabet = alphabet(&explored.playout);
    let Explored { playout, store, game } = explored;
    let mut config = Config::default();
    merge(game, strategy, &alphabet, &mut |state| {
        if state as usize >= store.len() {
            return Vec::new();
        }
        store.load(state, &mut config);
        playout.owed(&config)
    })
}

/// Verifies a controller, this project's own or another.
///
/// # Errors
/// [`Failure::Unverified`], or a mistake of the specification that a play reaches.
pub fn check(spec: &Spec, controller: &Controller, options: &Options) -> Result<usize, Failure> {
    verify(spec, options.semantics, controller, options.limits.states).map_err(|error| match error {
        VerifyError::Refuted(refutation) => Failure::Unverified(refutation),
        VerifyError::Play(mistake, play) => Failure::Wrong(vec![mistake.diagnostic(&play)]),
        VerifyError::TooLarge(nodes) => Failure::Limit(LimitReached {
            what: "states",
            limit: nodes,
            states: nodes,
            explored: nodes,
            edges: 0,
            memory: 0,
        }),
    })
}

impl Solved<'_> {
    /// Counts.
    #[must_use]
    pub fn figures(&self) -> Figures {
        let Solved { explored: Explored { store, game, .. }, solution } = self;
        let count =
            |counts: &dyn Fn(usize) -> bool| (0..game.states()).filter(|&state| counts(state)).count();
        let mut config = Config::default();
        let mut yielded_states = 0;
        for state in 0..store.len() as u32 {
            store.load(state, &mut config);
            yielded_states += usize::from(config.yielded);
        }
        Figures {
            realizable: solution.wins(game.initial),
            states: game.states(),
            transitions: game.edges(),
            system_states: count(&|s| game.turn[s].is_system()),
            environment_states: count(&|s| game.turn[s].is_environment()),
            yielded_states,
            idle_states: count(&|s| game.turn[s].is_environment() && game.edges_of(s as u32).is_empty()),
            winning_states: solution.winning_states(),
            assumption_sets: game.assumptions.len(),
            guarantee_sets: game.guarantees.len() + 1,
        }
    }
}

/// The events behind the labels of the game.
#[must_use]
pub fn alphabet(playout: &Playout<'_>) -> Alphabet {
    let domain = &playout.spec().domain;
    let letter = |event: u32| {
        let event = playout.event(event);
        let operation = &domain.operations[event.operation];
        let values = event.arguments.iter().zip(&operation.parameters);
        Letter {
            event: crate::controller::Event {
                text: event.text.clone(),
                sender: domain.objects[event.sender].name.clone(),
                receiver: domain.objects[event.receiver].name.clone(),
                operation: operation.name.clone(),
                arguments: values.map(|(&value, (_, ty))| domain.show(value, *ty)).collect(),
            },
            controllable: event.controllable,
            commands: event.controllable && !playout.spec().controllable[event.receiver],
        }
    };
    Alphabet { letters: (0..playout.event_count() as u32).map(letter).collect() }
}

/// What outputs say of their origin.
#[must_use]
pub fn provenance(loaded: &Loaded, spec: &Spec) -> Provenance {
    let requirement = |scenario: &crate::model::Scenario| Requirement {
        scenario: scenario.name.clone(),
        kind: match scenario.kind {
            Kind::Assumption => "assumption",
            Kind::Guarantee => "guarantee",
            Kind::Existential => "existential",
        },
        text: scenario.requirement.clone(),
        line: scenario.span.start.line,
    };
    Provenance {
        file: loaded.sources.path(Loaded::MAIN).to_owned(),
        hash: loaded.hash(),
        requirements: spec.scenarios.iter().map(requirement).collect(),
    }
}

/// Says that the system wins only by a super step that never ends.
fn endless_super_step(explored: &Explored<'_>, strategy: &Strategy, endless: EndlessSuperStep) -> Diagnostic {
    let Explored { playout, game, .. } = explored;
    let texts = |edges: &[usize]| -> String {
        let labels = edges.iter().map(|&edge| game.label[strategy.edge[edge] as usize]);
        let texts = labels.map(|label| match label {
            YIELD => "\n  yield".to_owned(),
            event => format!("\n  {}", playout.event(event).text),
        });
        texts.collect()
    };
    let play = strategy.play_to(endless.node);
    let (mut node, mut cycle) = (endless.node, Vec::new());
    while let Some(edge) = strategy.edges_of(node).next() {
        cycle.push(edge);
        node = strategy.target[edge];
        if node == endless.node {
            break;
        }
    }
    // What the system sends there is asked for by a guarantee.
    let open = game.key_sets.members(game.open[strategy.state[endless.node as usize] as usize]);
    let asked = open.iter().find(|key| game.guarantees.contains(key)).map(|&key| playout.key(key));
    let spec = playout.spec();
    let place = asked
        .map_or_else(start_of_file, |key| spec.scenarios[key.scenario].nodes[usize::from(key.node)].span);
    let message = "the system wins only by a super step that never ends";
    let mut diagnostic = Diagnostic::error(Code::EndlessSuperStep, place, message)
        .note("it keeps the environment from ever meeting an assumption that is still open; no controller can do that");
    if !play.is_empty() {
        diagnostic = diagnostic.note(format!("the shortest play that leads there:{}", texts(&play)));
    }
    diagnostic
        .note(format!("and then, for ever:{}", texts(&cycle)))
        .help("let the loop wait for an event of the environment, or relax a guarantee")
}

fn start_of_file() -> Span {
    let start = Pos { line: 1, column: 1 };
    Span { file: FileId(0), start, end: start }
}

/// Explains that the specification is not realizable.
fn unrealizable(solved: &Solved<'_>, timings: &mut Timings) -> Failure {
    match timings.stage("explain", || explain(solved)) {
        Some(explanation) => {
            let (figures, diagnostic) = (solved.figures(), explanation.diagnostic());
            Failure::Unrealizable(Box::new(Unrealizable { figures, diagnostic, explanation }))
        }
        None => Failure::Inconsistent("the environment wins, but no play shows it".to_owned()),
    }
}

#[cfg(test)]
mod tests;

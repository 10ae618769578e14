//! The second route as code: from the text of a plant to its feedback, and to the program that does it.

use super::event_based::{self, Races};
use super::modular::{self, modular};
use super::remember::{Remembered, remember};
use super::{
    ClosedLoop, FormulaError, Modular, ModularError, Module, Options, Plant, StateFeedback, SuperviseError,
    Synthesis, never_enabled, state_feedback, unreadable,
};
use crate::controller::{Controller, Level, minimize, number};
use crate::diagnostic::{Code, Diagnostic};
use crate::explore::Limits;
use crate::pipeline::{Failure, Refused, Size, Timings};
use crate::syntax::Span;

/// A plant with the program that controls it.
#[derive(Clone, Debug)]
pub struct Supervised {
    /// The plant under its feedback.
    pub closed: ClosedLoop,
    /// Bits for what constraints remember.
    pub memory: Vec<Remembered>,
    /// Formulas and program.
    pub feedback: StateFeedback,
}

/// The supremal controllable, nonblocking feedback.
///
/// # Errors
/// There is none, or a limit was reached.
pub fn feedback(plant: &Plant, limits: &Limits, timings: &mut Timings) -> Result<ClosedLoop, Failure> {
    let synthesis = synthesis(plant, limits, timings)?;
    let closed = timings.stage("close", || synthesis.closed_loop(limits));
    timings.size(Size::of_closed_loop(&closed));
    Ok(closed)
}

/// The same with all that was found on the way.
///
/// # Errors
/// As [`feedback`].
pub fn synthesis<'p>(
    plant: &'p Plant,
    limits: &Limits,
    timings: &mut Timings,
) -> Result<Synthesis<'p>, Failure> {
    if let Some(hopeless) = modular::too_large(plant, limits) {
        return Err(Failure::Wrong(vec![hopeless.help(SMALLER)]));
    }
    timings.stage("supervise", || Synthesis::new(plant, limits)).map_err(|error| failure(error, plant))
}

/// What to do about a product that is too large.
const SMALLER: &str = "supervise constraints apart with `--modular`, or make the plant smaller";

fn failure(error: SuperviseError, plant: &Plant) -> Failure {
    match error {
        SuperviseError::Limit(limit) => {
            let diagnostics = Failure::Limit(limit).diagnostics().into_iter().map(|one| {
                let help = one.help.clone().unwrap_or_default();
                one.help(format!("{help}; or supervise constraints apart with `--modular`"))
            });
            Failure::Wrong(diagnostics.collect())
        }
        SuperviseError::TooLarge(diagnostic) => Failure::Wrong(vec![*diagnostic]),
        SuperviseError::Refused(unavoidable) => Failure::Refused(Box::new(Refused {
            diagnostic: unavoidable.diagnostic(plant),
            unavoidable: *unavoidable,
        })),
    }
}

/// A plant with the supervisors of its constraints, and the program that does what all of them want.
#[derive(Clone, Debug)]
pub struct ModularlySupervised {
    /// The supervisors.
    pub modular: Modular,
    /// Formulas and program; `None` if the plant has no inputs and outputs.
    pub feedback: Option<StateFeedback>,
}

/// As [`control`], with a supervisor per constraint: the product of the whole plant is never built. Of the options, `share`
/// has no effect.
///
/// # Errors
/// As [`control`]; and if the modules conflict.
pub fn control_modular(
    plant: &Plant,
    limits: &Limits,
    options: Options,
    timings: &mut Timings,
) -> Result<ModularlySupervised, Failure> {
    let has_signals = !plant.signals.is_empty();
    let wrong = if has_signals { unreadable(plant) } else { Vec::new() };
    if !wrong.is_empty() {
        return Err(Failure::Wrong(wrong));
    }
    let modular = timings.stage("supervise", || modular(plant, limits)).map_err(|error| match error {
        ModularError::Module(part, error) => failure(error, &part),
        ModularError::Conflict(states) => {
            let (diagnostic, unavoidable) = modular::conflict(plant, states);
            Failure::Refused(Box::new(Refused { diagnostic, unavoidable }))
        }
    })?;
    let feedback = if has_signals { Some(program_of(plant, &modular, options, timings)?) } else { None };
    Ok(ModularlySupervised { modular, feedback })
}

/// One program of all modules.
///
/// # Errors
/// As [`control`], but for what states look like and limits.
pub fn program_of(
    plant: &Plant,
    modular: &Modular,
    options: Options,
    timings: &mut Timings,
) -> Result<StateFeedback, Failure> {
    let own = Options { share: false, extract: false, ..options };
    let feedbacks = timings.stage("formulas", || {
        let feedback = |module: &Module| {
            let Module { part, closed, .. } = module;
            let memory = remember(&part.plant, closed)
                .map_err(|unseen| Failure::Wrong(vec![unseen.diagnostic(&part.plant, closed)]))?;
            let feedback = state_feedback(&part.plant, closed, &memory, own);
            feedback.map_err(|error| of_formulas(&error, &part.plant, closed))
        };
        modular.modules.iter().map(feedback).collect::<Result<Vec<StateFeedback>, Failure>>()
    })?;
    let feedback = timings.stage("program", || modular::program(plant, modular, &feedbacks, options));
    feedback.map_err(|error| match modular.modules.first() {
        Some(module) => of_formulas(&error, plant, &module.closed),
        None => Failure::Inconsistent("no modules".to_owned()),
    })
}

/// A plant with the controller that follows its events.
#[derive(Clone, Debug)]
pub struct Followed {
    /// The plant under its feedback.
    pub closed: ClosedLoop,
    /// One command at most in every entry; minimised and numbered.
    pub controller: Controller,
    /// Events of one scan that the controller cannot follow.
    pub races: Races,
}

impl Followed {
    /// What is worth a look: commands that are never enabled or never given, and races.
    #[must_use]
    pub fn warnings(&self, plant: &Plant) -> Vec<Diagnostic> {
        let commands = [never_enabled(plant, &self.closed), event_based::never_given(plant, &self.closed)];
        [commands.concat(), self.races.diagnostics(plant, &self.closed)].concat()
    }
}

/// The whole way from a plant to a controller that follows its events; states need not be readable. Levels that use don't-cares
/// are for specifications, and taken for [`Level::Exact`] here.
///
/// # Errors
/// As [`feedback`].
pub fn follow(
    plant: &Plant,
    limits: &Limits,
    level: Level,
    timings: &mut Timings,
) -> Result<Followed, Failure> {
    let closed = feedback(plant, limits, timings)?;
    let controller = timings.stage("extract", || event_based::controller(plant, &closed));
    let level = if level == Level::None { level } else { Level::Exact };
    let controller = timings.stage("minimise", || number(minimize(controller, level)));
    let races = timings.stage("races", || event_based::races(plant, &closed));
    Ok(Followed { closed, controller, races })
}

/// The whole way from a plant that was read ([`super::read`]) to a program.
///
/// # Errors
/// As [`feedback`]; and if states cannot be read from inputs and outputs, what constraints remember cannot be seen, or
/// formulas get too large.
pub fn control(
    plant: &Plant,
    limits: &Limits,
    options: Options,
    timings: &mut Timings,
) -> Result<Supervised, Failure> {
    let wrong = unreadable(plant);
    if !wrong.is_empty() {
        return Err(Failure::Wrong(wrong));
    }
    let closed = feedback(plant, limits, timings)?;
    let memory = timings.stage("memory", || remember(plant, &closed));
    let memory = memory.map_err(|unseen| Failure::Wrong(vec![unseen.diagnostic(plant, &closed)]))?;
    let feedback = timings.stage("formulas", || state_feedback(plant, &closed, &memory, options));
    let feedback = feedback.map_err(|error| of_formulas(&error, plant, &closed))?;
    Ok(Supervised { closed, memory, feedback })
}

fn of_formulas(error: &FormulaError, plant: &Plant, closed: &ClosedLoop) -> Failure {
    let text = error.text(plant, closed);
    let span = |event: Option<u32>| event.map_or(Span::default(), |event| plant.events[event as usize].span);
    match *error {
        FormulaError::Indistinguishable { event, .. } => Failure::Wrong(vec![
            Diagnostic::error(Code::Unseen, span(Some(event)), text)
                .help("show in the formulas of states what makes the difference, or remember it in a constraint automaton"),
        ]),
        FormulaError::TooLarge { event, .. } => Failure::Wrong(vec![
            Diagnostic::error(Code::FormulaTooLarge, span(event), text)
                .help("split the plant, or use the controller that follows events"),
        ]),
        FormulaError::Wrong { .. } => Failure::Inconsistent(text),
    }
}

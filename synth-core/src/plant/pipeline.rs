//! The second route as code: from the text of a plant to its feedback, and to the program that does it.

use super::remember::{Remembered, remember};
use super::{
    ClosedLoop, FormulaError, Options, Plant, StateFeedback, SuperviseError, state_feedback, supervise,
    unreadable,
};
use crate::diagnostic::{Code, Diagnostic};
use crate::explore::Limits;
use crate::pipeline::{Failure, Timings};
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
    timings.stage("supervise", || supervise(plant, limits)).map_err(|error| match error {
        SuperviseError::Limit(limit) => Failure::Limit(limit),
        SuperviseError::TooLarge(diagnostic) => Failure::Wrong(vec![*diagnostic]),
        SuperviseError::Refused(unavoidable) => Failure::Refused(Box::new(unavoidable.diagnostic(plant))),
    })
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

//! From a feedback to the program that does it.
//!
//! One rung per controllable event, in the order of the file: its formula, then its commands. A rung sees what the rungs
//! above have commanded, so that several events may follow each other in one scan, each in a state in which the feedback
//! enables it. With [`Options::extract`] a relay sees to it that only the first of them happens.
//!
//! Bits of memory are brought up to date with what is seen at the start of a scan, and with every event that the program
//! causes.

mod check;
mod comments;
mod memory;
mod share;

use super::formulas::{Bounds, DontCare, Formula, FormulaError};
use super::remember::Remembered;
use super::{ClosedLoop, Coil, Command, Drive, EventId, Plant, Program, Rung, SignalKind, Use, Variable};
use crate::logic::{Expr, Function, TooLarge, Var};

/// What program is made.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Options {
    /// What formulas may do where the plant cannot be.
    pub dont_care: DontCare,
    /// Conditions are disjunctions of terms, not factored.
    pub two_level: bool,
    /// What several conditions have in common is computed once, where that takes fewer instructions.
    pub share: bool,
    /// At most one event a scan: the first in the order of the file whose formula holds.
    pub extract: bool,
}

impl Options {
    /// As in a command line, each with a space in front, as far as they are not the defaults.
    #[must_use]
    pub fn words(self) -> String {
        let Options { dont_care, two_level, share, extract } = self;
        let mut words = String::new();
        for (word, is_given) in [
            (" --dont-care decodable", dont_care == DontCare::Decodable),
            (" --dont-care all", dont_care == DontCare::All),
            (" --two-level", two_level),
            (" --share", share),
            (" --extract", extract),
        ] {
            words.push_str(if is_given { word } else { "" });
        }
        words
    }
}

/// A feedback as formulas and as a program.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct StateFeedback {
    /// One per controllable event, in the order of the file.
    pub formulas: Vec<Formula>,
    /// The program. No condition is constant: an event that never fires has no rung, and a condition that always holds is
    /// written `x || !x`.
    pub program: Program,
}

/// The formulas of all controllable events, and the program that fires the events.
///
/// `memory` is what constraints remember, from [`super::remember::remember`]; empty if inputs and outputs show all.
///
/// Formulas are checked against the feedback, and the instructions of the program against the formulas: on all values of the
/// variables one by one up to 20 variables, and symbolically however many there are.
///
/// # Errors
/// If entries cannot be told apart, or formulas get too large.
pub fn state_feedback(
    plant: &Plant,
    closed: &ClosedLoop,
    memory: &[Remembered],
    options: Options,
) -> Result<StateFeedback, FormulaError> {
    let mut bounds = Bounds::new(plant, closed, memory, options.dont_care)?;
    let formulas = bounds.formulas()?;
    let variables =
        variables(&mut bounds).map_err(|reason| FormulaError::TooLarge { event: None, reason })?;
    let mut assembly = Assembly {
        program: Program {
            name: plant.name.clone(),
            doc: plant.doc.clone(),
            variables,
            analogues: plant.analogues.clone(),
            rungs: Vec::new(),
        },
        bounds: &mut bounds,
        options,
        fired: None,
    };
    for which in 0..memory.len() {
        let done = assembly.update(which);
        if !done.map_err(|reason| FormulaError::TooLarge { event: None, reason })? {
            return Err(FormulaError::Wrong { event: None });
        }
    }
    for formula in &formulas {
        let event = formula.event;
        let expr = match &formula.terms {
            Ok(terms) if options.two_level => terms.cover.expr(),
            Err(reason) if options.two_level => {
                return Err(FormulaError::TooLarge { event: Some(event), reason: *reason });
            }
            _ => formula.factored.clone(),
        };
        let done = assembly.event(event, &expr);
        if !done.map_err(|reason| FormulaError::TooLarge { event: Some(event), reason })? {
            return Err(FormulaError::Wrong { event: Some(event) });
        }
    }
    if options.share && !assembly.share().map_err(|reason| FormulaError::TooLarge { event: None, reason })? {
        return Err(FormulaError::Wrong { event: None });
    }
    let program = assembly.program;
    Ok(StateFeedback { formulas, program })
}

struct Assembly<'a, 'b> {
    bounds: &'a mut Bounds<'b>,
    options: Options,
    program: Program,
    /// The relay that says that an event has fired in this scan.
    fired: Option<Var>,
}

impl Assembly<'_, '_> {
    /// The rungs of an event; `false` if they failed their check.
    fn event(&mut self, event: EventId, expr: &Expr) -> Result<bool, TooLarge> {
        let plant = self.bounds.plant;
        let name = &plant.events[event as usize].name;
        let mut coils: Vec<Coil> = plant.events[event as usize].commands.iter().map(coil).collect();
        if *expr == Expr::Constant(false) {
            self.program.doc.push(format!("`{name}` never fires: no entry enables it"));
            return Ok(true);
        }
        let writes = self.writes(event)?;
        coils.extend(writes.iter().filter(|write| write.always).map(|write| write.coil));
        if coils.is_empty() && writes.is_empty() {
            self.program.doc.push(format!("`{name}` has no rung: it commands nothing"));
            return Ok(true);
        }
        let first_rung = self.program.rungs.len();
        let interlock = self.options.extract.then(|| self.interlock(&mut coils));
        let guarded = |expr: Expr| match interlock {
            Some((relay, false)) => Expr::all(vec![Expr::literal(relay, false), expr]),
            _ => expr,
        };
        let mut delayed = Vec::new();
        for write in writes.into_iter().filter(|write| !write.always) {
            let condition = not_constant(guarded(write.condition));
            delayed.push(self.delay(Some(name), write.coil, Vec::new(), condition));
        }
        let comment = comments::of_event(plant, self.bounds.closed, event);
        self.rung(Some(event), comment, not_constant(guarded(expr.clone())), coils);
        self.drive(delayed);
        self.check_event(event, expr, first_rung)
    }

    /// The relay that keeps later events from firing; whether this is the first event, which writes it in any case.
    fn interlock(&mut self, coils: &mut Vec<Coil>) -> (Var, bool) {
        match self.fired {
            Some(variable) => {
                coils.push(Coil { variable, drive: Drive::Set });
                (variable, false)
            }
            None => {
                let variable = self.scratch("fired");
                self.fired = Some(variable);
                coils.push(Coil { variable, drive: Drive::Out });
                (variable, true)
            }
        }
    }

    fn rung(&mut self, event: Option<EventId>, comment: Vec<String>, condition: Expr, coils: Vec<Coil>) {
        self.program.rungs.push(Rung { event, comment, condition, coils });
    }

    /// A new relay.
    fn scratch(&mut self, name: &str) -> Var {
        let name = unique(&self.program.variables, name);
        self.program.variables.push(Variable { name, usage: Use::Scratch, doc: Vec::new() });
        self.program.variables.len() as Var - 1
    }
}

/// A rung cannot do without a contact.
fn not_constant(expr: Expr) -> Expr {
    match expr {
        Expr::Constant(true) => Expr::Or(vec![Expr::literal(0, true), Expr::literal(0, false)]),
        other => other,
    }
}

fn coil(command: &Command) -> Coil {
    Coil { variable: command.signal, drive: if command.set { Drive::Set } else { Drive::Reset } }
}

/// `name`, or with a number if that is taken, without regard to case.
pub(super) fn unique(variables: &[Variable], name: &str) -> String {
    let taken = |name: &str| variables.iter().any(|variable| variable.name.eq_ignore_ascii_case(name));
    let mut candidate = name.to_owned();
    let mut number = 2;
    while taken(&candidate) {
        candidate = format!("{name}{number}");
        number += 1;
    }
    candidate
}

/// Signals, then bits of memory.
fn variables(bounds: &mut Bounds<'_>) -> Result<Vec<Variable>, TooLarge> {
    let plant = bounds.plant;
    let mut variables: Vec<Variable> = Vec::with_capacity(plant.signals.len());
    let at_first = values_at_first(bounds)?;
    for (signal, at_first) in plant.signals.iter().zip(at_first) {
        let usage = match signal.kind {
            SignalKind::Input => Use::Input,
            SignalKind::Output => Use::Output,
            SignalKind::Memory => Use::Memory(at_first),
            SignalKind::Range { analogue, low, high } => Use::Range(analogue, low, high),
        };
        variables.push(Variable { name: signal.name.clone(), usage, doc: signal.doc.clone() });
    }
    for remembered in bounds.memory {
        let automata = remembered.name(plant);
        for bit in 0..remembered.bits {
            let name = match remembered.bits {
                1 => automata.clone(),
                _ => format!("{automata}_{bit}"),
            };
            variables.push(Variable {
                name: unique(&variables, &name),
                usage: Use::Memory(remembered.initial >> bit & 1 == 1),
                doc: remembered.doc(plant),
            });
        }
    }
    Ok(variables)
}

/// Per signal its value at the start, as far as the controller chooses: memory bits are such that the initial states can be
/// read, with outputs off if possible; of several ways the one with fewer bits on, the first in the file mattering most.
fn values_at_first(bounds: &mut Bounds<'_>) -> Result<Vec<bool>, TooLarge> {
    let plant = bounds.plant;
    let initial = bounds.closed.entry(bounds.closed.initial as usize);
    let mut possible = Function::TRUE;
    for (states, &state) in bounds.states.iter().zip(initial) {
        possible = bounds.bdd.and(possible, states[state as usize])?;
    }
    let mut values = vec![false; plant.signals.len()];
    for wanted in [SignalKind::Output, SignalKind::Memory] {
        for (signal, value) in
            values.iter_mut().enumerate().filter(|(it, _)| plant.signals[*it].kind == wanted)
        {
            let on = bounds.bdd.variable(bounds.position[signal])?;
            let off = bounds.bdd.without(possible, on)?;
            *value = off == Function::FALSE;
            possible = if *value { bounds.bdd.and(possible, on)? } else { off };
        }
    }
    Ok(values)
}

#[cfg(test)]
mod tests;

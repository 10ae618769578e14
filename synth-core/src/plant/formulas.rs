//! One Boolean formula per controllable event.
//!
//! A formula holds in the entries of the feedback in which its event is enabled, and in no other entry. What it does for
//! values of inputs and outputs that are no entry at all is free within the chosen policy, and makes it smaller.

use super::entries::Entries;
use super::readable::samples;
use super::remember::Remembered;
use super::{ClosedLoop, Condition, EventId, Plant, Program, SignalId, SignalKind};
use crate::emit::scan::formula::PLANT;
use crate::logic::{Bdd, Expr, Function, Minimal, TooLarge, Var, factor, minimize};
use hashbrown::HashMap;
use rustc_hash::FxBuildHasher;
use std::fmt;

/// What formulas may do where the plant cannot be.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum DontCare {
    /// Impossible values issue no command: a broken sensor stops the plant.
    #[default]
    None,
    /// Free where inputs and outputs show a state of every component, but the feedback never comes there.
    Decodable,
    /// Free wherever the feedback never comes.
    All,
}

/// When a controllable event may fire.
///
/// Variables are signals by their numbers; after them come the bits of memory.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Formula {
    /// The event.
    pub event: EventId,
    /// As a disjunction with the fewest terms, and of those the fewest literals, of all functions that the policy allows; or why
    /// there is none of reasonable size.
    pub terms: Result<Minimal, TooLarge>,
    /// The same function, with as few instructions as were found.
    pub factored: Expr,
}

impl Formula {
    /// For people: as [`Formula::text`], but `never` and `always` in place of a formula that is constant.
    #[must_use]
    pub fn words(&self, program: &Program) -> String {
        match self.factored {
            Expr::Constant(false) => "never".to_owned(),
            Expr::Constant(true) => "always".to_owned(),
            _ => self.text(program),
        }
    }

    /// In the syntax of plants, with the names of the program's variables: its terms, or where these are too many, factored.
    ///
    /// That syntax has no constants: what never holds is `x && !x` and what always holds is `x || !x`, so that whoever
    /// reads conditions can read this.
    #[must_use]
    pub fn text(&self, program: &Program) -> String {
        let name = |variable: Var| program.variables[variable as usize].name.clone();
        match &self.terms {
            Ok(terms) => terms.cover.text(name, 0),
            Err(_) => PLANT.text(&self.factored, &name),
        }
    }
}

/// Why there are no formulas.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum FormulaError {
    /// Two entries in which inputs, outputs and memory can be the same, though an event is enabled in only one of them.
    Indistinguishable {
        /// The event.
        event: EventId,
        /// The entries, ascending.
        entries: [usize; 2],
    },
    /// The formula of an event, or of some state, is too large.
    TooLarge {
        /// The event, if it is about one.
        event: Option<EventId>,
        /// What there is too much of.
        reason: TooLarge,
    },
    /// A result failed its check: a mistake of this program.
    Wrong {
        /// The event, if it is about one.
        event: Option<EventId>,
    },
}

impl FormulaError {
    /// In the words of the plant.
    #[must_use]
    pub fn text(&self, plant: &Plant, closed: &ClosedLoop) -> String {
        let name = |event: EventId| &plant.events[event as usize].name;
        match self {
            FormulaError::Indistinguishable { event, entries: [a, b] } => format!(
                "`{}` is enabled in only one of ({}) and ({}), and inputs, outputs and memory can be the same in both",
                name(*event),
                states(plant, closed, *a),
                states(plant, closed, *b)
            ),
            FormulaError::TooLarge { event: Some(event), reason } => {
                format!("the formula of `{}` is too large: {reason}", name(*event))
            }
            FormulaError::TooLarge { event: None, reason } => {
                format!("the states of the components are too many for formulas: {reason}")
            }
            FormulaError::Wrong { event } => format!(
                "the {} failed its check; this is a mistake of this program",
                event.map_or("program".to_owned(), |event| format!("formula of `{}`", name(event)))
            ),
        }
    }
}

/// The states of an entry by name.
fn states(plant: &Plant, closed: &ClosedLoop, entry: usize) -> impl fmt::Display {
    plant.state_names(closed.entry(entry)).join(", ")
}

/// The number of a bit of memory among the variables of formulas.
pub(super) fn bit(plant: &Plant, memory: &[Remembered], which: usize, bit: u32) -> Var {
    let before: u32 = memory[..which].iter().map(|remembered| remembered.bits).sum();
    plant.signals.len() as Var + before + bit
}

/// Between what formulas may lie.
///
/// Variables of the decision diagrams are numbered in the order in which the components mention signals, so that those of
/// one component are neighbours.
pub(super) struct Bounds<'a> {
    pub(super) plant: &'a Plant,
    pub(super) closed: &'a ClosedLoop,
    pub(super) memory: &'a [Remembered],
    dont_care: DontCare,
    entries: Entries,
    pub(super) bdd: Bdd,
    /// Per variable of the diagrams the signal or bit of memory.
    pub(super) order: Vec<Var>,
    /// The other way round.
    pub(super) position: Vec<Var>,
    /// Per component and state when it is that state.
    pub(super) states: Vec<Vec<Function>>,
    /// Where every analogue input has some value: ranges that do not overlap never hold together.
    measurable: Function,
    /// Where some entry can be.
    possible: Function,
    /// Where every component is in some state.
    decodable: Function,
}

impl<'a> Bounds<'a> {
    pub(super) fn new(
        plant: &'a Plant,
        closed: &'a ClosedLoop,
        memory: &'a [Remembered],
        dont_care: DontCare,
    ) -> Result<Self, FormulaError> {
        let entries = Entries::new(plant, closed, memory).map_err(|[a, b]| {
            FormulaError::Indistinguishable { event: differs(plant, closed, a, b), entries: [a, b] }
        })?;
        let bits: u32 = memory.iter().map(|remembered| remembered.bits).sum();
        let order = order(plant, bits);
        let mut position = vec![0; order.len()];
        order.iter().zip(0..).for_each(|(&variable, level)| position[variable as usize] = level);
        let mut bounds = Bounds {
            plant,
            closed,
            memory,
            dont_care,
            entries,
            bdd: Bdd::new(),
            order,
            position,
            states: Vec::new(),
            measurable: Function::TRUE,
            possible: Function::FALSE,
            decodable: Function::TRUE,
        };
        bounds.measurable().map_err(|reason| FormulaError::TooLarge { event: None, reason })?;
        bounds.states().map_err(|reason| FormulaError::TooLarge { event: None, reason })?;
        Ok(bounds)
    }

    fn measurable(&mut self) -> Result<(), TooLarge> {
        for (input, samples) in (0..).zip(samples(self.plant)).filter(|(_, samples)| !samples.is_empty()) {
            let mut any = Function::FALSE;
            for sample in samples {
                let mut all = Function::TRUE;
                for (signal, &level) in self.plant.signals.iter().zip(&self.position) {
                    if let SignalKind::Range { analogue, low, high } = signal.kind
                        && analogue == input
                    {
                        let literal = self.bdd.literal(level, (low..=high).contains(&sample))?;
                        all = self.bdd.and(all, literal)?;
                    }
                }
                any = self.bdd.or(any, all)?;
            }
            self.measurable = self.bdd.and(self.measurable, any)?;
        }
        Ok(())
    }

    fn states(&mut self) -> Result<(), TooLarge> {
        for component in &self.plant.automata[..self.plant.components] {
            let mut any = Function::FALSE;
            let mut functions = Vec::with_capacity(component.states.len());
            for state in &component.states {
                let function = match &state.formula {
                    None => Function::TRUE,
                    Some(formula) => condition(&mut self.bdd, &self.position, formula)?,
                };
                any = self.bdd.or(any, function)?;
                functions.push(function);
            }
            self.states.push(functions);
            self.decodable = self.bdd.and(self.decodable, any)?;
        }
        self.possible = self.entries_where(|_| true)?;
        Ok(())
    }

    /// Where an entry can be whose enabled events fulfil a condition.
    fn entries_where(&mut self, wanted: impl Fn(&[EventId]) -> bool) -> Result<Function, TooLarge> {
        let wanted: Vec<bool> = self.entries.enabled.iter().map(|events| wanted(events)).collect();
        let mut below = Vec::with_capacity(self.entries.leaves.len());
        for leaf in &self.entries.leaves {
            let mut sum = Function::FALSE;
            for (codes, _) in leaf.iter().filter(|(_, enabled)| wanted[*enabled as usize]) {
                let term =
                    self.memory.iter().zip(codes).enumerate().flat_map(|(which, (remembered, code))| {
                        (0..remembered.bits).map(move |bit| (which, bit, code >> bit & 1 == 1))
                    });
                let mut product = Function::TRUE;
                for (which, number, value) in term {
                    let variable = self.position[bit(self.plant, self.memory, which, number) as usize];
                    let literal = self.bdd.literal(variable, value)?;
                    product = self.bdd.and(product, literal)?;
                }
                sum = self.bdd.or(sum, product)?;
            }
            below.push(sum);
        }
        for (level, states) in self.entries.levels.iter().zip(&self.states).rev() {
            let mut here = Vec::with_capacity(level.len());
            for branches in level {
                let mut sum = Function::FALSE;
                for &(state, child) in branches {
                    let product = self.bdd.and(states[state as usize], below[child as usize])?;
                    sum = self.bdd.or(sum, product)?;
                }
                here.push(sum);
            }
            below = here;
        }
        self.bdd.and(below[self.entries.root as usize], self.measurable)
    }

    /// Where an entry can be in which `event` is enabled, and where one can be in which it is not.
    pub(super) fn on_and_off(&mut self, event: EventId) -> Result<(Function, Function), TooLarge> {
        let on = self.entries_where(|enabled| enabled.contains(&event))?;
        Ok((on, self.entries_where(|enabled| !enabled.contains(&event))?))
    }

    /// The formulas of all controllable events, in the order of the file.
    ///
    /// Each is checked against the feedback: it holds wherever an entry with the event can be, and nowhere where one without
    /// it can be. With [`DontCare::None`] it holds nowhere else either that analogue inputs have values for.
    pub(super) fn formulas(&mut self) -> Result<Vec<Formula>, FormulaError> {
        let events = 0..self.plant.events.len() as EventId;
        let controllable = events.filter(|&event| self.plant.events[event as usize].controllable);
        controllable
            .map(|event| {
                self.formula(event)
                    .unwrap_or_else(|reason| Err(FormulaError::TooLarge { event: Some(event), reason }))
            })
            .collect()
    }

    fn formula(&mut self, event: EventId) -> Result<Result<Formula, FormulaError>, TooLarge> {
        let (on, off) = self.on_and_off(event)?;
        let both = self.bdd.and(on, off)?;
        if let Some(witness) = self.bdd.witness(both) {
            return Ok(Err(self.indistinguishable(event, &witness)));
        }
        let upper = self.upper(on, off)?;
        let precondition = self.precondition(event)?;
        let (terms, factored) = self.forms(on, upper, precondition)?;
        let function = factored.function(&mut self.bdd)?;
        let same = match &terms {
            Ok(terms) => terms.cover.expr().function(&mut self.bdd)? == function,
            Err(_) => true,
        };
        if !same || !self.is_right(function, on, off)? {
            return Ok(Err(FormulaError::Wrong { event: Some(event) }));
        }
        let variable = |level: Var| self.order[level as usize];
        Ok(Ok(Formula {
            event,
            terms: terms.map(|terms| Minimal { cover: terms.cover.renamed(variable), ..terms }),
            factored: factored.renamed(&variable).in_order(),
        }))
    }

    /// Both forms of one function between the bounds: a disjunction that is a smallest of all of them, and this factored.
    fn forms(
        &mut self,
        lower: Function,
        upper: Function,
        precondition: Function,
    ) -> Result<(Result<Minimal, TooLarge>, Expr), TooLarge> {
        let terms = minimize(&mut self.bdd, lower, upper);
        let (lower, upper) = match &terms {
            Ok(terms) => {
                let function = terms.cover.function(&mut self.bdd)?;
                (function, function)
            }
            Err(_) => (lower, upper),
        };
        let factored = factor(&mut self.bdd, lower, upper, &[precondition])?;
        Ok((terms, factored))
    }

    fn upper(&mut self, on: Function, off: Function) -> Result<Function, TooLarge> {
        match self.dont_care {
            // What no analogue input can say is free: the controller itself makes Booleans of numbers.
            DontCare::None => self.bdd.or(on, !self.measurable),
            DontCare::Decodable => {
                let free = self.bdd.without(self.decodable, self.possible)?;
                let free = self.bdd.or(free, !self.measurable)?;
                self.bdd.or(on, free)
            }
            DontCare::All => Ok(!off),
        }
    }

    fn is_right(&mut self, function: Function, on: Function, off: Function) -> Result<bool, TooLarge> {
        Ok(match self.dont_care {
            DontCare::None => self.bdd.and(function, self.measurable)? == on,
            DontCare::Decodable | DontCare::All => {
                self.bdd.implies(on, function)? && self.bdd.and(function, off)? == Function::FALSE
            }
        })
    }

    /// The states of components in which the event can happen.
    fn precondition(&mut self, event: EventId) -> Result<Function, TooLarge> {
        let mut all = Function::TRUE;
        for (component, functions) in self.plant.automata.iter().zip(&self.states) {
            if component.alphabet.binary_search(&event).is_err() {
                continue;
            }
            let mut any = Function::FALSE;
            for (state, &function) in component.states.iter().zip(functions) {
                if state.edges.iter().any(|edge| edge.event == event) {
                    any = self.bdd.or(any, function)?;
                }
            }
            all = self.bdd.and(all, any)?;
        }
        Ok(all)
    }

    fn indistinguishable(&self, event: EventId, witness: &[(Var, bool)]) -> FormulaError {
        let holds = |variable: Var| witness.contains(&(self.position[variable as usize], true));
        let possible = |&entry: &usize| {
            let states = self.closed.entry(entry);
            let formulas = self.plant.automata[..self.plant.components].iter().zip(states);
            formulas
                .filter_map(|(component, &state)| component.states[state as usize].formula.as_ref())
                .all(|formula| formula.eval(&|&signal: &SignalId| holds(signal)))
                && self.memory.iter().enumerate().all(|(which, remembered)| {
                    (0..remembered.bits).all(|number| {
                        holds(bit(self.plant, self.memory, which, number))
                            == (remembered.codes[entry] >> number & 1 == 1)
                    })
                })
        };
        let with = |enabled: bool| {
            (0..self.closed.len())
                .filter(|&entry| self.closed.edges(entry).iter().any(|&(other, _)| other == event) == enabled)
                .find(possible)
        };
        match (with(true), with(false)) {
            (Some(a), Some(b)) => FormulaError::Indistinguishable { event, entries: [a.min(b), a.max(b)] },
            _ => FormulaError::Wrong { event: Some(event) },
        }
    }
}

/// An event that is enabled in only one of two entries.
fn differs(plant: &Plant, closed: &ClosedLoop, a: usize, b: usize) -> EventId {
    let has = |entry: usize, event: EventId| closed.edges(entry).iter().any(|&(other, _)| other == event);
    let mut controllable =
        (0..plant.events.len() as EventId).filter(|&event| plant.events[event as usize].controllable);
    controllable.find(|&event| has(a, event) != has(b, event)).unwrap_or(0)
}

/// All variables: signals in the order in which components mention them, the others, bits of memory.
fn order(plant: &Plant, bits: u32) -> Vec<Var> {
    let mut order: Vec<Var> = Vec::with_capacity(plant.signals.len());
    let mut seen: HashMap<Var, (), FxBuildHasher> = HashMap::default();
    let mut visit = |signal: Var| {
        if seen.insert(signal, ()).is_none() {
            order.push(signal);
        }
    };
    for component in &plant.automata[..plant.components] {
        for formula in component.states.iter().filter_map(|state| state.formula.as_ref()) {
            formula.atoms(&mut |&signal| visit(signal));
        }
    }
    (0..plant.signals.len() as Var + bits).for_each(visit);
    order
}

/// The formula of a state, in the variables of the diagrams.
fn condition(bdd: &mut Bdd, position: &[Var], formula: &Condition<SignalId>) -> Result<Function, TooLarge> {
    match formula {
        Condition::Atom(signal) => bdd.variable(position[*signal as usize]),
        Condition::Not(inner) => Ok(!condition(bdd, position, inner)?),
        Condition::And(parts) => parts.iter().try_fold(Function::TRUE, |product, part| {
            let part = condition(bdd, position, part)?;
            bdd.and(product, part)
        }),
        Condition::Or(parts) => parts.iter().try_fold(Function::FALSE, |sum, part| {
            let part = condition(bdd, position, part)?;
            bdd.or(sum, part)
        }),
    }
}

//! Whether inputs and outputs show the state of a plant, as state feedback needs.
//!
//! Two formulas overlap if both can be true. That is decided by a search that gives a value to one signal after another
//! and evaluates with three values what is known so far: formulas of states are conjunctions of few literals, mostly, so
//! hardly any value is given in vain. An analogue input is given a value as a whole, of which there are as many that
//! matter as its ranges have ends.

use super::{Automaton, Condition, Plant, SignalId, SignalKind, State, effects};
use crate::diagnostic::{Code, Diagnostic};

/// Whatever keeps a state-feedback controller from reading the states of components, in the order of places.
///
/// A component with several states needs a formula for each of them; every formula must hold for some values of inputs
/// and outputs; and no two of one component for the same. Of several states that look like a later one the first is told.
/// Constraint automata are not read. Where all this is so, commands must be seen, too: what an event commands makes the
/// formula of its target true, and that of its source false.
#[must_use]
pub fn unreadable(plant: &Plant) -> Vec<Diagnostic> {
    let mut search = Search::new(plant);
    let mut found = Vec::new();
    for component in &plant.automata[..plant.components] {
        without_formula(component, &mut found);
        let mut readable: Vec<(&State, &Condition<SignalId>)> = Vec::new();
        for state in &component.states {
            let Some(formula) = &state.formula else { continue };
            if search.satisfied(&[formula]).is_none() {
                found.push(never_holds(plant, state));
                continue;
            }
            let mut earlier = readable.iter();
            let overlap = earlier.find_map(|&(other, of_other)| {
                search.satisfied(&[of_other, formula]).map(|values| overlap(other, state, &values))
            });
            found.extend(overlap);
            readable.push((state, formula));
        }
    }
    if found.is_empty() {
        effects::unseen(plant, &mut search, &mut found);
    }
    found.sort_by_key(|d| d.span.start);
    found
}

fn without_formula(component: &Automaton, found: &mut Vec<Diagnostic>) {
    if component.states.len() < 2 {
        return;
    }
    for state in component.states.iter().filter(|state| state.formula.is_none()) {
        let message =
            format!("inputs and outputs do not show when `{}` is in `{}`", component.name, state.name);
        let error = Diagnostic::error(Code::NoFormula, state.span, message);
        found.push(error.help(format!("write a formula behind the name: `state {} [ … ]`", state.name)));
    }
}

fn never_holds(plant: &Plant, state: &State) -> Diagnostic {
    let message = format!("the formula of `{}` never holds", state.name);
    let error = Diagnostic::error(Code::NeverHolds, state.span, message);
    let mut ranges = false;
    if let Some(formula) = &state.formula {
        formula.atoms(&mut |&signal| {
            ranges |= matches!(plant.signals[signal as usize].kind, SignalKind::Range { .. });
        });
    }
    let error = if ranges { error.note("no value lies in ranges that do not overlap") } else { error };
    error.help("remove what contradicts the rest of it")
}

fn overlap(first: &State, second: &State, values: &str) -> Diagnostic {
    let message = format!("`{}` cannot be told from `{}`", second.name, first.name);
    let error = Diagnostic::error(Code::Overlap, second.span, message);
    let error = error.also(first.span, "looks the same").note(format!("both formulas hold where {values}"));
    error.help("add to one of them what the other excludes")
}

/// By analogue input: values of which at least one makes any ranges true, and all others false, for which there is a value.
pub(super) fn samples(plant: &Plant) -> Vec<Vec<i64>> {
    let mut samples = vec![Vec::new(); plant.analogues.len()];
    for signal in &plant.signals {
        let SignalKind::Range { analogue, low, high } = signal.kind else { continue };
        // What is true changes at the ends of ranges only.
        let ends = [Some(low), high.checked_add(1), low.checked_sub(1)];
        samples[analogue as usize].extend(ends.into_iter().flatten());
    }
    for samples in &mut samples {
        samples.sort_unstable();
        samples.dedup();
    }
    samples
}

/// A search for values that make formulas true.
pub(super) struct Search<'a> {
    plant: &'a Plant,
    /// What is known of each signal.
    values: Vec<Option<bool>>,
    /// By analogue input.
    samples: Vec<Vec<i64>>,
    /// Its ranges.
    ranges: Vec<Vec<SignalId>>,
    /// What has been given a value, in this order.
    given: Vec<Given>,
}

/// A value given to a signal, or to the analogue input of which the signal is a range.
struct Given {
    signal: SignalId,
    /// Tried first, if it is no range.
    first: bool,
    /// How many values have been given, this one included.
    tried: usize,
    /// How many there are.
    values: usize,
}

impl<'a> Search<'a> {
    pub(super) fn new(plant: &'a Plant) -> Self {
        let mut ranges = vec![Vec::new(); plant.analogues.len()];
        for (id, signal) in (0..).zip(&plant.signals) {
            if let SignalKind::Range { analogue, .. } = signal.kind {
                ranges[analogue as usize].push(id);
            }
        }
        let values = vec![None; plant.signals.len()];
        Search { plant, values, samples: samples(plant), ranges, given: Vec::new() }
    }

    /// Values that make all `formulas` true, in words, if there are any.
    pub(super) fn satisfied(&mut self, formulas: &[&Condition<SignalId>]) -> Option<String> {
        let possible = formulas.iter().all(|formula| self.give_literals(formula));
        let found = (possible && self.search(formulas)).then(|| self.shown());
        for given in std::mem::take(&mut self.given) {
            self.forget(given.signal);
        }
        found
    }

    /// Gives the values without which a conjunction cannot hold; says whether none contradicts another.
    fn give_literals(&mut self, formula: &Condition<SignalId>) -> bool {
        let (signal, value) = match formula {
            Condition::And(parts) => return parts.iter().all(|part| self.give_literals(part)),
            Condition::Atom(signal) => (*signal, true),
            Condition::Not(inner) => match **inner {
                Condition::Atom(signal) => (signal, false),
                _ => return true,
            },
            Condition::Or(_) => return true,
        };
        if self.analogue(signal).is_some() {
            return true;
        }
        if self.values[signal as usize].is_none() {
            self.give(Given { signal, first: value, tried: 1, values: 1 });
        }
        self.values[signal as usize] == Some(value)
    }

    /// Whether values can be added to those given that make all `formulas` true; if so they are added.
    fn search(&mut self, formulas: &[&Condition<SignalId>]) -> bool {
        loop {
            let known: Vec<Option<bool>> = formulas.iter().map(|formula| self.known(formula)).collect();
            if known.contains(&Some(false)) {
                if !self.another_way() {
                    return false;
                }
            } else if let Some(undecided) = known.iter().position(Option::is_none) {
                let (signal, first) = self.literal(formulas[undecided], true);
                let values = self.analogue(signal).map_or(2, |analogue| self.samples[analogue].len());
                self.give(Given { signal, first, tried: 1, values });
            } else {
                return true;
            }
        }
    }

    /// Gives another value to what was given one last, of all that have another.
    fn another_way(&mut self) -> bool {
        while let Some(Given { signal, first, tried, values }) = self.given.pop() {
            self.forget(signal);
            if tried < values {
                self.give(Given { signal, first, tried: tried + 1, values });
                return true;
            }
        }
        false
    }

    fn give(&mut self, given: Given) {
        match self.sample(&given) {
            None => self.values[given.signal as usize] = Some(given.first == (given.tried == 1)),
            Some((analogue, value)) => {
                for &range in &self.ranges[analogue] {
                    if let SignalKind::Range { low, high, .. } = self.plant.signals[range as usize].kind {
                        self.values[range as usize] = Some((low..=high).contains(&value));
                    }
                }
            }
        }
        self.given.push(given);
    }

    fn forget(&mut self, signal: SignalId) {
        self.values[signal as usize] = None;
        if let Some(analogue) = self.analogue(signal) {
            self.ranges[analogue].iter().for_each(|&range| self.values[range as usize] = None);
        }
    }

    fn known(&self, formula: &Condition<SignalId>) -> Option<bool> {
        formula.known(&|&signal| self.values[signal as usize])
    }

    /// The analogue input of a range.
    fn analogue(&self, signal: SignalId) -> Option<usize> {
        match self.plant.signals[signal as usize].kind {
            SignalKind::Range { analogue, .. } => Some(analogue as usize),
            _ => None,
        }
    }

    /// The analogue input that was given a value, and the value.
    fn sample(&self, given: &Given) -> Option<(usize, i64)> {
        let analogue = self.analogue(given.signal)?;
        Some((analogue, self.samples[analogue][given.tried - 1]))
    }

    /// A signal without a value in a formula that is not decided, and the value that makes the formula more like `wanted`.
    fn literal(&self, formula: &Condition<SignalId>, wanted: bool) -> (SignalId, bool) {
        match formula {
            Condition::Atom(signal) => (*signal, wanted),
            Condition::Not(inner) => self.literal(inner, !wanted),
            Condition::And(parts) | Condition::Or(parts) => {
                // What is not decided has a part that is not.
                let open = parts.iter().find(|part| self.known(part).is_none());
                self.literal(open.unwrap_or(&parts[0]), wanted)
            }
        }
    }

    /// The values given, as an expression and the values of analogue inputs.
    fn shown(&self) -> String {
        let mut given: Vec<&Given> = self.given.iter().collect();
        given.sort_unstable_by_key(|given| given.signal);
        let (mut booleans, mut shown) = (Vec::new(), Vec::new());
        for given in given {
            if let Some((analogue, value)) = self.sample(given) {
                shown.push(format!("`{}` is {value}", self.plant.analogues[analogue]));
                continue;
            }
            let negation = if self.values[given.signal as usize] == Some(true) { "" } else { "!" };
            booleans.push(format!("{negation}{}", self.plant.signals[given.signal as usize].name));
        }
        if !booleans.is_empty() {
            shown.insert(0, format!("`{}`", booleans.join(" && ")));
        }
        shown.join(" and ")
    }
}

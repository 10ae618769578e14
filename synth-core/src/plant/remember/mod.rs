//! What constraints have to remember, because inputs and outputs do not show it: a *dynamic* feedback.
//!
//! A constraint automaton follows events, and the controller sees none: it sees signals, once a scan. What it can do is to keep
//! bits for the automaton, and to change them
//!
//! - when it causes a controllable event itself, and
//! - when the components that take part in the automaton's events are seen in other states than the bits are about.
//!
//! So bits need not be right at every moment: it is enough that old bits and the states now seen determine the new ones.
//! A machine that is seen idle with the bits of a working one has finished. This often saves bits: a place in a buffer may be
//! taken when the machine that will fill it is started, instead of when it is seen to have finished.
//!
//! Each automaton that is needed at all (`needed`) gets bits of its own, as few as possible, named after it: bits shared by
//! several could be fewer now and then, but nobody could read them. Only where that does not do, because what has to be
//! remembered of one can be seen by the other only, automata are remembered together.
//!
//! Per automaton or group: `local` projects the closed loop to the automata and the components around them, `machine` is what a
//! controller can know of that, `refine` unites what means the same, `merge` what need not be told apart, `conclude` says what is
//! concluded from what, `search` gives the codes with the fewest bits, `fit` some with few where there is too much to search, and
//! `tidy` has fewer of them change. Automata come one after
//! the other, and what the feedback depends on besides is the *context*: the states of components, bits that were given
//! already, and the states of automata that are still to come. So at the end states of components and bits say what is enabled.

mod conclude;
mod fit;
mod local;
mod machine;
mod merge;
mod needed;
mod refine;
mod search;
mod tidy;

use super::{AutomatonId, ClosedLoop, EventId, Plant};
use crate::diagnostic::{Code, Diagnostic};
use crate::intern::Rows;
use conclude::{Conclusions, Occasion};
use local::Local;
use machine::Machine;
use search::{Codes, Problem};
use std::collections::BTreeSet;

/// What the bits of a constraint automaton are, or of several together, and when they change.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Remembered {
    /// The constraint automata, ascending: one, unless bits for each by itself do not do.
    pub automata: Vec<AutomatonId>,
    /// The components whose states tell of their events, ascending.
    pub components: Vec<AutomatonId>,
    /// How many bits there are.
    pub bits: u32,
    /// Whether fewer bits, changed on these components' states, are known not to do. Otherwise there was too much to search.
    pub fewest: bool,
    /// Their values at first; bit `i` of a code is the value of bit `i`.
    pub initial: u32,
    /// Per entry of the closed loop their values.
    pub codes: Vec<u32>,
    /// Changes because of what is seen, by states and old code.
    pub seen: Vec<Change>,
    /// Changes with a controllable event, by event, states and old code.
    pub caused: Vec<(EventId, Change)>,
}

impl Remembered {
    /// What bits are named after.
    #[must_use]
    pub fn name(&self, plant: &Plant) -> String {
        let names: Vec<&str> =
            self.automata.iter().map(|&automaton| plant.automata[automaton as usize].name.as_str()).collect();
        names.join("_")
    }

    /// What to say of the bits.
    #[must_use]
    pub fn doc(&self, plant: &Plant) -> Vec<String> {
        let mut doc = vec![format!("What `{}` has to remember", self.name(plant))];
        if !self.fewest {
            doc.push("Perhaps fewer bits would do: there were too many ways to try".to_owned());
        }
        doc
    }
}

/// With these states of [`Remembered::components`], one code becomes another.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Change {
    /// The states, as seen; for a controllable event those before it.
    pub states: Vec<u16>,
    /// The bits before.
    pub old: u32,
    /// The bits afterwards; others than before.
    pub new: u32,
}

/// Why bits cannot do it: two plays that look the same, though something different is enabled at their ends.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Indistinguishable {
    /// A constraint automaton that would tell the difference.
    pub automaton: AutomatonId,
    /// The events, from one entry, that lead to the same states of all components; one event twice if it leaves them as they
    /// are. From there on the plays are the same.
    pub events: [EventId; 2],
    /// The entries at the ends.
    pub entries: [usize; 2],
}

impl Indistinguishable {
    /// What to tell the author of the plant.
    #[must_use]
    pub fn diagnostic(&self, plant: &Plant, closed: &ClosedLoop) -> Diagnostic {
        let [a, b] = self.events.map(|event| &plant.events[event as usize]);
        let constraint = &plant.automata[self.automaton as usize];
        let message = format!("`{}` has to remember what nobody can see", constraint.name);
        let error = Diagnostic::error(Code::Unseen, constraint.span, message);
        let error = if a == b {
            error.also(a.span, format!("`{}` changes no state of a component", a.name))
        } else {
            let label = |other: &str| format!("looks the same as `{other}`");
            error.also(a.span, label(&b.name)).also(b.span, label(&a.name))
        };
        error.note(self.ends(plant, closed)).help("give a component states that show the difference")
    }

    /// What is enabled in only one of the entries, and which they are.
    fn ends(&self, plant: &Plant, closed: &ClosedLoop) -> String {
        let [a, b] = self.entries;
        let enabled = |entry: usize, event: EventId| closed.enabled(plant, entry).any(|other| other == event);
        let event = (0..plant.events.len() as EventId).find(|&event| enabled(a, event) != enabled(b, event));
        let name = event.map_or("", |event| &plant.events[event as usize].name);
        let states = |entry: usize| plant.state_names(closed.entry(entry)).join(", ");
        format!("`{name}` is enabled in only one of ({}) and ({})", states(a), states(b))
    }
}

/// The bits that a feedback needs; none if it depends on the components' states alone.
///
/// # Errors
///
/// No memory does: two entries in which something different is enabled look the same to whoever sees the states of all
/// components after each event, and knows which controllable events were caused.
pub fn remember(plant: &Plant, closed: &ClosedLoop) -> Result<Vec<Remembered>, Indistinguishable> {
    let enabled = needed::enabled(plant, closed);
    let mut open = needed::needed(plant, closed, &enabled);
    let mut memory = Memory { plant, closed, enabled, done: Vec::new() };
    for automaton in open.clone() {
        let others: Vec<AutomatonId> = open.iter().copied().filter(|&other| other != automaton).collect();
        if memory.of_group(&[automaton], &others) {
            open = others;
        }
    }
    if !open.is_empty() && !memory.of_group(&open, &[]) {
        memory.of_all()?;
    }
    memory.done.retain(|remembered| remembered.bits > 0);
    memory.done.sort_by(|a, b| a.automata.cmp(&b.automata));
    Ok(memory.done)
}

struct Memory<'a> {
    plant: &'a Plant,
    closed: &'a ClosedLoop,
    /// Per entry which controllable events are enabled, as a number.
    enabled: Vec<u32>,
    done: Vec<Remembered>,
}

impl Memory<'_> {
    /// Bits for some automata, while the states of others are known; `false` if that does not do.
    ///
    /// Tried first with the components that share events with the automata, then with those that share events with these.
    fn of_group(&mut self, automata: &[AutomatonId], others: &[AutomatonId]) -> bool {
        let context = self.contexts(others);
        let mut around = self.around(automata);
        loop {
            let local = Local::new(self.plant, self.closed, automata, around.clone());
            let machine = machine::observe(self.plant, &local);
            if let Some(meanings) = refine::meanings(&machine, &context, &self.enabled) {
                self.finish(automata, &local, &machine, &meanings, &context);
                return true;
            }
            let wider = self.around(&around);
            if wider == around {
                return false;
            }
            around = wider;
        }
    }

    /// Bits for all automata together: if these do not do, nothing does.
    fn of_all(&mut self) -> Result<(), Indistinguishable> {
        let components: Vec<AutomatonId> = (0..self.plant.components as AutomatonId).collect();
        let automata: Vec<AutomatonId> =
            (self.plant.components as AutomatonId..self.closed.automata as AutomatonId).collect();
        self.done.clear();
        let context = self.contexts(&[]);
        let local = Local::new(self.plant, self.closed, &automata, components);
        if let Some(confusion) = machine::confused(self.plant, &local, &self.enabled) {
            let differs = |[a, b]: [usize; 2], automaton: AutomatonId| {
                self.closed.entry(a)[automaton as usize] != self.closed.entry(b)[automaton as usize]
            };
            let both = |it: &&AutomatonId| differs(confusion.start, **it) && differs(confusion.entries, **it);
            let one = |it: &&AutomatonId| differs(confusion.start, **it);
            let automaton = automata.iter().find(both).or_else(|| automata.iter().find(one));
            return Err(Indistinguishable {
                automaton: automaton.copied().unwrap_or_default(),
                events: confusion.events,
                entries: confusion.entries,
            });
        }
        let machine = machine::observe(self.plant, &local);
        if let Some(meanings) = refine::meanings(&machine, &context, &self.enabled) {
            self.finish(&automata, &local, &machine, &meanings, &context);
        }
        Ok(())
    }

    /// The components that share events with some automata, and those among these.
    fn around(&self, automata: &[AutomatonId]) -> Vec<AutomatonId> {
        let mut touched = vec![false; self.plant.events.len()];
        for &automaton in automata {
            for &event in &self.plant.automata[automaton as usize].alphabet {
                touched[event as usize] = true;
            }
        }
        let shares = |&component: &AutomatonId| {
            automata.contains(&component)
                || self.plant.automata[component as usize].alphabet.iter().any(|&it| touched[it as usize])
        };
        (0..self.plant.components as AutomatonId).filter(shares).collect()
    }

    /// Per entry a number for what is known besides: states of components, bits, and states of some automata.
    fn contexts(&self, automata: &[AutomatonId]) -> Vec<u32> {
        let mut rows: Rows<u32> = Rows::new(self.plant.components + self.done.len() + automata.len());
        let mut row = Vec::with_capacity(rows.width());
        (0..self.closed.len())
            .map(|entry| {
                let states = self.closed.entry(entry);
                row.clear();
                row.extend(states[..self.plant.components].iter().copied().map(u32::from));
                row.extend(self.done.iter().map(|remembered| remembered.codes[entry]));
                row.extend(automata.iter().map(|&automaton| u32::from(states[automaton as usize])));
                rows.intern(&row)
            })
            .collect()
    }

    /// Codes for an observer, and what changes them.
    fn finish(
        &mut self,
        automata: &[AutomatonId],
        local: &Local,
        machine: &Machine,
        meanings: &[u32],
        context: &[u32],
    ) {
        let machine = machine.quotient(&refine::coarsest(machine, meanings));
        let (machine, conclusions, codes) = self.codes(machine, context);
        let initial = machine.of_entry[self.closed.initial as usize];
        let (seen, caused) = changes(local, &conclusions, &codes);
        self.done.push(Remembered {
            automata: automata.to_vec(),
            components: local.components.clone(),
            bits: codes.bits,
            fewest: codes.fewest,
            initial: codes.of[initial as usize],
            codes: machine.of_entry.iter().map(|&state| codes.of[state as usize]).collect(),
            seen,
            caused,
        });
    }
}

/// A machine, what is concluded in it, and codes of its states.
type Coded = (Machine, Conclusions, Codes);

impl Memory<'_> {
    /// Codes for a machine, with its states as classes of the machine that is returned.
    fn codes(&self, machine: Machine, context: &[u32]) -> Coded {
        let initial = |machine: &Machine| machine.of_entry[self.closed.initial as usize];
        if machine.len() > search::STATES {
            let conclusions = conclude::conclusions(&machine);
            let codes = fit::fit(&machine, initial(&machine), &conclusions.all);
            return (machine, conclusions, codes);
        }
        let apart = apart(&machine, context, &self.enabled);
        let merged = machine.quotient(&merge::merge(&machine, &apart));
        let problem = |machine: &Machine, apart: &[(u32, u32)]| {
            let conclusions = conclude::conclusions(machine);
            let problem = Problem::new(machine.len(), initial(machine), &conclusions.all, apart);
            (conclusions, problem)
        };
        let (conclusions, first) = problem(&merged, &self::apart(&merged, context, &self.enabled));
        let codes = first.fewest(u32::MAX).codes;
        let mut codes = codes.unwrap_or_else(|| fit::fit(&merged, initial(&merged), &conclusions.all));
        let (other_conclusions, second) = problem(&machine, &apart);
        let fewer = second.fewest(codes.bits);
        if let Some(codes) = fewer.codes {
            let codes = best(&machine, initial(&machine), &other_conclusions, &second, codes);
            return (machine, other_conclusions, codes);
        }
        codes.fewest = fewer.fewest;
        let codes = best(&merged, initial(&merged), &conclusions, &first, codes);
        (merged, conclusions, codes)
    }
}

/// Of codes with so many bits some that change with few events.
fn best(
    machine: &Machine,
    initial: u32,
    conclusions: &Conclusions,
    problem: &Problem,
    codes: Codes,
) -> Codes {
    let mut best = codes;
    if best.bits == 0 || best.bits > search::BITS {
        return best;
    }
    let mut least = tidy::tidy(machine, initial, &conclusions.all, &mut best);
    for of in problem.variants(best.bits) {
        let mut other = Codes { of, ..best };
        let cost = tidy::tidy(machine, initial, &conclusions.all, &mut other);
        if cost < least {
            (least, best) = (cost, other);
        }
    }
    best
}

/// Pairs of states, in both orders, in which something different is enabled in one context.
fn apart(machine: &Machine, context: &[u32], enabled: &[u32]) -> Vec<(u32, u32)> {
    let mut cases: Vec<(u32, u32, u32)> =
        context.iter().zip(&machine.of_entry).zip(enabled).map(|((&c, &s), &e)| (c, s, e)).collect();
    cases.sort_unstable();
    cases.dedup();
    let mut pairs = BTreeSet::new();
    for group in cases.chunk_by(|a, b| a.0 == b.0) {
        for &(_, a, one) in group {
            let others = group.iter().filter(|(_, _, other)| *other != one);
            pairs.extend(others.map(|&(_, b, _)| (a, b)));
        }
    }
    pairs.into_iter().collect()
}

/// What changes codes: because of what is seen, and with which events.
fn changes(local: &Local, conclusions: &Conclusions, codes: &Codes) -> (Vec<Change>, Vec<(EventId, Change)>) {
    let code = |state: u32| codes.of[state as usize];
    let change = |sight: u32, old: u32, new: u32| Change { states: local.sight(sight).to_vec(), old, new };
    let (mut seen, mut caused) = (BTreeSet::new(), Vec::new());
    for it in &conclusions.all {
        match it.occasion {
            Occasion::Seen(sight) => {
                seen.insert((sight, code(it.source), code(it.target)));
            }
            Occasion::Caused(event, sight) if code(it.source) != code(it.target) => {
                caused.push((event, change(sight, code(it.source), code(it.target))));
            }
            Occasion::Caused(..) => {}
        }
    }
    let mut vague: Vec<(u32, u32, u32)> = conclusions
        .vague
        .iter()
        .filter_map(|it| match it.occasion {
            Occasion::Seen(sight) => Some((sight, code(it.source), code(it.target))),
            Occasion::Caused(..) => None,
        })
        .collect();
    vague.sort_unstable();
    vague.dedup();
    for explained in vague.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)).filter(|group| group.len() == 1) {
        let (sight, old, _) = explained[0];
        if seen.range((sight, old, 0)..=(sight, old, u32::MAX)).next().is_none() {
            seen.insert(explained[0]);
        }
    }
    let changed = seen.into_iter().filter(|(_, old, new)| old != new);
    let mut seen: Vec<Change> = changed.map(|(sight, old, new)| change(sight, old, new)).collect();
    seen.sort_unstable();
    caused.sort_unstable();
    caused.dedup();
    (seen, caused)
}

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
//! several could be fewer now and then, but nobody could read them. Per automaton: `local` projects the closed loop to the
//! automaton and the components around it, `merge` unites what need not be told apart, `seen` says what is concluded from
//! what, `color` gives codes.

mod color;
mod local;
mod merge;
mod needed;
mod seen;

use super::{AutomatonId, ClosedLoop, EventId, Plant};
use crate::diagnostic::{Code, Diagnostic};
use local::Local;

/// What the bits of one constraint automaton are, and when they change.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Remembered {
    /// The constraint automaton.
    pub automaton: AutomatonId,
    /// The components whose states tell of its events, ascending.
    pub components: Vec<AutomatonId>,
    /// How many bits there are.
    pub bits: u32,
    /// Their values at first; bit `i` of a code is the value of bit `i`.
    pub initial: u32,
    /// Per entry of the closed loop their values.
    pub codes: Vec<u32>,
    /// Changes because of what is seen, by states and old code.
    pub seen: Vec<Change>,
    /// Changes with a controllable event, by event, states and old code.
    pub caused: Vec<(EventId, Change)>,
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

/// Why bits cannot do it: two plays that look the same, one event each, need different bits.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Indistinguishable {
    /// The constraint automaton.
    pub automaton: AutomatonId,
    /// The events that lead to the same states of all components around it, but to different ones of the automaton.
    pub events: [EventId; 2],
}

impl Indistinguishable {
    /// What to tell the author of the plant.
    #[must_use]
    pub fn diagnostic(&self, plant: &Plant) -> Diagnostic {
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
        error.help("give a component states that show the difference")
    }
}

/// The bits that a feedback needs; none if it depends on the components' states alone.
///
/// # Errors
///
/// What has to be told apart cannot be seen.
pub fn remember(plant: &Plant, closed: &ClosedLoop) -> Result<Vec<Remembered>, Indistinguishable> {
    let needed = needed::needed(plant, closed);
    needed.iter().map(|&automaton| of_automaton(plant, closed, &needed, automaton)).collect()
}

fn of_automaton(
    plant: &Plant,
    closed: &ClosedLoop,
    needed: &[AutomatonId],
    automaton: AutomatonId,
) -> Result<Remembered, Indistinguishable> {
    let local = Local::new(plant, closed, automaton);
    let apart = local.apart(plant, closed, needed);
    let class = merge::merge(&local, &apart);
    let conclusions =
        seen::conclusions(plant, &local, &class).map_err(|events| Indistinguishable { automaton, events })?;
    let color = color::color(&conclusions.differ(), class[local.of_entry[closed.initial as usize] as usize]);
    let code = |node: u32| color.of[class[node as usize] as usize];
    let change = |sight: u32, old: u32, new: u32| Change { states: local.sight(sight).to_vec(), old, new };
    let mut seen: Vec<Change> = conclusions
        .all()
        .map(|(sight, from, to)| change(sight, color.of[from as usize], color.of[to as usize]))
        .filter(|change| change.old != change.new)
        .collect();
    seen.sort_unstable();
    seen.dedup();
    let controllable = local.edges.iter().filter(|edge| plant.events[edge.event as usize].controllable);
    let mut caused: Vec<(EventId, Change)> = controllable
        .map(|edge| (edge.event, change(local.sight_of(edge.source), code(edge.source), code(edge.target))))
        .filter(|(_, change)| change.old != change.new)
        .collect();
    caused.sort_unstable();
    caused.dedup();
    Ok(Remembered {
        automaton,
        components: local.components.clone(),
        bits: color.bits,
        initial: code(local.of_entry[closed.initial as usize]),
        codes: local.of_entry.iter().map(|&node| code(node)).collect(),
        seen,
        caused,
    })
}

//! Why the feedback inhibits an event.

use super::moves::{Candidates, Moves};
use super::product::{Product, Scope};
use super::refusal::{Source, Unavoidable, forbidding};
use super::supremal::Synthesis;
use super::{ClosedLoop, EventId, Plant};
use crate::explore::Limits;

/// Why an event is inhibited.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Why {
    /// These constraints forbid it: conditions, then automata. There is at least one.
    Forbidden(Vec<Source>),
    /// What could not be avoided once it has happened.
    Unavoidable(Box<Unavoidable>),
}

impl Why {
    /// In a few words, as in "`left` is inhibited: ...".
    #[must_use]
    pub fn text(&self, plant: &Plant) -> String {
        match self {
            Why::Forbidden(sources) => {
                let names: Vec<String> =
                    sources.iter().map(|source| format!("`{}`", source.name(plant))).collect();
                let verb = if names.len() == 1 { "forbids" } else { "forbid" };
                format!("{} {verb} it", names.join(" and "))
            }
            Why::Unavoidable(unavoidable) => unavoidable.text(plant),
        }
    }
}

impl Synthesis<'_> {
    /// Why a controllable event is inhibited in an entry of the closed loop; `None` if it is enabled, or the components do not
    /// allow it.
    ///
    /// What nobody can prevent behind the event is explored anew, which is little; the rest was found by the synthesis.
    ///
    /// # Panics
    /// If there is no such entry.
    #[must_use]
    pub fn why(&self, closed: &ClosedLoop, entry: usize, event: EventId) -> Option<Why> {
        closed.inhibited(entry).binary_search(&event).ok()?;
        let Synthesis { plant, product, fates } = self;
        let states = closed.entry(entry);
        let sources = forbidding(plant, states, event);
        if !sources.is_empty() {
            return Some(Why::Forbidden(sources));
        }
        let target = after(plant, states, event)?;
        // What follows was explored before, so it is within any limits.
        let forced = Product::explore(plant, &target, Scope::Uncontrollable, &Limits::default()).ok()?;
        let unavoidable = if forced.bad.is_empty() {
            let mut row = vec![0; product.packing.words()];
            product.packing.pack(&target, &mut row);
            Unavoidable::find(plant, product, fates, product.rows.find(&row)?)
        } else {
            Unavoidable::to_bad(plant, &forced)?
        };
        Some(Why::Unavoidable(Box::new(unavoidable)))
    }
}

/// The automata's states after an event that can happen.
fn after(plant: &Plant, states: &[u16], event: EventId) -> Option<Vec<u16>> {
    let mut candidates = Candidates::default();
    Moves::constrained(plant).collect(states, &mut candidates);
    let (_, changes) = candidates.iter().find(|(candidate, _)| candidate.event == event)?;
    let mut target = states.to_vec();
    for &(automaton, state) in changes {
        target[automaton as usize] = state;
    }
    Some(target)
}

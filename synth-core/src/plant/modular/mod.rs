//! Supervisors of single constraints, for plants whose product is too large.
//!
//! A constraint is often about a few components. A *module* is supervised with these alone: those that name an event or are
//! in a condition of the constraint, and whatever shares events with them, not only directly, so that what is left out moves
//! independently. An event is inhibited if some module inhibits it. That is the supremal feedback of the whole plant,
//! provided that the modules do not conflict: each keeps a way to its marked states, but all together might not (de Queiroz
//! and Cury, "Modular supervisory control of large scale discrete event systems", WODES 2000).
//!
//! Where nothing but marked states exists there is nothing to conflict about, nor between modules that share no component.
//! Otherwise the product under the modules is explored to find out ([`conflicts`]); if that is too large, it is not known.
//!
//! The program of modules ([`program`]) has a rung per event like any other: its condition is the conjunction of those that
//! the modules give it.

mod conflicts;
mod part;
mod program;
mod scope;
mod too_large;

pub use part::Part;
pub(super) use program::program;
pub(super) use too_large::too_large;

use super::{ClosedLoop, EventId, Plant, SuperviseError, Unavoidable, supervise};
use crate::diagnostic::{Code, Diagnostic};
use crate::explore::{LimitReached, Limits};
use crate::syntax::Span;

/// The supervisor of a constraint, of several that speak of the same automata, or of components that no constraint is about.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Module {
    /// The constraints that are conditions, as positions among [`Plant::constraints`].
    pub constraints: Vec<u32>,
    /// The automata that take part, their events and signals.
    pub part: Part,
    /// Of the part.
    pub closed: ClosedLoop,
}

impl Module {
    /// Whether an event of the plant is one of the module's.
    #[must_use]
    pub fn knows(&self, event: EventId) -> bool {
        scope::place(&self.part.events, event).is_some()
    }

    /// The names of its constraints, conditions and then automata.
    #[must_use]
    pub fn constraints(&self) -> Vec<&str> {
        let Plant { constraints, automata, components, .. } = &self.part.plant;
        let conditions = constraints.iter().map(|constraint| constraint.name.as_str());
        conditions.chain(automata[*components..].iter().map(|automaton| automaton.name.as_str())).collect()
    }

    /// Whether it inhibits an event that it knows when its automata are in these states; wherever it never lets them come, it
    /// inhibits everything.
    fn inhibits_in(&self, own: &[u16], event: EventId) -> bool {
        let Some(event) = scope::place(&self.part.events, event) else { return false };
        let (mut low, mut high) = (0, self.closed.len());
        while low < high {
            let middle = low.midpoint(high);
            match self.closed.entry(middle).cmp(own) {
                std::cmp::Ordering::Less => low = middle + 1,
                std::cmp::Ordering::Equal => {
                    return self.closed.inhibited(middle).binary_search(&event).is_ok();
                }
                std::cmp::Ordering::Greater => high = middle,
            }
        }
        true
    }
}

/// Modules that are not known to conflict.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Modular {
    /// In order of their first automaton.
    pub modules: Vec<Module>,
    /// Why it is not known whether they conflict; `None` if they do not.
    pub unknown: Option<LimitReached>,
}

impl Modular {
    /// Whether some module inhibits an event when all automata of the plant are in these states.
    #[must_use]
    pub fn inhibits(&self, states: &[u16], event: EventId) -> bool {
        self.modules.iter().filter(|module| module.knows(event)).any(|module| {
            let own: Vec<u16> = module.part.automata.iter().map(|&id| states[id as usize]).collect();
            module.inhibits_in(&own, event)
        })
    }

    /// What there is to warn of, of modules and of all together.
    #[must_use]
    pub fn warnings(&self) -> Vec<Diagnostic> {
        let unknown = self.unknown.iter().map(|limit| {
            let message = "whether the modules conflict is not known: their product is too large";
            Diagnostic::warning(Code::ConflictUnknown, Span::default(), message)
                .note(limit.to_string())
                .note(
                    "no constraint is violated, but a state could be reached from which no marked one can be",
                )
                .help("raise `--max-states`, or mark all states where nobody has to come back")
        });
        let mut all: Vec<Diagnostic> = Vec::new();
        for warning in
            self.modules.iter().flat_map(|module| super::warnings(&module.part.plant, &module.closed))
        {
            let known = |one: &Diagnostic| {
                (one.code, one.span, &one.message) == (warning.code, warning.span, &warning.message)
            };
            if !all.iter().any(known) {
                all.push(warning);
            }
        }
        all.sort_by_key(|warning| warning.span.start);
        all.extend(unknown);
        all
    }
}

/// Why there are no modules.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ModularError {
    /// Of the constraints of a module alone, with the part of the plant that they are about. What is refused here has no
    /// feedback in the whole plant either.
    Module(Box<Plant>, SuperviseError),
    /// With all modules, the automata can come into these states, from which no marked ones can be reached. There may
    /// be a feedback of the whole plant all the same.
    Conflict(Vec<u16>),
}

/// What to tell of modules that conflict, in these states of all automata.
#[must_use]
pub(super) fn conflict(plant: &Plant, states: Vec<u16>) -> (Diagnostic, Unavoidable) {
    let text = plant.state_names(&states).join(", ");
    let diagnostic = Diagnostic::error(Code::Conflict, Span::default(), "the modules conflict")
        .note(format!(
            "with all of them the automata can come here, from where no marked states can be reached: {text}"
        ))
        .help("supervise the plant as a whole, or write constraints that block each other as one automaton");
    let reason = super::Reason::Blocked { unmarked: Vec::new(), forbidden: Vec::new() };
    (diagnostic, Unavoidable { play: Vec::new(), forced: 0, states, reason })
}

/// Supervises every constraint with the components that it is about, and looks for conflicts.
///
/// # Errors
/// A module has no feedback or reaches a limit, or modules conflict.
pub fn modular(plant: &Plant, limits: &Limits) -> Result<Modular, ModularError> {
    let scopes = scope::scopes(plant);
    let mut modules = Vec::with_capacity(scopes.len());
    for scope in &scopes {
        let part = Part::new(plant, scope);
        let closed = supervise(&part.plant, limits)
            .map_err(|error| ModularError::Module(Box::new(part.plant.clone()), error))?;
        modules.push(Module { constraints: scope.constraints.iter().copied().collect(), part, closed });
    }
    let unknown = conflicts::check(plant, &scopes, &modules, limits)?;
    Ok(Modular { modules, unknown })
}

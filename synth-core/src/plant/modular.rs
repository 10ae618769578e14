//! Supervisors of single constraints, for plants whose product is too large.
//!
//! A constraint is often about a few components. A *module* is supervised with these alone: those that name an event or are
//! in a condition of the constraint, and whatever shares events with them, not only directly, so that what is left out moves
//! independently. An event is inhibited if some module inhibits it. That is the supremal feedback of the whole plant,
//! provided that the modules do not conflict: each keeps a way to its marked states, but all together might not (de Queiroz
//! and Cury, "Modular supervisory control of large scale discrete event systems", WODES 2000).
//!
//! Where nothing but marked states exists there is nothing to conflict about. Otherwise the product under all modules is
//! explored to find out; if that is too large, no answer is given.

use super::moves::{Candidates, Moves, marks};
use super::packing::Packing;
use super::product::initial;
use super::{
    AutomatonId, ClosedLoop, Condition, Constraint, EventId, Plant, Rule, StateRef, SuperviseError, supervise,
};
use crate::explore::{LimitReached, Limits};
use crate::intern::Rows;
use std::collections::BTreeSet;

/// The supervisor of a constraint, or of several that speak of the same constraint automata.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Module {
    /// The constraints that are conditions, as positions among [`Plant::constraints`].
    pub constraints: Vec<u32>,
    /// The automata that take part, ascending: components, then constraint automata.
    pub automata: Vec<AutomatonId>,
    /// Its entries have states of [`Self::automata`].
    pub closed: ClosedLoop,
}

impl Module {
    /// What it inhibits when all automata of the plant are in these states; `None` where it never lets the plant come.
    #[must_use]
    pub fn inhibited(&self, states: &[u16]) -> Option<&[EventId]> {
        let own: Vec<u16> = self.automata.iter().map(|&automaton| states[automaton as usize]).collect();
        let (mut low, mut high) = (0, self.closed.len());
        while low < high {
            let middle = low.midpoint(high);
            match self.closed.entry(middle).cmp(&own) {
                std::cmp::Ordering::Less => low = middle + 1,
                std::cmp::Ordering::Equal => return Some(self.closed.inhibited(middle)),
                std::cmp::Ordering::Greater => high = middle,
            }
        }
        None
    }
}

/// Modules that do not conflict.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Modular {
    /// In order of their first automaton.
    pub modules: Vec<Module>,
}

impl Modular {
    /// Whether some module inhibits an event when all automata of the plant are in these states.
    #[must_use]
    pub fn inhibits(&self, states: &[u16], event: EventId) -> bool {
        self.modules.iter().any(|module| {
            module.inhibited(states).is_none_or(|inhibited| inhibited.binary_search(&event).is_ok())
        })
    }
}

/// Why there are no modules.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ModularError {
    /// Of the constraints of a module alone, with the part of the plant that they are about, which has all events of the
    /// plant but only some of its automata. What is refused here has no feedback in the whole plant either.
    Module(Box<Plant>, SuperviseError),
    /// With all modules, the automata can come into these states, from which no marked ones can be reached. There may
    /// be a feedback of the whole plant all the same.
    Conflict(Vec<u16>),
    /// Whether there is a conflict is not known: the product under all modules is too large.
    Unknown(LimitReached),
}

/// Supervises every constraint with the components that it is about.
///
/// # Errors
/// A module has no feedback, modules conflict, or a limit was reached before this was known.
pub fn modular(plant: &Plant, limits: &Limits) -> Result<Modular, ModularError> {
    let mut modules = Vec::new();
    for scope in scopes(plant) {
        let part = part(plant, &scope);
        let closed =
            supervise(&part, limits).map_err(|error| ModularError::Module(Box::new(part.clone()), error))?;
        modules.push(Module {
            constraints: scope.constraints.into_iter().collect(),
            automata: scope.automata.into_iter().collect(),
            closed,
        });
    }
    let modular = Modular { modules };
    check_conflicts(plant, &modular, limits)?;
    Ok(modular)
}

/// What a module is about.
struct Scope {
    constraints: BTreeSet<u32>,
    automata: BTreeSet<AutomatonId>,
}

/// The scopes of all constraints; those with a constraint automaton in common are one.
fn scopes(plant: &Plant) -> Vec<Scope> {
    let components = plant.components as AutomatonId;
    let conditions = (0..).zip(&plant.constraints).map(|(place, constraint)| {
        let (mut automata, condition, events) = match &constraint.rule {
            Rule::Only { event, when } => (BTreeSet::new(), when, Some(*event)),
            Rule::Never(condition) => (BTreeSet::new(), condition, None),
        };
        condition.atoms(&mut |atom: &StateRef| {
            automata.insert(atom.automaton);
        });
        automata.extend(events.into_iter().flat_map(|event| naming(plant, event)));
        Scope { constraints: BTreeSet::from([place]), automata }
    });
    let automata = (components..plant.automata.len() as AutomatonId)
        .map(|id| Scope { constraints: BTreeSet::new(), automata: BTreeSet::from([id]) });
    let mut scopes: Vec<Scope> = Vec::new();
    for mut scope in conditions.chain(automata) {
        let shares = |other: &Scope| other.automata.range(components..).any(|id| scope.automata.contains(id));
        let (same, others) = scopes.into_iter().partition(shares);
        scopes = others;
        let same: Vec<Scope> = same;
        for other in same {
            scope.constraints.extend(other.constraints);
            scope.automata.extend(other.automata);
        }
        scopes.push(scope);
    }
    for scope in &mut scopes {
        close(plant, &mut scope.automata);
    }
    scopes.sort_by_key(|scope| (scope.automata.first().copied(), scope.constraints.first().copied()));
    scopes
}

/// The components that name an event.
fn naming(plant: &Plant, event: EventId) -> impl Iterator<Item = AutomatonId> {
    (0..)
        .zip(&plant.automata[..plant.components])
        .filter(move |(_, automaton)| automaton.alphabet.binary_search(&event).is_ok())
        .map(|(id, _)| id)
}

/// Adds the components that share events with automata, and those that share events with these, and so on.
fn close(plant: &Plant, automata: &mut BTreeSet<AutomatonId>) {
    let mut work: Vec<AutomatonId> = automata.iter().copied().collect();
    while let Some(id) = work.pop() {
        for &event in &plant.automata[id as usize].alphabet {
            work.extend(naming(plant, event).filter(|&id| automata.insert(id)));
        }
    }
}

/// The plant with some automata and constraints only, and all events.
fn part(plant: &Plant, scope: &Scope) -> Plant {
    let place = |id: AutomatonId| scope.automata.iter().position(|&other| other == id);
    let there = |condition: &Condition<StateRef>| {
        condition.resolved(&mut |atom: &StateRef| {
            Some(StateRef { automaton: place(atom.automaton)? as AutomatonId, state: atom.state })
        })
    };
    let constraint = |&id: &u32| {
        let constraint = &plant.constraints[id as usize];
        let rule = match &constraint.rule {
            Rule::Only { event, when } => Rule::Only { event: *event, when: there(when)? },
            Rule::Never(condition) => Rule::Never(there(condition)?),
        };
        Some(Constraint { rule, ..constraint.clone() })
    };
    Plant {
        name: plant.name.clone(),
        doc: Vec::new(),
        signals: plant.signals.clone(),
        analogues: plant.analogues.clone(),
        events: plant.events.clone(),
        automata: scope.automata.iter().map(|&id| plant.automata[id as usize].clone()).collect(),
        components: scope.automata.range(..plant.components as AutomatonId).count(),
        constraints: scope.constraints.iter().filter_map(constraint).collect(),
    }
}

/// Explores the product under all modules, unless every state is marked.
fn check_conflicts(plant: &Plant, modular: &Modular, limits: &Limits) -> Result<(), ModularError> {
    if (0..plant.automata.len() as AutomatonId).all(|id| marks(plant, id).is_none()) {
        return Ok(());
    }
    let moves = Moves::constrained(plant);
    let packing = Packing::new(plant.automata.iter().map(|automaton| automaton.states.len()));
    let mut rows = Rows::new(packing.words());
    let mut row = vec![0; packing.words()];
    let mut states = initial(plant);
    packing.pack(&states, &mut row);
    rows.intern(&row);
    let mut candidates = Candidates::default();
    let mut edges: Vec<(u32, u32)> = Vec::new();
    let mut reaches = Vec::new();
    let mut source = 0;
    while (source as usize) < rows.len() {
        let memory = rows.memory() + edges.capacity() * size_of::<(u32, u32)>();
        for (what, limit, reached) in [
            ("states", limits.states, rows.len() > limits.states),
            ("memory", limits.memory, memory > limits.memory),
        ] {
            if reached {
                let explored = source as usize;
                let (states, edges) = (rows.len(), edges.len());
                return Err(ModularError::Unknown(LimitReached {
                    what,
                    limit,
                    states,
                    explored,
                    edges,
                    memory,
                }));
            }
        }
        packing.unpack(rows.get(source), &mut states);
        reaches.push(moves.marked(&states));
        moves.collect(&states, &mut candidates);
        for (candidate, changes) in candidates.iter() {
            if candidate.forbidden || modular.inhibits(&states, candidate.event) {
                continue;
            }
            row.copy_from_slice(rows.get(source));
            for &(automaton, next) in changes {
                packing.set(&mut row, automaton, next);
            }
            edges.push((rows.intern(&row), source));
        }
        source += 1;
    }
    edges.sort_unstable();
    let mut work: Vec<u32> = (0..source).filter(|&state| reaches[state as usize]).collect();
    while let Some(target) = work.pop() {
        let first = edges.partition_point(|edge| edge.0 < target);
        for &(_, source) in edges[first..].iter().take_while(|edge| edge.0 == target) {
            if !std::mem::replace(&mut reaches[source as usize], true) {
                work.push(source);
            }
        }
    }
    match (0..source).find(|&state| !reaches[state as usize]) {
        None => Ok(()),
        Some(state) => {
            packing.unpack(rows.get(state), &mut states);
            Err(ModularError::Conflict(states))
        }
    }
}

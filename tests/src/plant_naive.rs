//! Supervisory control straight from its definitions, on explicit sets of tuples; for small plants only.

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use synth_core::plant::{AutomatonId, Condition, EventId, Plant, Rule, StateRef};

/// The states of all automata.
pub type Tuple = Vec<u32>;

/// A transition system with what a definition says of its states.
#[derive(Clone, Debug)]
pub struct Constrained {
    /// All that can be reached, and what can happen there under the constraints; nothing in bad states.
    pub states: BTreeMap<Tuple, BTreeMap<EventId, Tuple>>,
    /// Where something bad holds or cannot be prevented.
    pub bad: BTreeSet<Tuple>,
}

/// Where the automata start.
#[must_use]
pub fn initial(plant: &Plant) -> Tuple {
    plant.automata.iter().map(|automaton| automaton.initial).collect()
}

/// What an automaton does with an event: nothing if it does not name it, `None` if it does not allow it.
fn step(plant: &Plant, automaton: usize, state: u32, event: EventId) -> Option<u32> {
    let automaton = &plant.automata[automaton];
    if !automaton.alphabet.contains(&event) {
        return Some(state);
    }
    let edges = &automaton.states[state as usize].edges;
    edges.iter().find(|edge| edge.event == event).map(|edge| edge.target)
}

/// What the components do with an event that at least one of them names.
fn components(plant: &Plant, tuple: &[u32], event: EventId) -> Option<Tuple> {
    let named = plant.automata[..plant.components].iter().any(|one| one.alphabet.contains(&event));
    if !named {
        return None;
    }
    (0..plant.components).map(|one| step(plant, one, tuple[one], event)).collect()
}

/// What the components allow in a state.
#[must_use]
pub fn possible(plant: &Plant, tuple: &[u32]) -> BTreeSet<EventId> {
    let events = 0..plant.events.len() as EventId;
    events.filter(|&event| components(plant, tuple, event).is_some()).collect()
}

fn holds(condition: &Condition<StateRef>, tuple: &[u32]) -> bool {
    match condition {
        Condition::Atom(atom) => tuple[atom.automaton as usize] == atom.state,
        Condition::Not(inner) => !holds(inner, tuple),
        Condition::And(parts) => parts.iter().all(|part| holds(part, tuple)),
        Condition::Or(parts) => parts.iter().any(|part| holds(part, tuple)),
    }
}

/// Components and constraints together.
fn both(plant: &Plant, tuple: &[u32], event: EventId) -> Option<Tuple> {
    let mut next = components(plant, tuple, event)?;
    for constraint in &plant.constraints {
        if let Rule::Only { event: of, when } = &constraint.rule
            && *of == event
            && !holds(when, tuple)
        {
            return None;
        }
    }
    for (automaton, &state) in tuple.iter().enumerate().skip(plant.components) {
        next.push(step(plant, automaton, state, event)?);
    }
    Some(next)
}

/// States and transitions of the product of the components.
#[must_use]
pub fn plant_size(plant: &Plant) -> (u64, u64) {
    let start = initial(plant)[..plant.components].to_vec();
    let mut states = BTreeSet::from([start.clone()]);
    let mut open = vec![start];
    let mut transitions = 0;
    while let Some(state) = open.pop() {
        for event in 0..plant.events.len() as EventId {
            let Some(next) = components(plant, &state, event) else { continue };
            transitions += 1;
            if states.insert(next.clone()) {
                open.push(next);
            }
        }
    }
    (states.len() as u64, transitions)
}

/// Everything that can be reached under the constraints.
#[must_use]
pub fn constrained(plant: &Plant, start: Tuple) -> Constrained {
    let mut all = Constrained { states: BTreeMap::new(), bad: BTreeSet::new() };
    let mut open = vec![start];
    while let Some(tuple) = open.pop() {
        if all.states.contains_key(&tuple) {
            continue;
        }
        let mut edges = BTreeMap::new();
        if is_bad(plant, &tuple) {
            all.bad.insert(tuple.clone());
        } else {
            let events = 0..plant.events.len() as EventId;
            edges.extend(events.filter_map(|event| Some((event, both(plant, &tuple, event)?))));
        }
        open.extend(edges.values().cloned());
        all.states.insert(tuple, edges);
    }
    all
}

fn is_bad(plant: &Plant, tuple: &[u32]) -> bool {
    let never = |rule: &Rule| matches!(rule, Rule::Never(condition) if holds(condition, tuple));
    plant.constraints.iter().any(|constraint| never(&constraint.rule))
        || possible(plant, tuple)
            .iter()
            .any(|&event| !plant.events[event as usize].controllable && both(plant, tuple, event).is_none())
}

fn is_marked(plant: &Plant, tuple: &[u32]) -> bool {
    plant.automata.iter().zip(tuple).all(|(automaton, &state)| {
        automaton.states[state as usize].marked || automaton.states.iter().all(|state| !state.marked)
    })
}

/// The states of a set from which a marked state of the set can be reached within it.
#[must_use]
pub fn coreachable(plant: &Plant, all: &Constrained, set: &BTreeSet<Tuple>) -> BTreeSet<Tuple> {
    let mut found: BTreeSet<Tuple> = set.iter().filter(|tuple| is_marked(plant, tuple)).cloned().collect();
    loop {
        let more: Vec<Tuple> = set
            .iter()
            .filter(|tuple| !found.contains(*tuple))
            .filter(|tuple| all.states[*tuple].values().any(|next| found.contains(next)))
            .cloned()
            .collect();
        if more.is_empty() {
            return found;
        }
        found.extend(more);
    }
}

/// Whether no uncontrollable event leads from this state out of the set.
fn is_kept(plant: &Plant, all: &Constrained, set: &BTreeSet<Tuple>, tuple: &Tuple) -> bool {
    let mut edges = all.states[tuple].iter();
    edges.all(|(event, next)| plant.events[*event as usize].controllable || set.contains(next))
}

/// Whether a set is one that a feedback can keep the plant in: no bad states, controllable, nonblocking.
#[must_use]
pub fn is_safe(plant: &Plant, all: &Constrained, set: &BTreeSet<Tuple>) -> bool {
    set.is_disjoint(&all.bad)
        && set.iter().all(|tuple| is_kept(plant, all, set, tuple))
        && coreachable(plant, all, set) == *set
}

/// The largest such set: all that breaks the definition is removed until nothing does.
#[must_use]
pub fn supremal(plant: &Plant, all: &Constrained) -> BTreeSet<Tuple> {
    let mut set: BTreeSet<Tuple> =
        all.states.keys().filter(|tuple| !all.bad.contains(*tuple)).cloned().collect();
    loop {
        let coreachable = coreachable(plant, all, &set);
        let left: BTreeSet<Tuple> =
            coreachable.iter().filter(|tuple| is_kept(plant, all, &set, tuple)).cloned().collect();
        if left == set {
            return set;
        }
        set = left;
    }
}

/// What can be reached from a state within a set that contains it.
#[must_use]
pub fn reachable(all: &Constrained, set: &BTreeSet<Tuple>, start: Tuple) -> BTreeSet<Tuple> {
    let mut found = BTreeSet::new();
    let mut open = vec![start];
    while let Some(tuple) = open.pop() {
        if found.insert(tuple.clone()) {
            open.extend(all.states[&tuple].values().filter(|next| set.contains(*next)).cloned());
        }
    }
    found
}

/// How many events lead from a state that is removed to one that is bad or blocked from the beginning, where every event is
/// one that cannot be prevented, or the best that can be done on the way to a marked state.
#[must_use]
pub fn shortest_play(plant: &Plant, all: &Constrained, start: &Tuple) -> Option<usize> {
    let (hopeless, blocked) = (hopeless(plant, all), blocked(plant, all));
    let stays = supremal(plant, all);
    let mut distance = BTreeMap::from([(start.clone(), 0)]);
    let mut queue = VecDeque::from([start.clone()]);
    while let Some(tuple) = queue.pop_front() {
        let here = distance[&tuple];
        if hopeless.contains(&tuple) {
            return Some(here);
        }
        for (event, next) in &all.states[&tuple] {
            let follows = if blocked.contains(&tuple) {
                !hopeless.contains(next)
            } else {
                !plant.events[*event as usize].controllable && !stays.contains(next)
            };
            if follows && !distance.contains_key(next) {
                distance.insert(next.clone(), here + 1);
                queue.push_back(next.clone());
            }
        }
    }
    None
}

/// Bad states, and those from which no marked state can be reached.
#[must_use]
pub fn hopeless(plant: &Plant, all: &Constrained) -> BTreeSet<Tuple> {
    let good = all.states.keys().filter(|tuple| !all.bad.contains(*tuple)).cloned().collect();
    let coreachable = coreachable(plant, all, &good);
    all.states.keys().filter(|tuple| !coreachable.contains(*tuple)).cloned().collect()
}

/// States that could reach a marked state, but only through others that cannot be kept: in rounds of first what is blocked,
/// then what cannot be prevented from going there.
fn blocked(plant: &Plant, all: &Constrained) -> BTreeSet<Tuple> {
    let hopeless = hopeless(plant, all);
    let mut set: BTreeSet<Tuple> =
        all.states.keys().filter(|tuple| !hopeless.contains(*tuple)).cloned().collect();
    let mut blocked = BTreeSet::new();
    loop {
        loop {
            let kept: BTreeSet<Tuple> =
                set.iter().filter(|tuple| is_kept(plant, all, &set, tuple)).cloned().collect();
            if kept == set {
                break;
            }
            set = kept;
        }
        let coreachable = coreachable(plant, all, &set);
        if coreachable == set {
            return blocked;
        }
        blocked.extend(set.difference(&coreachable).cloned());
        set = coreachable;
    }
}

/// Plays events; `None` if one of them cannot happen under the constraints.
#[must_use]
pub fn play(all: &Constrained, start: &Tuple, events: &[EventId]) -> Option<Tuple> {
    events.iter().try_fold(start.clone(), |tuple, event| all.states[&tuple].get(event).cloned())
}

/// The automata of which no marked state can be reached from a state.
#[must_use]
pub fn never_marked(plant: &Plant, all: &Constrained, start: &Tuple) -> Vec<AutomatonId> {
    let everything = all.states.keys().cloned().collect();
    let reached = reachable(all, &everything, start.clone());
    let marked = |automaton: usize| {
        let states = &plant.automata[automaton].states;
        reached.iter().any(|tuple| states[tuple[automaton] as usize].marked)
            || states.iter().all(|state| !state.marked)
    };
    (0..plant.automata.len()).filter(|&automaton| !marked(automaton)).map(|id| id as AutomatonId).collect()
}

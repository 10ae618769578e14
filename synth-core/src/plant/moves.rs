//! What can happen where: the events that the components allow, and what forbids them.

use super::{AutomatonId, Condition, EventId, Plant, Rule, StateRef};

/// No next state.
const NONE: u32 = u32::MAX;

/// An event that the components allow.
#[derive(Clone, Copy, Debug)]
pub(super) struct Candidate {
    pub(super) event: EventId,
    /// Whether a constraint forbids it.
    pub(super) forbidden: bool,
    /// Where what it changes ends among [`Candidates::changes`]; it begins where the one before ends.
    end: u32,
}

/// What the components allow in some state; a buffer that is filled again and again.
#[derive(Clone, Debug, Default)]
pub(super) struct Candidates {
    pub(super) all: Vec<Candidate>,
    /// Automata by their positions, and their next states.
    changes: Vec<(u32, u16)>,
}

impl Candidates {
    /// The candidates with what they change; of a forbidden one this means nothing.
    pub(super) fn iter(&self) -> impl Iterator<Item = (Candidate, &[(u32, u16)])> {
        let mut start = 0;
        self.all.iter().map(move |&candidate| {
            let changes = &self.changes[start..candidate.end as usize];
            start = candidate.end as usize;
            (candidate, changes)
        })
    }
}

/// An edge of the first component that names an event; the event may need others to take part.
#[derive(Clone, Copy, Debug)]
struct Lead {
    event: EventId,
    target: u16,
}

/// An automaton beside the first component that names an event.
#[derive(Clone, Copy, Debug)]
struct Partner {
    automaton: u32,
    /// Where its next states by this event lie in [`Moves::next`].
    next: u32,
}

/// Who has a say in an event, beside the first component that names it.
#[derive(Clone, Debug, Default)]
struct Say<'p> {
    /// Components: where one of them has no edge, the event is not possible.
    components: Vec<Partner>,
    /// Constraint automata: where one of them has no edge, it is forbidden.
    constraints: Vec<Partner>,
    /// Where one of these does not hold, it is forbidden, too.
    conditions: Vec<&'p Condition<StateRef>>,
}

/// The edges of some automata of a plant, by state. An event that no component names never happens.
#[derive(Clone, Debug)]
pub(super) struct Moves<'p> {
    /// The automata; others refer to them by their positions here.
    pub(super) automata: Vec<AutomatonId>,
    /// The leads of state `s` of component `c` are at `first[base[c] + s]..first[base[c] + s + 1]`.
    base: Vec<u32>,
    first: Vec<u32>,
    leads: Vec<Lead>,
    next: Vec<u32>,
    says: Vec<Say<'p>>,
    nevers: Vec<&'p Condition<StateRef>>,
    marked: Vec<Option<Vec<bool>>>,
}

impl<'p> Moves<'p> {
    /// All automata and constraints of a plant.
    pub(super) fn constrained(plant: &'p Plant) -> Self {
        let mut moves = Moves::new(plant, (0..plant.automata.len() as AutomatonId).collect());
        for constraint in &plant.constraints {
            match &constraint.rule {
                Rule::Only { event, when } => moves.says[*event as usize].conditions.push(when),
                Rule::Never(condition) => moves.nevers.push(condition),
            }
        }
        moves
    }

    /// Some automata, components first, without conditions.
    pub(super) fn new(plant: &'p Plant, automata: Vec<AutomatonId>) -> Self {
        let mut says = vec![Say::default(); plant.events.len()];
        let mut leader = vec![NONE; plant.events.len()];
        let mut next = Vec::new();
        for (position, &id) in (0..).zip(&automata) {
            let automaton = &plant.automata[id as usize];
            let component = (id as usize) < plant.components;
            for &event in &automaton.alphabet {
                if component && leader[event as usize] == NONE {
                    leader[event as usize] = position;
                    continue;
                }
                let partner = Partner { automaton: position, next: next.len() as u32 };
                next.extend(automaton.states.iter().map(|state| {
                    let edge = state.edges.iter().find(|edge| edge.event == event);
                    edge.map_or(NONE, |edge| edge.target)
                }));
                let say: &mut Say<'_> = &mut says[event as usize];
                if component { &mut say.components } else { &mut say.constraints }.push(partner);
            }
        }
        let (mut base, mut first, mut leads) = (Vec::new(), vec![0], Vec::new());
        for (position, &id) in (0..).zip(&automata) {
            if (id as usize) >= plant.components {
                break;
            }
            base.push(first.len() as u32 - 1);
            for state in &plant.automata[id as usize].states {
                let led = state.edges.iter().filter(|edge| leader[edge.event as usize] == position);
                leads.extend(led.map(|edge| Lead { event: edge.event, target: edge.target as u16 }));
                first.push(leads.len() as u32);
            }
        }
        let marked = automata.iter().map(|&id| marks(plant, id)).collect();
        Moves { automata, base, first, leads, next, says, nevers: Vec::new(), marked }
    }

    /// Collects what the components allow in a state, not ordered.
    pub(super) fn collect(&self, states: &[u16], candidates: &mut Candidates) {
        let Candidates { all, changes } = candidates;
        all.clear();
        changes.clear();
        for (position, &base) in (0..).zip(&self.base) {
            let at = base as usize + states[position as usize] as usize;
            for lead in &self.leads[self.first[at] as usize..self.first[at + 1] as usize] {
                let start = changes.len();
                changes.push((position, lead.target));
                let say = &self.says[lead.event as usize];
                if !say.components.iter().all(|partner| self.joins(partner, states, changes)) {
                    changes.truncate(start);
                    continue;
                }
                let forbidden = !(say.conditions.iter().all(|condition| holds(condition, states))
                    && say.constraints.iter().all(|partner| self.joins(partner, states, changes)));
                all.push(Candidate { event: lead.event, forbidden, end: changes.len() as u32 });
            }
        }
    }

    /// Whether a partner can take part; then its change is noted.
    fn joins(&self, partner: &Partner, states: &[u16], changes: &mut Vec<(u32, u16)>) -> bool {
        let next = self.next[partner.next as usize + states[partner.automaton as usize] as usize];
        if next != NONE {
            changes.push((partner.automaton, next as u16));
        }
        next != NONE
    }

    /// Whether some `never` holds.
    pub(super) fn violates(&self, states: &[u16]) -> bool {
        self.nevers.iter().any(|condition| holds(condition, states))
    }

    /// Whether every state is marked.
    pub(super) fn all_marked(&self) -> bool {
        self.marked.iter().all(Option::is_none)
    }

    /// Whether all automata are in marked states.
    pub(super) fn marked(&self, states: &[u16]) -> bool {
        let mut each = self.marked.iter().zip(states);
        each.all(|(marks, &state)| marks.as_ref().is_none_or(|marks| marks[state as usize]))
    }
}

/// Which states of an automaton are marked; `None` if all are.
pub(super) fn marks(plant: &Plant, automaton: AutomatonId) -> Option<Vec<bool>> {
    let marks: Vec<bool> =
        plant.automata[automaton as usize].states.iter().map(|state| state.marked).collect();
    (marks.contains(&true) && marks.contains(&false)).then_some(marks)
}

/// Whether a condition holds in a state of all automata.
pub(super) fn holds(condition: &Condition<StateRef>, states: &[u16]) -> bool {
    condition.eval(&|atom: &StateRef| u32::from(states[atom.automaton as usize]) == atom.state)
}

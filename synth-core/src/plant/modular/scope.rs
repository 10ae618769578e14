//! What a module is about, and which modules have to do with each other.

use super::super::product::groups;
use super::super::{AutomatonId, EventId, Plant, Rule, StateRef};
use std::collections::BTreeSet;

/// Constraints that are supervised together, and the automata that take part.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(super) struct Scope {
    /// Conditions, ascending.
    pub(super) constraints: BTreeSet<u32>,
    /// Components, then constraint automata.
    pub(super) automata: BTreeSet<AutomatonId>,
}

/// The groups of components that share events, and who names what.
struct Groups {
    members: Vec<Vec<AutomatonId>>,
    /// Per component.
    of: Vec<usize>,
    /// Per event the group whose components name it.
    naming: Vec<Option<usize>>,
}

impl Groups {
    fn new(plant: &Plant) -> Self {
        let members = groups(plant);
        let mut of = vec![0; plant.components];
        let mut naming = vec![None; plant.events.len()];
        for (group, members) in members.iter().enumerate() {
            for &component in members {
                of[component as usize] = group;
                for &event in &plant.automata[component as usize].alphabet {
                    naming[event as usize] = Some(group);
                }
            }
        }
        Groups { members, of, naming }
    }
}

/// A scope for every constraint: constraints that speak of the same constraint automaton are one, and so are conditions about
/// the same components. Components that no constraint is about have a scope for each group of those that share events.
/// Scopes are in the order of their first automaton.
pub(super) fn scopes(plant: &Plant) -> Vec<Scope> {
    let groups = Groups::new(plant);
    // Per scope the groups that it is about.
    let mut all: Vec<(BTreeSet<usize>, Scope)> = Vec::new();
    for id in plant.components as AutomatonId..plant.automata.len() as AutomatonId {
        let alphabet = &plant.automata[id as usize].alphabet;
        let about = alphabet.iter().filter_map(|&event| groups.naming[event as usize]).collect();
        all.push((about, Scope { automata: BTreeSet::from([id]), ..Scope::default() }));
    }
    for (place, constraint) in (0..).zip(&plant.constraints) {
        let (condition, event): (_, Option<EventId>) = match &constraint.rule {
            Rule::Only { event, when } => (when, Some(*event)),
            Rule::Never(condition) => (condition, None),
        };
        let mut about: BTreeSet<usize> =
            event.and_then(|event| groups.naming[event as usize]).into_iter().collect();
        let mut automata = BTreeSet::new();
        condition.atoms(&mut |atom: &StateRef| match groups.of.get(atom.automaton as usize) {
            Some(&group) => {
                about.insert(group);
            }
            None => {
                automata.insert(atom.automaton);
            }
        });
        all.push((about, Scope { constraints: BTreeSet::from([place]), automata }));
    }
    let mut scopes = united(all);
    let mut free: BTreeSet<usize> = (0..groups.members.len()).collect();
    for (about, _) in &scopes {
        about.iter().for_each(|group| {
            free.remove(group);
        });
    }
    scopes.extend(free.into_iter().map(|group| (BTreeSet::from([group]), Scope::default())));
    let mut scopes: Vec<Scope> = scopes
        .into_iter()
        .map(|(about, mut scope)| {
            scope.automata.extend(about.iter().flat_map(|&group| &groups.members[group]));
            scope
        })
        .collect();
    scopes.sort_by_key(|scope| (scope.automata.first().copied(), scope.constraints.first().copied()));
    scopes
}

/// Unites scopes with a constraint automaton in common, then those without any that are about the same groups.
fn united(all: Vec<(BTreeSet<usize>, Scope)>) -> Vec<(BTreeSet<usize>, Scope)> {
    let keys = |(_, scope): &(BTreeSet<usize>, Scope)| scope.automata.iter().copied().collect::<Vec<_>>();
    let with_automata = unite(all, keys);
    let mut plain: std::collections::BTreeMap<BTreeSet<usize>, Scope> = std::collections::BTreeMap::new();
    let mut united = Vec::new();
    for (about, scope) in with_automata {
        if scope.automata.is_empty() {
            plain.entry(about).or_default().constraints.extend(scope.constraints);
        } else {
            united.push((about, scope));
        }
    }
    united.extend(plain);
    united
}

/// Unites what has a key in common, directly or through others. The order of the first of each is kept.
fn unite(
    all: Vec<(BTreeSet<usize>, Scope)>,
    keys: impl Fn(&(BTreeSet<usize>, Scope)) -> Vec<AutomatonId>,
) -> Vec<(BTreeSet<usize>, Scope)> {
    let keys: Vec<Vec<AutomatonId>> = all.iter().map(keys).collect();
    let leaders = leaders(&keys);
    let mut united: Vec<Option<(BTreeSet<usize>, Scope)>> = vec![None; all.len()];
    for ((about, scope), leader) in all.into_iter().zip(leaders) {
        let (all_groups, all_scope) = united[leader].get_or_insert_with(Default::default);
        all_groups.extend(about);
        all_scope.constraints.extend(scope.constraints);
        all_scope.automata.extend(scope.automata);
    }
    united.into_iter().flatten().collect()
}

/// Per list the first one that has a number in common with it, directly or through others.
fn leaders(lists: &[Vec<AutomatonId>]) -> Vec<usize> {
    fn root(leader: &mut [usize], mut at: usize) -> usize {
        while leader[at] != at {
            leader[at] = leader[leader[at]];
            at = leader[at];
        }
        at
    }
    let numbers = lists.iter().flatten().max().map_or(0, |&most| most as usize + 1);
    let mut first = vec![usize::MAX; numbers];
    let mut leader: Vec<usize> = (0..lists.len()).collect();
    for (place, list) in lists.iter().enumerate() {
        for &number in list {
            let other = &mut first[number as usize];
            if *other == usize::MAX {
                *other = place;
                continue;
            }
            let (a, b) = (root(&mut leader, *other), root(&mut leader, place));
            leader[a.max(b)] = a.min(b);
        }
    }
    (0..lists.len()).map(|place| root(&mut leader, place)).collect()
}

/// Scopes that have to do with each other, through automata in common: what is in different clusters moves independently.
pub(super) fn clusters(scopes: &[Scope]) -> Vec<Vec<usize>> {
    let automata: Vec<Vec<AutomatonId>> =
        scopes.iter().map(|scope| scope.automata.iter().copied().collect()).collect();
    let mut clusters: Vec<Vec<usize>> = vec![Vec::new(); scopes.len()];
    for (scope, leader) in leaders(&automata).into_iter().enumerate() {
        clusters[leader].push(scope);
    }
    clusters.retain(|cluster| !cluster.is_empty());
    clusters
}

/// All of several scopes.
pub(super) fn union<'s>(scopes: impl IntoIterator<Item = &'s Scope>) -> Scope {
    let mut all = Scope::default();
    for scope in scopes {
        all.constraints.extend(&scope.constraints);
        all.automata.extend(&scope.automata);
    }
    all
}

/// Who numbers the parts: `of[i]` is what the whole plant calls number `i` of a part, ascending.
pub(super) fn place(of: &[u32], number: u32) -> Option<u32> {
    of.binary_search(&number).ok().map(|place| place as u32)
}

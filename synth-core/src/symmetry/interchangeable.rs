//! Interchangeable objects: any two of them can change places, and the specification says the same.
//!
//! Two objects are interchangeable if the permutation that swaps them maps the specification onto itself. That is an
//! equivalence relation, since of three objects two swaps make the third. So a specification's classes of
//! interchangeable objects give a group of permutations, all those that leave each object in its class, and every one
//! of these maps states onto states, moves onto moves and keys onto keys.

use super::form::Form;
use crate::model::{Effect, Endpoint, Kind, ObjectId, OperationId, Permutation, Scenario, Spec, Type};
use std::collections::BTreeMap;

/// The interchangeable objects of a specification.
#[derive(Debug)]
pub(super) struct Interchangeable {
    /// Sets of at least two, ascending.
    pub(super) groups: Vec<Vec<ObjectId>>,
    /// Per object: which group it is in.
    pub(super) group_of: Vec<Option<usize>>,
    /// Per scenario: the first one that it can become.
    pub(super) orbits: Vec<usize>,
    /// Per scenario: the interchangeable objects that it names, and how often.
    pub(super) names: Vec<Vec<(ObjectId, u32)>>,
    /// Per two objects of a group, the lesser first: the scenarios that become others when they are swapped.
    renamed: BTreeMap<(ObjectId, ObjectId), Vec<(usize, usize)>>,
}

impl Interchangeable {
    /// Compares a specification with itself under every swap of two objects of one class.
    pub(super) fn of(spec: &Spec) -> Self {
        let comparison = Comparison::new(spec);
        let mut found: Vec<Vec<ObjectId>> = Vec::new();
        for object in 0..spec.domain.objects.len() {
            match found.iter_mut().find(|group| comparison.swap(group[0], object).is_some()) {
                Some(group) => group.push(object),
                None => found.push(vec![object]),
            }
        }
        found.retain(|group| group.len() > 1);
        let mut group_of = vec![None; spec.domain.objects.len()];
        let mut renamed = BTreeMap::new();
        let mut orbits: Vec<usize> = (0..spec.scenarios.len()).collect();
        for (index, group) in found.iter().enumerate() {
            for (position, &a) in group.iter().enumerate() {
                group_of[a] = Some(index);
                for &b in &group[position + 1..] {
                    // That they can be swapped follows from swaps with the first of the group.
                    let pairs = comparison.renamed(a, b).unwrap_or_default();
                    for &(from, to) in &pairs {
                        join(&mut orbits, from, to);
                    }
                    if !pairs.is_empty() {
                        renamed.insert((a, b), pairs);
                    }
                }
            }
        }
        let interchangeable = |form: &Form| {
            let names = form.names.iter().filter(|(object, _)| group_of[**object].is_some());
            names.map(|(&object, &times)| (object, times)).collect()
        };
        let names = comparison.forms.iter().map(interchangeable).collect();
        Interchangeable { groups: found, group_of, orbits, names, renamed }
    }

    /// The permutation of scenarios that belongs to one of objects, which leaves each in its group.
    pub(super) fn permutation(&self, objects: Box<[ObjectId]>) -> Permutation {
        let mut scenarios: Box<[usize]> = (0..self.orbits.len()).collect();
        if !self.renamed.is_empty() {
            // Swap by swap: each brings one object to its place.
            let mut reached: Vec<ObjectId> = (0..objects.len()).collect();
            for &object in self.groups.iter().flatten() {
                let (a, b) = (reached[object], objects[object]);
                if a != b {
                    let swapped = |object: ObjectId| swapped(a, b, object);
                    reached.iter_mut().for_each(|object| *object = swapped(*object));
                    let renamed = self.renamed_by(a, b);
                    scenarios.iter_mut().for_each(|scenario| *scenario = image(renamed, *scenario));
                }
            }
        }
        Permutation { objects, scenarios }
    }

    /// Two objects of a group change places.
    pub(super) fn swap(&self, a: ObjectId, b: ObjectId) -> Permutation {
        let mut swap = Permutation::identity(self.group_of.len(), self.orbits.len());
        swap.objects.swap(a, b);
        for &(from, to) in self.renamed_by(a, b) {
            swap.scenarios[from] = to;
        }
        swap
    }

    /// Swaps that together make every permutation of the group.
    pub(super) fn generators(&self) -> Vec<Permutation> {
        let neighbours = self.groups.iter().flat_map(|group| group.windows(2));
        neighbours.map(|pair| self.swap(pair[0], pair[1])).collect()
    }

    fn renamed_by(&self, a: ObjectId, b: ObjectId) -> &[(usize, usize)] {
        self.renamed.get(&(a.min(b), a.max(b))).map_or(&[], Vec::as_slice)
    }
}

fn swapped(a: ObjectId, b: ObjectId, object: ObjectId) -> ObjectId {
    match object {
        _ if object == a => b,
        _ if object == b => a,
        _ => object,
    }
}

fn image(renamed: &[(usize, usize)], scenario: usize) -> usize {
    renamed.iter().find(|(from, _)| *from == scenario).map_or(scenario, |(_, to)| *to)
}

/// Makes one set of two; the least of a set stands for it.
fn join(orbits: &mut [usize], a: usize, b: usize) {
    let (a, b) = (orbits[a], orbits[b]);
    if a != b {
        orbits.iter_mut().filter(|orbit| **orbit == a.max(b)).for_each(|orbit| *orbit = a.min(b));
    }
}

/// What a specification says, ready to be compared with what it says when objects are swapped.
struct Comparison<'s> {
    spec: &'s Spec,
    /// Per scenario.
    forms: Vec<Form>,
    /// The scenarios that say the same, in textual order. Existential ones have no part in the game.
    by_text: BTreeMap<Vec<i64>, Vec<usize>>,
    /// Per effect.
    effects: Vec<Form>,
}

impl<'s> Comparison<'s> {
    fn new(spec: &'s Spec) -> Self {
        let forms: Vec<Form> = spec
            .scenarios
            .iter()
            .map(|scenario| Form::of_scenario(spec, scenario, &|object| object))
            .collect();
        let mut by_text: BTreeMap<Vec<i64>, Vec<usize>> = BTreeMap::new();
        for (index, form) in forms.iter().enumerate().filter(|(index, _)| counts(&spec.scenarios[*index])) {
            by_text.entry(form.text.clone()).or_default().push(index);
        }
        let effects =
            spec.effects.iter().map(|effect| Form::of_effect(spec, effect, &|object| object)).collect();
        Comparison { spec, forms, by_text, effects }
    }

    /// If the specification is the same with two objects swapped: the scenarios that become others by it.
    fn swap(&self, a: ObjectId, b: ObjectId) -> Option<Vec<(usize, usize)>> {
        let spec = self.spec;
        let unclear = self.forms.iter().chain(&self.effects).any(|form| form.is_unclear);
        let alike = spec.domain.objects[a].class == spec.domain.objects[b].class
            && spec.controllable[a] == spec.controllable[b];
        let same = !unclear && alike && self.same_attributes(a, b) && self.same_ranges(a, b);
        if same && self.same_effects(a, b) { self.renamed(a, b) } else { None }
    }

    /// Initial values, and which attributes can change.
    fn same_attributes(&self, a: ObjectId, b: ObjectId) -> bool {
        let domain = &self.spec.domain;
        (0..domain.objects.len()).all(|object| {
            let class = &domain.classes[domain.objects[object].class];
            class.attributes.iter().enumerate().all(|(attribute, declared)| {
                let here = domain.slot(object, attribute);
                let there = domain.slot(swapped(a, b, object), attribute);
                let value = domain.initial[here];
                let value = match (declared.ty, usize::try_from(value)) {
                    (Type::Class(_), Ok(object)) => swapped(a, b, object) as i64,
                    _ => value,
                };
                domain.initial[there] == value && domain.mutable[here] == domain.mutable[there]
            })
        })
    }

    /// Parameter ranges name objects of both or of neither.
    fn same_ranges(&self, a: ObjectId, b: ObjectId) -> bool {
        self.spec.ranges.iter().all(|range| {
            let ty = self.spec.domain.operations[range.event.operation].parameters[range.parameter].1;
            let has = |object: ObjectId| range.values.contains(&(object as i64));
            !matches!(ty, Type::Class(_)) || has(a) == has(b)
        })
    }

    /// Every event does what its image does with the objects swapped.
    fn same_effects(&self, a: ObjectId, b: ObjectId) -> bool {
        let spec = self.spec;
        let image = |object| swapped(a, b, object);
        let renamed: Vec<Form> =
            spec.effects.iter().map(|effect| Form::of_effect(spec, effect, &image)).collect();
        let names_neither = |effect: &Effect| {
            [effect.sender, effect.receiver].iter().all(|end| ![a, b].map(Endpoint::Object).contains(end))
        };
        if spec.effects.iter().all(names_neither)
            && renamed.iter().zip(&self.effects).all(|(renamed, form)| renamed.text == form.text)
        {
            return true;
        }
        let mut operations: Vec<OperationId> = spec.effects.iter().map(|effect| effect.operation).collect();
        operations.sort_unstable();
        operations.dedup();
        let objects = 0..spec.domain.objects.len();
        operations.iter().all(|&operation| {
            objects.clone().all(|sender| {
                objects.clone().all(|receiver| {
                    let of = |sender, receiver| {
                        let applies = move |index: &usize| {
                            let effect = &spec.effects[*index];
                            effect.operation == operation
                                && is_at(spec, effect.sender, sender)
                                && is_at(spec, effect.receiver, receiver)
                        };
                        (0..spec.effects.len()).filter(applies)
                    };
                    let here = of(sender, receiver).map(|index| &renamed[index].text);
                    here.eq(of(image(sender), image(receiver)).map(|index| &self.effects[index].text))
                })
            })
        })
    }

    /// Which scenario each becomes; of several that say the same, the first becomes the first.
    fn renamed(&self, a: ObjectId, b: ObjectId) -> Option<Vec<(usize, usize)>> {
        let mut pairs = Vec::new();
        for (index, form) in self.forms.iter().enumerate() {
            let names = form.names.contains_key(&a) || form.names.contains_key(&b);
            if !names || !counts(&self.spec.scenarios[index]) {
                continue;
            }
            let renamed =
                Form::of_scenario(self.spec, &self.spec.scenarios[index], &|object| swapped(a, b, object));
            let (from, to) = (&self.by_text[&form.text], self.by_text.get(&renamed.text)?);
            if from.len() != to.len() {
                return None;
            }
            let position = from.iter().position(|&one| one == index)?;
            if to[position] != index {
                pairs.push((index, to[position]));
            }
        }
        Some(pairs)
    }
}

/// Whether a scenario has a part in the game.
fn counts(scenario: &Scenario) -> bool {
    scenario.kind != Kind::Existential
}

fn is_at(spec: &Spec, end: Endpoint, object: ObjectId) -> bool {
    match end {
        Endpoint::Object(named) => named == object,
        Endpoint::Class(class) => spec.domain.is_a(spec.domain.objects[object].class, class),
    }
}

//! Of all states that differ only by interchangeable objects one that stands for them, and how many they are.
//!
//! Objects are told apart by colours: first by what a state says of each, then, round after round, by the colours of those that
//! it relates them to. Objects of one colour often can change places pairwise without changing the state; then their
//! order does not matter. Where some cannot, one after the other is told apart from the rest and the search goes on, and of all
//! states that this leads to the least stands for all. Whatever the colours are, the result is an image of the state,
//! so nothing is wrong if it is not always the same; there are only more of them.
//!
//! The search is that of McKay, "Practical Graph Isomorphism" (1981), without the automorphisms that it learns: those that swap
//! two objects are nearly all that occur.

use super::interchangeable::Interchangeable;
use super::orbit::Factors;
use crate::model::{Domain, ObjectId, Permutation, SlotId, Type, Value};
use crate::playout::{Config, CopyId, Playout};
use std::cmp::Ordering;

/// Orders of the objects that are tried for one state.
const MOST_ORDERS: usize = 256;

/// The state that stands for another.
#[derive(Debug)]
pub(super) struct Canonical {
    pub(super) config: Config,
    /// What makes it of the other.
    pub(super) permutation: Permutation,
    /// How many permutations leave the state as it is; `None` if not all orders were tried.
    pub(super) stabiliser: Option<Factors>,
    /// The colours with which it was found, in the order of places. Results that agree in these, too, are related by a
    /// permutation that maps what was told apart in one onto what was told apart in the other.
    colours: Colours,
}

impl Canonical {
    /// The least stands for all.
    fn rank(&self) -> (&Colours, &Config) {
        (&self.colours, &self.config)
    }
}

/// Finds representatives.
#[derive(Debug)]
pub(super) struct Canonizer<'i> {
    interchangeable: &'i Interchangeable,
    /// Attributes that can change and belong to an interchangeable object or can hold one.
    slots: Vec<Slot>,
    /// Per copy: what it says of interchangeable objects.
    facts: Vec<Option<Fact>>,
}

#[derive(Clone, Copy, Debug)]
struct Slot {
    slot: SlotId,
    owner: ObjectId,
    attribute: usize,
    ty: Type,
}

/// Something that a state says of objects.
#[derive(Clone, Debug)]
struct Fact {
    /// What it says, whoever the interchangeable objects are.
    label: u64,
    /// The part that each of these has in it.
    objects: Vec<(u64, ObjectId)>,
}

/// Per object; only those of interchangeable ones mean something.
type Colours = Vec<u64>;

impl<'i> Canonizer<'i> {
    pub(super) fn new(domain: &Domain, interchangeable: &'i Interchangeable) -> Self {
        let mut slots = Vec::new();
        for (owner, object) in domain.objects.iter().enumerate() {
            let attributes = domain.classes[object.class].attributes.iter().enumerate();
            for (attribute, declared) in attributes {
                let slot = domain.slot(owner, attribute);
                let concerned =
                    interchangeable.group_of[owner].is_some() || matches!(declared.ty, Type::Class(_));
                if domain.mutable[slot] && concerned {
                    slots.push(Slot { slot, owner, attribute, ty: declared.ty });
                }
            }
        }
        Canonizer { interchangeable, slots, facts: Vec::new() }
    }

    /// The representative of a state.
    pub(super) fn of(&mut self, playout: &mut Playout<'_>, config: &Config) -> Canonical {
        let facts = self.facts(playout, config);
        let mut search = Search { canonizer: self, playout, config, facts, orders: 0 };
        let colours = search.first_colours();
        search.run(colours, 0)
    }

    fn facts(&mut self, playout: &Playout<'_>, config: &Config) -> Vec<Fact> {
        let values = playout.values(config.valuation);
        let mut facts: Vec<Fact> =
            self.slots.iter().filter_map(|slot| self.of_slot(*slot, values[slot.slot])).collect();
        for &copy in &config.copies {
            let index = copy as usize;
            if index >= self.facts.len() {
                self.facts.resize(index + 1, None);
            }
            if self.facts[index].is_none() {
                self.facts[index] = Some(self.of_copy(playout, copy));
            }
            facts.extend(self.facts[index].clone().filter(|fact| !fact.objects.is_empty()));
        }
        facts
    }

    fn of_slot(&self, slot: Slot, value: Value) -> Option<Fact> {
        let mut fact = Fact { label: mix(1, slot.attribute as u64), objects: Vec::new() };
        self.say(&mut fact, 1, slot.owner as Value, true);
        self.say(&mut fact, 2, value, matches!(slot.ty, Type::Class(_)));
        (!fact.objects.is_empty()).then_some(fact)
    }

    fn of_copy(&self, playout: &Playout<'_>, copy: CopyId) -> Fact {
        let copy = playout.copy(copy);
        let scenario = &playout.spec().scenarios[copy.scenario];
        let mut fact =
            Fact { label: mix(2, self.interchangeable.orbits[copy.scenario] as u64), objects: Vec::new() };
        for &node in &copy.cut {
            fact.label = mix(fact.label, u64::from(node));
        }
        for (position, &value) in copy.roles.iter().enumerate() {
            self.say(&mut fact, mix(3, position as u64), value, true);
        }
        for (position, &value) in copy.variables.iter().enumerate() {
            let is_object = matches!(scenario.variables[position].ty, Type::Class(_));
            self.say(&mut fact, mix(4, position as u64), value, is_object);
        }
        let names = &self.interchangeable.names[copy.scenario];
        fact.objects.extend(names.iter().map(|&(object, times)| (mix(5, u64::from(times)), object)));
        fact
    }

    /// Adds a value that has some part in a fact.
    fn say(&self, fact: &mut Fact, part: u64, value: Value, is_object: bool) {
        match usize::try_from(value) {
            Ok(object) if is_object && self.interchangeable.group_of[object].is_some() => {
                fact.objects.push((part, object));
            }
            _ => fact.label = mix(mix(fact.label, part), value as u64),
        }
    }
}

struct Search<'c, 'i, 'p, 's> {
    canonizer: &'c Canonizer<'i>,
    playout: &'p mut Playout<'s>,
    config: &'c Config,
    facts: Vec<Fact>,
    /// So many were tried.
    orders: usize,
}

impl Search<'_, '_, '_, '_> {
    fn first_colours(&self) -> Colours {
        let groups = &self.canonizer.interchangeable.group_of;
        groups.iter().map(|group| group.map_or(0, |group| mix(6, group as u64))).collect()
    }

    /// `depth`: so many objects were told apart from the others of their colour.
    fn run(&mut self, mut colours: Colours, depth: u64) -> Canonical {
        self.refine(&mut colours);
        let mut stabiliser = Factors::default();
        for cell in self.cells(&colours) {
            let alike = self.alike(&cell);
            if alike.len() > 1 {
                return self.branch(&colours, &alike, depth);
            }
            stabiliser.factorial(cell.len());
        }
        self.orders += 1;
        let (config, permutation) = self.ordered(&colours);
        let mut in_place = vec![0; colours.len()];
        for (colour, &place) in colours.iter().zip(&permutation.objects) {
            in_place[place] = *colour;
        }
        Canonical { config, permutation, stabiliser: Some(stabiliser), colours: in_place }
    }

    /// Tells one of the objects of a cell from the others, of each kind that there is in it, and takes the least result.
    fn branch(&mut self, colours: &Colours, alike: &[Vec<ObjectId>], depth: u64) -> Canonical {
        let mut best: Option<Canonical> = None;
        let mut in_orbit = 0;
        let mut is_complete = true;
        for kind in alike {
            if best.is_some() && self.orders >= MOST_ORDERS {
                is_complete = false;
                break;
            }
            let mut colours = colours.clone();
            // A colour that no other object gets, of those that were told apart before either.
            colours[kind[0]] = mix(mix(colours[kind[0]], 7), depth);
            let found = self.run(colours, depth + 1);
            is_complete &= found.stabiliser.is_some();
            match best.as_ref().map(|best| found.rank().cmp(&best.rank())) {
                Some(Ordering::Greater) => {}
                Some(Ordering::Equal) => in_orbit += kind.len(),
                Some(Ordering::Less) | None => {
                    in_orbit = kind.len();
                    best = Some(found);
                }
            }
        }
        let mut best = best.expect("a cell has objects");
        if is_complete {
            best.stabiliser.iter_mut().for_each(|stabiliser| stabiliser.multiply(in_orbit));
        } else {
            best.stabiliser = None;
        }
        best
    }

    /// Objects that the state says different things of get different colours, until that tells no more of them apart.
    fn refine(&self, colours: &mut Colours) {
        let mut distinct = self.count(colours);
        loop {
            let mut next = colours.clone();
            for fact in &self.facts {
                let mut parts: Vec<(u64, u64)> =
                    fact.objects.iter().map(|&(part, object)| (part, colours[object])).collect();
                parts.sort_unstable();
                let seen =
                    parts.iter().fold(fact.label, |seen, &(part, colour)| mix(mix(seen, part), colour));
                for &(part, object) in &fact.objects {
                    // A sum, since facts come in no order.
                    next[object] = next[object].wrapping_add(mix(mix(seen, part), colours[object]));
                }
            }
            let told_apart = self.count(&next);
            if told_apart <= distinct {
                return;
            }
            distinct = told_apart;
            *colours = next;
        }
    }

    fn count(&self, colours: &Colours) -> usize {
        let mut all: Vec<u64> = self.interchangeable().map(|object| colours[object]).collect();
        all.sort_unstable();
        all.dedup();
        all.len()
    }

    fn interchangeable(&self) -> impl Iterator<Item = ObjectId> {
        self.canonizer.interchangeable.groups.iter().flatten().copied()
    }

    /// The objects of each colour that several have, in an order that does not depend on which ones they are.
    fn cells(&self, colours: &Colours) -> Vec<Vec<ObjectId>> {
        let mut cells = Vec::new();
        for group in &self.canonizer.interchangeable.groups {
            let ordered = in_order(group, colours);
            let chunks = ordered.chunk_by(|&a, &b| colours[a] == colours[b]);
            cells.extend(chunks.filter(|chunk| chunk.len() > 1).map(<[ObjectId]>::to_vec));
        }
        cells
    }

    /// The objects of a cell in sets of which any two can change places.
    fn alike(&mut self, cell: &[ObjectId]) -> Vec<Vec<ObjectId>> {
        let mut sets: Vec<Vec<ObjectId>> = Vec::new();
        for &object in cell {
            match sets.iter_mut().find(|set| self.can_swap(set[0], object)) {
                Some(set) => set.push(object),
                None => sets.push(vec![object]),
            }
        }
        sets
    }

    /// Whether the state is the same with two objects swapped.
    fn can_swap(&mut self, a: ObjectId, b: ObjectId) -> bool {
        let swap = self.canonizer.interchangeable.swap(a, b);
        let values = self.playout.values(self.config.valuation);
        let domain = &self.playout.spec().domain;
        let same_values = self.canonizer.slots.iter().all(|slot| {
            let image = domain.slot(swap.objects[slot.owner], slot.attribute);
            values[image] == swap.value(values[slot.slot], slot.ty)
        });
        same_values
            && self.config.copies.iter().all(|&copy| {
                let fact = self.canonizer.facts[copy as usize].as_ref();
                let concerned = fact
                    .is_some_and(|fact| fact.objects.iter().any(|&(_, object)| object == a || object == b));
                !concerned
                    || self.config.copies.binary_search(&self.playout.permuted_copy(copy, &swap)).is_ok()
            })
    }

    /// The image of the state in which the objects of each group come in the order of their colours.
    fn ordered(&mut self, colours: &Colours) -> (Config, Permutation) {
        let mut objects: Box<[ObjectId]> = (0..colours.len()).collect();
        for group in &self.canonizer.interchangeable.groups {
            for (&place, object) in group.iter().zip(in_order(group, colours)) {
                objects[object] = place;
            }
        }
        let permutation = self.canonizer.interchangeable.permutation(objects);
        (self.playout.permuted(self.config, &permutation), permutation)
    }
}

fn in_order(group: &[ObjectId], colours: &Colours) -> Vec<ObjectId> {
    let mut ordered = group.to_vec();
    ordered.sort_by_key(|&object| colours[object]);
    ordered
}

/// The next of a series of hash values (the finaliser of SplitMix64: Steele, Lea and Flood 2014).
fn mix(hash: u64, next: u64) -> u64 {
    let mut bits = hash.rotate_left(23) ^ next.wrapping_mul(0x9E37_79B9_7F4A_7C15);
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    bits ^ (bits >> 31)
}

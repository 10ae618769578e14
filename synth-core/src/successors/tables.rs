//! Everything that is known of the specification's steps, by small numbers.

use super::concerns::Concerns;
use super::groups::{GroupId, Groups};
use super::layout::Layout;
use super::sets::{SetId, Sets};
use super::trees::{NOTHING, Node, Trees, UNKNOWN, is_leaf};
use crate::game::{KeySets, KeySetsBuilder, insert, words_for};
use crate::intern::Indexed;
use crate::model::{Kind, SlotId, Value};
use crate::playout::{Config, CopyId, EventId, KeyId, Playout};

/// The field that says whether the system has yielded since the last event.
pub(super) const YIELDED: usize = 0;

/// The field of the first attribute.
const FIRST_ATTRIBUTE: usize = 1;

/// An attribute that effects can change.
#[derive(Debug)]
pub(super) struct Attribute {
    pub(super) slot: SlotId,
    /// The values that it had so far, in order of discovery; the field holds their numbers. The initial one is 0.
    pub(super) values: Indexed<Value>,
}

/// What an event does to a group of copies, or what it starts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Reaction {
    /// What it violates.
    pub(super) flags: u8,
    /// The slot's value afterwards; nothing for a start.
    pub(super) value: u32,
    /// The keys that it discharges.
    pub(super) discharged: SetId,
    /// The copies that come to other slots, or to this one in other ways: a range of `joins`.
    pub(super) joins: (u32, u32),
}

/// Bits of [`Reaction::flags`].
pub(super) mod flag {
    /// A guarantee that counts is violated.
    pub(in crate::successors) const GUARANTEE: u8 = 1;
    /// An assumption that counts is violated.
    pub(in crate::successors) const ASSUMPTION: u8 = 2;
    /// A relaxed guarantee is violated.
    pub(in crate::successors) const EXCUSED_GUARANTEE: u8 = 4;
    /// A relaxed assumption is violated.
    pub(in crate::successors) const EXCUSED_ASSUMPTION: u8 = 8;
    /// A copy of the scenario that is followed comes to its end.
    pub(in crate::successors) const COMPLETED: u8 = 16;
    /// The event itself violates, whatever it does to others. What only shows in settling counts unless there is a mistake.
    pub(in crate::successors) const AT_ONCE: u8 = 32;
}

/// In what order wishes are looked at.
pub(super) mod class {
    pub(in crate::successors) const SYSTEM_COMMITTED: u8 = 0;
    pub(in crate::successors) const ENVIRONMENT_COMMITTED: u8 = 1;
    pub(in crate::successors) const SYSTEM_URGENT: u8 = 2;
    pub(in crate::successors) const ENVIRONMENT_URGENT: u8 = 3;
    pub(in crate::successors) const SYSTEM_EVENTUALLY: u8 = 4;
    /// Assumptions that say that an event comes some time, or only may come.
    pub(in crate::successors) const ENVIRONMENT: u8 = 5;
    /// How many there are.
    pub(in crate::successors) const COUNT: usize = 6;
}

/// An event that a group asks for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Wish {
    pub(super) class: u8,
    /// A relaxed guarantee asks.
    pub(super) relaxed: bool,
    pub(super) event: EventId,
}

/// What is known of one event.
#[derive(Clone, Copy, Debug)]
pub(super) struct EventEntry {
    /// Whether it has a link: a leaf other than [`NOTHING`] means that it has none.
    pub(super) link: Node,
    /// A leaf is an index into `effects`.
    pub(super) effects: Node,
    /// A leaf is an index into `reactions`.
    pub(super) starts: Node,
    /// Its place in the order of texts.
    pub(super) rank: u32,
}

/// Where a tree's root is kept.
#[derive(Clone, Copy, Debug)]
pub(super) enum Place {
    Link(EventId),
    Effects(EventId),
    Starts(EventId),
    /// What an event does to a group that it concerns.
    Reaction(GroupId, EventId),
    /// What an event does to a group that it does not concern: the same for all of these.
    Settling(GroupId, EventId),
    Offers(GroupId),
}

/// What is known of one group, beside what events do to it.
#[derive(Clone, Copy, Debug)]
pub(super) struct GroupEntry {
    /// A leaf is an index into `offers`.
    pub(super) offers: Node,
    /// A leaf is an index into `reactions`.
    pub(super) settling: Node,
    /// The keys that it has open: a range of `open`.
    open: (u32, u32),
}

/// The successor function's tables.
#[derive(Debug)]
pub(crate) struct Successors {
    pub(super) classic: bool,
    pub(super) layout: Layout,
    pub(super) trees: Trees,
    pub(super) groups: Groups,
    pub(super) concerns: Concerns,
    pub(super) sets: Sets,
    pub(super) attributes: Vec<Attribute>,
    /// Per slot of the domain: the field, if effects can change it.
    pub(super) field_of: Vec<Option<u32>>,
    pub(super) events: Vec<EventEntry>,
    /// Events by the order of their texts.
    pub(super) by_rank: Vec<EventId>,
    /// Events of the environment that need no assumption to cause them, as bits in the order of texts.
    pub(super) spontaneous: Vec<u64>,
    /// Roots by group and event, `stride` a group.
    reacted: Vec<Node>,
    stride: usize,
    pub(super) entries: Vec<GroupEntry>,
    /// Words of sets of open keys that are not 0, and their places.
    open: Vec<(u32, u64)>,
    /// Words of a set of open keys.
    key_words: usize,
    /// What leaves stand for. The first of each kind stands for nothing.
    pub(super) reactions: Vec<Reaction>,
    pub(super) joins: Vec<CopyId>,
    pub(super) effects: Vec<(u32, u32)>,
    /// Fields and their values.
    pub(super) assignments: Vec<(u32, u32)>,
    pub(super) offers: Vec<(u32, u32)>,
    pub(super) wishes: Vec<Wish>,
}

/// The elements of a range.
pub(super) fn part<T>(all: &[T], (start, end): (u32, u32)) -> &[T] {
    &all[start as usize..end as usize]
}

impl Successors {
    /// Knows nothing yet. The tables serve the play-out as it is now: they are void if other scenarios are relaxed.
    pub(crate) fn new(playout: &Playout<'_>) -> Self {
        let domain = &playout.spec().domain;
        let mut attributes = Vec::new();
        let mut field_of = vec![None; domain.initial.len()];
        for slot in (0..domain.initial.len()).filter(|&slot| domain.mutable[slot]) {
            field_of[slot] = Some((FIRST_ATTRIBUTE + attributes.len()) as u32);
            let mut values = Indexed::default();
            values.intern(domain.initial[slot]);
            attributes.push(Attribute { slot, values });
        }
        let layout = Layout::new(FIRST_ATTRIBUTE + attributes.len()).widened(&[(YIELDED as u32, 1)]);
        let nothing = Reaction { flags: 0, value: 0, discharged: 0, joins: (0, 0) };
        let mut successors = Successors {
            classic: playout.semantics().classic,
            layout,
            trees: Trees::default(),
            groups: Groups::default(),
            concerns: Concerns::default(),
            sets: Sets::default(),
            attributes,
            field_of,
            events: Vec::new(),
            by_rank: Vec::new(),
            spontaneous: Vec::new(),
            reacted: Vec::new(),
            stride: 0,
            entries: Vec::new(),
            open: Vec::new(),
            key_words: 1,
            reactions: vec![nothing],
            joins: Vec::new(),
            effects: vec![(0, 0)],
            assignments: Vec::new(),
            offers: vec![(0, 0)],
            wishes: Vec::new(),
        };
        successors.keep_up(playout);
        successors
    }

    /// Takes note of events, copies and groups that are new.
    pub(super) fn keep_up(&mut self, playout: &Playout<'_>) {
        for copy in self.groups.copies()..playout.copy_count() {
            if self.groups.add_copy(playout.copy(copy as CopyId)) {
                self.concerns.add_slot(playout, copy as CopyId);
            }
        }
        while self.layout.len() < self.first_slot() + self.groups.slots() {
            self.layout.push();
        }
        let laid_out = self.events.len();
        if laid_out < playout.event_count() {
            self.add_events(playout);
        }
        let stride = if self.stride < self.events.len() { self.events.len() * 5 / 4 } else { self.stride };
        if stride != self.stride {
            let mut reacted = Vec::with_capacity(self.groups.len() * stride);
            for row in self.reacted.chunks(self.stride.max(1)) {
                reacted.extend_from_slice(row);
                reacted.resize(reacted.len() + stride - row.len(), UNKNOWN);
            }
            (self.reacted, self.stride) = (reacted, stride);
        }
        self.reacted.resize(self.groups.len() * self.stride, UNKNOWN);
        self.add_entries(playout, laid_out);
        if laid_out < self.events.len() {
            self.lay_out();
        }
    }

    /// Takes note of the keys that new groups have open; nothing else is known of them. So many events have masks.
    fn add_entries(&mut self, playout: &Playout<'_>, laid_out: usize) {
        let mut keys: Vec<KeyId> = Vec::new();
        for group in self.entries.len()..self.groups.len() {
            keys.clear();
            playout.open_of(&self.groups.get(group as GroupId).copies, &mut keys);
            keys.sort_unstable();
            let start = self.open.len() as u32;
            for keys in keys.chunk_by(|a, b| a / u64::BITS == b / u64::BITS) {
                let word = keys.iter().fold(0, |word, key| word | 1 << (key % u64::BITS));
                self.open.push((keys[0] / u64::BITS, word));
            }
            self.key_words = self.key_words.max(words_for(keys.last().map_or(0, |most| most + 1)));
            let open = (start, self.open.len() as u32);
            // Without attributes that change there is nothing to wait for.
            let settling = if self.attributes.is_empty() { NOTHING } else { UNKNOWN };
            self.entries.push(GroupEntry { offers: UNKNOWN, settling, open });
            // Nobody knows what the new group violates.
            let slot = self.groups.slot_of(self.groups.get(group as GroupId).copies[0]);
            let field = self.layout.field(self.first_slot() + slot as usize);
            for event in 0..laid_out {
                self.concerns.set_bar(event as EventId, field, 0);
            }
        }
    }

    fn add_events(&mut self, playout: &Playout<'_>) {
        for event in self.events.len()..playout.event_count() {
            let event = event as EventId;
            let known = |known: bool| if known { NOTHING } else { UNKNOWN };
            self.events.push(EventEntry {
                link: known(!playout.needs_link(event)),
                effects: known(!playout.assigns(event)),
                starts: UNKNOWN,
                rank: 0,
            });
            self.concerns.add_event(playout);
            self.by_rank.push(event);
        }
        self.by_rank.sort_by(|&a, &b| playout.event(a).text.cmp(&playout.event(b).text));
        self.spontaneous.clear();
        self.spontaneous.resize(words_for(self.by_rank.len() as u32), 0);
        for (rank, &event) in (0..).zip(&self.by_rank) {
            self.events[event as usize].rank = rank;
            if playout.event(event).spontaneous && playout.is_foreseen(event) {
                insert(&mut self.spontaneous, rank);
            }
        }
    }

    pub(super) fn first_slot(&self) -> usize {
        FIRST_ATTRIBUTE + self.attributes.len()
    }

    #[inline(always)]
    pub(super) fn root(&self, place: Place) -> Node {
        match place {
            Place::Link(event) => self.events[event as usize].link,
            Place::Effects(event) => self.events[event as usize].effects,
            Place::Starts(event) => self.events[event as usize].starts,
            Place::Reaction(group, event) => self.reacted[group as usize * self.stride + event as usize],
            Place::Settling(group, _) => self.entries[group as usize].settling,
            Place::Offers(group) => self.entries[group as usize].offers,
        }
    }

    pub(super) fn root_mut(&mut self, place: Place) -> &mut Node {
        match place {
            Place::Link(event) => &mut self.events[event as usize].link,
            Place::Effects(event) => &mut self.events[event as usize].effects,
            Place::Starts(event) => &mut self.events[event as usize].starts,
            Place::Reaction(group, event) => &mut self.reacted[group as usize * self.stride + event as usize],
            Place::Settling(group, _) => &mut self.entries[group as usize].settling,
            Place::Offers(group) => &mut self.entries[group as usize].offers,
        }
    }

    /// Where fields lie.
    pub(crate) fn layout(&self) -> &Layout {
        &self.layout
    }

    /// The layout with room for these values of fields. Packing all rows anew takes long, and what comes to one slot soon comes to
    /// those of the scenario's other bindings, so those that are as narrow get the same room.
    pub(crate) fn widened(&self, narrow: &[(u32, u32)]) -> Layout {
        let first = self.first_slot() as u32;
        let width = |slot: u32| self.layout.field((first + slot) as usize).width();
        let mut values = narrow.to_vec();
        for &(field, value) in narrow.iter().filter(|(field, _)| *field >= first) {
            let slot = field - first;
            let alike = self.groups.of_same_scenario(slot).filter(|&other| width(other) == width(slot));
            values.extend(alike.map(|other| (first + other, value)));
        }
        self.layout.widened(&values)
    }

    /// From now on fields lie as this says.
    pub(crate) fn set_layout(&mut self, layout: Layout) {
        self.layout = layout;
        self.lay_out();
    }

    /// Makes the masks of rows anew.
    fn lay_out(&mut self) {
        self.concerns.lay_out(&self.layout, self.first_slot());
        for event in 0..self.events.len() as EventId {
            for index in 0..self.concerns.slots(event).len() {
                self.note_bar(self.concerns.slots(event)[index], event);
            }
        }
    }

    /// Takes note of what all groups of a slot violate at once by an event, as far as that is known.
    pub(super) fn note_bar(&mut self, slot: u32, event: EventId) {
        let flags = |&group: &GroupId| {
            let root = self.root(Place::Reaction(group, event));
            if is_leaf(root) { self.reactions[root as usize].flags } else { 0 }
        };
        let of_all = self.groups.of_slot(slot).iter().map(flags).reduce(|all, one| all & one).unwrap_or(0);
        let violated = if of_all & flag::AT_ONCE != 0 { of_all } else { 0 };
        self.concerns.set_bar(event, self.layout.field(self.first_slot() + slot as usize), violated);
    }

    /// The sets of keys that moves discharge, and others that were asked for.
    pub(crate) fn key_sets(&self) -> &KeySets {
        self.sets.all()
    }

    /// The same, to find and to add some.
    pub(crate) fn key_sets_builder(&self) -> &KeySetsBuilder {
        self.sets.builder()
    }

    pub(crate) fn key_sets_builder_mut(&mut self) -> &mut KeySetsBuilder {
        self.sets.builder_mut()
    }

    /// The groups of copies that are active in a state, with their fields.
    #[inline]
    pub(super) fn active(&self, row: &[u64], mut visit: impl FnMut(GroupId, u32)) {
        let first = self.first_slot();
        self.layout.occupied(row, |field, value| {
            visit(self.groups.at(field as usize - first, value), field);
        });
    }

    /// The group that a slot's field stands for with a value that is not 0.
    #[inline]
    pub(super) fn group(&self, field: u32, value: u32) -> GroupId {
        self.groups.at(field as usize - self.first_slot(), value)
    }

    /// Words of a set of open keys.
    pub(super) fn key_words(&self) -> usize {
        self.key_words
    }

    /// Adds the keys that a group has open to a set of bits.
    #[inline]
    pub(super) fn add_open_keys(&self, group: GroupId, open: &mut [u64]) {
        for &(index, keys) in part(&self.open, self.entries[group as usize].open) {
            open[index as usize] |= keys;
        }
    }

    /// The keys that are open in a state, as a bit for each, into a cleared list.
    pub(crate) fn open_keys(&self, row: &[u64], open: &mut Vec<u64>) {
        open.clear();
        open.resize(self.key_words, 0);
        self.active(row, |group, _| self.add_open_keys(group, open));
    }

    /// The set of the keys that are open in a state.
    pub(crate) fn open_set(&mut self, row: &[u64]) -> SetId {
        let mut open = Vec::new();
        self.open_keys(row, &mut open);
        self.sets.intern_bits(&open)
    }

    /// Adds the keys that are open in a state to those of others, a bit for each.
    pub(crate) fn open_too(&self, row: &[u64], open: &mut Vec<u64>) {
        open.resize(open.len().max(self.key_words), 0);
        self.active(row, |group, _| self.add_open_keys(group, open));
    }

    /// Whether the system has yielded since the last event.
    pub(crate) fn yielded(&self, row: &[u64]) -> bool {
        self.layout.field(YIELDED).read(row) != 0
    }

    /// Appends the copies of a state, ascending.
    pub(crate) fn copies(&self, row: &[u64], copies: &mut Vec<CopyId>) {
        self.active(row, |group, _| copies.extend_from_slice(&self.groups.get(group).copies));
        copies.sort_unstable();
    }

    /// The values of all attributes in a state, by slot.
    pub(crate) fn values(&self, playout: &Playout<'_>, row: &[u64], values: &mut Vec<Value>) {
        values.clear();
        values.extend_from_slice(&playout.spec().domain.initial);
        for (index, attribute) in self.attributes.iter().enumerate() {
            let value = self.layout.field(FIRST_ATTRIBUTE + index).read(row);
            values[attribute.slot] = *attribute.values.get(value);
        }
    }

    /// Unpacks a state.
    pub(crate) fn load(
        &self,
        playout: &mut Playout<'_>,
        row: &[u64],
        scratch: &mut Vec<Value>,
        config: &mut Config,
    ) {
        self.values(playout, row, scratch);
        config.valuation = playout.valuation(scratch);
        config.yielded = self.yielded(row);
        config.copies.clear();
        self.copies(row, &mut config.copies);
    }

    /// The fields' values of a state that are not 0.
    pub(super) fn take_apart(&mut self, playout: &Playout<'_>, config: &Config) -> Vec<(u32, u32)> {
        let mut fields = vec![(YIELDED as u32, u32::from(config.yielded))];
        let values = playout.values(config.valuation);
        for (index, attribute) in self.attributes.iter_mut().enumerate() {
            let (value, _) = attribute.values.intern(values[attribute.slot]);
            fields.push(((FIRST_ATTRIBUTE + index) as u32, value));
        }
        self.keep_up(playout);
        let mut by_slot: Vec<(u32, CopyId)> =
            config.copies.iter().map(|&copy| (self.groups.slot_of(copy), copy)).collect();
        by_slot.sort_unstable();
        for one in by_slot.chunk_by(|a, b| a.0 == b.0) {
            let copies: Vec<CopyId> = one.iter().map(|&(_, copy)| copy).collect();
            let value = self.groups.value(one[0].0, &copies);
            fields.push((self.first_slot() as u32 + one[0].0, value));
        }
        self.keep_up(playout);
        fields.retain(|&(_, value)| value != 0);
        fields
    }

    /// The number of a value of an attribute, new or not.
    pub(super) fn number(&mut self, field: u32, value: Value) -> u32 {
        self.attributes[field as usize - FIRST_ATTRIBUTE].values.intern(value).0
    }

    /// The [`flag`] that a violation raises.
    pub(super) fn violation(playout: &Playout<'_>, scenario: usize) -> u8 {
        match (playout.spec().scenarios[scenario].kind, playout.is_relaxed(scenario)) {
            (Kind::Guarantee, false) => flag::GUARANTEE,
            (Kind::Guarantee, true) => flag::EXCUSED_GUARANTEE,
            (Kind::Assumption, false) => flag::ASSUMPTION,
            (Kind::Assumption, true) => flag::EXCUSED_ASSUMPTION,
            (Kind::Existential, _) => 0,
        }
    }

    /// Bytes held, about.
    pub(crate) fn memory(&self) -> usize {
        self.trees.memory()
            + self.groups.memory()
            + self.sets.memory()
            + self.concerns.memory()
            + self.reacted.capacity() * size_of::<Node>()
            + self.entries.capacity() * size_of::<GroupEntry>()
            + self.open.capacity() * size_of::<(u32, u64)>()
            + self.reactions.capacity() * size_of::<Reaction>()
            + (self.effects.capacity() + self.assignments.capacity() + self.offers.capacity())
                * size_of::<(u32, u32)>()
            + self.wishes.capacity() * size_of::<Wish>()
            + self.joins.capacity() * size_of::<CopyId>()
    }
}

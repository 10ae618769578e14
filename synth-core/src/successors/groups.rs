//! The copies of one scenario with one role binding share a *slot*, a field of the rows. Most slots hold no copy or one of
//! a few, so the field numbers the slot's distinct sets of copies, its *groups*; 0 is the empty one.

use crate::model::Value;
use crate::playout::{Copy, CopyId};
use rustc_hash::FxHashMap;

/// Index of a group among those of all slots.
pub(super) type GroupId = u32;

/// A value that is not known yet.
const UNKNOWN: u32 = u32::MAX;

/// A non-empty set of copies of one slot.
#[derive(Clone, Debug)]
pub(super) struct Group {
    /// Ascending.
    pub(super) copies: Box<[CopyId]>,
    /// The groups that one more copy leads to, as far as anybody asked.
    joined: Vec<(CopyId, u32)>,
}

/// All slots and groups.
#[derive(Clone, Debug, Default)]
pub(super) struct Groups {
    groups: Vec<Group>,
    /// Per slot, and per value from 1: the group.
    slots: Vec<Vec<GroupId>>,
    /// Per slot: its scenario.
    scenarios: Vec<usize>,
    slot_index: FxHashMap<(usize, Box<[Value]>), u32>,
    /// Values by slot and copies.
    index: FxHashMap<(u32, Box<[CopyId]>), u32>,
    /// Per copy: its slot, and the value for the copy alone.
    alone: Vec<(u32, u32)>,
}

impl Groups {
    pub(super) fn slots(&self) -> usize {
        self.slots.len()
    }

    pub(super) fn len(&self) -> usize {
        self.groups.len()
    }

    pub(super) fn get(&self, group: GroupId) -> &Group {
        &self.groups[group as usize]
    }

    /// The group of a slot with this value, which is not 0.
    #[inline]
    pub(super) fn at(&self, slot: usize, value: u32) -> GroupId {
        self.slots[slot][value as usize - 1]
    }

    /// The groups of a slot.
    pub(super) fn of_slot(&self, slot: u32) -> &[GroupId] {
        &self.slots[slot as usize]
    }

    /// The slots that hold copies of the same scenario as this one, itself among them.
    pub(super) fn of_same_scenario(&self, slot: u32) -> impl Iterator<Item = u32> {
        let scenario = self.scenarios[slot as usize];
        (0..).zip(&self.scenarios).filter(move |&(_, &other)| other == scenario).map(|(slot, _)| slot)
    }

    /// The slot of a copy that is known, and the value for the copy alone, if that is known.
    #[inline]
    pub(super) fn alone(&self, copy: CopyId) -> (u32, Option<u32>) {
        let (slot, value) = self.alone[copy as usize];
        (slot, (value != UNKNOWN).then_some(value))
    }

    /// The slot of a copy that is known.
    pub(super) fn slot_of(&self, copy: CopyId) -> u32 {
        self.alone[copy as usize].0
    }

    /// The value of a slot when one more copy comes to this one, if that is known.
    pub(super) fn joined(&self, value: u32, copy: CopyId) -> Option<u32> {
        let (slot, alone) = self.alone[copy as usize];
        if value == 0 {
            return (alone != UNKNOWN).then_some(alone);
        }
        let group = &self.groups[self.at(slot as usize, value) as usize];
        group.joined.iter().find(|&&(other, _)| other == copy).map(|&(_, value)| value)
    }

    /// Finds out [`Groups::joined`].
    pub(super) fn join(&mut self, value: u32, copy: CopyId) {
        let slot = self.slot_of(copy);
        if value == 0 {
            self.value(slot, &[copy]);
            return;
        }
        let group = self.at(slot as usize, value);
        let mut copies = self.groups[group as usize].copies.to_vec();
        if let Err(place) = copies.binary_search(&copy) {
            copies.insert(place, copy);
        }
        let joined = self.value(slot, &copies);
        self.groups[group as usize].joined.push((copy, joined));
    }

    /// The value of a slot for these copies, ascending; 0 for none.
    pub(super) fn value(&mut self, slot: u32, copies: &[CopyId]) -> u32 {
        if copies.is_empty() {
            return 0;
        }
        if let Some(&value) = self.index.get(&(slot, Box::from(copies))) {
            return value;
        }
        let groups = &mut self.slots[slot as usize];
        groups.push(self.groups.len() as GroupId);
        let value = groups.len() as u32;
        self.groups.push(Group { copies: copies.into(), joined: Vec::new() });
        self.index.insert((slot, copies.into()), value);
        if let &[copy] = copies {
            self.alone[copy as usize].1 = value;
        }
        value
    }

    /// Gives the next copy its slot; copies come in the order of their ids. Whether the slot is new.
    pub(super) fn add_copy(&mut self, copy: &Copy) -> bool {
        let next = self.slots.len() as u32;
        let slot = *self.slot_index.entry((copy.scenario, copy.roles.clone())).or_insert(next);
        if slot == next {
            self.slots.push(Vec::new());
            self.scenarios.push(copy.scenario);
        }
        self.alone.push((slot, UNKNOWN));
        slot == next
    }

    /// How many copies have a slot.
    pub(super) fn copies(&self) -> usize {
        self.alone.len()
    }

    /// Bytes held, about.
    pub(super) fn memory(&self) -> usize {
        // A set is held twice, and an entry of the index has a hash beside it.
        let per_group = 2 * size_of::<Group>() + 64;
        self.groups.capacity() * per_group + self.alone.capacity() * size_of::<(u32, u32)>()
    }
}

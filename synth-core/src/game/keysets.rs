//! Interned sets of fairness keys: few distinct ones, shared by many states and edges.

use crate::intern::hash;
use hashbrown::HashTable;

/// All distinct sets; set 0 is the empty one.
#[derive(Clone, Debug)]
pub struct KeySets {
    keys: u32,
    first: Vec<u32>,
    members: Vec<u32>,
}

impl KeySets {
    /// Number of keys; ids are below it.
    #[must_use]
    pub fn keys(&self) -> u32 {
        self.keys
    }

    /// Number of distinct sets.
    #[must_use]
    pub fn len(&self) -> usize {
        self.first.len() - 1
    }

    /// Never: set 0 always exists.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        false
    }

    /// The members of a set, ascending.
    #[must_use]
    pub fn members(&self, set: u32) -> &[u32] {
        &self.members[self.first[set as usize] as usize..self.first[set as usize + 1] as usize]
    }

    /// For one key: per set, whether it is in there.
    #[must_use]
    pub fn containing(&self, key: u32) -> Vec<bool> {
        (0..self.len() as u32).map(|set| self.members(set).binary_search(&key).is_ok()).collect()
    }
}

/// Collects sets while a game is explored.
#[derive(Debug)]
pub struct KeySetsBuilder {
    sets: KeySets,
    index: HashTable<u32>,
}

impl Default for KeySetsBuilder {
    fn default() -> Self {
        let sets = KeySets { keys: 0, first: vec![0], members: Vec::new() };
        let mut builder = KeySetsBuilder { sets, index: HashTable::new() };
        builder.intern(&[]);
        builder
    }
}

impl KeySetsBuilder {
    /// The id of a set; `members` must be ascending without duplicates.
    pub fn intern(&mut self, members: &[u32]) -> u32 {
        debug_assert!(members.windows(2).all(|pair| pair[0] < pair[1]));
        let KeySetsBuilder { sets, index } = self;
        let found = index.find(hash(members), |&set| sets.members(set) == members);
        if let Some(&set) = found {
            return set;
        }
        let set = sets.len() as u32;
        sets.members.extend_from_slice(members);
        sets.first.push(sets.members.len() as u32);
        sets.keys = sets.keys.max(members.last().map_or(0, |last| last + 1));
        index.insert_unique(hash(members), set, |&set| hash(sets.members(set)));
        set
    }

    /// Number of distinct sets so far.
    #[must_use]
    pub fn len(&self) -> usize {
        self.sets.len()
    }

    /// Never: set 0 always exists.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        false
    }

    /// The members of a set, ascending.
    #[must_use]
    pub fn members(&self, set: u32) -> &[u32] {
        self.sets.members(set)
    }

    /// Bytes held.
    #[must_use]
    pub fn memory(&self) -> usize {
        // The index has a byte of its own beside each id.
        (self.sets.members.capacity() + self.sets.first.capacity()) * size_of::<u32>()
            + self.index.capacity() * (size_of::<u32>() + 1)
    }

    /// The finished sets.
    #[must_use]
    pub fn finish(self) -> KeySets {
        self.sets
    }
}

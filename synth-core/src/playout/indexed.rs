//! Values interned in order of discovery.

use hashbrown::HashTable;
use rustc_hash::FxHasher;
use std::hash::{Hash, Hasher};

/// Distinct values with ids from 0.
#[derive(Debug)]
pub(super) struct Indexed<T> {
    items: Vec<T>,
    index: HashTable<u32>,
}

impl<T> Default for Indexed<T> {
    fn default() -> Self {
        Indexed { items: Vec::new(), index: HashTable::new() }
    }
}

impl<T: Eq + Hash> Indexed<T> {
    pub(super) fn len(&self) -> usize {
        self.items.len()
    }

    pub(super) fn get(&self, id: u32) -> &T {
        &self.items[id as usize]
    }

    pub(super) fn find(&self, item: &T) -> Option<u32> {
        self.index.find(hash(item), |&id| self.items[id as usize] == *item).copied()
    }

    /// The id of `item`, and whether it is new.
    pub(super) fn intern(&mut self, item: T) -> (u32, bool) {
        if let Some(found) = self.find(&item) {
            return (found, false);
        }
        let id = self.items.len() as u32;
        let Indexed { items, index } = self;
        items.push(item);
        index.insert_unique(hash(&items[id as usize]), id, |&id| hash(&items[id as usize]));
        (id, true)
    }
}

fn hash<T: Hash>(item: &T) -> u64 {
    let mut hasher = FxHasher::default();
    item.hash(&mut hasher);
    hasher.finish()
}

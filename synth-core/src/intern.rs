//! Values interned in order of discovery: equal ones are one, with ids from 0.

use hashbrown::HashTable;
use rustc_hash::FxHasher;
use std::hash::{Hash, Hasher};

/// Distinct values.
#[derive(Debug)]
pub(crate) struct Indexed<T> {
    items: Vec<T>,
    index: HashTable<u32>,
}

impl<T> Default for Indexed<T> {
    fn default() -> Self {
        Indexed { items: Vec::new(), index: HashTable::new() }
    }
}

impl<T: Eq + Hash> Indexed<T> {
    pub(crate) fn len(&self) -> usize {
        self.items.len()
    }

    pub(crate) fn get(&self, id: u32) -> &T {
        &self.items[id as usize]
    }

    /// The id of `item`, and whether it is new.
    pub(crate) fn intern(&mut self, item: T) -> (u32, bool) {
        let Indexed { items, index } = self;
        let code = hash(&item);
        if let Some(&found) = index.find(code, |&id| items[id as usize] == item) {
            return (found, false);
        }
        let id = items.len() as u32;
        items.push(item);
        index.insert_unique(code, id, |&id| hash(&items[id as usize]));
        (id, true)
    }
}

/// Distinct rows of `width` values, side by side.
#[derive(Debug)]
pub(crate) struct Rows<T> {
    width: usize,
    values: Vec<T>,
    count: u32,
    index: HashTable<u32>,
}

impl<T: Copy + Eq + Hash> Rows<T> {
    /// None yet. A width of 0 is allowed: there is one such row.
    pub(crate) fn new(width: usize) -> Self {
        Rows { width, values: Vec::new(), count: 0, index: HashTable::new() }
    }

    pub(crate) fn width(&self) -> usize {
        self.width
    }

    pub(crate) fn len(&self) -> usize {
        self.count as usize
    }

    pub(crate) fn get(&self, id: u32) -> &[T] {
        nth(&self.values, self.width, id)
    }

    /// The id of `row`, whose length is the width.
    pub(crate) fn intern(&mut self, row: &[T]) -> u32 {
        debug_assert_eq!(row.len(), self.width);
        let Rows { width, values, count, index } = self;
        let code = hash(row);
        if let Some(&found) = index.find(code, |&id| nth(values, *width, id) == row) {
            return found;
        }
        let id = *count;
        *count += 1;
        values.extend_from_slice(row);
        index.insert_unique(code, id, |&id| hash(nth(values, *width, id)));
        id
    }

    /// The id of `row`, if it was interned.
    pub(crate) fn find(&self, row: &[T]) -> Option<u32> {
        self.index.find(hash(row), |&id| self.get(id) == row).copied()
    }

    /// Bytes held.
    pub(crate) fn memory(&self) -> usize {
        // The index has a byte of its own beside each id.
        self.values.capacity() * size_of::<T>() + self.index.capacity() * (size_of::<u32>() + 1)
    }
}

fn nth<T>(values: &[T], width: usize, id: u32) -> &[T] {
    &values[id as usize * width..(id as usize + 1) * width]
}

/// The same on every machine and in every run.
pub(crate) fn hash<T: Hash + ?Sized>(item: &T) -> u64 {
    let mut hasher = FxHasher::default();
    item.hash(&mut hasher);
    hasher.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_values_are_one() {
        let mut indexed = Indexed::default();
        assert_eq!(["a", "b", "a"].map(|item| indexed.intern(item)), [(0, true), (1, true), (0, false)]);
        assert_eq!((indexed.len(), *indexed.get(1)), (2, "b"));
    }

    #[test]
    fn equal_rows_are_one() {
        let mut rows = Rows::new(2);
        assert_eq!([[1, 2], [2, 1], [1, 2]].map(|row| rows.intern(&row)), [0, 1, 0]);
        assert_eq!((rows.len(), rows.get(1)), (2, &[2, 1][..]));
    }

    #[test]
    fn there_is_one_row_without_values() {
        let mut rows: Rows<u32> = Rows::new(0);
        assert_eq!([rows.intern(&[]), rows.intern(&[])], [0, 0]);
        assert_eq!((rows.len(), rows.get(0)), (1, &[][..]));
    }
}

//! Packed rows side by side, found by their contents.

use hashbrown::HashTable;

/// Distinct rows of some words each, numbered in the order in which they came.
#[derive(Debug)]
pub(crate) struct PackedRows {
    words: usize,
    values: Vec<u64>,
    count: u32,
    index: HashTable<u32>,
}

/// The same on every machine and in every run. The upper half of a product of 64 bits depends on all of the word; it is
/// folded back, as hash tables look at both ends.
#[inline]
pub(crate) fn hash_row(row: &[u64]) -> u64 {
    let mut hash: u64 = 0;
    for &word in row {
        hash = (hash.rotate_left(29) ^ word).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        hash ^= hash >> 32;
    }
    hash.wrapping_mul(0xd6e8_feb8_6659_fd93)
}

/// Makes room for more elements. A vector of many grows by an eighth: it is never half empty, and the system moves its
/// pages without copying.
pub(crate) fn reserve<T>(values: &mut Vec<T>, additional: usize) {
    if values.capacity() - values.len() < additional {
        if values.len() < 1 << 16 {
            values.reserve(additional);
        } else {
            values.reserve_exact(additional.max(values.len() / 8));
        }
    }
}

impl PackedRows {
    pub(crate) fn new(words: usize) -> Self {
        PackedRows { words, values: Vec::new(), count: 0, index: HashTable::new() }
    }

    pub(crate) fn words(&self) -> usize {
        self.words
    }

    pub(crate) fn len(&self) -> usize {
        self.count as usize
    }

    #[inline]
    pub(crate) fn get(&self, id: u32) -> &[u64] {
        nth(&self.values, self.words, id)
    }

    /// The id of a row with this hash, if it is there.
    #[inline]
    pub(crate) fn find(&self, hash: u64, row: &[u64]) -> Option<u32> {
        let PackedRows { words, values, index, .. } = self;
        if let &[word] = row {
            return index.find(hash, |&id| values[id as usize] == word).copied();
        }
        index.find(hash, |&id| nth(values, *words, id) == row).copied()
    }

    /// The id of a row with this hash, new or not.
    pub(crate) fn intern(&mut self, hash: u64, row: &[u64]) -> u32 {
        debug_assert_eq!(row.len(), self.words);
        if let Some(id) = self.find(hash, row) {
            return id;
        }
        let id = self.count;
        self.count += 1;
        reserve(&mut self.values, self.words);
        self.values.extend_from_slice(row);
        let PackedRows { words, values, index, .. } = self;
        index.insert_unique(hash, id, |&id| hash_row(nth(values, *words, id)));
        id
    }

    /// Bytes held.
    pub(crate) fn memory(&self) -> usize {
        // The index has a byte of its own beside each id, and fills seven of eight places.
        let places = self.index.capacity() * 8 / 7;
        self.values.capacity() * size_of::<u64>() + places * (size_of::<u32>() + 1)
    }
}

#[inline]
fn nth(values: &[u64], words: usize, id: u32) -> &[u64] {
    &values[id as usize * words..(id as usize + 1) * words]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_rows_are_one() {
        let mut rows = PackedRows::new(2);
        let mut intern = |row: [u64; 2]| rows.intern(hash_row(&row), &row);
        assert_eq!([[1, 2], [2, 1], [1, 2]].map(&mut intern), [0, 1, 0]);
        assert_eq!((rows.len(), rows.get(1)), (2, &[2, 1][..]));
        assert_eq!(rows.find(hash_row(&[3, 3]), &[3, 3]), None);
    }
}

//! Packed rows side by side, found by their contents.

use super::layout::Layout;
use hashbrown::HashTable;
use hashbrown::hash_table::Entry;

/// Distinct rows of some words each, numbered in the order in which they came. A row is held in the bytes that its
/// fields reach into.
#[derive(Debug)]
pub(crate) struct PackedRows {
    words: usize,
    /// Bytes of a row, and which bits of its last word they hold.
    bytes: usize,
    last: u64,
    /// The rows, and behind them as many bytes as make reading a whole word possible everywhere.
    values: Vec<u8>,
    count: u32,
    index: HashTable<u32>,
}

/// Bytes of a word.
const WORD: usize = size_of::<u64>();

/// The same on every machine and in every run. The upper half of a product of 64 bits depends on all of the word; it is
/// folded back, as hash tables look at both ends.
#[inline]
pub(crate) fn hash_row(row: &[u64]) -> u64 {
    row.iter().fold(0, |hash, &word| mixed(hash, word)).wrapping_mul(0xd6e8_feb8_6659_fd93)
}

#[inline]
fn mixed(hash: u64, word: u64) -> u64 {
    let hash = (hash.rotate_left(29) ^ word).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    hash ^ hash >> 32
}

/// Makes room for more elements. A vector of many grows by a sixteenth: next to nothing of it is empty, and the system
/// moves its pages without copying.
pub(crate) fn reserve<T>(values: &mut Vec<T>, additional: usize) {
    if values.capacity() - values.len() < additional {
        if values.len() < 1 << 16 {
            values.reserve(additional);
        } else {
            values.reserve_exact(additional.max(values.len() / 16));
        }
    }
}

impl PackedRows {
    /// For rows of this layout.
    pub(crate) fn new(layout: &Layout) -> Self {
        let (words, bytes) = (layout.words(), layout.bytes());
        let last = u64::MAX >> (u64::BITS as usize - 8 * (bytes - (words - 1) * WORD));
        PackedRows { words, bytes, last, values: vec![0; WORD], count: 0, index: HashTable::new() }
    }

    pub(crate) fn words(&self) -> usize {
        self.words
    }

    pub(crate) fn len(&self) -> usize {
        self.count as usize
    }

    /// A row, put into `row`.
    #[inline]
    pub(crate) fn get<'r>(&self, id: u32, row: &'r mut Vec<u64>) -> &'r [u64] {
        row.clear();
        row.extend((0..self.words).map(|word| self.word(id, word)));
        row
    }

    #[inline]
    fn word(&self, id: u32, word: usize) -> u64 {
        let start = id as usize * self.bytes + word * WORD;
        let bytes = self.values[start..].first_chunk().map_or(0, |bytes| u64::from_le_bytes(*bytes));
        if word + 1 == self.words { bytes & self.last } else { bytes }
    }

    #[inline]
    fn is(&self, id: u32, row: &[u64]) -> bool {
        row.iter().enumerate().all(|(word, &value)| self.word(id, word) == value)
    }

    fn hash(&self, id: u32) -> u64 {
        let hash = (0..self.words).fold(0, |hash, word| mixed(hash, self.word(id, word)));
        hash.wrapping_mul(0xd6e8_feb8_6659_fd93)
    }

    /// The id of a row with this hash, if it is there.
    #[inline]
    pub(crate) fn find(&self, hash: u64, row: &[u64]) -> Option<u32> {
        self.index.find(hash, |&id| self.is(id, row)).copied()
    }

    /// The id of a row with this hash, new or not.
    pub(crate) fn intern(&mut self, hash: u64, row: &[u64]) -> u32 {
        debug_assert_eq!(row.len(), self.words);
        if self.index.is_empty() && self.count > 0 {
            self.index_all();
        }
        // The rest of `self` is read while the index is written.
        let mut index = std::mem::take(&mut self.index);
        let id = match index.entry(hash, |&id| self.is(id, row), |&id| self.hash(id)) {
            Entry::Occupied(known) => *known.get(),
            Entry::Vacant(place) => *place.insert(self.count).get(),
        };
        self.index = index;
        if id == self.count {
            self.push(row);
        }
        id
    }

    /// Appends a row, which is not put into the index.
    fn push(&mut self, row: &[u64]) {
        let start = self.values.len() - WORD;
        reserve(&mut self.values, self.bytes);
        self.values.resize(start + self.bytes + WORD, 0);
        for (word, &value) in row.iter().enumerate() {
            if let Some(place) = self.values[start + word * WORD..].first_chunk_mut() {
                *place = value.to_le_bytes();
            }
        }
        self.count += 1;
    }

    fn index_all(&mut self) {
        let mut index = HashTable::with_capacity(self.len());
        for id in 0..self.count {
            index.insert_unique(self.hash(id), id, |&id| self.hash(id));
        }
        self.index = index;
    }

    /// All rows with their fields where another layout has them, which is wider.
    pub(crate) fn converted(self, from: &Layout, to: &Layout) -> PackedRows {
        let mut rows = PackedRows::new(to);
        rows.values.reserve_exact(self.len() * rows.bytes);
        // The old index goes before the new one comes.
        let old = PackedRows { index: HashTable::new(), ..self };
        let (mut narrow, mut wide) = (Vec::new(), vec![0; to.words()]);
        for id in 0..old.count {
            wide.fill(0);
            to.convert(from, old.get(id, &mut narrow), &mut wide);
            rows.push(&wide);
        }
        drop(old);
        rows.index_all();
        rows
    }

    /// These rows, which are numbered anew in this order.
    pub(crate) fn selected(&self, ids: &[u32]) -> PackedRows {
        let mut rows = PackedRows {
            words: self.words,
            bytes: self.bytes,
            last: self.last,
            values: vec![0; WORD],
            count: 0,
            index: HashTable::new(),
        };
        rows.values.reserve_exact(ids.len() * self.bytes);
        let mut row = Vec::new();
        for &id in ids {
            rows.push(self.get(id, &mut row));
        }
        rows
    }

    /// Gives up what only finding takes. It is made anew if another row comes.
    pub(crate) fn close(&mut self) {
        self.index = HashTable::new();
        self.values.shrink_to_fit();
    }

    /// Bytes held.
    pub(crate) fn memory(&self) -> usize {
        self.values.capacity() + self.index.allocation_size()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn layout(widths: &[u32]) -> Layout {
        let widest: Vec<(u32, u32)> =
            (0..).zip(widths.iter().map(|width| u32::MAX >> (32 - width))).collect();
        Layout::new(widths.len()).widened(&widest)
    }

    #[test]
    fn equal_rows_are_one() {
        let mut rows = PackedRows::new(&layout(&[32, 32, 3]));
        let mut intern = |row: [u64; 2]| rows.intern(hash_row(&row), &row);
        assert_eq!([[u64::MAX, 2], [2, 1], [u64::MAX, 2]].map(&mut intern), [0, 1, 0]);
        assert_eq!((rows.len(), rows.bytes), (2, 9));
        assert_eq!([0, 1].map(|id| rows.get(id, &mut Vec::new()).to_vec()), [[u64::MAX, 2], [2, 1]]);
        assert_eq!(rows.find(hash_row(&[3, 3]), &[3, 3]), None);
    }

    #[test]
    fn rows_are_found_after_all_that_happens_to_them() {
        let (narrow, wide) = (layout(&[3, 7]), layout(&[3, 31, 32]));
        let mut rows = PackedRows::new(&narrow);
        let all = || 0..1000_u64;
        all().for_each(|row| assert_eq!(rows.intern(hash_row(&[row]), &[row]), row as u32));
        rows.close();
        all().for_each(|row| assert_eq!(rows.intern(hash_row(&[row]), &[row]), row as u32));
        let mut rows = rows.converted(&narrow, &wide);
        for row in all() {
            let row = [row, 0];
            assert_eq!(rows.intern(hash_row(&row), &row), row[0] as u32);
        }
        assert_eq!((rows.len(), rows.bytes), (1000, 12));
    }
}

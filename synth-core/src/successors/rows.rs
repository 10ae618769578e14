//! Packed rows side by side, found by their contents.

use super::layout::Layout;
use crate::index::{Index, WINDOW, hash_words};

/// Distinct rows of some words each, numbered in the order in which they came. A row is held in the bytes that its
/// fields reach into.
#[derive(Debug)]
pub(crate) struct PackedRows {
    /// Per word: at which byte of a row it begins, and which of its bits are held.
    words: Vec<(usize, u64)>,
    /// Bytes of a row.
    bytes: usize,
    /// The rows, and behind them as many bytes as make reading a whole word possible everywhere.
    values: Vec<u8>,
    count: u32,
    index: Index,
}

/// Bytes of a word.
const WORD: usize = size_of::<u64>();

/// The hash by which a row is found.
#[inline]
pub(crate) fn hash_row(row: &[u64]) -> u64 {
    hash_words(row.iter().copied())
}

/// Makes room for more elements. A vector of many grows by a sixteenth: next to nothing of it is empty, and the system
/// moves its pages without copying. What is smaller may be copied each time, so it grows by more.
pub(crate) fn reserve<T>(values: &mut Vec<T>, additional: usize) {
    const COPIED: usize = 1 << 25;
    if values.capacity() - values.len() < additional {
        match values.len() * size_of::<T>() {
            0..=0xffff => values.reserve(additional),
            bytes => {
                let part = if bytes <= COPIED { 4 } else { 16 };
                values.reserve_exact(additional.max(values.len() / part));
            }
        }
    }
}

/// The bits that so many bytes hold, 8 at most.
fn bits(bytes: usize) -> u64 {
    u64::MAX.checked_shr(u64::BITS - 8 * bytes.min(WORD) as u32).unwrap_or(0)
}

impl PackedRows {
    /// For rows of so many bytes. With a tail there is one more word, of which so many bytes are held.
    pub(crate) fn new(bytes: usize, tail: usize) -> Self {
        let mut words: Vec<(usize, u64)> =
            (0..bytes).step_by(WORD).map(|start| (start, bits(bytes - start))).collect();
        if tail > 0 {
            words.push((bytes, bits(tail)));
        }
        PackedRows { words, bytes: bytes + tail, values: vec![0; WORD], count: 0, index: Index::default() }
    }

    /// Words of a row.
    pub(crate) fn words(&self) -> usize {
        self.words.len()
    }

    pub(crate) fn len(&self) -> usize {
        self.count as usize
    }

    /// A row, put into `row`.
    #[inline]
    pub(crate) fn get<'r>(&self, id: u32, row: &'r mut Vec<u64>) -> &'r [u64] {
        row.clear();
        row.extend(self.row(id));
        row
    }

    #[inline]
    fn row(&self, id: u32) -> impl Iterator<Item = u64> {
        let row = &self.values[id as usize * self.bytes..];
        self.words.iter().map(|&(start, bits)| {
            let word = row[start..].first_chunk().map_or(0, |bytes| u64::from_le_bytes(*bytes));
            word & bits
        })
    }

    #[inline]
    fn is(&self, id: u32, row: &[u64]) -> bool {
        self.row(id).zip(row).all(|(word, &wanted)| word == wanted)
    }

    fn hash(&self, id: u32) -> u64 {
        hash_words(self.row(id))
    }

    /// For each of many rows, side by side with their hashes, its id or `none`, into a cleared list.
    pub(crate) fn find_all(&self, hashes: &[u64], rows: &[u64], none: u32, found: &mut Vec<u32>) {
        self.index.fetch(hashes);
        found.clear();
        let rows = rows.chunks_exact(self.words());
        let ids = hashes.iter().zip(rows).map(|(&hash, row)| self.index.find(hash, |id| self.is(id, row)));
        found.extend(ids.map(|id| id.unwrap_or(none)));
    }

    /// Prepares for interning rows with these hashes.
    pub(crate) fn fetch(&self, hashes: &[u64]) {
        self.index.fetch(hashes);
    }

    /// The id of a row with this hash, new or not.
    pub(crate) fn intern(&mut self, hash: u64, row: &[u64]) -> u32 {
        debug_assert_eq!(row.len(), self.words());
        if !self.index.has_room() {
            self.index_all();
        }
        if let Some(id) = self.index.find(hash, |id| self.is(id, row)) {
            return id;
        }
        let id = self.count;
        self.index.insert(hash, id);
        self.push(row);
        id
    }

    /// Appends a row, which is not put into the index.
    fn push(&mut self, row: &[u64]) {
        let start = self.values.len() - WORD;
        reserve(&mut self.values, self.bytes);
        self.values.resize(start + self.bytes + WORD, 0);
        // In their order: what a word has beyond its bits, the next one overwrites.
        for (&(offset, _), &value) in self.words.iter().zip(row) {
            if let Some(place) = self.values[start + offset..].first_chunk_mut() {
                *place = value.to_le_bytes();
            }
        }
        self.count += 1;
    }

    /// Makes the index anew, with room for more rows. The old one goes first: rows are read in their order, and say it all.
    fn index_all(&mut self) {
        self.index = Index::default();
        let mut index = Index::with_room_for(self.len() + 1);
        let mut hashes = Vec::with_capacity(WINDOW);
        for start in (0..self.count).step_by(WINDOW) {
            hashes.clear();
            hashes.extend((start..self.count).take(WINDOW).map(|id| self.hash(id)));
            index.fetch(&hashes);
            (start..).zip(&hashes).for_each(|(id, &hash)| index.insert(hash, id));
        }
        self.index = index;
    }

    /// All rows with their fields where another layout has them, which is wider. Tails stay.
    pub(crate) fn converted(self, from: &Layout, to: &Layout) -> PackedRows {
        let tail = self.bytes - from.bytes();
        let mut rows = PackedRows::new(to.bytes(), tail);
        rows.values.reserve_exact(self.len() * rows.bytes);
        // The old index goes before the new one comes.
        let old = PackedRows { index: Index::default(), ..self };
        let runs = runs(from, to);
        let (mut narrow, mut wide) = (Vec::new(), vec![0; rows.words()]);
        for id in 0..old.count {
            let narrow = old.get(id, &mut narrow);
            wide.fill(0);
            for run in &runs {
                wide[run.to] |= (narrow[run.from] & run.bits).rotate_left(run.shift);
            }
            if tail > 0 {
                wide[to.words()] = narrow[from.words()];
            }
            rows.push(&wide);
        }
        drop(old);
        rows.index_all();
        rows
    }

    /// These rows, which are numbered anew in this order.
    pub(crate) fn selected(&self, ids: &[u32]) -> PackedRows {
        let mut rows = PackedRows {
            words: self.words.clone(),
            bytes: self.bytes,
            values: vec![0; WORD],
            count: 0,
            index: Index::default(),
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
        self.index = Index::default();
        self.values.shrink_to_fit();
    }

    /// Bytes held.
    pub(crate) fn memory(&self) -> usize {
        self.values.capacity() + self.index.memory()
    }
}

/// Bits of one word that go to another together.
struct Run {
    from: usize,
    to: usize,
    bits: u64,
    /// By how many bits to the left, around the end.
    shift: u32,
}

/// Where one layout has the bits of another. Few fields change between two layouts, so there are few runs.
fn runs(from: &Layout, to: &Layout) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    let (mut one, mut row) = (vec![0; from.words()], vec![0; to.words()]);
    for place in 0..from.words() * u64::BITS as usize {
        let (word, bit) = (place / u64::BITS as usize, 1 << (place % u64::BITS as usize));
        one[word] = bit;
        row.fill(0);
        to.convert(from, &one, &mut row);
        one[word] = 0;
        let Some(target) = row.iter().position(|&word| word != 0) else { continue };
        let shift = (row[target].trailing_zeros() + u64::BITS - bit.trailing_zeros()) % u64::BITS;
        match runs.last_mut() {
            Some(run) if (run.from, run.to, run.shift) == (word, target, shift) => run.bits |= bit,
            _ => runs.push(Run { from: word, to: target, bits: bit, shift }),
        }
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::collection::vec;
    use proptest::prelude::{any, prop_assert_eq, proptest};

    fn layout(widths: &[u32]) -> Layout {
        let widest: Vec<(u32, u32)> =
            (0..).zip(widths.iter().map(|width| u32::MAX >> (32 - width))).collect();
        Layout::new(widths.len()).widened(&widest)
    }

    /// What is found of rows of two words, 9 for nothing.
    fn found(rows: &PackedRows, wanted: &[[u64; 2]]) -> Vec<u32> {
        let hashes: Vec<u64> = wanted.iter().map(|row| hash_row(row)).collect();
        let mut found = Vec::new();
        rows.find_all(&hashes, wanted.as_flattened(), 9, &mut found);
        found
    }

    #[test]
    fn equal_rows_are_one() {
        let mut rows = PackedRows::new(layout(&[32, 32, 3]).bytes(), 0);
        let mut intern = |row: [u64; 2]| rows.intern(hash_row(&row), &row);
        assert_eq!([[u64::MAX, 2], [2, 1], [u64::MAX, 2]].map(&mut intern), [0, 1, 0]);
        assert_eq!((rows.len(), rows.bytes), (2, 9));
        assert_eq!([0, 1].map(|id| rows.get(id, &mut Vec::new()).to_vec()), [[u64::MAX, 2], [2, 1]]);
        assert_eq!(found(&rows, &[[2, 1], [3, 3]]), [1, 9]);
    }

    #[test]
    fn rows_are_found_after_all_that_happens_to_them() {
        let (narrow, wide) = (layout(&[3, 7]), layout(&[3, 31, 32]));
        let mut rows = PackedRows::new(narrow.bytes(), 0);
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

    #[test]
    fn tails_stay_where_they_are() {
        let (narrow, wide) = (layout(&[5, 6]), layout(&[5, 9]));
        let mut rows = PackedRows::new(narrow.bytes(), 3);
        let all = [[0, 0], [0x7ff, 0xff_ffff], [1, 0x12_3456], [1, 0x12_3457]];
        let ids = all.map(|row| rows.intern(hash_row(&row), &row));
        assert_eq!(ids, [0, 1, 2, 3]);
        assert_eq!((rows.len(), rows.bytes), (4, 5));
        assert_eq!(found(&rows, &[all[3], all[1], [2, 0]]), [3, 1, 9]);
        let rows = rows.converted(&narrow, &wide);
        assert_eq!(found(&rows, &all), [0, 1, 2, 3]);
    }

    proptest! {
        /// A layout says itself where its fields go.
        #[test]
        fn runs_do_what_layouts_say(
            widths in vec((0..20_u32, 0..4_u32), 1..20),
            values in vec(any::<u32>(), 20),
        ) {
            let narrow: Vec<u32> = widths.iter().map(|width| width.0).collect();
            let wide: Vec<u32> = widths.iter().map(|width| width.0 + width.1).collect();
            let (from, to) = (Layout::of_widths(&narrow), Layout::of_widths(&wide));
            let mut row = vec![0; from.words()];
            for (field, &value) in (0..narrow.len()).zip(&values) {
                from.field(field).write(&mut row, value & ((1 << narrow[field]) - 1));
            }
            let mut expect = vec![0; to.words()];
            to.convert(&from, &row, &mut expect);
            let mut rows = PackedRows::new(from.bytes(), 0);
            rows.intern(hash_row(&row), &row);
            let rows = rows.converted(&from, &to);
            prop_assert_eq!(rows.row(0).collect::<Vec<u64>>(), expect);
        }
    }
}

//! Rows that were found lately. Most edges lead to a row that others lead to, too; those that are still known here need
//! not be written, sorted and looked for.

use crate::successors::hash_row;

/// Remembers some of the rows that it was told of: the last one for each place.
#[derive(Debug)]
pub(super) struct Recent {
    words: usize,
    places: Vec<u64>,
    mask: usize,
}

/// Fills places that have no row. A row of such words is never remembered.
const NONE: u64 = u64::MAX;

impl Recent {
    /// With room for at most so many rows.
    pub(super) fn new(words: usize, most: usize) -> Recent {
        let count = if most.is_power_of_two() { most } else { most.next_power_of_two() / 2 }.max(1);
        Recent { words, places: vec![NONE; count * words], mask: count - 1 }
    }

    pub(super) fn rows(&self) -> usize {
        self.mask + 1
    }

    /// Remembers a row; whether it was known.
    #[inline]
    pub(super) fn knows(&mut self, row: &[u64]) -> bool {
        // The upper bits of the hash are the better ones.
        let place = (hash_row(row) >> 24) as usize & self.mask;
        let known = &mut self.places[place * self.words..(place + 1) * self.words];
        if known == row {
            return row.iter().any(|&word| word != NONE);
        }
        known.copy_from_slice(row);
        false
    }

    pub(super) fn memory(&self) -> usize {
        self.places.capacity() * size_of::<u64>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_it_knows_it_was_told() {
        let mut recent = Recent::new(2, 9);
        assert_eq!((recent.rows(), recent.memory()), (8, 128));
        let mut told = std::collections::BTreeSet::new();
        let mut known = 0;
        for i in 0..1000_u64 {
            let row = [i * i % 31, i % 3];
            let knows = recent.knows(&row);
            assert!(!knows || told.contains(&row));
            known += usize::from(knows);
            told.insert(row);
            assert!(recent.knows(&row));
        }
        assert!(known > 0);
        assert!(!recent.knows(&[NONE; 2]) && !recent.knows(&[NONE; 2]));
    }
}

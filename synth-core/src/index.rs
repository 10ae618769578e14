//! Numbers found by hashes of words, in half the memory accesses of a general table.

use std::hint::black_box;

/// So much is looked up or added at a time: the places are fetched together, which takes hardly longer than one.
pub(crate) const WINDOW: usize = 256;

/// The same on every machine and in every run. The upper half of a product of 64 bits depends on all of the word; it is
/// folded back, as tables look at both ends.
#[inline]
pub(crate) fn hash_words(words: impl Iterator<Item = u64>) -> u64 {
    words.fold(0, mixed).wrapping_mul(0xd6e8_feb8_6659_fd93)
}

#[inline]
fn mixed(hash: u64, word: u64) -> u64 {
    let hash = (hash.rotate_left(29) ^ word).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    hash ^ hash >> 32
}

/// Numbers of rows that someone else holds, each below how many there are. A slot is a word of 32 bits, and a search begins at the slot
/// that the upper bits of the hash name; the lower bits of the hash fill what the number leaves of the word, so a row is seldom
/// looked at in vain.
#[derive(Debug, Default)]
pub(crate) struct Index {
    /// As many as a power of two, or none.
    slots: Vec<u32>,
    /// The bits of a slot that hold a number.
    mask: u32,
    len: usize,
}

/// A slot without a number: the greatest number has no place, since a quarter of the slots is empty.
const EMPTY: u32 = u32::MAX;

/// Fewest slots, unless there are none.
const FEWEST: usize = 16;

impl Index {
    /// Has room for so many numbers.
    pub(crate) fn with_room_for(count: usize) -> Self {
        let slots = (count + count / 3 + 1).next_power_of_two().max(FEWEST);
        Index { slots: vec![EMPTY; slots], mask: (slots as u64 - 1) as u32, len: 0 }
    }

    /// Whether there is room for another number.
    pub(crate) fn has_room(&self) -> bool {
        self.len < self.slots.len() / 4 * 3
    }

    pub(crate) fn clear(&mut self) {
        if self.len > 0 {
            self.slots.fill(EMPTY);
            self.len = 0;
        }
    }

    #[inline]
    fn home(&self, hash: u64) -> usize {
        // The same as shifting right, in which no slots at all would be a case of its own.
        ((u128::from(hash) * self.slots.len() as u128) >> u64::BITS) as usize
    }

    /// The first number behind this hash for which `is` holds.
    #[inline]
    pub(crate) fn find(&self, hash: u64, is: impl Fn(u32) -> bool) -> Option<u32> {
        let mut at = self.home(hash);
        loop {
            let slot = *self.slots.get(at)?;
            if slot == EMPTY {
                return None;
            }
            if (slot ^ hash as u32) & !self.mask == 0 && is(slot & self.mask) {
                return Some(slot & self.mask);
            }
            at = (at + 1) & self.mask as usize;
        }
    }

    /// Adds a number for which there is room.
    #[inline]
    pub(crate) fn insert(&mut self, hash: u64, number: u32) {
        debug_assert!(self.has_room() && number & !self.mask == 0);
        let mut at = self.home(hash);
        while self.slots[at] != EMPTY {
            at = (at + 1) & self.mask as usize;
        }
        self.slots[at] = hash as u32 & !self.mask | number;
        self.len += 1;
    }

    /// Lets the processor fetch the slots of many hashes at once, since searching them one by one waits for each.
    pub(crate) fn fetch(&self, hashes: &[u64]) {
        let slots = hashes.iter().filter_map(|&hash| self.slots.get(self.home(hash)));
        black_box(slots.fold(0, |all, &slot| all ^ slot));
    }

    /// Bytes held.
    pub(crate) fn memory(&self) -> usize {
        self.slots.capacity() * size_of::<u32>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::collection::vec;
    use proptest::prelude::{any, prop_assert_eq, proptest};

    #[test]
    fn nothing_is_found_in_nothing() {
        let index = Index::default();
        index.fetch(&[0, u64::MAX]);
        assert_eq!([0, 7, u64::MAX].map(|hash| index.find(hash, |_| true)), [None; 3]);
        assert!(!index.has_room());
    }

    #[test]
    fn there_is_as_much_room_as_asked_for() {
        for count in 0..1000 {
            let mut index = Index::with_room_for(count);
            // The worst of hashes: all begin at the last slot, with the bits of an empty one.
            (0..count as u32).for_each(|number| index.insert(u64::MAX, number));
            for number in [0, count as u32 / 2, count as u32] {
                let found = index.find(u64::MAX, |one| one == number);
                assert_eq!(found, (number < count as u32).then_some(number));
            }
            assert_eq!(index.find(0, |_| true), None);
        }
    }

    proptest! {
        #[test]
        fn whatever_was_inserted_is_found(hashes in vec(any::<u64>(), 0..200), others in vec(any::<u64>(), 20)) {
            let mut index = Index::with_room_for(hashes.len());
            (0..).zip(&hashes).for_each(|(number, &hash)| index.insert(hash, number));
            for hash in hashes.iter().chain(&others) {
                let first = hashes.iter().position(|one| one == hash).map(|first| first as u32);
                prop_assert_eq!(index.find(*hash, |number| hashes[number as usize] == *hash), first);
            }
            index.clear();
            prop_assert_eq!(hashes.iter().find_map(|&hash| index.find(hash, |_| true)), None);
        }
    }
}

//! What the copies of a state ask for: sets of events by class, each as bits in the order of the events' texts.

use super::tables::class;

/// Sets of events. Those of relaxed scenarios are kept beside the others.
#[derive(Clone, Debug, Default)]
pub(super) struct Wishes {
    /// Two sets a class, `words` words each.
    bits: Vec<u64>,
    words: usize,
    /// Which sets are not empty, as bits.
    some: u32,
}

impl Wishes {
    /// No wishes, for so many events.
    pub(super) fn clear(&mut self, events: usize) {
        let words = events.div_ceil(u64::BITS as usize);
        if words != self.words {
            self.words = words;
            self.bits.clear();
            self.bits.resize(2 * class::COUNT * words, 0);
        }
        while self.some != 0 {
            let set = self.some.trailing_zeros() as usize;
            self.bits[set * words..(set + 1) * words].fill(0);
            self.some &= self.some - 1;
        }
    }

    #[inline]
    pub(super) fn insert(&mut self, class: u8, relaxed: bool, rank: u32) {
        let set = 2 * u32::from(class) + u32::from(relaxed);
        self.some |= 1 << set;
        self.bits[set as usize * self.words + (rank / u64::BITS) as usize] |= 1 << (rank % u64::BITS);
    }

    /// Whether an event of this class is asked for.
    #[inline]
    pub(super) fn has(&self, class: u8) -> bool {
        self.some >> (2 * class) & 3 != 0
    }

    /// Whether more than relaxed scenarios ask for an event, if any do.
    pub(super) fn asks(&self, class: u8, rank: u32) -> Option<bool> {
        let (all, firm) = self.word(class, (rank / u64::BITS) as usize);
        let bit = 1 << (rank % u64::BITS);
        (all & bit != 0).then_some(firm & bit != 0)
    }

    /// Words of a set.
    pub(super) fn words(&self) -> usize {
        self.words
    }

    /// Part of the set of all events of a class that are asked for, and of that without what only relaxed scenarios
    /// ask for.
    #[inline]
    pub(super) fn word(&self, class: u8, index: usize) -> (u64, u64) {
        let place = 2 * usize::from(class) * self.words + index;
        let firm = self.bits[place];
        (firm | self.bits[place + self.words], firm)
    }

    /// Adds all events of a class to a set.
    pub(super) fn add_to(&self, class: u8, set: &mut [u64]) {
        if self.has(class) {
            for (index, word) in set.iter_mut().enumerate() {
                *word |= self.word(class, index).0;
            }
        }
    }
}

/// Takes the first of some bits, which begin with number 64 times `index`.
#[inline]
pub(super) fn take(bits: &mut u64, index: usize) -> usize {
    let bit = bits.trailing_zeros() as usize;
    *bits &= *bits - 1;
    index * u64::BITS as usize + bit
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_class_has_what_was_asked_for_since_it_was_cleared() {
        let mut wishes = Wishes::default();
        let mut set = [0; 2];
        for _ in 0..2 {
            wishes.clear(100);
            assert!((0..class::COUNT as u8).all(|class| !wishes.has(class)));
            wishes.insert(class::SYSTEM_URGENT, true, 3);
            wishes.insert(class::SYSTEM_URGENT, false, 99);
            wishes.insert(class::ENVIRONMENT, true, 0);
            assert!(wishes.has(class::SYSTEM_URGENT) && !wishes.has(class::SYSTEM_COMMITTED));
            assert_eq!(wishes.word(class::SYSTEM_URGENT, 0), (1 << 3, 0));
            assert_eq!(wishes.word(class::SYSTEM_URGENT, 1), (1 << 35, 1 << 35));
            let asked = [3, 99, 4].map(|rank| wishes.asks(class::SYSTEM_URGENT, rank));
            assert_eq!(asked, [Some(false), Some(true), None]);
            set.fill(0);
            (0..class::COUNT as u8).for_each(|class| wishes.add_to(class, &mut set));
            assert_eq!(set, [1 | 1 << 3, 1 << 35]);
        }
        wishes.clear(20);
        wishes.insert(class::ENVIRONMENT, false, 19);
        assert_eq!((wishes.words(), wishes.word(class::ENVIRONMENT, 0)), (1, (1 << 19, 1 << 19)));
    }

    #[test]
    fn bits_are_taken_in_order() {
        let mut bits = 1 << 5 | 1 << 63;
        assert_eq!((take(&mut bits, 1), take(&mut bits, 1), bits), (69, 127, 0));
    }
}

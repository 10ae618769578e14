//! Sets of events, one bit each.

use core::fmt;

use crate::Column;

/// A set of numbers below `32 * W`; larger ones are never members.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bits<const W: usize> {
    words: [u32; W],
}

impl<const W: usize> Bits<W> {
    /// The set whose member `32 * i + j` is bit `j` of `words[i]`.
    #[must_use]
    pub const fn new(words: [u32; W]) -> Self {
        Bits { words }
    }

    /// The set of a state: `set_of[state]` is its position among `sets`, of `W` words each.
    ///
    /// Where either column ends, the set is empty.
    #[must_use]
    pub fn of_state(set_of: &impl Column, sets: &impl Column<Number = u32>, state: u32) -> Self {
        let mut words = [0; W];
        if let Some(set) = set_of.get(state as usize) {
            let first = W.saturating_mul(set.into() as usize);
            for (i, word) in words.iter_mut().enumerate() {
                *word = sets.get(first.saturating_add(i)).unwrap_or(0);
            }
        }
        Bits { words }
    }

    /// Adds a number; `false` if it was a member already.
    #[inline]
    pub fn insert(&mut self, number: usize) -> bool {
        let Some(word) = self.words.get_mut(number / 32) else { return false };
        let before = *word;
        *word |= 1 << (number % 32);
        *word != before
    }

    /// Takes a number out.
    #[inline]
    pub fn remove(&mut self, number: usize) {
        if let Some(word) = self.words.get_mut(number / 32) {
            *word &= !(1 << (number % 32));
        }
    }

    /// Whether a number is a member.
    #[inline]
    #[must_use]
    pub fn contains(&self, number: usize) -> bool {
        self.words.get(number / 32).is_some_and(|word| word >> (number % 32) & 1 != 0)
    }

    /// Whether there are no members.
    #[inline]
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.words.iter().all(|&word| word == 0)
    }

    /// What [`new`](Self::new) takes.
    #[inline]
    #[must_use]
    pub const fn words(self) -> [u32; W] {
        self.words
    }

    /// The members in ascending order.
    #[inline]
    #[must_use]
    pub const fn ones(self) -> Ones<W> {
        Ones { words: self.words, word: 0 }
    }
}

impl<const W: usize> fmt::Debug for Bits<W> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_set().entries(self.ones()).finish()
    }
}

/// Members of [`Bits`] in ascending order.
#[derive(Clone, Debug)]
pub struct Ones<const W: usize> {
    words: [u32; W],
    word: usize,
}

impl<const W: usize> Iterator for Ones<W> {
    type Item = usize;

    #[inline]
    fn next(&mut self) -> Option<usize> {
        loop {
            let rest = self.words.get_mut(self.word)?;
            if *rest != 0 {
                let bit = rest.trailing_zeros() as usize;
                *rest &= *rest - 1;
                return Some(32 * self.word + bit);
            }
            self.word += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_set_over_several_words() {
        let mut set = Bits::new([0; 3]);
        assert!(set.is_empty());
        for number in [69, 31, 32, 0] {
            assert!(set.insert(number));
            assert!(!set.insert(number));
            assert!(set.contains(number));
        }
        assert!(set.ones().eq([0, 31, 32, 69]));
        set.remove(32);
        assert!(!set.contains(32) && set.contains(31));
        assert!(set.ones().eq([0, 31, 69]));
    }

    #[test]
    fn sets_of_states() {
        let (set_of, sets) = ([0, 1, 0, 2_u8], [1, 0, 0, 1 << 31, 7]);
        let of = |state| Bits::<2>::of_state(&set_of, &sets, state);
        assert_eq!(of(0), Bits::new([1, 0]));
        assert_eq!(of(1), Bits::new([0, 1 << 31]));
        assert_eq!(of(2), of(0));
        assert_eq!(of(3), Bits::new([7, 0]));
        assert!(of(4).is_empty());
    }

    #[test]
    fn numbers_beyond_the_end_are_no_members() {
        let mut none = Bits::new([]);
        assert!(!none.insert(0) && !none.contains(0) && none.is_empty());
        assert_eq!(none.ones().next(), None);
        let mut one = Bits::new([u32::MAX]);
        one.remove(32);
        assert!(!one.insert(32) && !one.contains(32));
        assert_eq!(one.ones().count(), 32);
    }
}

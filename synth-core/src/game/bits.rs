//! Squares of bits: many sets of states at once, and what is in many sets for one state.

use fixedbitset::FixedBitSet;

/// Bits of a word, and so the sets that are looked at together.
pub(super) const BITS: usize = usize::BITS as usize;

/// Per number below `states` the sets that it is in, as the bits of a word. There are at most [`BITS`] sets.
pub(super) fn by_state(states: usize, sets: &[&FixedBitSet]) -> Vec<usize> {
    let mut words = Vec::with_capacity(states);
    for block in 0..states.div_ceil(BITS) {
        let mut square = [0; BITS];
        square.iter_mut().zip(sets).for_each(|(row, set)| *row = set.as_slice()[block]);
        transpose(&mut square);
        words.extend_from_slice(&square[..BITS.min(states - words.len())]);
    }
    words
}

/// The sets that are given by the bits of a word for each state, as many as there are `sets`.
pub(super) fn by_set(sets: usize, mut words: impl ExactSizeIterator<Item = usize>) -> Vec<FixedBitSet> {
    let states = words.len();
    let mut blocks = vec![Vec::with_capacity(states.div_ceil(BITS)); sets];
    while words.len() > 0 {
        let mut square = [0; BITS];
        square.iter_mut().zip(&mut words).for_each(|(row, word)| *row = word);
        transpose(&mut square);
        blocks.iter_mut().zip(square).for_each(|(blocks, row)| blocks.push(row));
    }
    blocks.into_iter().map(|blocks| FixedBitSet::with_capacity_and_blocks(states, blocks)).collect()
}

/// Makes columns rows, by swapping smaller and smaller quarters.
fn transpose(square: &mut [usize; BITS]) {
    let mut size = BITS / 2;
    let mut low = usize::MAX >> size;
    while size > 0 {
        for row in (0..BITS).filter(|row| row & size == 0) {
            let swap = (square[row] >> size ^ square[row + size]) & low;
            square[row] ^= swap << size;
            square[row + size] ^= swap;
        }
        size /= 2;
        low ^= low << size;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::collection::vec;
    use proptest::prelude::{any, prop_assert, prop_assert_eq, proptest};

    proptest! {
        #[test]
        fn sets_and_words_say_the_same(words in vec(any::<usize>(), 0..300), sets in 1..=BITS) {
            let found = by_set(sets, words.iter().copied());
            prop_assert_eq!(found.len(), sets);
            for (state, word) in words.iter().enumerate() {
                prop_assert!((0..sets).all(|set| found[set].contains(state) == (word >> set & 1 == 1)));
            }
            let mask = usize::MAX >> (BITS - sets);
            let back = by_state(words.len(), &found.iter().collect::<Vec<_>>());
            prop_assert_eq!(back, words.iter().map(|word| word & mask).collect::<Vec<_>>());
        }
    }
}

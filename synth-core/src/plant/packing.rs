//! States of several automata in a few words.

/// Where the state of one automaton lies in a row; it never crosses a word.
#[derive(Clone, Copy, Debug)]
struct Field {
    word: usize,
    shift: u32,
    mask: u64,
}

/// Where the states of all automata lie. The first automaton has the most significant bits of the first word, so rows
/// compare as the states do, lexicographically.
#[derive(Clone, Debug)]
pub(super) struct Packing {
    fields: Vec<Field>,
    words: usize,
}

impl Packing {
    /// For automata with so many states each.
    pub(super) fn new(sizes: impl Iterator<Item = usize>) -> Self {
        let (mut words, mut free) = (1, u64::BITS);
        let mut fields = Vec::new();
        for size in sizes {
            let width = usize::BITS - size.saturating_sub(1).leading_zeros();
            if width > free {
                (words, free) = (words + 1, u64::BITS);
            }
            free -= width;
            // Of width 0 behind 64 full bits the shift may be anything.
            fields.push(Field { word: words - 1, shift: free.min(63), mask: (1 << width) - 1 });
        }
        Packing { fields, words }
    }

    /// Words of a row.
    pub(super) fn words(&self) -> usize {
        self.words
    }

    /// Writes the states of all automata.
    pub(super) fn pack(&self, states: &[u16], row: &mut [u64]) {
        row.fill(0);
        for (field, &state) in self.fields.iter().zip(states) {
            row[field.word] |= u64::from(state) << field.shift;
        }
    }

    /// Reads the states of all automata.
    pub(super) fn unpack(&self, row: &[u64], states: &mut [u16]) {
        for (field, state) in self.fields.iter().zip(states) {
            *state = (row[field.word] >> field.shift & field.mask) as u16;
        }
    }

    /// Writes the state of one automaton.
    pub(super) fn set(&self, row: &mut [u64], automaton: u32, state: u16) {
        let Field { word, shift, mask } = self.fields[automaton as usize];
        row[word] = row[word] & !(mask << shift) | u64::from(state) << shift;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(sizes: &[usize], words: usize, lesser: &[u16], greater: &[u16]) {
        let packing = Packing::new(sizes.iter().copied());
        assert_eq!(packing.words(), words);
        let (mut a, mut b) = (vec![0; words], vec![u64::MAX; words]);
        packing.pack(lesser, &mut a);
        packing.pack(greater, &mut b);
        assert!(a < b);
        for (automaton, &state) in greater.iter().enumerate() {
            packing.set(&mut a, automaton as u32, state);
        }
        assert_eq!(a, b);
        let mut read = vec![0; sizes.len()];
        packing.unpack(&b, &mut read);
        assert_eq!(read, greater);
    }

    #[test]
    fn rows_read_back_and_compare_as_their_states() {
        check(&[4, 2, 4, 4], 1, &[0, 1, 3, 3], &[1, 0, 0, 0]);
        check(&[1, 3, 1], 1, &[0, 1, 0], &[0, 2, 0]);
        check(&[1 << 16; 4], 1, &[7, 65535, 65535, 65535], &[8, 0, 0, 1]);
        check(&[1 << 16, 1 << 16, 1 << 16, 1 << 16, 1], 1, &[0, 0, 0, 0, 0], &[9, 0, 0, 1, 0]);
        check(&[1 << 16; 5], 2, &[0, 0, 0, 1, 65535], &[0, 0, 0, 2, 0]);
        check(&[3; 33], 2, &[0; 33], &[2; 33]);
    }
}

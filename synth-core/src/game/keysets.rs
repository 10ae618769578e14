//! Interned sets of fairness keys: few distinct ones, shared by many states and edges. A set is a bit for each key.

use crate::index::{Index, hash_words};

/// All distinct sets; set 0 is the empty one.
#[derive(Clone, Debug)]
pub struct KeySets {
    keys: u32,
    /// Words of a set, at least one.
    words: usize,
    bits: Vec<u64>,
}

impl KeySets {
    /// Number of keys; ids are below it.
    #[must_use]
    pub fn keys(&self) -> u32 {
        self.keys
    }

    /// Number of distinct sets.
    #[must_use]
    pub fn len(&self) -> usize {
        self.bits.len() / self.words
    }

    /// Never: set 0 always exists.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        false
    }

    /// The members of a set, ascending.
    pub fn members(&self, set: u32) -> impl Iterator<Item = u32> + Clone + use<'_> {
        self.row(set).iter().enumerate().flat_map(|(index, &word)| {
            let mut rest = word;
            std::iter::from_fn(move || {
                let bit = (rest != 0).then(|| rest.trailing_zeros())?;
                rest &= rest - 1;
                Some(index as u32 * u64::BITS + bit)
            })
        })
    }

    /// Whether a key is in a set.
    #[must_use]
    #[inline]
    pub fn contains(&self, set: u32, key: u32) -> bool {
        let word = self.row(set).get((key / u64::BITS) as usize);
        word.is_some_and(|word| word >> (key % u64::BITS) & 1 != 0)
    }

    /// Which of the keys from `first` on, as many as a `usize` has bits and a multiple of that, are in a set.
    #[inline]
    pub(super) fn word(&self, set: u32, first: u32) -> usize {
        (self.row(set)[(first / u64::BITS) as usize] >> (first % u64::BITS)) as usize
    }

    /// Bytes held.
    #[must_use]
    pub fn memory(&self) -> usize {
        self.bits.capacity() * size_of::<u64>()
    }

    fn row(&self, set: u32) -> &[u64] {
        &self.bits[set as usize * self.words..(set as usize + 1) * self.words]
    }
}

/// Collects sets while a game is explored.
#[derive(Debug)]
pub struct KeySetsBuilder {
    sets: KeySets,
    index: Index,
}

impl Default for KeySetsBuilder {
    fn default() -> Self {
        let sets = KeySets { keys: 0, words: 1, bits: Vec::new() };
        let mut builder = KeySetsBuilder { sets, index: Index::default() };
        builder.intern(&[]);
        builder
    }
}

impl KeySetsBuilder {
    /// The id of a set; `members` must be ascending without duplicates.
    pub fn intern(&mut self, members: &[u32]) -> u32 {
        debug_assert!(members.windows(2).all(|pair| pair[0] < pair[1]));
        let mut bits = vec![0; words_for(members.last().map_or(0, |last| last + 1))];
        for &key in members {
            insert(&mut bits, key);
        }
        self.intern_bits(&bits)
    }

    /// The id of a set, given as a bit for each key, 64 a word; words that are left out are 0.
    pub(crate) fn intern_bits(&mut self, bits: &[u64]) -> u32 {
        self.intern_hashed(hash_set(bits), bits)
    }

    /// The same where the hash is known.
    pub(crate) fn intern_hashed(&mut self, hash: u64, bits: &[u64]) -> u32 {
        if let Some(set) = self.find_hashed(hash, bits) {
            return set;
        }
        let bits = significant(bits);
        if bits.len() > self.sets.words {
            self.widen(bits.len());
        }
        let KeySetsBuilder { sets, index } = self;
        let set = sets.len() as u32;
        if !index.has_room() {
            *index = Index::with_room_for(sets.len() + 1);
            (0..set).for_each(|set| index.insert(hash_set(sets.row(set)), set));
        }
        index.insert(hash, set);
        sets.bits.extend_from_slice(bits);
        sets.bits.resize((set as usize + 1) * sets.words, 0);
        let keys = bits.len() as u32 * u64::BITS - bits.last().map_or(0, |last| last.leading_zeros());
        sets.keys = sets.keys.max(keys);
        set
    }

    /// The id of a set given like this, if it was met before.
    pub(crate) fn find_bits(&self, bits: &[u64]) -> Option<u32> {
        self.find_hashed(hash_set(bits), bits)
    }

    /// The same where the hash is known.
    pub(crate) fn find_hashed(&self, hash: u64, bits: &[u64]) -> Option<u32> {
        self.index.find(hash, |set| significant(self.sets.row(set)) == significant(bits))
    }

    /// Prepares for sets with these hashes.
    pub(crate) fn fetch(&self, hashes: &[u64]) {
        self.index.fetch(hashes);
    }

    /// Makes room for more keys, which happens seldom.
    fn widen(&mut self, words: usize) {
        let sets = &mut self.sets;
        let mut wider = Vec::with_capacity(sets.len() * words);
        for row in sets.bits.chunks(sets.words) {
            wider.extend_from_slice(row);
            wider.resize(wider.len() + words - row.len(), 0);
        }
        (sets.bits, sets.words) = (wider, words);
    }

    /// Number of distinct sets so far.
    #[must_use]
    pub fn len(&self) -> usize {
        self.sets.len()
    }

    /// Never: set 0 always exists.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        false
    }

    /// The sets so far.
    #[must_use]
    pub fn sets(&self) -> &KeySets {
        &self.sets
    }

    /// Bytes held.
    #[must_use]
    pub fn memory(&self) -> usize {
        self.sets.memory() + self.index.memory()
    }

    /// The finished sets.
    #[must_use]
    pub fn finish(mut self) -> KeySets {
        self.sets.bits.shrink_to_fit();
        self.sets
    }
}

/// Words that so many keys take.
pub(crate) fn words_for(keys: u32) -> usize {
    keys.div_ceil(u64::BITS) as usize
}

/// Puts a key into a set of bits.
pub(crate) fn insert(bits: &mut [u64], key: u32) {
    bits[(key / u64::BITS) as usize] |= 1 << (key % u64::BITS);
}

/// Without words that are 0 at the end: so the same set is the same however many keys there are.
#[inline]
fn significant(bits: &[u64]) -> &[u64] {
    let end = bits.iter().rposition(|&word| word != 0).map_or(0, |last| last + 1);
    &bits[..end]
}

/// The hash by which a set is found.
#[inline]
pub(crate) fn hash_set(bits: &[u64]) -> u64 {
    hash_words(significant(bits).iter().copied())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_sets_are_one_however_many_keys_there_are() {
        let mut sets = KeySetsBuilder::default();
        let lists: [&[u32]; 6] = [&[0, 5], &[], &[63, 64, 200], &[0, 5], &[63], &[200]];
        assert_eq!(lists.map(|members| sets.intern(members)), [1, 0, 2, 1, 3, 4]);
        assert_eq!(sets.intern_bits(&[1 << 63, 0, 0, 0, 0, 0]), 3);
        assert_eq!((sets.find_bits(&[33]), sets.find_bits(&[34])), (Some(1), None));
        let sets = sets.finish();
        assert_eq!((sets.len(), sets.keys()), (5, 201));
        assert_eq!(
            [1, 0, 2].map(|set| sets.members(set).collect::<Vec<_>>()),
            [lists[0], lists[1], lists[2]]
        );
        assert!(!sets.contains(2, 1000));
    }
}

//! Remembering what was computed: for all states where it depends on no attribute that can change, else for each
//! valuation.

use super::ValuationId;
use crate::model::Reads;
use rustc_hash::FxHashMap;
use std::hash::Hash;

/// Results by key, and by valuation where they depend on it.
#[derive(Debug)]
pub(super) struct Memo<K, T> {
    results: Vec<T>,
    /// [`DEPENDS`], or the result in every state.
    always: FxHashMap<K, u32>,
    in_valuation: FxHashMap<(K, ValuationId), u32>,
}

const DEPENDS: u32 = u32::MAX;

impl<K, T> Default for Memo<K, T> {
    fn default() -> Self {
        Memo { results: Vec::new(), always: FxHashMap::default(), in_valuation: FxHashMap::default() }
    }
}

impl<K: Copy + Eq + Hash, T> Memo<K, T> {
    /// The result for a key in a state with this valuation, computed if it is not known.
    ///
    /// `compute` records which attributes it reads.
    pub(super) fn get(&mut self, key: K, valuation: ValuationId, compute: impl FnOnce(&Reads) -> T) -> &T {
        let known = match self.always.get(&key) {
            Some(&DEPENDS) => self.in_valuation.get(&(key, valuation)).copied(),
            always => always.copied(),
        };
        let id = known.unwrap_or_else(|| {
            let reads = Reads::default();
            self.results.push(compute(&reads));
            let id = self.results.len() as u32 - 1;
            if !reads.is_empty() {
                self.always.insert(key, DEPENDS);
                self.in_valuation.insert((key, valuation), id);
            } else {
                self.always.insert(key, id);
            }
            id
        });
        &self.results[id as usize]
    }

    /// Bytes held, where a result owns about so many itself.
    pub(super) fn memory(&self, owned: usize) -> usize {
        let entry = size_of::<(K, u32)>() + 1;
        let entry_in_valuation = size_of::<((K, ValuationId), u32)>() + 1;
        self.results.capacity() * (size_of::<T>() + owned)
            + self.always.capacity() * entry
            + self.in_valuation.capacity() * entry_in_valuation
    }
}

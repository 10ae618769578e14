//! Interned valuations: the values of all attributes of all objects.

use crate::model::{Domain, Value};
use hashbrown::HashTable;
use rustc_hash::FxHasher;
use std::hash::{Hash, Hasher};

/// Index of a valuation, in order of discovery; 0 is the initial one.
pub type ValuationId = u32;

/// All valuations met so far.
#[derive(Debug)]
pub(super) struct Valuations {
    slots: usize,
    values: Vec<Value>,
    count: u32,
    index: HashTable<ValuationId>,
}

impl Valuations {
    /// With the declared initial values as valuation 0.
    pub(super) fn new(domain: &Domain) -> Self {
        let slots = domain.initial.len();
        let mut valuations = Valuations { slots, values: Vec::new(), count: 0, index: HashTable::new() };
        valuations.intern(&domain.initial);
        valuations
    }

    pub(super) fn get(&self, valuation: ValuationId) -> &[Value] {
        row(&self.values, self.slots, valuation)
    }

    pub(super) fn intern(&mut self, values: &[Value]) -> ValuationId {
        let Valuations { slots, values: all, count, index } = self;
        if let Some(&found) = index.find(hash(values), |&v| row(all, *slots, v) == values) {
            return found;
        }
        let id = *count;
        *count += 1;
        all.extend_from_slice(values);
        index.insert_unique(hash(values), id, |&v| hash(row(all, *slots, v)));
        id
    }

    pub(super) fn memory(&self) -> usize {
        self.values.capacity() * size_of::<Value>() + self.index.capacity() * size_of::<ValuationId>()
    }
}

fn row(values: &[Value], slots: usize, valuation: ValuationId) -> &[Value] {
    &values[valuation as usize * slots..(valuation as usize + 1) * slots]
}

fn hash(values: &[Value]) -> u64 {
    let mut hasher = FxHasher::default();
    values.hash(&mut hasher);
    hasher.finish()
}

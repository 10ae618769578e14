//! Sets of fairness keys, and what two of them make together.

use super::UNKNOWN_SET;
use crate::game::{KeySets, KeySetsBuilder};
use crate::playout::KeyId;
use rustc_hash::FxHashMap;

/// Index of a set; 0 is the empty one.
pub type SetId = u32;

/// All distinct sets met so far.
#[derive(Debug, Default)]
pub(super) struct Sets {
    sets: KeySetsBuilder,
    unions: FxHashMap<u64, SetId>,
}

fn pair(a: SetId, b: SetId) -> u64 {
    u64::from(a.min(b)) << 32 | u64::from(a.max(b))
}

impl Sets {
    pub(super) fn all(&self) -> &KeySets {
        self.sets.sets()
    }

    pub(super) fn builder(&self) -> &KeySetsBuilder {
        &self.sets
    }

    pub(super) fn builder_mut(&mut self) -> &mut KeySetsBuilder {
        &mut self.sets
    }

    /// The id of a set, given ascending.
    pub(super) fn intern(&mut self, members: &[KeyId]) -> SetId {
        self.sets.intern(members)
    }

    /// The id of a set, given as bits.
    pub(super) fn intern_bits(&mut self, bits: &[u64]) -> SetId {
        self.sets.intern_bits(bits)
    }

    /// The id of a set given like this, or [`UNKNOWN_SET`].
    pub(super) fn find_bits(&self, bits: &[u64]) -> SetId {
        self.sets.find_bits(bits).unwrap_or(UNKNOWN_SET)
    }

    /// The union, if it is known.
    #[inline]
    pub(super) fn union(&self, a: SetId, b: SetId) -> Option<SetId> {
        match (a, b) {
            (0, one) | (one, 0) => Some(one),
            _ if a == b => Some(a),
            _ => self.unions.get(&pair(a, b)).copied(),
        }
    }

    /// The union.
    pub(super) fn unite(&mut self, a: SetId, b: SetId) -> SetId {
        self.union(a, b).unwrap_or_else(|| {
            let mut members: Vec<KeyId> = self.all().members(a).chain(self.all().members(b)).collect();
            members.sort_unstable();
            members.dedup();
            let union = self.sets.intern(&members);
            self.unions.insert(pair(a, b), union);
            union
        })
    }

    /// Bytes held.
    pub(super) fn memory(&self) -> usize {
        self.sets.memory() + self.unions.capacity() * (size_of::<(u64, SetId)>() + 1)
    }
}

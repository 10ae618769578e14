//! States packed to bits and interned.
//!
//! A row has one field for the valuation, one bit for `yielded` and one field for every *slot*: the copies of one
//! scenario with one role binding. Most slots hold no copy or one of a few, so a field is a few bits that index the
//! slot's distinct sets of copies. Slots and sets are discovered on the way; when a field becomes too narrow, all
//! rows are packed anew with a wider one, which happens about as often as there are bits in a row.

use crate::model::Value;
use crate::playout::{Config, CopyId, Playout};
use hashbrown::HashTable;
use rustc_hash::{FxHashMap, FxHasher};
use std::hash::{Hash, Hasher};

/// Index of a state, in order of discovery.
pub type StateId = u32;

const VALUATION: usize = 0;
const YIELDED: usize = 1;
const FIRST_SLOT: usize = 2;

/// Where a field lies in a row; it never crosses a word.
#[derive(Clone, Copy, Debug)]
struct Field {
    word: usize,
    shift: u32,
    width: u32,
}

impl Field {
    fn mask(self) -> u64 {
        (1 << self.width) - 1
    }

    fn read(self, row: &[u64]) -> u64 {
        row[self.word] >> self.shift & self.mask()
    }

    fn write(self, row: &mut [u64], value: u64) {
        row[self.word] |= value << self.shift;
    }
}

/// The distinct sets of copies of one slot; set 0 is the empty one.
#[derive(Debug, Default)]
struct Slot {
    sets: Vec<Box<[CopyId]>>,
    index: FxHashMap<Box<[CopyId]>, u32>,
}

impl Slot {
    fn new() -> Self {
        let mut slot = Slot::default();
        slot.intern(&[]);
        slot
    }

    fn intern(&mut self, copies: &[CopyId]) -> u32 {
        if let Some(&set) = self.index.get(copies) {
            return set;
        }
        let set = self.sets.len() as u32;
        self.sets.push(copies.into());
        self.index.insert(copies.into(), set);
        set
    }
}

/// All states found so far.
#[derive(Debug)]
pub struct StateStore {
    fields: Vec<Field>,
    words: usize,
    rows: Vec<u64>,
    count: u32,
    index: HashTable<StateId>,
    slots: Vec<Slot>,
    slot_index: FxHashMap<(usize, Box<[Value]>), usize>,
    /// Per copy: its slot.
    slot_of: Vec<usize>,
    /// Scratch: copies by slot, the fields' values, the packed row.
    by_slot: Vec<(usize, CopyId)>,
    values: Vec<u64>,
    row: Vec<u64>,
}

impl Default for StateStore {
    fn default() -> Self {
        let mut store = StateStore {
            fields: Vec::new(),
            words: 0,
            rows: Vec::new(),
            count: 0,
            index: HashTable::new(),
            slots: Vec::new(),
            slot_index: FxHashMap::default(),
            slot_of: Vec::new(),
            by_slot: Vec::new(),
            values: Vec::new(),
            row: Vec::new(),
        };
        store.lay_out(&[1, 1]);
        store
    }
}

impl StateStore {
    /// Number of states; ids are below it.
    #[must_use]
    pub fn len(&self) -> usize {
        self.count as usize
    }

    /// Whether no state was interned yet.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Bytes held.
    #[must_use]
    pub fn memory(&self) -> usize {
        self.rows.capacity() * size_of::<u64>() + self.index.capacity() * (size_of::<StateId>() + 1)
    }

    /// Bits that carry information in a row.
    #[must_use]
    pub fn bits(&self) -> u32 {
        self.fields.iter().map(|field| field.width).sum()
    }

    /// The id of a state, new or not.
    pub fn intern(&mut self, playout: &Playout<'_>, config: &Config) -> StateId {
        self.take_apart(playout, config);
        self.widen();
        self.row.clear();
        self.row.resize(self.words, 0);
        for (field, &value) in self.fields.iter().zip(&self.values) {
            field.write(&mut self.row, value);
        }
        let StateStore { rows, words, row, index, count, .. } = self;
        let hash_of = |id: StateId| hash(nth(rows, *words, id));
        if let Some(&found) = index.find(hash(row), |&id| nth(rows, *words, id) == row.as_slice()) {
            return found;
        }
        let id = *count;
        index.insert_unique(hash(row), id, |&id| hash_of(id));
        *count += 1;
        rows.extend_from_slice(row);
        id
    }

    /// Unpacks a state.
    pub fn load(&self, state: StateId, config: &mut Config) {
        let row = nth(&self.rows, self.words, state);
        config.valuation = self.fields[VALUATION].read(row) as u32;
        config.yielded = self.fields[YIELDED].read(row) != 0;
        config.copies.clear();
        for (slot, field) in self.slots.iter().zip(&self.fields[FIRST_SLOT..]) {
            config.copies.extend_from_slice(&slot.sets[field.read(row) as usize]);
        }
        config.copies.sort_unstable();
    }

    /// Computes the fields' values of `config` into `self.values`.
    fn take_apart(&mut self, playout: &Playout<'_>, config: &Config) {
        self.by_slot.clear();
        for &copy in &config.copies {
            let slot = self.slot(playout, copy);
            self.by_slot.push((slot, copy));
        }
        self.by_slot.sort_unstable();
        self.values.clear();
        self.values.resize(FIRST_SLOT + self.slots.len(), 0);
        self.values[VALUATION] = u64::from(config.valuation);
        self.values[YIELDED] = u64::from(config.yielded);
        for group in self.by_slot.chunk_by(|a, b| a.0 == b.0) {
            let slot = group[0].0;
            let set = match group {
                [(_, copy)] => self.slots[slot].intern(&[*copy]),
                several => {
                    let copies: Vec<CopyId> = several.iter().map(|&(_, copy)| copy).collect();
                    self.slots[slot].intern(&copies)
                }
            };
            self.values[FIRST_SLOT + slot] = u64::from(set);
        }
    }

    fn slot(&mut self, playout: &Playout<'_>, copy: CopyId) -> usize {
        for unseen in self.slot_of.len()..=copy as usize {
            let copy = playout.copy(unseen as CopyId);
            let next = self.slots.len();
            let slot = *self.slot_index.entry((copy.scenario, copy.roles.clone())).or_insert(next);
            if slot == next {
                self.slots.push(Slot::new());
            }
            self.slot_of.push(slot);
        }
        self.slot_of[copy as usize]
    }

    /// Packs all rows anew if some value does not fit its field.
    fn widen(&mut self) {
        let fits = |(field, &value): (&Field, &u64)| value <= field.mask();
        if self.fields.len() == self.values.len() && self.fields.iter().zip(&self.values).all(fits) {
            return;
        }
        let old_widths = self.fields.iter().map(|field| field.width).chain(std::iter::repeat(1));
        let needed = self.values.iter().map(|&value| u64::BITS - value.leading_zeros());
        let widths: Vec<u32> = old_widths.zip(needed).map(|(old, needed)| old.max(needed)).collect();
        let (old_fields, old_words) = (std::mem::take(&mut self.fields), self.words);
        self.lay_out(&widths);
        let mut rows = vec![0; self.words * self.len()];
        for (old, new) in self.rows.chunks_exact(old_words.max(1)).zip(rows.chunks_exact_mut(self.words)) {
            for (from, to) in old_fields.iter().zip(&self.fields) {
                to.write(new, from.read(old));
            }
        }
        self.rows = rows;
        self.index.clear();
        let StateStore { rows, words, index, count, .. } = self;
        for id in 0..*count {
            let hash_of = |&id: &StateId| hash(nth(rows, *words, id));
            index.insert_unique(hash_of(&id), id, hash_of);
        }
    }

    /// Places fields of these widths, first come first served.
    fn lay_out(&mut self, widths: &[u32]) {
        let (mut word, mut shift) = (0, 0);
        self.fields = Vec::with_capacity(widths.len());
        for &width in widths {
            if shift + width > u64::BITS {
                (word, shift) = (word + 1, 0);
            }
            self.fields.push(Field { word, shift, width });
            shift += width;
        }
        self.words = word + 1;
    }
}

fn nth(rows: &[u64], words: usize, state: StateId) -> &[u64] {
    &rows[state as usize * words..(state as usize + 1) * words]
}

fn hash(row: &[u64]) -> u64 {
    let mut hasher = FxHasher::default();
    row.hash(&mut hasher);
    hasher.finish()
}

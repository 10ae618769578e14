//! States packed to bits and interned.
//!
//! A row has one field for the valuation, one bit for `yielded` and one field for every *slot*: the copies of one
//! scenario with one role binding. Most slots hold no copy or one of a few, so a field is a few bits that index the
//! slot's distinct sets of copies. Slots and sets are discovered on the way; when a field becomes too narrow, all
//! rows are packed anew with a wider one, which happens about as often as there are bits in a row.

use crate::intern::Rows;
use crate::model::Value;
use crate::playout::{Config, CopyId, Playout};
use rustc_hash::FxHashMap;

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
    rows: Rows<u64>,
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
        let (fields, words) = lay_out(&[1, 1]);
        StateStore {
            fields,
            rows: Rows::new(words),
            slots: Vec::new(),
            slot_index: FxHashMap::default(),
            slot_of: Vec::new(),
            by_slot: Vec::new(),
            values: Vec::new(),
            row: Vec::new(),
        }
    }
}

impl StateStore {
    /// Number of states; ids are below it.
    #[must_use]
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether no state was interned yet.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Bytes held.
    #[must_use]
    pub fn memory(&self) -> usize {
        self.rows.memory()
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
        pack(&mut self.row, self.rows.width(), self.fields.iter().zip(self.values.iter().copied()));
        self.rows.intern(&self.row)
    }

    /// Unpacks a state.
    pub fn load(&self, state: StateId, config: &mut Config) {
        let row = self.rows.get(state);
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
        let (fields, words) = lay_out(&widths);
        let mut rows = Rows::new(words);
        for state in 0..self.len() as StateId {
            let old = self.rows.get(state);
            let values = self.fields.iter().map(|field| field.read(old));
            pack(&mut self.row, words, fields.iter().zip(values));
            rows.intern(&self.row);
        }
        (self.fields, self.rows) = (fields, rows);
    }
}

/// Writes the fields' values to a cleared row.
fn pack<'f>(row: &mut Vec<u64>, words: usize, values: impl Iterator<Item = (&'f Field, u64)>) {
    row.clear();
    row.resize(words, 0);
    for (field, value) in values {
        field.write(row, value);
    }
}

/// Places fields of these widths, first come first served, and counts the words of a row.
fn lay_out(widths: &[u32]) -> (Vec<Field>, usize) {
    let (mut word, mut shift) = (0, 0);
    let mut fields = Vec::with_capacity(widths.len());
    for &width in widths {
        if shift + width > u64::BITS {
            (word, shift) = (word + 1, 0);
        }
        fields.push(Field { word, shift, width });
        shift += width;
    }
    (fields, word + 1)
}

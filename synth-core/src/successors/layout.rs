//! Where the fields of a packed row lie.

/// One field of a row; it never crosses a word.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Field {
    word: u32,
    shift: u32,
    /// As many ones as the field has bits; none if it has only ever held 0.
    mask: u64,
}

impl Field {
    #[inline]
    pub(super) fn read(self, row: &[u64]) -> u32 {
        (row[self.word as usize] >> self.shift & self.mask) as u32
    }

    /// Writes a value that fits.
    #[inline]
    pub(super) fn write(self, row: &mut [u64], value: u32) {
        debug_assert!(self.fits(value));
        let word = &mut row[self.word as usize];
        *word = *word & !(self.mask << self.shift) | u64::from(value) << self.shift;
    }

    /// Sets all bits of the field, or none.
    pub(super) fn fill(self, mask: &mut [u64], all: bool) {
        let (word, bits) = (&mut mask[self.word as usize], self.mask << self.shift);
        *word = *word & !bits | if all { bits } else { 0 };
    }

    /// Whether the first bit of the field is set.
    #[inline]
    pub(super) fn is_in(self, mask: &[u64]) -> bool {
        mask[self.word as usize] >> self.shift & 1 != 0
    }

    pub(super) fn fits(self, value: u32) -> bool {
        u64::from(value) <= self.mask
    }

    pub(super) fn width(self) -> u32 {
        self.mask.count_ones()
    }
}

/// All fields, first come first served. A field is as wide as the values need that it has held so far.
#[derive(Clone, Debug, Default)]
pub(crate) struct Layout {
    fields: Vec<Field>,
    words: usize,
    /// Fields from this one on are for slots.
    first_slot: usize,
    /// Per word: the bits of slots; and per bit the field that it belongs to.
    slots: Vec<u64>,
    owner: Vec<u32>,
}

impl Layout {
    /// Fields of no bits, none for slots.
    pub(super) fn new(fields: usize) -> Self {
        Layout {
            fields: vec![Field::default(); fields],
            words: 1,
            first_slot: fields,
            slots: vec![0],
            owner: vec![0; u64::BITS as usize],
        }
    }

    #[inline]
    pub(super) fn field(&self, field: usize) -> Field {
        self.fields[field]
    }

    pub(super) fn len(&self) -> usize {
        self.fields.len()
    }

    /// The fields of slots that are not 0 in a row, ascending, with their values. Most are 0, so this looks for bits.
    #[inline]
    pub(super) fn occupied(&self, row: &[u64], mut visit: impl FnMut(u32, u32)) {
        for (index, (&word, &slots)) in row.iter().zip(&self.slots).enumerate() {
            let mut rest = word & slots;
            while rest != 0 {
                let (field, value) = self.take(index, word, &mut rest);
                visit(field, value);
            }
        }
    }

    /// The bits of slots in a word of a row.
    #[inline]
    pub(super) fn slots(&self, index: usize) -> u64 {
        self.slots[index]
    }

    /// The field to which the first of some bits of a word of a row belongs, and its value. All its bits are taken away.
    #[inline]
    pub(super) fn take(&self, index: usize, word: u64, bits: &mut u64) -> (u32, u32) {
        let field = self.owner[index * u64::BITS as usize + bits.trailing_zeros() as usize];
        let Field { shift, mask, .. } = self.fields[field as usize];
        *bits &= !(mask << shift);
        (field, (word >> shift & mask) as u32)
    }

    /// Adds a field of no bits, for a slot.
    pub(super) fn push(&mut self) {
        self.fields.push(Field::default());
    }

    /// Words of a row.
    pub(crate) fn words(&self) -> usize {
        self.words
    }

    /// Bytes of a row that fields reach into, one at least.
    pub(crate) fn bytes(&self) -> usize {
        let end = |field: &Field| field.word * u64::BITS + field.shift + field.width();
        self.fields.iter().map(end).max().unwrap_or(0).div_ceil(8).max(1) as usize
    }

    /// Bits that carry information in a row.
    pub(crate) fn bits(&self) -> u32 {
        self.fields.iter().map(|field| field.width()).sum()
    }

    /// The layout in which these fields hold these values, too.
    pub(super) fn widened(&self, values: &[(u32, u32)]) -> Layout {
        let mut widths: Vec<u32> = self.fields.iter().map(|field| field.width()).collect();
        for &(field, value) in values {
            let width = &mut widths[field as usize];
            *width = (*width).max(u32::BITS - value.leading_zeros());
        }
        let (mut word, mut shift) = (0, 0);
        let mut fields = Vec::with_capacity(widths.len());
        let (mut slots, mut owner) = (Vec::new(), Vec::new());
        for (index, width) in widths.into_iter().enumerate() {
            if shift + width > u64::BITS {
                (word, shift) = (word + 1, 0);
            }
            slots.resize(word as usize + 1, 0);
            owner.resize((word * u64::BITS + shift + width) as usize, index as u32);
            if index >= self.first_slot {
                slots[word as usize] |= ((1 << width) - 1) << shift;
            }
            // A field of no bits must not be shifted out of its word.
            let place = if width == 0 { 0 } else { shift };
            fields.push(Field { word, shift: place, mask: (1 << width) - 1 });
            shift += width;
        }
        Layout { fields, words: word as usize + 1, first_slot: self.first_slot, slots, owner }
    }

    /// Fields of so many bits each.
    #[cfg(test)]
    pub(crate) fn of_widths(widths: &[u32]) -> Layout {
        let values: Vec<(u32, u32)> =
            (0..).zip(widths).map(|(field, &width)| (field, ((1_u64 << width) - 1) as u32)).collect();
        Layout::new(widths.len()).widened(&values)
    }

    /// Writes a row of another layout, which may have fewer fields and narrower ones, into a cleared one of this.
    pub(crate) fn convert(&self, from: &Layout, old: &[u64], row: &mut [u64]) {
        for (field, to) in from.fields.iter().zip(&self.fields) {
            to.write(row, field.read(old));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_do_not_disturb_each_other() {
        let wide = Layout::new(5).widened(&[(0, 1), (2, u32::MAX), (3, u32::MAX), (4, 6)]);
        assert_eq!((wide.words(), wide.bytes(), wide.bits()), (2, 13, 68));
        let mut row = [0; 2];
        let values = [1, 0, 0xdead_beef, 0x1234_5678, 5];
        for (field, &value) in values.iter().enumerate() {
            wide.field(field).write(&mut row, u32::MAX >> (32 - wide.field(field).width().max(1)) & value);
            wide.field(field).write(&mut row, value);
        }
        assert_eq!([0, 1, 2, 3, 4].map(|field| wide.field(field).read(&row)), values);
    }

    #[test]
    fn occupied_slots_are_found() {
        let mut layout = Layout::new(2);
        (0..5).for_each(|_| layout.push());
        let layout = layout.widened(&[(1, 9), (2, 1), (4, u32::MAX), (5, u32::MAX), (6, 3)]);
        let mut row = [0; 2];
        let values = [(1, 9), (2, 1), (5, 1 << 31), (6, 2)];
        values.iter().for_each(|&(field, value)| layout.field(field).write(&mut row, value));
        let mut found = Vec::new();
        layout.occupied(&row, |field, value| found.push((field as usize, value)));
        assert_eq!(found, values[1..]);
    }

    #[test]
    fn widening_keeps_values() {
        let narrow = Layout::new(2).widened(&[(0, 3), (1, 1)]);
        let mut old = [0; 1];
        narrow.field(0).write(&mut old, 2);
        narrow.field(1).write(&mut old, 1);
        let mut wide = narrow.clone();
        wide.push();
        let wide = wide.widened(&[(0, 200), (2, 9)]);
        let mut row = [0; 1];
        wide.convert(&narrow, &old, &mut row);
        assert_eq!([0, 1, 2].map(|field| wide.field(field).read(&row)), [2, 1, 0]);
        assert!(wide.field(0).fits(255) && !wide.field(0).fits(256));
    }
}

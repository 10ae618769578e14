//! Columns of tables: arrays, and byte strings for those that are too long to be compiled as arrays.

use core::marker::PhantomData;
use core::ops::Range;

use crate::probes::{PREDICTS, probe};

mod sealed {
    pub trait Sealed {}
}

/// The number types of tables: `u8`, `u16` and `u32`.
pub trait Number: Copy + Ord + Into<u32> + sealed::Sealed {
    /// Bytes of one number.
    const WIDTH: usize;

    /// The number at `bytes[WIDTH * index..]`, little-endian; `None` beyond the end.
    fn read(bytes: &[u8], index: usize) -> Option<Self>;

    /// The same number, if the type holds it.
    fn from_u32(number: u32) -> Option<Self>;
}

macro_rules! number {
    ($($number:ty),*) => {$(
        impl sealed::Sealed for $number {}

        impl Number for $number {
            const WIDTH: usize = size_of::<Self>();

            #[inline]
            fn read(bytes: &[u8], index: usize) -> Option<Self> {
                let rest = bytes.get(index.checked_mul(Self::WIDTH)?..)?;
                rest.first_chunk().map(|&bytes| Self::from_le_bytes(bytes))
            }

            #[inline]
            fn from_u32(number: u32) -> Option<Self> {
                Self::try_from(number).ok()
            }
        }
    )*};
}

number!(u8, u16, u32);

/// A column of numbers whose length is part of its type.
pub trait Column {
    /// What it holds.
    type Number: Number;

    /// How many.
    const LEN: usize;

    /// The number at `index`; `None` beyond the end.
    fn get(&self, index: usize) -> Option<Self::Number>;

    /// Where `number` is among `rows`, which ascend strictly; counted from the column's first.
    fn position(&self, rows: Range<usize>, number: Self::Number) -> Option<usize>;

    /// The last of `rows`, which ascend, that is not above `number`. If all are above, any row, which is above, too, or none.
    fn floor(&self, rows: Range<usize>, number: Self::Number) -> Option<usize>;

    /// The number at `index` as an index into another column.
    #[inline]
    fn index(&self, index: usize) -> Option<usize> {
        self.get(index).map(|number| number.into() as usize)
    }
}

impl<T: Number, const N: usize> Column for [T; N] {
    type Number = T;

    const LEN: usize = N;

    #[inline]
    fn get(&self, index: usize) -> Option<T> {
        self.as_slice().get(index).copied()
    }

    #[inline]
    fn position(&self, rows: Range<usize>, number: T) -> Option<usize> {
        if PREDICTS { position_fast(self, rows, number) } else { search_small(self, rows, number).ok() }
    }

    #[inline]
    fn floor(&self, rows: Range<usize>, number: T) -> Option<usize> {
        if PREDICTS {
            search(rows, number, |index| Column::get(self, index))
        } else {
            search_small(self, rows, number).or_else(|above| above.checked_sub(1).ok_or(0)).ok()
        }
    }
}

/// A column as one byte string, little-endian; `B` is its length in bytes.
///
/// The compiler takes microseconds for every number of an array and next to nothing for a byte string.
///
/// ```
/// use controller_template::{Column, Packed};
///
/// static STATES: Packed<u16, 4> = Packed::new(*b"\x07\x00\x00\x01");
/// assert_eq!(STATES.get(1), Some(256));
/// assert_eq!(STATES.get(2), None);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Packed<T, const B: usize> {
    bytes: [u8; B],
    number: PhantomData<T>,
}

impl<T, const B: usize> Packed<T, B> {
    /// Takes the bytes as they are.
    #[must_use]
    pub const fn new(bytes: [u8; B]) -> Self {
        Packed { bytes, number: PhantomData }
    }
}

impl<T: Number, const B: usize> Column for Packed<T, B> {
    type Number = T;

    const LEN: usize = B / T::WIDTH;

    #[inline]
    fn get(&self, index: usize) -> Option<T> {
        T::read(&self.bytes, index)
    }

    #[inline]
    fn position(&self, rows: Range<usize>, number: T) -> Option<usize> {
        position_in(&self.bytes, rows, number)
    }

    #[inline]
    fn floor(&self, rows: Range<usize>, number: T) -> Option<usize> {
        search(rows, number, |index| T::read(&self.bytes, index))
    }
}

/// For arrays of any length and processors that guess where a branch leads, see [`search`].
#[inline(never)]
fn position_fast<T: Number>(column: &[T], rows: Range<usize>, number: T) -> Option<usize> {
    search(rows, number, |index| column.get(index).copied()).filter(|&row| {
        probe();
        column.get(row) == Some(&number)
    })
}

/// For processors that execute one instruction after the other from little flash: ten to seventeen instructions a probe,
/// in as few bytes as can be. To be part of its caller, which knows the length and where the column is.
///
/// Where `number` is, or else the first row above it; never a row that is not there.
///
/// The order of the comparisons decides what compilers make of it: Thumb code of 76 to 88 bytes with the target's access,
/// against 82 to 124 if equality is asked first.
#[inline(always)]
fn search_small<T: Number>(column: &[T], rows: Range<usize>, number: T) -> Result<usize, usize> {
    let Range { mut start, mut end } = rows;
    while start < end {
        let middle = start.wrapping_add(end) / 2;
        let Some(&found) = column.get(middle) else { break };
        probe();
        if found < number {
            start = middle + 1;
            continue;
        }
        if found == number {
            return Ok(middle);
        }
        end = middle;
    }
    Err(start)
}

/// One function for byte strings of any length: large tables wait for memory, not for instructions.
#[inline(never)]
fn position_in<T: Number>(bytes: &[u8], rows: Range<usize>, number: T) -> Option<usize> {
    search(rows, number, |index| T::read(bytes, index)).filter(|&row| {
        probe();
        T::read(bytes, row) == Some(number)
    })
}

/// Binary search of rows that ascend, without a branch that depends on them: the last that is not above `number`, or the
/// first.
///
/// It keeps or moves its base instead of branching, so that the compiler selects by conditional moves: where a branch is
/// guessed wrong every other time, it takes five times as long from a few thousand rows on. It must be in a function
/// that is never inlined: in a loop of the caller, x86 back ends make branches of its conditional moves. The number of
/// probes follows from the number of rows alone: the least `p` with `2^(p - 1) >= rows`.
#[inline(always)]
fn search<T: Number>(rows: Range<usize>, number: T, get: impl Fn(usize) -> Option<T>) -> Option<usize> {
    let Range { start: mut base, end } = rows;
    let mut rest = end.checked_sub(base)?;
    while rest > 1 {
        let half = rest / 2;
        let middle = base + half;
        probe();
        base = if get(middle)? <= number { middle } else { base };
        rest -= half;
    }
    (rest == 1).then_some(base)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Both searches are the same, whatever the processor of this machine.
    #[test]
    fn searches_agree() {
        let column: [u16; 40] = core::array::from_fn(|i| 3 * i as u16);
        for start in 0..=41 {
            for end in 0..=41 {
                for number in 0..=121 {
                    let fast = position_fast(&column, start..end, number);
                    let small = search_small(&column, start..end, number).ok();
                    let expected = (number % 3 == 0).then_some(usize::from(number / 3));
                    let expected = expected.filter(|row| (start..end.min(40)).contains(row));
                    if end <= 40 {
                        assert_eq!((fast, small), (expected, expected), "{number} in {start}..{end}");
                    } else {
                        // Nothing is promised beyond the end but an answer.
                        assert!([fast, small].iter().all(|found| found.is_none() || *found == expected));
                    }
                }
            }
        }
    }
}

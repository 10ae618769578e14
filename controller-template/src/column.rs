//! Columns of tables: arrays, and byte strings for those that are too long to be compiled as arrays.

use core::marker::PhantomData;

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

    /// Where `number` is in a column that ascends strictly.
    fn position(&self, number: Self::Number) -> Option<usize>;

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

    /// The length is known, so the search is unrolled: three instructions a probe, and no bounds left to check.
    ///
    /// It stays a function: inlined into a loop of the caller, x86 back ends make branches of its conditional moves,
    /// which costs five times as long from a few thousand rows on, and tables of one length can share it.
    #[inline(never)]
    fn position(&self, number: T) -> Option<usize> {
        search(N, number, |index| Column::get(self, index))
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
    fn position(&self, number: T) -> Option<usize> {
        position_in(&self.bytes, number)
    }
}

/// One function for byte strings of any length: large tables wait for memory, not for instructions, and hundreds of
/// unrolled searches would take their time to compile.
fn position_in<T: Number>(bytes: &[u8], number: T) -> Option<usize> {
    search(bytes.len() / T::WIDTH, number, |index| T::read(bytes, index))
}

/// Binary search of a column that ascends strictly.
///
/// It keeps or moves its base instead of branching, so that the compiler selects by conditional moves. The number of
/// probes follows from the length alone: the least `p` with `2^(p - 1) >= length`.
#[inline(always)]
fn search<T: Number>(length: usize, number: T, get: impl Fn(usize) -> Option<T>) -> Option<usize> {
    let mut base = 0;
    let mut rest = length;
    while rest > 1 {
        let half = rest / 2;
        let middle = base + half;
        base = if get(middle)? <= number { middle } else { base };
        rest -= half;
    }
    get(base).filter(|&found| found == number).map(|_| base)
}

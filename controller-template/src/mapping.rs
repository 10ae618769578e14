//! Mapping functions (Gritzner and Greenyer 2018, section 4).

use crate::Column;

/// A partial function of states: two columns of equal length, ascending sources and their targets.
///
/// ```
/// use controller_template::Mapping;
///
/// static ARRIVED: Mapping<[u8; 3]> = Mapping::new([0, 4, 5], [1, 2, 6]);
/// assert_eq!(ARRIVED.lookup(4), Some(2));
/// assert_eq!(ARRIVED.lookup(3), None);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Mapping<C> {
    source: C,
    target: C,
}

impl<C> Mapping<C> {
    /// A mapping from `source[i]` to `target[i]`.
    ///
    /// `source` must ascend strictly: states are not found otherwise.
    #[must_use]
    pub const fn new(source: C, target: C) -> Self {
        Mapping { source, target }
    }
}

impl<C: Column> Mapping<C> {
    /// Where the mapping leads from `state`.
    #[inline]
    pub fn lookup(&self, state: C::Number) -> Option<C::Number> {
        self.target(self.row(state)?)
    }

    /// The row whose source is `state`.
    #[inline]
    pub fn row(&self, state: C::Number) -> Option<usize> {
        self.source.position(state)
    }

    /// The target of a row.
    #[inline]
    pub fn target(&self, row: usize) -> Option<C::Number> {
        self.target.get(row)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Number, Packed};

    /// Every state in and around the sources `1, 3, 5, …`, all of which lead to `100 - source`.
    #[track_caller]
    fn check<C: Column<Number: TryFrom<u32>>>(mapping: &Mapping<C>, length: usize) {
        assert_eq!(C::LEN, length);
        for state in 0..=2 * length as u32 + 2 {
            let expected = (state % 2 == 1 && state < 2 * length as u32).then(|| 200 - state);
            let number = <C::Number as TryFrom<u32>>::try_from(state).ok().expect("small");
            assert_eq!(mapping.lookup(number).map(Into::into), expected, "{state} among {length}");
            assert_eq!(mapping.row(number), expected.map(|_| state as usize / 2));
        }
    }

    fn array<T: Number + TryFrom<u32>, const N: usize>() -> Mapping<[T; N]> {
        let number = |n: usize| T::try_from(n as u32).ok().expect("small");
        Mapping::new(
            core::array::from_fn(|i| number(2 * i + 1)),
            core::array::from_fn(|i| number(200 - (2 * i + 1))),
        )
    }

    fn packed<T: Number, const B: usize>() -> Mapping<Packed<T, B>> {
        let byte = |i: usize, number: usize| (number >> (8 * (i % T::WIDTH))) as u8;
        let bytes = |number: fn(usize) -> usize| core::array::from_fn(|i| byte(i, number(i / T::WIDTH)));
        Mapping::new(Packed::new(bytes(|row| 2 * row + 1)), Packed::new(bytes(|row| 200 - (2 * row + 1))))
    }

    macro_rules! lengths {
        ($($n:literal)*) => {$(
            check(&array::<u8, $n>(), $n);
            check(&array::<u16, $n>(), $n);
            check(&array::<u32, $n>(), $n);
            check(&packed::<u8, $n>(), $n);
            check(&packed::<u16, { 2 * $n }>(), $n);
            check(&packed::<u32, { 4 * $n }>(), $n);
        )*};
    }

    #[test]
    fn every_state_of_every_length() {
        lengths!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 31 32 33 34 35);
        lengths!(36 37 38 39 40 41 42 43 44 45 46 47 48 49 50 51 52 53 54 55 56 57 58 59 60 61 62 63 64 65 66 67);
        lengths!(68 69 70);
    }

    #[test]
    fn the_greatest_numbers_are_found() {
        assert_eq!(Mapping::new([0, u8::MAX], [1, 2]).lookup(u8::MAX), Some(2));
        assert_eq!(Mapping::new([0, u16::MAX], [1, 2]).lookup(u16::MAX), Some(2));
        assert_eq!(Mapping::new([0, u32::MAX], [1, u32::MAX]).lookup(u32::MAX), Some(u32::MAX));
    }
}

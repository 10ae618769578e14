//! Mapping functions (Gritzner and Greenyer 2018, section 4).

use crate::Column;

/// Several partial functions of states: for each, ascending sources and their targets. The rows of all stand one behind
/// the other in two columns.
///
/// ```
/// use controller_template::Mappings;
///
/// // The first leads from 0, 4 and 5, the second from 4.
/// static ROWS: Mappings<[u8; 3], [u8; 4]> =
///     Mappings { first: [0, 3, 4], source: [0, 4, 5, 4], target: [1, 2, 6, 0] };
/// assert_eq!(ROWS.lookup(0, 4), Some(2));
/// assert_eq!(ROWS.lookup(1, 5), None);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Mappings<F, C> {
    /// Per mapping its first row; one more entry ends the last.
    pub first: F,
    /// Per row the state that it leads from; strictly ascending within a mapping, or states are not found.
    pub source: C,
    /// Per row the state that it leads to.
    pub target: C,
}

impl<F: Column, C: Column> Mappings<F, C> {
    /// Where a mapping leads from `state`.
    #[inline]
    pub fn lookup(&self, mapping: usize, state: C::Number) -> Option<C::Number> {
        self.target.get(self.place(mapping, state)?)
    }

    /// The row of `state` counted from the mapping's first, and its target.
    #[inline]
    pub fn row(&self, mapping: usize, state: C::Number) -> Option<(usize, C::Number)> {
        let place = self.place(mapping, state)?;
        let row = place.checked_sub(self.first.index(mapping)?)?;
        Some((row, self.target.get(place)?))
    }

    /// The row whose source is `state`, counted from the first of all.
    #[inline]
    fn place(&self, mapping: usize, state: C::Number) -> Option<usize> {
        let first = self.first.index(mapping)?;
        let end = self.first.index(mapping.checked_add(1)?)?;
        self.source.position(first..end, state)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Number, Packed};

    /// Nothing, then the sources `1, 3, 5, …`, all of which lead to `200 - source`, then what would be found if the search
    /// left its mapping.
    #[track_caller]
    fn check<C: Column>(source: C, target: C, length: usize) {
        let rows = Mappings { first: [0, 0, length as u8, length as u8 + 1], source, target };
        for state in 0..=2 * length as u32 + 2 {
            let expected = (state % 2 == 1 && state < 2 * length as u32).then(|| 200 - state);
            let number = C::Number::from_u32(state).expect("small");
            assert_eq!(rows.lookup(0, number).map(Into::into), None);
            assert_eq!(rows.lookup(1, number).map(Into::into), expected, "{state} among {length}");
            let row = rows.row(1, number).map(|(row, target)| (row, target.into()));
            assert_eq!(row, expected.map(|target| (state as usize / 2, target)));
            let last = (state == 2 * length as u32 + 1).then_some((0, 200 - state));
            assert_eq!(rows.row(2, number).map(|(row, target)| (row, target.into())), last);
            assert_eq!(rows.lookup(3, number).map(Into::into), None);
        }
    }

    fn array<T: Number, const N: usize>() {
        let number = |number: usize| T::from_u32(number as u32).expect("small");
        let source: [T; N] = core::array::from_fn(|i| number(2 * i + 1));
        check(source, core::array::from_fn(|i| number(200 - (2 * i + 1))), N - 1);
    }

    fn packed<T: Number, const B: usize>() {
        let byte = |i: usize, number: usize| (number >> (8 * (i % T::WIDTH))) as u8;
        let bytes = |number: fn(usize) -> usize| core::array::from_fn(|i| byte(i, number(i / T::WIDTH)));
        let source: Packed<T, B> = Packed::new(bytes(|row| 2 * row + 1));
        check(source, Packed::new(bytes(|row| 200 - (2 * row + 1))), B / T::WIDTH - 1);
    }

    macro_rules! lengths {
        ($($n:literal)*) => {$(
            array::<u8, $n>();
            array::<u16, $n>();
            array::<u32, $n>();
            packed::<u8, $n>();
            packed::<u16, { 2 * $n }>();
            packed::<u32, { 4 * $n }>();
        )*};
    }

    #[test]
    fn every_state_of_every_length() {
        lengths!(1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 31 32 33 34 35);
        lengths!(36 37 38 39 40 41 42 43 44 45 46 47 48 49 50 51 52 53 54 55 56 57 58 59 60 61 62 63 64 65 66 67);
        lengths!(68 69 70);
    }

    #[track_caller]
    fn check_greatest<T: Number + core::fmt::Debug>(zero: T, greatest: T) {
        let rows = Mappings { first: [0_u8, 2], source: [zero, greatest], target: [zero, greatest] };
        assert_eq!(rows.lookup(0, greatest), Some(greatest));
        assert_eq!(rows.lookup(0, zero), Some(zero));
    }

    #[test]
    fn the_greatest_numbers_are_found() {
        check_greatest(0, u8::MAX);
        check_greatest(0, u16::MAX);
        check_greatest(0, u32::MAX);
    }

    #[test]
    fn rows_that_are_not_there_are_not_found() {
        let rows = Mappings { first: [0_u8, 9, 3], source: [1_u8, 2, 3], target: [4_u8, 5, 6] };
        assert_eq!((rows.lookup(0, 9), rows.lookup(1, 1), rows.lookup(usize::MAX, 1)), (None, None, None));
    }
}

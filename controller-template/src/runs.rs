//! Mapping functions over runs of consecutive states, with targets of as few bits as they need.

use crate::probes::probe;
use crate::{Column, Number};

/// Several mapping functions in one.
///
/// The states in which a mapping is defined are *runs* of consecutive numbers. A run has its first state, and the number of
/// rows of the mapping up to its end; the rows of a mapping follow each other in a string of bits, each the target less the
/// mapping's least.
///
/// Type parameters are the columns' types, so that each is as narrow as its numbers; `B` is the number of bytes of targets.
#[derive(Clone, Copy, Debug)]
pub struct Runs<M, L, S, E, T, const W: usize, const B: usize> {
    /// Per mapping its first run; one more entry ends the last.
    pub first: M,
    /// Per mapping its first bit of `bits`.
    pub start: L,
    /// Per mapping its least target.
    pub base: T,
    /// Per mapping the bits of a target; at most 25.
    pub width: [u8; W],
    /// Per run its first state; ascending within a mapping.
    pub state: S,
    /// Per run the rows of its mapping up to its end.
    pub end: E,
    /// The targets, the least significant bit first; three more bytes than they need.
    pub bits: [u8; B],
}

impl<M, L, S, E, T, const W: usize, const B: usize> Runs<M, L, S, E, T, W, B>
where
    M: Column,
    L: Column,
    S: Column,
    E: Column,
    T: Column,
{
    /// Where a mapping leads from a state.
    #[inline]
    pub fn lookup(&self, mapping: usize, state: S::Number) -> Option<T::Number> {
        let (_, row) = self.row(mapping, state)?;
        self.target(mapping, row)
    }

    /// The run, counted from the mapping's first, and the row of a state.
    #[inline(never)]
    pub fn row(&self, mapping: usize, state: S::Number) -> Option<(usize, u32)> {
        let first = self.first.get(mapping)?.into() as usize;
        let end = self.first.get(mapping.checked_add(1)?)?.into() as usize;
        let run = self.state.floor(first..end, state)?;
        // In front of them if the state is.
        let nth = run.checked_sub(first)?;
        let begin = self.state.get(run)?.into();
        probe();
        let further = state.into().checked_sub(begin)?;
        let before = if nth == 0 { 0 } else { self.end.get(run - 1)?.into() };
        let row = before.checked_add(further)?;
        let end = self.end.get(run)?.into();
        probe();
        (row < end).then_some((nth, row))
    }

    /// The target of a row.
    #[inline]
    pub fn target(&self, mapping: usize, row: u32) -> Option<T::Number> {
        let width = u32::from(*self.width.as_slice().get(mapping)?);
        let bit = self.start.get(mapping)?.into().wrapping_add(row.wrapping_mul(width));
        let bytes = self.bits.as_slice().get((bit / 8) as usize..)?.first_chunk()?;
        let value = u32::from_le_bytes(*bytes) >> (bit % 8) & !(u32::MAX.checked_shl(width)?);
        T::Number::from_u32(self.base.get(mapping)?.into().wrapping_add(value))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Mapping 0: states 3, 4, 5 and 9 to 10, 12, 11, 13. Mapping 1: nothing. Mapping 2: state 0 to 300.
    #[allow(clippy::type_complexity, reason = "every column has a type of its own")]
    fn runs() -> Runs<[u8; 4], [u8; 3], [u16; 3], [u8; 3], [u16; 3], 3, 5> {
        Runs {
            first: [0, 2, 2, 3],
            start: [0, 8, 8],
            base: [10, 0, 300],
            width: [2, 0, 1],
            state: [3, 9, 0],
            end: [3, 4, 1],
            bits: [0b11_01_10_00, 0, 0, 0, 0],
        }
    }

    #[track_caller]
    fn check(mapping: usize, expected: &[(u16, u16)]) {
        for state in 0..=12 {
            let target = expected.iter().find(|(source, _)| *source == state).map(|(_, target)| *target);
            assert_eq!(runs().lookup(mapping, state), target, "{state}");
        }
    }

    #[test]
    fn every_state() {
        check(0, &[(3, 10), (4, 12), (5, 11), (9, 13)]);
        check(1, &[]);
        check(2, &[(0, 300)]);
        check(3, &[]);
        assert_eq!((runs().row(0, 5), runs().row(0, 9)), (Some((0, 2)), Some((1, 3))));
    }
}

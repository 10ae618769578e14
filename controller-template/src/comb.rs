//! All mapping functions in one array, the rows of each state shifted until they interlock (row displacement; Tarjan and
//! Yao, "Storing a sparse table", CACM 1979).

use crate::probes::probe;
use crate::{Column, Number};

/// A two-dimensional table with holes, in one dimension.
///
/// The entry of a state and an event is at the state's displacement plus the event's index, if the event stands there in
/// `check`: no two states have the same displacement, so an event that is found is the state's own.
///
/// It takes the same few instructions for every state and event.
#[derive(Clone, Copy, Debug)]
pub struct Comb<D, C, T> {
    /// Per state, from `first` on, where its entries begin.
    pub displacement: D,
    /// The state with the first displacement; those below have no entries.
    pub first: u32,
    /// Per place the event whose entry it is; a number that is no event where there is none.
    pub check: C,
    /// Per place the state that the entry leads to.
    pub target: T,
}

impl<D: Column, C: Column, T: Column> Comb<D, C, T> {
    /// Where an event leads from a state.
    #[inline]
    pub fn lookup(&self, event: usize, state: impl Number) -> Option<T::Number> {
        let state = state.into().wrapping_sub(self.first) as usize;
        let place = self.displacement.index(state)?.wrapping_add(event);
        let found = self.check.index(place)?;
        probe();
        if found == event { self.target.get(place) } else { None }
    }

    /// The same as an index into another column.
    #[inline]
    pub fn index(&self, event: usize, state: impl Number) -> Option<usize> {
        self.lookup(event, state).map(|target| target.into() as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// From state 10: events 0 and 2 to 7 and 8; from state 12 event 0 to 9.
    #[test]
    fn entries_interlock() {
        let comb = Comb {
            displacement: [0_u8, 3, 1],
            first: 10,
            check: [0_u8, 0, 2, 9, 9, 9],
            target: [7_u16, 9, 8, 0, 0, 0],
        };
        let found: [[Option<u16>; 3]; 5] =
            core::array::from_fn(|state| core::array::from_fn(|event| comb.lookup(event, state as u8 + 9)));
        let none = [None; 3];
        assert_eq!(found, [none, [Some(7), None, Some(8)], none, [Some(9), None, None], none]);
    }
}

//! A mapping function over consecutive states.

use crate::{Column, Number};

/// The targets of the states from `first` on, one after the other.
#[derive(Clone, Copy, Debug)]
pub struct Span<C> {
    first: u32,
    target: C,
}

impl<C: Column> Span<C> {
    /// Of states from `first` on.
    #[must_use]
    pub const fn new(first: u32, target: C) -> Self {
        Span { first, target }
    }

    /// The row of a state, if there is one.
    #[inline]
    pub fn row(&self, state: impl Number) -> Option<usize> {
        let row = state.into().checked_sub(self.first)? as usize;
        (row < C::LEN).then_some(row)
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

    #[test]
    fn rows_are_those_of_its_states() {
        let span = Span::new(5, [7_u16, 8]);
        let rows: [Option<usize>; 9] = core::array::from_fn(|state| span.row(state as u8));
        assert_eq!(rows, [None, None, None, None, None, Some(0), Some(1), None, None]);
        assert_eq!((span.target(1), span.target(2)), (Some(8), None));
    }
}

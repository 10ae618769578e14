//! The states found so far, in a few sorted files that are looked through side by side.

use super::error::Result;
use super::folder::Folder;
use super::order::{compare, convert};
use super::segment::{Cursor, Index, Segment};
use crate::successors::Layout;
use std::borrow::Cow;

/// One of the files.
#[derive(Debug)]
pub(super) struct Visited {
    pub(super) segment: Segment,
    pub(super) index: Index,
}

/// Asks one of the files for rows, which ascend.
#[derive(Debug)]
pub(super) struct Probe<'v> {
    cursor: Cursor,
    offsets: &'v [u64],
    /// In the last layout.
    firsts: Cow<'v, [u64]>,
    words: usize,
    /// The cursor stands at a row.
    valid: bool,
}

impl<'v> Probe<'v> {
    pub(super) fn new(folder: &Folder, visited: &'v Visited, layouts: &[Layout]) -> Result<Probe<'v>> {
        let (own, last) = (visited.segment.layout as usize, layouts.len() - 1);
        let firsts = &visited.index.firsts;
        Ok(Probe {
            cursor: Cursor::new(folder, &visited.segment, layouts)?,
            offsets: &visited.index.offsets,
            firsts: if own == last {
                Cow::Borrowed(firsts)
            } else {
                Cow::Owned(convert(&layouts[own], &layouts[last], firsts))
            },
            words: layouts[last].words(),
            valid: false,
        })
    }

    /// Whether the row is there. Rows that are asked for later must not be smaller.
    pub(super) fn contains(&mut self, row: &[u64]) -> Result<bool> {
        let at = self.cursor.block();
        let next = at.map_or(0, |block| block + 1);
        if next < self.offsets.len() && compare(self.first(next), row).is_le() {
            let block = next + self.blocks_up_to(next, row) - 1;
            self.cursor.seek(block, self.offsets[block])?;
            self.valid = self.cursor.advance()?;
        } else if at.is_none() {
            return Ok(false);
        }
        while self.valid && compare(self.cursor.row(), row).is_lt() {
            self.valid = self.cursor.advance()?;
        }
        Ok(self.valid && self.cursor.row() == row)
    }

    fn first(&self, block: usize) -> &[u64] {
        &self.firsts[block * self.words..(block + 1) * self.words]
    }

    /// How many blocks from this one on begin with rows that are not greater.
    fn blocks_up_to(&self, from: usize, row: &[u64]) -> usize {
        let (mut low, mut high) = (from, self.offsets.len());
        while low < high {
            let middle = low + (high - low) / 2;
            if compare(self.first(middle), row).is_le() { low = middle + 1 } else { high = middle }
        }
        low - from
    }
}

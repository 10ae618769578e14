//! Several files read as one.

use super::error::Result;
use super::order::compare;
use super::segment::Cursor;

/// The rows of several files, ascending, each once.
#[derive(Debug)]
pub(super) struct Merge {
    /// A heap: no file stands at a smaller row than the one at half its place.
    heap: Vec<Cursor>,
    last: Vec<u64>,
    begun: bool,
}

impl Merge {
    /// Of files that have not been read yet.
    pub(super) fn new(cursors: Vec<Cursor>) -> Result<Merge> {
        let mut heap = Vec::with_capacity(cursors.len());
        for mut cursor in cursors {
            if cursor.advance()? {
                heap.push(cursor);
            }
        }
        let mut merge = Merge { heap, last: Vec::new(), begun: false };
        for place in (0..merge.heap.len() / 2).rev() {
            merge.sift_down(place);
        }
        Ok(merge)
    }

    /// The next row.
    pub(super) fn next(&mut self) -> Result<Option<&[u64]>> {
        while let Some(least) = self.heap.first_mut() {
            if !self.begun {
                self.begun = true;
            } else if least.row() == self.last {
                if !least.advance()? {
                    self.heap.swap_remove(0);
                }
                self.sift_down(0);
                continue;
            }
            self.last.clear();
            self.last.extend_from_slice(least.row());
            return Ok(Some(&self.last));
        }
        Ok(None)
    }

    fn sift_down(&mut self, mut place: usize) {
        loop {
            let mut least = place;
            for child in [2 * place + 1, 2 * place + 2] {
                if child < self.heap.len() && compare(self.heap[child].row(), self.heap[least].row()).is_lt()
                {
                    least = child;
                }
            }
            if least == place {
                return;
            }
            self.heap.swap(place, least);
            place = least;
        }
    }
}

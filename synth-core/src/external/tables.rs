//! The successor function, and what it had to learn.
//!
//! What it knows follows from what it was asked, in which order. So a checkpoint does not hold the tables but the rows that
//! were asked; asked once more they make the same tables, with the same numbers.

use super::bytes::{Source, put_numbers};
use crate::playout::{EventId, PlayError, Playout};
use crate::successors::{Layout, Learned, PackedMoves, Successors, learn};

/// A mistake, and the event that met it.
pub(super) type Mistake = (Option<EventId>, PlayError);

/// Tables that remember how they came about.
#[derive(Debug)]
pub(super) struct Tables<'p, 's> {
    pub(super) playout: &'p mut Playout<'s>,
    pub(super) successors: Successors,
    /// All layouts so far; the last one holds.
    pub(super) layouts: Vec<Layout>,
    journal: Vec<Lesson>,
}

/// One thing that was learned.
#[derive(Clone, Debug)]
enum Lesson {
    /// The moves of a row.
    Moves(Box<[u64]>),
    /// Room in rows for everything that did not fit since the last time.
    Widening,
}

impl<'p, 's> Tables<'p, 's> {
    /// Know the initial state only, which is returned.
    pub(super) fn new(playout: &'p mut Playout<'s>) -> Result<(Self, Vec<u64>), PlayError> {
        let initial = playout.initial()?;
        let mut successors = Successors::new(playout);
        let row = successors.pack_first(playout, &initial);
        let layouts = vec![successors.layout().clone()];
        Ok((Tables { playout, successors, layouts, journal: Vec::new() }, row))
    }

    pub(super) fn layout(&self) -> &Layout {
        self.successors.layout()
    }

    pub(super) fn words(&self) -> usize {
        self.layout().words()
    }

    /// Finds the moves of a row, learning what is not known. What rows have no room for is appended to `narrow`.
    pub(super) fn settle(
        &mut self,
        row: &[u64],
        narrow: &mut Vec<(u32, u32)>,
        moves: &mut PackedMoves,
    ) -> Result<Learned, Mistake> {
        if self.successors.moves(row, moves).is_err() {
            self.journal.push(Lesson::Moves(row.into()));
            return learn(&mut self.successors, self.playout, row, narrow, moves);
        }
        Ok(Learned::Moves)
    }

    /// From now on rows have room for these values of fields.
    pub(super) fn widen(&mut self, narrow: &[(u32, u32)]) {
        self.journal.push(Lesson::Widening);
        let layout = self.successors.widened(narrow);
        self.layouts.push(layout.clone());
        self.successors.set_layout(layout);
    }

    /// Bytes held.
    pub(super) fn memory(&self) -> usize {
        let of_journal = self.journal.len() * (size_of::<Lesson>() + self.words() * size_of::<u64>());
        self.playout.memory() + self.successors.memory() + of_journal
    }

    /// What was learned, for [`Tables::read`].
    pub(super) fn write(&self, out: &mut Vec<u8>) {
        put_numbers(out, &[self.journal.len() as u64]);
        for lesson in &self.journal {
            let (kind, row): (u64, &[u64]) = match lesson {
                Lesson::Moves(row) => (0, row),
                Lesson::Widening => (1, &[]),
            };
            put_numbers(out, &[kind]);
            put_numbers(out, row);
        }
        put_numbers(out, &self.shape());
    }

    /// Learns the same in tables that know nothing yet; nothing if that does not make the same tables.
    pub(super) fn read(&mut self, source: &mut Source<'_>) -> Option<()> {
        let (mut moves, mut narrow) = (PackedMoves::default(), Vec::new());
        for _ in 0..source.number()? {
            let kind = source.number()?;
            if kind == 1 {
                self.widen(&narrow);
                narrow.clear();
                continue;
            }
            let row = (0..self.words()).map(|_| source.number()).collect::<Option<Vec<u64>>>()?;
            self.settle(&row, &mut narrow, &mut moves).ok()?;
        }
        self.shape().iter().all(|&number| source.number() == Some(number)).then_some(())
    }

    /// Numbers by which other tables would hardly be the same.
    fn shape(&self) -> [u64; 6] {
        let counts =
            [self.layouts.len(), self.words(), self.playout.event_count(), self.playout.copy_count()];
        let [layouts, words, events, copies] = counts.map(|count| count as u64);
        [layouts, words, u64::from(self.layout().bits()), events, copies, self.journal.len() as u64]
    }
}

//! The super steps of a controller as a table.

use super::Lists;

/// One row of the super steps.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SuperStep<'a> {
    /// The state in which it is due.
    pub source: u32,
    /// The state after it.
    pub target: u32,
    /// Its system events in order, as indices into [`Controller::commands`](super::Controller::commands); never empty, and
    /// at most one of each component.
    pub events: &'a [u32],
}

/// Super steps, one after the other: the rows of three columns of the same length.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct SuperSteps {
    /// Per super step the state in which it is due.
    pub source: Vec<u32>,
    /// Per super step the state after it.
    pub target: Vec<u32>,
    /// Per super step its system events.
    pub events: Lists,
}

impl SuperSteps {
    /// Number of super steps.
    #[must_use]
    pub fn len(&self) -> usize {
        self.source.len()
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.source.is_empty()
    }

    /// The super step of a row.
    ///
    /// # Panics
    ///
    /// If there is no such row.
    #[must_use]
    pub fn row(&self, row: usize) -> SuperStep<'_> {
        SuperStep { source: self.source[row], target: self.target[row], events: &self.events[row] }
    }

    /// The super step that is due in a state, if sources ascend.
    #[must_use]
    pub fn due(&self, state: u32) -> Option<SuperStep<'_>> {
        self.source.binary_search(&state).ok().map(|row| self.row(row))
    }

    /// All, row by row.
    pub fn iter(&self) -> Iter<'_> {
        Iter { steps: self, row: 0 }
    }

    /// Adds a row.
    pub fn push(&mut self, SuperStep { source, target, events }: SuperStep<'_>) {
        self.source.push(source);
        self.target.push(target);
        self.events.push(events);
    }

    /// Adds a row whose list of events has a known number.
    pub(crate) fn push_number(&mut self, source: u32, target: u32, events: u32) {
        self.source.push(source);
        self.target.push(target);
        self.events.push_number(events);
    }

    /// Replaces source and target of every row, and sorts. Rows for which there are no new ones go.
    pub(crate) fn rename(&mut self, new: impl Fn(u32, u32) -> Option<(u32, u32)>) {
        let mut renamed = SuperSteps { events: self.events.cleared(), ..SuperSteps::default() };
        for (row, (&source, &target)) in self.source.iter().zip(&self.target).enumerate() {
            if let Some((source, target)) = new(source, target) {
                renamed.push_number(source, target, self.events.number(row));
            }
        }
        *self = renamed;
        self.sort();
    }

    /// Puts them in ascending order of their sources; those of the same source stay in order.
    pub fn sort(&mut self) {
        if self.source.is_sorted() {
            return;
        }
        let mut order: Vec<u32> = (0..self.len() as u32).collect();
        order.sort_by_key(|&row| self.source[row as usize]);
        self.source = order.iter().map(|&row| self.source[row as usize]).collect();
        self.target = order.iter().map(|&row| self.target[row as usize]).collect();
        self.events = std::mem::take(&mut self.events).reordered(&order);
    }
}

/// The rows of [`SuperSteps`].
#[derive(Clone, Debug)]
pub struct Iter<'a> {
    steps: &'a SuperSteps,
    row: usize,
}

impl<'a> Iterator for Iter<'a> {
    type Item = SuperStep<'a>;

    fn next(&mut self) -> Option<SuperStep<'a>> {
        let step = (self.row < self.steps.len()).then(|| self.steps.row(self.row));
        self.row += 1;
        step
    }
}

impl<'a> IntoIterator for &'a SuperSteps {
    type Item = SuperStep<'a>;
    type IntoIter = Iter<'a>;

    fn into_iter(self) -> Iter<'a> {
        self.iter()
    }
}

impl<'a> FromIterator<SuperStep<'a>> for SuperSteps {
    fn from_iter<I: IntoIterator<Item = SuperStep<'a>>>(steps: I) -> SuperSteps {
        let mut all = SuperSteps::default();
        all.extend(steps);
        all
    }
}

impl<'a> Extend<SuperStep<'a>> for SuperSteps {
    fn extend<I: IntoIterator<Item = SuperStep<'a>>>(&mut self, steps: I) {
        steps.into_iter().for_each(|step| self.push(step));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_sorted_by_source_and_found() {
        let step = |source, events| SuperStep { source, target: source + 1, events };
        let all = [step(7, &[1, 2][..]), step(2, &[0]), step(4, &[1, 2])];
        let mut steps: SuperSteps = all.into_iter().collect();
        steps.sort();
        assert_eq!(steps.iter().collect::<Vec<_>>(), [all[1], all[2], all[0]]);
        assert_eq!((steps.due(4), steps.due(5)), (Some(all[2]), None));
    }
}

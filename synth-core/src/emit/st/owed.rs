//! `owed`: the events that the environment owes in the present state, on demand.
//!
//! Many states owe the same events, so there is a list of the distinct sets, and a number of one per state.

use std::collections::BTreeMap;

use super::block::Block;
use super::bound::Cost;
use super::integer::Integer;
use super::unit::Section;
use super::writer::Writer;

/// The output.
pub(super) const OWED: &str = "owed";

/// What is owed, as three arrays.
pub(super) struct Owed {
    /// Per state its set.
    set: Vec<u32>,
    /// Per set its first place in `event`, and one more for the end.
    first: Vec<u32>,
    /// The sets, one after the other, in order of their first states.
    event: Vec<u32>,
}

impl Owed {
    /// From the events that each state owes.
    pub(super) fn new(states: &[Vec<u32>]) -> Owed {
        let mut known: BTreeMap<&[u32], u32> = BTreeMap::new();
        let mut owed = Owed { set: Vec::with_capacity(states.len()), first: vec![0], event: Vec::new() };
        for events in states {
            let next = known.len() as u32;
            let set = *known.entry(events).or_insert_with(|| {
                owed.event.extend_from_slice(events);
                owed.first.push(owed.event.len() as u32);
                next
            });
            owed.set.push(set);
        }
        owed
    }

    /// Whether no state owes anything.
    pub(super) fn is_empty(&self) -> bool {
        self.event.is_empty()
    }

    /// The largest number that the arrays and their indices need.
    pub(super) fn largest(&self) -> u64 {
        self.event
            .iter()
            .chain(&self.first)
            .map(|&number| u64::from(number))
            .max()
            .unwrap_or(0)
            .max(self.first.len() as u64)
    }

    /// The most events that a state owes.
    fn most(&self) -> u64 {
        self.first.windows(2).map(|ends| u64::from(ends[1] - ends[0])).max().unwrap_or(0)
    }

    /// Declares the arrays.
    pub(super) fn tables(&self, out: &mut Section, integer: Integer) {
        out.comment(
            "what the environment owes: per state the number of a set, where each set begins, the sets",
        );
        out.array("owed_set", integer, &self.set);
        out.array("owed_first", integer, &self.first);
        out.array("owed_event", integer, &self.event);
    }

    /// Sets the output.
    pub(super) fn update(&self, out: &mut Writer, block: &Block<'_>) {
        block.for_each_event(out, |out| out.code("#owed[#index] := FALSE;"));
        out.code("#owed_row := #owed_first[#owed_set[#state]];");
        out.code("WHILE #owed_row < #owed_first[#owed_set[#state] + 1] DO");
        out.indented(|out| {
            out.code("#owed[#owed_event[#owed_row]] := TRUE;");
            out.code("#owed_row := #owed_row + 1;");
        });
        out.code("END_WHILE;");
    }

    /// What that costs at most, without the loop over the events.
    pub(super) fn cost(&self) -> Cost {
        let most = self.most();
        Cost { statements: 2 + 2 * most, iterations: most, probes: 1 + most }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sets_are_shared() {
        let owed = Owed::new(&[vec![], vec![1, 2], vec![], vec![0], vec![1, 2]]);
        assert_eq!(
            (&owed.set[..], &owed.first[..], &owed.event[..]),
            (&[0, 1, 0, 2, 1][..], &[0, 0, 2, 3][..], &[1, 2, 0][..])
        );
        assert_eq!((owed.largest(), owed.most(), owed.is_empty()), (4, 2, false));
    }
}

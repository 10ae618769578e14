//! All rows of environment events, and super steps of scattered states, in one array, those of each state shifted until
//! they interlock like the teeth of combs (row displacement with first fit decreasing: Tarjan and Yao, "Storing a sparse
//! table", CACM 1979).

use std::cmp::Reverse;

use hashbrown::HashMap;
use rustc_hash::FxBuildHasher;

use super::tables::Tables;

/// The interlocked rows.
///
/// From state `s`, event `e` leads to `target[place]` with `place = displacement[s - first] + e` if `check[place]` is `e`, and
/// nowhere otherwise. No two states have the same displacement, so `e` stands at a place for one state only. Every place
/// that a displacement and an event make is there.
///
/// Super steps of consecutive states need no search. Those of other states are rows of one more event behind all others,
/// which lead to their positions among the super steps.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Comb {
    /// The first state with a displacement. States below it and beyond the last have no rows.
    pub first: u32,
    /// Per state from `first` on.
    pub displacement: Vec<u32>,
    /// Per place its event; a number that is no event where there is none.
    pub check: Vec<u32>,
    /// Per place the target; 0 where there is none.
    pub target: Vec<u32>,
    /// The state of the first super step, if all are of consecutive states and thus not in here.
    pub super_steps: Option<u32>,
}

/// So many places are tried for a state before it gets one behind all others: that bounds the time.
const TRIES: usize = 4096;

impl Comb {
    /// Packs the rows. Takes time linear in the rows, but for a constant number of tries each.
    #[must_use]
    pub fn of(tables: &Tables) -> Comb {
        let super_steps = match tables.super_steps.source[..] {
            [] => Some(0),
            [first, ..] => is_consecutive(&tables.super_steps.source).then_some(first),
        };
        let scattered = super_steps.is_none();
        let rows = rows_of_states(tables, scattered);
        let first = rows.iter().position(|rows| !rows.is_empty()).unwrap_or(0) as u32;
        let end = rows.iter().rposition(|rows| !rows.is_empty()).map_or(first, |last| last as u32 + 1);
        let mut states: Vec<u32> = (first..end).collect();
        states.sort_by_key(|&state| Reverse(rows[state as usize].len()));
        let events = tables.events.len() as u32 + u32::from(scattered);
        let mut packing = Packing::new(events);
        let mut displacement = vec![0; states.len()];
        for state in states {
            displacement[(state - first) as usize] = packing.place(&rows[state as usize]);
        }
        let Packing { check, target, .. } = packing;
        Comb { first, displacement, check, target, super_steps }
    }
}

fn is_consecutive(ascending: &[u32]) -> bool {
    ascending.windows(2).all(|pair| pair[1] == pair[0] + 1)
}

/// Per state its rows, event and target, events ascending; with the positions of super steps if they are `scattered`.
fn rows_of_states(tables: &Tables, scattered: bool) -> Vec<Vec<(u32, u32)>> {
    let mut rows = vec![Vec::new(); tables.states as usize];
    for (event, table) in (0..).zip(&tables.events) {
        for (&source, &target) in table.mapping.source.iter().zip(&table.mapping.target) {
            rows[source as usize].push((event, target));
        }
    }
    if scattered {
        for (row, &source) in (0..).zip(&tables.super_steps.source) {
            rows[source as usize].push((tables.events.len() as u32, row));
        }
    }
    rows
}

struct Packing {
    events: u32,
    check: Vec<u32>,
    target: Vec<u32>,
    /// Whether a state has this displacement.
    taken: Vec<bool>,
    /// Per set of events the displacement from which to try: places only fill up, so what did not fit once never will.
    from: HashMap<Vec<u32>, usize, FxBuildHasher>,
}

impl Packing {
    fn new(events: u32) -> Packing {
        Packing { events, check: Vec::new(), target: Vec::new(), taken: Vec::new(), from: HashMap::default() }
    }

    /// Places the rows of a state, at the first displacement where they fit.
    fn place(&mut self, rows: &[(u32, u32)]) -> u32 {
        let events: Vec<u32> = rows.iter().map(|(event, _)| *event).collect();
        let from = self.from.get(&events).copied().unwrap_or(0);
        let behind_all = self.check.len().max(from);
        let mut tries = from..behind_all.min(from + TRIES);
        let displacement = tries.find(|&d| self.fits(d, &events)).unwrap_or(behind_all);
        self.from.insert(events, displacement + 1);
        self.grow(displacement);
        self.taken[displacement] = true;
        for &(event, target) in rows {
            self.check[displacement + event as usize] = event;
            self.target[displacement + event as usize] = target;
        }
        displacement as u32
    }

    fn fits(&self, displacement: usize, events: &[u32]) -> bool {
        let occupied = |event: &u32| {
            self.check.get(displacement + *event as usize).is_some_and(|event| *event != self.events)
        };
        self.taken.get(displacement) != Some(&true) && !events.iter().any(occupied)
    }

    /// Makes room for all events at a displacement.
    fn grow(&mut self, displacement: usize) {
        let places = displacement + self.events as usize;
        if self.taken.len() <= displacement {
            self.taken.resize(displacement + 1, false);
            self.check.resize(places.max(self.check.len()), self.events);
            self.target.resize(places.max(self.target.len()), 0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::fixtures::{controller, controllers};
    use super::super::tables::Provenance;
    use super::super::{Controller, number};
    use super::*;
    use proptest::prelude::*;

    fn tables(controller: &Controller) -> Tables {
        Tables::new("S", controller, Provenance::default())
    }

    #[test]
    fn rows_interlock() {
        let comb = Comb::of(&tables(&controller("0! arm.go 1 \n 1: a 0, c 2 \n 2: a 1 \n 3: b 2, a 3")));
        // State 1 and 3 have two rows each; state 2 fills the hole of the first.
        assert_eq!(comb.first, 1);
        assert_eq!(comb.displacement, [0, 1, 3]);
        assert_eq!(comb.check, [0, 0, 2, 0, 1, 3]);
        assert_eq!(comb.target, [0, 1, 2, 3, 2, 0]);
    }

    #[test]
    fn scattered_super_steps_are_packed() {
        let comb = Comb::of(&tables(&controller("0! arm.go 1 \n 1: a 0 \n 2! arm.go 1")));
        assert_eq!((comb.super_steps, comb.first), (None, 0));
        // One event, then the super steps: the first, from state 0, and the second, from state 2.
        assert_eq!(comb.displacement, [0, 2, 3]);
        assert_eq!((&comb.check[..], &comb.target[..]), (&[2, 1, 0, 2, 1][..], &[0, 0, 0, 0, 1][..]));
    }

    #[test]
    fn nothing_is_packed() {
        let comb = Comb::of(&tables(&controller("0! arm.go 0")));
        assert_eq!((comb.check.len(), comb.target.len()), (0, 0));
    }

    proptest! {
        #[test]
        fn it_says_the_same_as_the_tables(controller in controllers(12), numbered in any::<bool>()) {
            let tables = tables(&if numbered { number(controller) } else { controller });
            let comb = Comb::of(&tables);
            let mut displacements = comb.displacement.clone();
            displacements.sort_unstable();
            displacements.dedup();
            prop_assert_eq!(displacements.len(), comb.displacement.len(), "no two are the same");
            let found = |event: usize, state: u32| {
                let displacement = state.checked_sub(comb.first).and_then(|s| comb.displacement.get(s as usize));
                let place = displacement.map(|d| *d as usize + event);
                place.filter(|place| comb.check[*place] == event as u32).map(|place| comb.target[place])
            };
            for state in 0..tables.states {
                for (event, table) in tables.events.iter().enumerate() {
                    let row = table.mapping.source.binary_search(&state).ok();
                    prop_assert_eq!(found(event, state), row.map(|row| table.mapping.target[row]));
                }
                let step = tables.super_steps.source.binary_search(&state).ok().map(|row| row as u32);
                match comb.super_steps {
                    Some(first) => prop_assert!(step.is_none_or(|row| row == state - first)),
                    None => prop_assert_eq!(found(tables.events.len(), state), step),
                }
            }
        }
    }
}

//! A smallest set of guarantees that cannot be met together.
//!
//! Delta debugging (Zeller and Hildebrandt 2002) over relaxed scenarios: start from all guarantees, try to relax a
//! whole group at once, and where that makes the specification realizable, each half of it by itself. What is left is
//! minimal because relaxing is monotone: what was needed with more guarantees in force is needed with fewer.

use super::guarantees;
use super::probe::{Prober, Scenarios};

/// Guarantees without which the specification would be realizable.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Core {
    /// Indices. With every other guarantee relaxed the specification is unrealizable.
    pub(super) scenarios: Scenarios,
    /// With any one of them relaxed, too, it is realizable; else that could not be found out for some.
    pub(super) is_minimal: bool,
}

/// A core of an unrealizable specification. Tries to do without the guarantees that are not `involved`, then without the
/// later ones of those that are.
pub(super) fn core(prober: &mut Prober<'_>, involved: &[usize]) -> Core {
    let spec = prober.spec();
    let all: Scenarios = guarantees(spec).collect();
    let others: Vec<usize> = all.iter().copied().filter(|scenario| !involved.contains(scenario)).collect();
    let mut involved: Vec<usize> =
        involved.iter().copied().filter(|scenario| all.contains(scenario)).collect();
    involved.reverse();
    let mut search = Search { prober, relaxed: Scenarios::new(), is_minimal: true };
    search.relax(&others);
    search.relax(&involved);
    let Search { relaxed, is_minimal, .. } = search;
    Core { scenarios: all.difference(&relaxed).copied().collect(), is_minimal }
}

struct Search<'p, 's> {
    prober: &'p mut Prober<'s>,
    /// With these relaxed the specification is unrealizable.
    relaxed: Scenarios,
    is_minimal: bool,
}

impl Search<'_, '_> {
    /// Relaxes as many of the group as possible.
    fn relax(&mut self, group: &[usize]) {
        if group.is_empty() {
            return;
        }
        let more: Scenarios = self.relaxed.iter().chain(group).copied().collect();
        match (self.prober.is_realizable(&more), group) {
            (Some(false), _) => self.relaxed = more,
            (answer, [_]) => self.is_minimal &= answer.is_some(),
            (_, group) => {
                let (front, back) = group.split_at(group.len() / 2);
                self.relax(front);
                self.relax(back);
            }
        }
    }
}

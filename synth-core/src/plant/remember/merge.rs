//! Uniting what need not be told apart.

use super::machine::{Machine, numbered};
use fixedbitset::FixedBitSet;

/// Pairs of states that are looked at before what is left stays as it is.
const STEPS: u64 = 2_000_000;

/// Per state its class: states of one sight, none of which have to be told apart, whose successors by a label are in one class.
///
/// Greedy, in order of the states: each pair is united, together with all that this entails, unless that would unite what must
/// stay apart. Fewer codes can be had without this now and then, but codes of such classes change with fewer events.
pub(super) fn merge(machine: &Machine, apart: &[(u32, u32)]) -> Vec<u32> {
    let states = machine.len();
    let mut differ = vec![FixedBitSet::with_capacity(states); states];
    apart.iter().for_each(|&(a, b)| differ[a as usize].insert(b as usize));
    let mut order: Vec<u32> = (0..states as u32).collect();
    order.sort_by_key(|&state| machine.sight[state as usize]);
    let members = (0..states as u32).map(|state| vec![state]).collect();
    let mut classes = Classes { machine, differ, of: (0..states as u32).collect(), members, steps: 0 };
    for group in order.chunk_by(|&a, &b| machine.sight[a as usize] == machine.sight[b as usize]) {
        for (i, &a) in group.iter().enumerate() {
            for &b in &group[i + 1..] {
                if classes.steps < STEPS {
                    classes.try_to_unite(a, b);
                }
            }
        }
    }
    numbered(classes.of.into_iter())
}

struct Classes<'a> {
    machine: &'a Machine,
    /// Per state those that must be in another class.
    differ: Vec<FixedBitSet>,
    /// Per state its class, the number of a member.
    of: Vec<u32>,
    /// Per class its members.
    members: Vec<Vec<u32>>,
    steps: u64,
}

impl Classes<'_> {
    /// Unites two classes, those of their successors, and so on; or changes nothing.
    fn try_to_unite(&mut self, a: u32, b: u32) {
        // What was moved, to move it back: the class from which and to which, and how many members that had.
        let mut trail: Vec<(u32, u32, usize)> = Vec::new();
        let mut open = vec![(a, b)];
        while let Some((a, b)) = open.pop() {
            let (a, b) = (self.of[a as usize], self.of[b as usize]);
            if a == b {
                continue;
            }
            let mut allowed = true;
            for &x in &self.members[a as usize] {
                for &y in &self.members[b as usize] {
                    self.steps += 1;
                    allowed &= !self.differ[x as usize].contains(y as usize);
                    open.extend(shared(self.machine, x, y));
                }
            }
            if !allowed {
                self.undo(trail);
                return;
            }
            let moved = std::mem::take(&mut self.members[b as usize]);
            moved.iter().for_each(|&state| self.of[state as usize] = a);
            trail.push((b, a, self.members[a as usize].len()));
            self.members[a as usize].extend(moved);
        }
    }

    fn undo(&mut self, trail: Vec<(u32, u32, usize)>) {
        for (from, to, before) in trail.into_iter().rev() {
            let moved = self.members[to as usize].split_off(before);
            moved.iter().for_each(|&state| self.of[state as usize] = from);
            self.members[from as usize] = moved;
        }
    }
}

/// Where labels of both states lead.
fn shared(machine: &Machine, x: u32, y: u32) -> impl Iterator<Item = (u32, u32)> {
    let of_y = machine.edges(y);
    machine.edges(x).iter().filter_map(move |&(label, to)| {
        let found = of_y.binary_search_by_key(&label, |&(label, _)| label).ok()?;
        Some((to, of_y[found].1))
    })
}

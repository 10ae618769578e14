//! Codes: a coloring of classes with as few bits as possible.

use std::collections::BTreeSet;

/// Codes of classes.
pub(super) struct Coloring {
    /// Per class its code.
    pub(super) of: Vec<u32>,
    /// Bits of a code.
    pub(super) bits: u32,
}

/// Steps after which one more bit is taken instead.
const BUDGET: u32 = 200_000;

/// The fewest bits whose codes tell apart what differs; `initial` has code 0.
///
/// Exact unless the search exceeds its budget (Brélaz, "New methods to color the vertices of a graph", CACM 1979, with
/// backtracking).
pub(super) fn color(differ: &[BTreeSet<u32>], initial: u32) -> Coloring {
    let mut bits = u32::from(differ.iter().any(|others| !others.is_empty()));
    loop {
        let mut search = Search { differ, colors: 1 << bits, of: vec![None; differ.len()], budget: BUDGET };
        if search.run() {
            let first = search.of[initial as usize].unwrap_or(0);
            // Any code may stand for any other: swap that of the initial class with 0.
            let swap = |code: u32| {
                if code == first {
                    0
                } else if code == 0 {
                    first
                } else {
                    code
                }
            };
            return Coloring {
                of: search.of.into_iter().map(|code| swap(code.unwrap_or(0))).collect(),
                bits,
            };
        }
        bits += 1;
    }
}

struct Search<'a> {
    differ: &'a [BTreeSet<u32>],
    colors: u32,
    of: Vec<Option<u32>>,
    budget: u32,
}

impl Search<'_> {
    /// Colors what has no color yet; `false`, and nothing changed, if there is no way or the budget is used up.
    fn run(&mut self) -> bool {
        let Some(next) = self.most_constrained() else { return true };
        let taken = self.taken(next);
        // All colors that nobody has yet are the same.
        let used = self.of.iter().flatten().max().map_or(0, |most| most + 1);
        for color in (0..self.colors.min(used + 1)).filter(|color| !taken.contains(color)) {
            let Some(budget) = self.budget.checked_sub(1) else { return false };
            self.budget = budget;
            self.of[next as usize] = Some(color);
            if self.run() {
                return true;
            }
            self.of[next as usize] = None;
        }
        false
    }

    fn taken(&self, class: u32) -> BTreeSet<u32> {
        self.differ[class as usize].iter().filter_map(|&other| self.of[other as usize]).collect()
    }

    /// The class with the most colors around it, then the most neighbours, then the least number.
    fn most_constrained(&self) -> Option<u32> {
        let open = (0..self.differ.len() as u32).filter(|&class| self.of[class as usize].is_none());
        open.max_by_key(|&class| {
            (self.taken(class).len(), self.differ[class as usize].len(), std::cmp::Reverse(class))
        })
    }
}

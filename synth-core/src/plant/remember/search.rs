//! The fewest bits, by search.

use super::conclude::Conclusion;
use std::cmp::Reverse;

/// So many states are searched; with more there are too many ways.
pub(super) const STATES: usize = 512;
/// So many bits at most: a set of codes is a word.
pub(super) const BITS: u32 = 6;
/// Conclusions that are looked at before the search for so many bits gives up.
const STEPS: u64 = 1_000_000;

/// Codes of states.
#[derive(Debug)]
pub(super) struct Codes {
    /// Per state.
    pub(super) of: Vec<u32>,
    /// Bits of a code.
    pub(super) bits: u32,
    /// Whether fewer bits are known not to do.
    pub(super) fewest: bool,
}

/// What a search found.
pub(super) struct Found {
    /// Codes, if there are any.
    pub(super) codes: Option<Codes>,
    /// Whether it is certain that no fewer bits than these, or than were allowed, do.
    pub(super) fewest: bool,
}

/// What codes have to fulfil.
pub(super) struct Problem {
    initial: u32,
    /// Per state those that need other codes.
    apart: Vec<Vec<u32>>,
    /// Per state as a source its occasions and targets.
    from: Vec<Vec<(u32, u32)>>,
    /// Per state as a target its occasions and sources.
    to: Vec<Vec<(u32, u32)>>,
    /// Per occasion sources and targets.
    on: Vec<Vec<(u32, u32)>>,
}

/// In which order states and codes are tried.
#[derive(Clone, Copy)]
struct Order {
    /// States with the fewest possible codes first.
    by_codes: bool,
    /// States with the most neighbours whose codes are known first.
    by_neighbours: bool,
    /// Codes of the most neighbours first, or else the least code.
    near: bool,
    /// Of states that are equal in this, the one with the least product of its number and this, modulo the number of states.
    stride: u32,
}

/// Finds contradictions early.
const TO_REFUTE: Order = Order { by_codes: true, by_neighbours: true, near: true, stride: 1 };

/// One or the other of these finds codes that change with few events.
fn to_please() -> impl Iterator<Item = Order> {
    let flags = |number: u32, bit: u32| number >> bit & 1 == 1;
    (0..32).map(move |number| Order {
        by_codes: false,
        by_neighbours: flags(number, 0),
        near: flags(number, 1),
        stride: 2 * (number >> 2) + 1,
    })
}

impl Problem {
    /// The state `initial` has code 0. `pairs` are states that need different codes, each pair in both orders, ascending.
    pub(super) fn new(
        states: usize,
        initial: u32,
        conclusions: &[Conclusion],
        pairs: &[(u32, u32)],
    ) -> Problem {
        let mut apart = vec![Vec::new(); states];
        pairs.iter().for_each(|&(a, b)| apart[a as usize].push(b));
        let (mut from, mut to, mut on) = (vec![Vec::new(); states], vec![Vec::new(); states], Vec::new());
        for (group, number) in conclusions.chunk_by(|a, b| a.occasion == b.occasion).zip(0..) {
            for &Conclusion { source, target, .. } in group {
                from[source as usize].push((number, target));
                to[target as usize].push((number, source));
            }
            on.push(group.iter().map(|it| (it.source, it.target)).collect());
        }
        Problem { initial, apart, from, to, on }
    }

    /// Codes with the fewest bits, fewer than `below`.
    ///
    /// By numbers of bits, the least first: a backtracking search over sets of codes that are still possible, until it
    /// succeeds or everything was tried. No more than six bits are tried.
    pub(super) fn fewest(&self, below: u32) -> Found {
        if below > 0 && self.apart.iter().all(Vec::is_empty) {
            let codes = Codes { of: vec![0; self.apart.len()], bits: 0, fewest: true };
            return Found { codes: Some(codes), fewest: true };
        }
        let mut fewest = true;
        for bits in 1..below.min(BITS + 1) {
            let (of, everything) = self.search(bits, TO_REFUTE, STEPS);
            if let Some(of) = of {
                return Found { codes: Some(Codes { of, bits, fewest }), fewest };
            }
            fewest &= everything;
        }
        Found { codes: None, fewest: fewest && below <= BITS + 1 }
    }

    /// Some codes with so many bits, as different orders find them.
    pub(super) fn variants(&self, bits: u32) -> impl Iterator<Item = Vec<u32>> {
        to_please().filter_map(move |order| self.search(bits, order, STEPS / 10).0)
    }

    /// Codes, if any were found, and whether everything was tried if need be.
    fn search(&self, bits: u32, order: Order, steps: u64) -> (Option<Vec<u32>>, bool) {
        let all = u64::MAX >> (64 - (1u32 << bits));
        let mut search = Search {
            problem: self,
            order,
            possible: vec![all; self.apart.len()],
            trail: Vec::new(),
            open: Vec::new(),
            conflicts: vec![0; self.apart.len()],
            steps,
        };
        let found = search.narrow(self.initial, 1) && search.propagate() && search.run();
        let of = found.then(|| search.possible.iter().map(|codes| codes.trailing_zeros()).collect());
        (of, search.steps > 0)
    }
}

struct Search<'a> {
    problem: &'a Problem,
    order: Order,
    /// Per state the codes that it may have.
    possible: Vec<u64>,
    /// What was possible before, to go back.
    trail: Vec<(u32, u64)>,
    /// States whose code has become known and that have not been looked at.
    open: Vec<u32>,
    /// Per state how often no code was left for it.
    conflicts: Vec<u32>,
    /// How many steps are left.
    steps: u64,
}

impl Search<'_> {
    /// Chooses codes for what has none; `false`, and nothing changed, if there is no way or too much was tried.
    fn run(&mut self) -> bool {
        let Some(state) = self.next() else { return true };
        // Codes that nobody has are all the same: one of them is enough.
        let used = self.used();
        let fresh = !used & used.wrapping_add(1);
        let mut codes = self.possible[state as usize] & (used | fresh);
        let around = if self.order.near { self.around(state) } else { Vec::new() };
        while codes != 0 && self.steps > 0 {
            let each = (0..u64::BITS).map(|code| 1 << code).filter(|code| codes & code != 0);
            let near = |code: u64| around.iter().filter(|&&other| other == code).count();
            let liked = each.max_by_key(|&code| (near(code), Reverse(code)));
            let code = liked.unwrap_or(codes);
            codes ^= code;
            let before = self.trail.len();
            if self.narrow(state, code) && self.propagate() && self.run() {
                return true;
            }
            self.open.clear();
            while self.trail.len() > before {
                let Some((state, possible)) = self.trail.pop() else { break };
                self.possible[state as usize] = possible;
            }
        }
        false
    }

    /// The codes of states that lead to a state or that it leads to.
    fn around(&self, state: u32) -> Vec<u64> {
        let problem = self.problem;
        let both = problem.from[state as usize].iter().chain(&problem.to[state as usize]);
        both.filter_map(|&(_, other)| self.known(other)).collect()
    }

    /// All codes up to the greatest that a state has.
    fn used(&self) -> u64 {
        let known = self.possible.iter().filter(|codes| codes.is_power_of_two());
        known.fold(1, |used, code| used | code | (code - 1))
    }

    /// The state that was most often the reason to go back, then as the order says, then the first.
    fn next(&self) -> Option<u32> {
        let open = (0..self.possible.len()).filter(|&state| !self.possible[state].is_power_of_two());
        open.min_by_key(|&state| {
            let codes = if self.order.by_codes { self.possible[state].count_ones() } else { 0 };
            let around = if self.order.by_neighbours { self.around(state as u32).len() } else { 0 };
            let place = state * self.order.stride as usize % self.possible.len();
            (Reverse(self.conflicts[state]), codes, Reverse(around), place)
        })
        .map(|state| state as u32)
    }

    /// Leaves only some codes; `false` if none is left.
    fn narrow(&mut self, state: u32, codes: u64) -> bool {
        let before = self.possible[state as usize];
        let after = before & codes;
        if after != before {
            self.trail.push((state, before));
            self.possible[state as usize] = after;
            if after.is_power_of_two() {
                self.open.push(state);
            }
        }
        self.conflicts[state as usize] += u32::from(after == 0);
        after != 0
    }

    fn known(&self, state: u32) -> Option<u64> {
        Some(self.possible[state as usize]).filter(|codes| codes.is_power_of_two())
    }

    /// What follows from codes that have become known; `false` if there is a contradiction.
    fn propagate(&mut self) -> bool {
        while let Some(state) = self.open.pop() {
            let problem = self.problem;
            let index = state as usize;
            let code = self.possible[index];
            self.steps = self.steps.saturating_sub(problem.apart[index].len() as u64 + 1);
            if !problem.apart[index].iter().all(|&other| self.narrow(other, !code)) {
                return false;
            }
            for &(occasion, target) in &problem.from[index] {
                if !self.as_source(occasion, code, target) {
                    return false;
                }
            }
            for &(occasion, source) in &problem.to[index] {
                if !self.as_target(occasion, source, code) {
                    return false;
                }
            }
        }
        true
    }

    /// The source of `target` on an occasion has a code: others with this code lead to the same code.
    fn as_source(&mut self, occasion: u32, code: u64, target: u32) -> bool {
        let others = &self.problem.on[occasion as usize];
        self.steps = self.steps.saturating_sub(others.len() as u64);
        others.iter().all(|&(other, to)| {
            let common = self.possible[target as usize] & self.possible[to as usize];
            if self.known(other) == Some(code) {
                self.narrow(target, common) && self.narrow(to, common)
            } else {
                common != 0 || self.narrow(other, !code)
            }
        })
    }

    /// The target of `source` on an occasion has a code: sources of others must have another code than `source`.
    fn as_target(&mut self, occasion: u32, source: u32, code: u64) -> bool {
        let others = &self.problem.on[occasion as usize];
        self.steps = self.steps.saturating_sub(others.len() as u64);
        others.iter().all(|&(other, to)| match (self.known(source), self.known(other)) {
            (Some(own), Some(its)) if own == its => self.narrow(to, code),
            _ if self.possible[to as usize] & code != 0 => true,
            (Some(own), _) => self.narrow(other, !own),
            (None, Some(its)) => self.narrow(source, !its),
            (None, None) => true,
        })
    }
}

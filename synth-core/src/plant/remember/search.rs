//! The fewest bits, by search.

use super::conclude::Conclusion;
use std::cmp::Reverse;

/// So many states are searched; with more there are too many ways.
pub(super) const STATES: usize = 512;
/// So many bits at most: a set of codes is a word.
const BITS: u32 = 6;
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

/// Codes with the fewest bits, fewer than `below`; the state `initial` has code 0.
///
/// `apart` are pairs of states that need different codes, each pair in both orders, ascending. By numbers of bits, the least
/// first: a backtracking search over sets of codes that are still possible, the state with the fewest first, until it
/// succeeds or everything was tried. No more than six bits are tried.
pub(super) fn search(
    states: usize,
    initial: u32,
    conclusions: &[Conclusion],
    apart: &[(u32, u32)],
    below: u32,
) -> Found {
    if below > 0 && apart.is_empty() {
        return Found { codes: Some(Codes { of: vec![0; states], bits: 0, fewest: true }), fewest: true };
    }
    let problem = Problem::new(states, conclusions, apart);
    let mut fewest = true;
    for bits in 1..below.min(BITS + 1) {
        let all = u64::MAX >> (64 - (1u32 << bits));
        let mut search = Search {
            problem: &problem,
            possible: vec![all; states],
            trail: Vec::new(),
            open: Vec::new(),
            conflicts: vec![0; states],
            steps: 0,
        };
        if search.narrow(initial, 1) && search.propagate() && search.run() {
            let of = search.possible.iter().map(|codes| codes.trailing_zeros()).collect();
            return Found { codes: Some(Codes { of, bits, fewest }), fewest };
        }
        fewest &= search.steps <= STEPS;
    }
    Found { codes: None, fewest: fewest && below <= BITS + 1 }
}

/// What codes have to fulfil.
struct Problem {
    /// Per state those that need other codes.
    apart: Vec<Vec<u32>>,
    /// Per state as a source its occasions and targets.
    from: Vec<Vec<(u32, u32)>>,
    /// Per state as a target its occasions and sources.
    to: Vec<Vec<(u32, u32)>>,
    /// Per occasion sources and targets.
    on: Vec<Vec<(u32, u32)>>,
}

impl Problem {
    fn new(states: usize, conclusions: &[Conclusion], pairs: &[(u32, u32)]) -> Problem {
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
        Problem { apart, from, to, on }
    }
}

struct Search<'a> {
    problem: &'a Problem,
    /// Per state the codes that it may have.
    possible: Vec<u64>,
    /// What was possible before, to go back.
    trail: Vec<(u32, u64)>,
    /// States whose code has become known and that have not been looked at.
    open: Vec<u32>,
    /// Per state how often no code was left for it.
    conflicts: Vec<u32>,
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
        // Those of most neighbours first: then fewer events change bits.
        let around = self.around(state);
        while codes != 0 && self.steps <= STEPS {
            let each = (0..u64::BITS).map(|code| 1 << code).filter(|code| codes & code != 0);
            let liked = each.max_by_key(|&code| {
                (around.iter().filter(|&&other| other == code).count(), Reverse(code))
            });
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

    /// The state with the fewest codes to choose from, then the one that was most often the reason to go back, then the one
    /// about which most is said, then the first.
    fn next(&self) -> Option<u32> {
        let open = (0..self.possible.len()).filter(|&state| !self.possible[state].is_power_of_two());
        let said = |state: usize| self.problem.apart[state].len() + self.problem.from[state].len();
        open.min_by_key(|&state| {
            let around = self.around(state as u32).len();
            (Reverse(self.conflicts[state]), self.possible[state].count_ones(), Reverse(around), Reverse(said(state)))
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
            self.steps += problem.apart[index].len() as u64 + 1;
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
        self.steps += others.len() as u64;
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
        self.steps += others.len() as u64;
        others.iter().all(|&(other, to)| match (self.known(source), self.known(other)) {
            (Some(own), Some(its)) if own == its => self.narrow(to, code),
            _ if self.possible[to as usize] & code != 0 => true,
            (Some(own), _) => self.narrow(other, !own),
            (None, Some(its)) => self.narrow(source, !its),
            (None, None) => true,
        })
    }
}

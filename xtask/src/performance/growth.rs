//! How instructions per state grow with the states of a family.

use super::report::Instructions;

/// By how much instructions per state may grow when states double, in percent.
pub(super) const MOST: f64 = 15.0;

/// A member as growth sees it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Point {
    pub(super) states: u64,
    pub(super) instructions: u64,
}

impl Point {
    pub(super) fn of(states: u64, counts: &Instructions) -> Point {
        Point { states, instructions: counts.iter().map(|(_, count)| count).sum() }
    }

    pub(super) fn per_state(self) -> f64 {
        self.instructions as f64 / self.states.max(1) as f64
    }
}

/// By how many percent instructions per state grow from one member to the next, for each time that the states double. Less
/// than 0 if a state gets cheaper.
pub(super) fn per_doubling(small: Point, large: Point) -> f64 {
    let doublings = (large.states as f64 / small.states as f64).log2();
    ((large.per_state() / small.per_state()).powf(1.0 / doublings) - 1.0) * 100.0
}

#[cfg(test)]
mod tests {
    use super::{Point, per_doubling};

    #[track_caller]
    fn check(states: [u64; 2], instructions: [u64; 2], percent: i64) {
        let point = |i: usize| Point { states: states[i], instructions: instructions[i] };
        assert_eq!(per_doubling(point(0), point(1)).round() as i64, percent);
    }

    #[test]
    fn growth_is_per_doubling() {
        check([100, 200], [1_000, 2_000], 0);
        check([100, 200], [1_000, 2_300], 15);
        check([100, 400], [1_000, 4_840], 10);
        check([100, 200], [1_000, 1_000], -50);
    }
}

//! Decision trees over the attributes that a computation looked at: what it found is kept at a leaf, for every state
//! in which it would see the same.

use super::layout::Layout;
use crate::model::Moment;

/// A node of some tree: a leaf, which is a number of the owner's, a test, or [`UNKNOWN`].
pub(super) type Node = u32;

/// The leaf of whatever comes to nothing.
pub(super) const NOTHING: Node = 0;

/// Nobody has been here yet.
pub(super) const UNKNOWN: Node = u32::MAX;

/// Marks tests; the rest of the number is an index.
const TEST: u32 = 1 << 31;

/// Whether a node is a leaf, for every state.
#[inline]
pub(super) fn is_leaf(node: Node) -> bool {
    node & TEST == 0
}

/// One look at an attribute: the field that holds it, when, and what was seen.
#[derive(Clone, Copy, Debug)]
pub(super) struct Look {
    pub(super) field: u32,
    pub(super) moment: Moment,
    pub(super) value: u32,
}

/// Branches by the value of a field, in the row before the event or in the one behind its effects.
#[derive(Clone, Copy, Debug)]
struct Test {
    field: u32,
    after: bool,
    /// The nodes for the values from 0.
    first: u32,
    count: u32,
}

/// All trees.
#[derive(Clone, Debug, Default)]
pub(super) struct Trees {
    tests: Vec<Test>,
    nodes: Vec<Node>,
}

impl Trees {
    /// The leaf for a state and what the event's effects made of it, or [`UNKNOWN`].
    #[inline]
    pub(super) fn walk(&self, mut node: Node, layout: &Layout, before: &[u64], after: &[u64]) -> Node {
        while !is_leaf(node) && node != UNKNOWN {
            let test = &self.tests[(node ^ TEST) as usize];
            let value = layout.field(test.field as usize).read(if test.after { after } else { before });
            node = if value < test.count { self.nodes[(test.first + value) as usize] } else { UNKNOWN };
        }
        node
    }

    /// The tree with one more leaf, behind these looks.
    pub(super) fn grow(&mut self, node: Node, looks: &[Look], leaf: Node) -> Node {
        debug_assert!(leaf & TEST == 0);
        let Some((look, rest)) = looks.split_first() else { return leaf };
        let test = if node == UNKNOWN {
            self.tests.push(Test {
                field: look.field,
                after: look.moment == Moment::After,
                first: self.nodes.len() as u32,
                count: 0,
            });
            self.tests.len() - 1
        } else {
            (node ^ TEST) as usize
        };
        debug_assert_eq!(self.tests[test].field, look.field, "the same values lead to the same looks");
        if look.value >= self.tests[test].count {
            self.widen(test, look.value);
        }
        let place = (self.tests[test].first + look.value) as usize;
        self.nodes[place] = self.grow(self.nodes[place], rest, leaf);
        TEST | test as u32
    }

    /// Makes room for a value. The nodes move to the end; a value is met first so seldom that the gap does not matter.
    fn widen(&mut self, test: usize, value: u32) {
        let Test { first, count, .. } = self.tests[test];
        let (start, room) = (self.nodes.len(), (value + 1).next_power_of_two());
        self.nodes.extend_from_within(first as usize..(first + count) as usize);
        self.nodes.resize(start + room as usize, UNKNOWN);
        (self.tests[test].first, self.tests[test].count) = (start as u32, room);
    }

    /// Bytes held.
    pub(super) fn memory(&self) -> usize {
        self.tests.capacity() * size_of::<Test>() + self.nodes.capacity() * size_of::<Node>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_leaf_holds_where_the_same_is_seen() {
        let layout = Layout::new(3).widened(&[(0, 3), (1, 7), (2, 1)]);
        let row = |values: [u32; 3]| {
            let mut row = [0];
            (0..3).for_each(|field| layout.field(field).write(&mut row, values[field]));
            row
        };
        let look = |field, moment, value| Look { field, moment, value };
        let mut trees = Trees::default();
        let root = trees.grow(UNKNOWN, &[look(0, Moment::Before, 1)], 7);
        let root = trees.grow(root, &[look(0, Moment::Before, 2), look(1, Moment::After, 5)], NOTHING);
        let root = trees.grow(root, &[look(0, Moment::Before, 2), look(1, Moment::After, 0)], 9);
        let walk = |before, after| trees.walk(root, &layout, &row(before), &row(after));
        assert_eq!(walk([1, 3, 1], [0, 0, 0]), 7);
        assert_eq!(walk([2, 0, 0], [0, 5, 1]), NOTHING);
        assert_eq!(walk([2, 5, 0], [0, 0, 1]), 9);
        assert_eq!(walk([2, 5, 0], [0, 7, 1]), UNKNOWN);
        assert_eq!(walk([3, 0, 0], [0, 0, 0]), UNKNOWN);
        assert_eq!(trees.walk(UNKNOWN, &layout, &[0], &[0]), UNKNOWN);
    }
}

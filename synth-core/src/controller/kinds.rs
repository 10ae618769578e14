//! Which labels the rows of each state have.

use super::Controller;
use hashbrown::HashMap;
use rustc_hash::FxBuildHasher;

const NONE: u32 = u32::MAX;

/// States by their sets of labels: those of the same kind have rows of the same labels.
///
/// Sets are the nodes of a tree (a trie): that of a node is that of its parent and the label on the way down, larger than all
/// before. So it takes one look at a small table per row to find the kind of every state, in the order of the rows.
pub(super) struct Kinds {
    /// Per state its kind.
    pub(super) of: Vec<u32>,
    /// Per kind the one with one label less. The first kind is that of states without rows, and its own parent.
    pub(super) parent: Vec<u32>,
    /// Per kind its largest label.
    pub(super) label: Vec<u32>,
    /// Per kind the number of its labels.
    pub(super) labels: Vec<u32>,
}

impl Kinds {
    /// By the environment's events that states accept. A kind need not have a state, but then others have it for a parent.
    pub(super) fn of_events(controller: &Controller) -> Kinds {
        let mut kinds = Kinds {
            of: vec![0; controller.states as usize],
            parent: vec![0],
            label: vec![NONE],
            labels: vec![0],
        };
        // Per kind the child by the event that is looked at.
        let mut child = vec![NONE];
        for (event, rows) in (0..).zip(&controller.environment) {
            let before = kinds.len();
            for &(source, _) in rows {
                let kind = kinds.of[source as usize];
                let known = child[kind as usize];
                kinds.of[source as usize] = if known == NONE {
                    child[kind as usize] = kinds.len() as u32;
                    kinds.add(kind, event)
                } else {
                    known
                };
            }
            kinds.parent[before..].iter().for_each(|&parent| child[parent as usize] = NONE);
            child.resize(kinds.len(), NONE);
        }
        kinds
    }

    /// By the super steps' lists of events, too, whose labels follow those of the environment's events.
    pub(super) fn of_all_rows(controller: &Controller) -> Kinds {
        let mut kinds = Kinds::of_events(controller);
        let events = controller.events.len() as u32;
        let mut known: HashMap<(u32, u32), u32, FxBuildHasher> = HashMap::default();
        for (&source, &list) in
            controller.super_steps.source.iter().zip(controller.super_steps.events.numbers())
        {
            let kind = kinds.of[source as usize];
            let next = known.entry((kind, list)).or_insert_with(|| kinds.add(kind, events + list));
            kinds.of[source as usize] = *next;
        }
        kinds
    }

    fn add(&mut self, parent: u32, label: u32) -> u32 {
        self.parent.push(parent);
        self.label.push(label);
        self.labels.push(self.labels[parent as usize] + 1);
        self.len() as u32 - 1
    }

    /// Number of kinds.
    pub(super) fn len(&self) -> usize {
        self.parent.len()
    }
}

#[cfg(test)]
mod tests {
    use super::super::fixtures::{controller, controllers};
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeMap;

    fn labels(kinds: &Kinds, state: usize) -> Vec<u32> {
        let mut kind = kinds.of[state];
        let mut labels = Vec::new();
        while kind != 0 {
            labels.insert(0, kinds.label[kind as usize]);
            kind = kinds.parent[kind as usize];
        }
        labels
    }

    #[test]
    fn lists_of_super_steps_are_labels_behind_events() {
        let all = controller("0: a 1, b 2 \n 1! arm.go 0 \n 2! log.x 0 \n 3! arm.go 1 \n 4: b 0");
        let kinds = Kinds::of_all_rows(&all);
        let found: Vec<_> = (0..5).map(|state| labels(&kinds, state)).collect();
        assert_eq!(found, [vec![0, 1], vec![2], vec![3], vec![2], vec![1]]);
    }

    proptest! {
        #[test]
        fn states_are_of_one_kind_if_they_accept_the_same(controller in controllers(12)) {
            let kinds = Kinds::of_events(&controller);
            let mut sets = BTreeMap::new();
            for state in 0..controller.states {
                let accepts = |rows: &Vec<(u32, u32)>| rows.iter().any(|row| row.0 == state);
                let set: Vec<u32> =
                    (0..).zip(&controller.environment).filter(|row| accepts(row.1)).map(|row| row.0).collect();
                let kind = kinds.of[state as usize];
                prop_assert_eq!(&labels(&kinds, state as usize), &set);
                prop_assert_eq!(kinds.labels[kind as usize] as usize, set.len());
                prop_assert_eq!(*sets.entry(set).or_insert(kind), kind);
            }
        }
    }
}

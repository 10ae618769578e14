//! States of an observer that do the same in every context.

use super::machine::{Machine, numbered};
use crate::controller::partition::{Partition, bucket};
use crate::intern::Indexed;

/// Per state its class: the coarsest bisimulation that keeps apart what `initial`, numbers without gaps, keeps apart.
///
/// Takes `O(m log n)` (Valmari and Lehtinen, "Efficient minimization of DFAs with partial transition functions", STACS 2008).
pub(super) fn coarsest(machine: &Machine, initial: &[u32]) -> Vec<u32> {
    let states = machine.len() as u32;
    let count = initial.iter().max().map_or(0, |most| most + 1);
    let mut source = Vec::with_capacity(machine.edges.len());
    for state in 0..states {
        source.resize(source.len() + machine.edges(state).len(), state);
    }
    let target: Vec<u32> = machine.edges.iter().map(|&(_, target)| target).collect();
    let labels = numbered(machine.edges.iter().map(|&(label, _)| label));
    let kinds = labels.iter().max().map_or(0, |most| most + 1);
    let (incoming, by_target) = bucket(&target, states);
    // Edges go by their place in `by_target`, so that those into a state are neighbours.
    let pick =
        |per_edge: &[u32]| -> Vec<u32> { by_target.iter().map(|&edge| per_edge[edge as usize]).collect() };
    let source = pick(&source);
    let mut cords = Partition::new(&pick(&labels), kinds);
    let mut blocks = Partition::new(initial, count);
    // Every edge leads into some block, so one of the first may be left out.
    let (mut cord, mut block) = (0, 1);
    loop {
        while block < blocks.sets() {
            for &state in blocks.elements(block) {
                (incoming[state as usize]..incoming[state as usize + 1]).for_each(|edge| cords.mark(edge));
            }
            cords.split();
            block += 1;
        }
        if cord == cords.sets() {
            return numbered(blocks.into_sets().into_iter());
        }
        for &edge in cords.elements(cord) {
            blocks.mark(source[edge as usize]);
        }
        blocks.split();
        cord += 1;
    }
}

/// Per state a number for its sight and for what is enabled in which context; `None` if a state and a context do not say what
/// is enabled.
pub(super) fn meanings(machine: &Machine, context: &[u32], enabled: &[u32]) -> Option<Vec<u32>> {
    let mut cases: Vec<(u32, u32, u32)> =
        machine.of_entry.iter().zip(context).zip(enabled).map(|((&s, &c), &e)| (s, c, e)).collect();
    cases.sort_unstable();
    cases.dedup();
    if cases.windows(2).any(|pair| (pair[0].0, pair[0].1) == (pair[1].0, pair[1].1)) {
        return None;
    }
    let mut meanings: Indexed<(u32, Vec<(u32, u32)>)> = Indexed::default();
    let per_state = cases.chunk_by(|a, b| a.0 == b.0).map(|cases| {
        let list = cases.iter().map(|&(_, context, enabled)| (context, enabled)).collect();
        meanings.intern((machine.sight[cases[0].0 as usize], list)).0
    });
    Some(per_state.collect())
}

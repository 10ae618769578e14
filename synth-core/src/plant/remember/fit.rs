//! Few bits, for machines that are too large to search for the fewest.

use super::conclude::Conclusion;
use super::machine::Machine;
use super::search::Codes;
use hashbrown::HashMap;
use rustc_hash::FxBuildHasher;

/// So many codes are tried for a state before it gets a new one.
const TRIES: u32 = 64;

/// Codes for states, each the first that fits; the state `initial` has code 0.
///
/// States of one sight have different codes. Tried first are the codes of states that lead to the state or that it leads to,
/// for then often nothing has to change; after them the first ones that its own sight has no use for. Takes time linear
/// in the conclusions.
pub(super) fn fit(machine: &Machine, initial: u32, conclusions: &[Conclusion]) -> Codes {
    let states = machine.len();
    let mut from: Vec<Vec<(u32, u32)>> = vec![Vec::new(); states];
    let mut into: Vec<Vec<u32>> = vec![Vec::new(); states];
    for (group, number) in conclusions.chunk_by(|a, b| a.occasion == b.occasion).zip(0..) {
        for &Conclusion { source, target, .. } in group {
            from[source as usize].push((number, target));
            into[target as usize].push(source);
        }
    }
    let mut taken: HashMap<(u32, u32), u32, FxBuildHasher> = HashMap::default();
    let mut of = vec![u32::MAX; states];
    let mut used = 0;
    // Per sight, below which all codes are taken.
    let mut full: HashMap<u32, u32, FxBuildHasher> = HashMap::default();
    for state in breadth_first(machine, initial) {
        let index = state as usize;
        let fits = |code: u32| {
            from[index].iter().all(|&(occasion, target)| {
                taken.get(&(occasion, code)).is_none_or(|&concluded| concluded == target)
            })
        };
        let around = from[index].iter().map(|&(_, target)| target).chain(into[index].iter().copied());
        let around = around.map(|other| of[other as usize]).filter(|&code| code != u32::MAX);
        let start = full.entry(machine.sight[index]).or_insert(0);
        let code = around.chain(*start..used.min(*start + TRIES)).find(|&code| fits(code)).unwrap_or(used);
        of[index] = code;
        used = used.max(code + 1);
        for &(occasion, target) in &from[index] {
            taken.insert((occasion, code), target);
        }
        if code == *start {
            *start += 1;
        }
    }
    Codes { of, bits: used.max(1).next_power_of_two().trailing_zeros(), fewest: used < 2 }
}

/// All states, by their distance from the initial one.
fn breadth_first(machine: &Machine, initial: u32) -> Vec<u32> {
    let mut reached = vec![false; machine.len()];
    reached[initial as usize] = true;
    let mut order = vec![initial];
    let mut head = 0;
    while let Some(&state) = order.get(head) {
        head += 1;
        for &(_, target) in machine.edges(state) {
            if !std::mem::replace(&mut reached[target as usize], true) {
                order.push(target);
            }
        }
    }
    order
}

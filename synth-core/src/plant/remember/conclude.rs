//! What is concluded from bits that are perhaps old, and the states that are seen now.

use super::machine::{Machine, Observation};
use crate::plant::EventId;
use std::collections::{BTreeMap, BTreeSet};

/// From a state to another on some occasion: two sources with one code need targets with one code.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Conclusion {
    pub(super) occasion: Occasion,
    pub(super) source: u32,
    pub(super) target: u32,
}

/// When bits change.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum Occasion {
    /// A sight is seen, perhaps the one that there was before.
    Seen(u32),
    /// A controllable event is caused in a sight.
    Caused(EventId, u32),
}

/// All that is concluded.
pub(super) struct Conclusions {
    /// What has to be concluded, ascending.
    pub(super) all: Vec<Conclusion>,
    /// What may be concluded from a sight if several explanations lead to one code.
    pub(super) vague: Vec<Conclusion>,
}

/// So many steps are looked at in search of explanations with several events.
const STEPS: usize = 4_000_000;

/// From each state all that happens by itself until the next scan sees it: the fewest events that explain a sight count.
///
/// Nothing has to be concluded from a sight that several plays of more than one event, all of the least length, explain
/// differently. Once [`STEPS`] steps have been looked at, only single events are.
pub(super) fn conclusions(machine: &Machine) -> Conclusions {
    let (mut all, mut vague) = (Vec::new(), Vec::new());
    let mut steps = 0;
    for source in 0..machine.len() as u32 {
        let own = machine.sight[source as usize];
        all.push(Conclusion { occasion: Occasion::Seen(own), source, target: source });
        for &(label, target) in machine.edges(source) {
            if let Observation::Caused(event) = machine.observation(label) {
                all.push(Conclusion { occasion: Occasion::Caused(event, own), source, target });
            }
        }
        let mut explained = BTreeSet::from([own]);
        let mut reached = BTreeSet::from([source]);
        let mut layer = vec![source];
        while !layer.is_empty() {
            let mut found: BTreeMap<u32, BTreeSet<u32>> = BTreeMap::new();
            for &state in &layer {
                steps += machine.edges(state).len();
                for &(label, target) in machine.edges(state) {
                    if let Observation::Seen(sight) = machine.observation(label) {
                        found.entry(sight).or_default().insert(target);
                    }
                }
            }
            layer = found.values().flatten().copied().filter(|&state| reached.insert(state)).collect();
            for (sight, targets) in found {
                if explained.insert(sight) {
                    let list = if targets.len() == 1 { &mut all } else { &mut vague };
                    let occasion = Occasion::Seen(sight);
                    list.extend(targets.into_iter().map(|target| Conclusion { occasion, source, target }));
                }
            }
            if steps > STEPS {
                break;
            }
        }
    }
    all.sort_unstable();
    vague.sort_unstable();
    Conclusions { all, vague }
}

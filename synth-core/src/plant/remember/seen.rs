//! What is concluded from bits that are perhaps old, and the states that are seen now.

use std::collections::{BTreeMap, BTreeSet};

use super::local::Local;
use crate::plant::{EventId, Plant};

/// Per sight, and per class whose code may still be stored when it is seen, the class that is concluded.
pub(super) struct Conclusions {
    classes: u32,
    of: Vec<BTreeMap<u32, u32>>,
}

impl Conclusions {
    /// Sight, stored class, concluded class.
    pub(super) fn all(&self) -> impl Iterator<Item = (u32, u32, u32)> {
        let sights = self.of.iter().zip(0..);
        sights.flat_map(|(of, sight)| of.iter().map(move |(&from, &to)| (sight, from, to)))
    }

    /// Per class those that must not have its code: stored at some sight, they lead to other conclusions.
    pub(super) fn differ(&self) -> Vec<BTreeSet<u32>> {
        let mut differ = vec![BTreeSet::new(); self.classes as usize];
        for of in &self.of {
            for (&a, conclusion) in of {
                let others = of.iter().filter(|(_, other)| *other != conclusion);
                differ[a as usize].extend(others.map(|(&b, _)| b));
            }
        }
        differ
    }
}

/// From each class all that happens by itself until the next scan sees it: the fewest events that explain a sight count.
///
/// Nothing is concluded from a sight that several plays of more than one event, all of the least length, explain
/// differently.
///
/// # Errors
///
/// Two events, or one twice, of which this cannot be told although they are alone: both lead to one sight, or one leads
/// to the sight that there was before, and the class would have to change.
pub(super) fn conclusions(plant: &Plant, local: &Local, class: &[u32]) -> Result<Conclusions, [EventId; 2]> {
    let classes = class.iter().max().map_or(0, |most| most + 1);
    let mut sight_of = vec![0; classes as usize];
    let mut spontaneous = vec![BTreeSet::new(); classes as usize];
    let mut sights = 0;
    for node in 0..local.len() as u32 {
        sight_of[class[node as usize] as usize] = local.sight_of(node);
        sights = sights.max(local.sight_of(node) + 1);
    }
    for edge in local.edges.iter().filter(|edge| !plant.events[edge.event as usize].controllable) {
        let (source, target) = (class[edge.source as usize], class[edge.target as usize]);
        if source != target {
            spontaneous[source as usize].insert((edge.event, target));
        }
    }
    let mut of = vec![BTreeMap::new(); sights as usize];
    for from in 0..classes {
        of[sight_of[from as usize] as usize].insert(from, from);
        let mut explained = BTreeSet::from([sight_of[from as usize]]);
        let mut layer = BTreeSet::from([from]);
        let mut reached = layer.clone();
        for length in 1.. {
            let mut found: BTreeMap<u32, BTreeMap<u32, EventId>> = BTreeMap::new();
            for &source in &layer {
                for &(event, target) in &spontaneous[source as usize] {
                    found.entry(sight_of[target as usize]).or_default().entry(target).or_insert(event);
                }
            }
            layer = found.values().flat_map(BTreeMap::keys).copied().filter(|&c| reached.insert(c)).collect();
            for (sight, targets) in found {
                let events: Vec<EventId> = targets.values().copied().collect();
                let known = !explained.insert(sight);
                if length == 1 && known {
                    return Err([events[0]; 2]);
                }
                match (known, targets.first_key_value()) {
                    (false, Some((&to, _))) if targets.len() == 1 => {
                        of[sight as usize].insert(from, to);
                    }
                    (false, _) if length == 1 => return Err([events[0], events[1]]),
                    _ => {}
                }
            }
            if layer.is_empty() {
                break;
            }
        }
    }
    Ok(Conclusions { classes, of })
}

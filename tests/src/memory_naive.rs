//! Memory straight from its definition, by trying everything; for small closed loops only.
//!
//! A controller sees the states of all components after each event, and knows which controllable events it causes.

use std::collections::{BTreeMap, BTreeSet};
use synth_core::plant::{ClosedLoop, EventId, Plant};

/// What a controller notices.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Notice {
    Caused(EventId),
    Seen(Vec<u16>),
}

fn sight(plant: &Plant, closed: &ClosedLoop, entry: u32) -> Vec<u16> {
    closed.entry(entry as usize)[..plant.components].to_vec()
}

fn enabled(plant: &Plant, closed: &ClosedLoop, entry: u32) -> Vec<EventId> {
    let edges = closed.edges(entry as usize).iter().map(|&(event, _)| event);
    edges.filter(|&event| plant.events[event as usize].controllable).collect()
}

/// What is noticed of an event; nothing if it changes no component and the controller does not cause it.
fn notice(plant: &Plant, closed: &ClosedLoop, from: u32, (event, to): (EventId, u32)) -> Option<Notice> {
    if plant.events[event as usize].controllable {
        return Some(Notice::Caused(event));
    }
    let after = sight(plant, closed, to);
    (after != sight(plant, closed, from)).then_some(Notice::Seen(after))
}

/// Whether an observer always knows what is enabled, by the subset construction.
#[must_use]
pub fn can_be_followed(plant: &Plant, closed: &ClosedLoop) -> bool {
    let (mut noticed, mut unnoticed) = (vec![Vec::new(); closed.len()], vec![Vec::new(); closed.len()]);
    for entry in 0..closed.len() {
        for &edge in closed.edges(entry) {
            match notice(plant, closed, entry as u32, edge) {
                Some(it) => noticed[entry].push((it, edge.1)),
                None => unnoticed[entry].push(edge.1),
            }
        }
    }
    let enabled: Vec<Vec<EventId>> =
        (0..closed.len() as u32).map(|entry| enabled(plant, closed, entry)).collect();
    let unnoticed = |mut known: BTreeSet<u32>| {
        let mut open: Vec<u32> = known.iter().copied().collect();
        while let Some(entry) = open.pop() {
            open.extend(unnoticed[entry as usize].iter().filter(|&&to| known.insert(to)));
        }
        known
    };
    let mut open = vec![unnoticed(BTreeSet::from([closed.initial]))];
    let mut reached: BTreeSet<BTreeSet<u32>> = open.iter().cloned().collect();
    while let Some(known) = open.pop() {
        let all: BTreeSet<&Vec<EventId>> = known.iter().map(|&entry| &enabled[entry as usize]).collect();
        if all.len() > 1 {
            return false;
        }
        let mut next: BTreeMap<&Notice, BTreeSet<u32>> = BTreeMap::new();
        for (notice, to) in known.iter().flat_map(|&entry| &noticed[entry as usize]) {
            next.entry(notice).or_default().insert(*to);
        }
        for known in next.into_values().map(unnoticed) {
            if reached.insert(known.clone()) {
                open.push(known);
            }
        }
    }
    true
}

/// Whether a controller can follow single events with so many bits, one code an entry: old code and what is seen, or what was
/// seen and the event that is caused, say the new code; code and what is seen say what is enabled.
#[must_use]
pub fn bits_do(plant: &Plant, closed: &ClosedLoop, bits: u32) -> bool {
    assign(plant, closed, 1 << bits, &mut Vec::new())
}

fn assign(plant: &Plant, closed: &ClosedLoop, codes: u32, chosen: &mut Vec<u32>) -> bool {
    if !consistent(plant, closed, chosen) {
        return false;
    }
    if chosen.len() == closed.len() {
        return true;
    }
    // Codes that nobody has yet are all the same.
    let fresh = chosen.iter().max().map_or(0, |most| most + 1);
    for code in 0..codes.min(fresh + 1) {
        chosen.push(code);
        if assign(plant, closed, codes, chosen) {
            return true;
        }
        chosen.pop();
    }
    false
}

/// Whether the codes of the first entries contradict nothing.
fn consistent(plant: &Plant, closed: &ClosedLoop, codes: &[u32]) -> bool {
    let code = |entry: u32| codes.get(entry as usize).copied();
    let mut feedback = BTreeMap::new();
    let mut after = BTreeMap::new();
    for entry in 0..codes.len() as u32 {
        let (old, here) = (codes[entry as usize], sight(plant, closed, entry));
        let now = enabled(plant, closed, entry);
        if *feedback.entry((here.clone(), old)).or_insert_with(|| now.clone()) != now {
            return false;
        }
        let mut conclude = |event: Option<EventId>, seen: Vec<u16>, new: Option<u32>| {
            new.is_none_or(|new| *after.entry((event, seen, old)).or_insert(new) == new)
        };
        if !conclude(None, here.clone(), Some(old)) {
            return false;
        }
        for &(event, to) in closed.edges(entry as usize) {
            let right = match plant.events[event as usize].controllable {
                true => conclude(Some(event), here.clone(), code(to)),
                false => conclude(None, sight(plant, closed, to), code(to)),
            };
            if !right {
                return false;
            }
        }
    }
    true
}

/// Whether no two events can happen by themselves in a row, one of which changes what is seen.
#[must_use]
pub fn waits(plant: &Plant, closed: &ClosedLoop) -> bool {
    let own = |entry: u32| {
        closed.edges(entry as usize).iter().filter(|(event, _)| !plant.events[*event as usize].controllable)
    };
    (0..closed.len() as u32)
        .all(|entry| own(entry).all(|&edge| edge.1 == entry || own(edge.1).all(|&(_, to)| to == edge.1)))
}

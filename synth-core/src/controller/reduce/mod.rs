//! Fewer states by what is left open.
//!
//! A controller is read as a Mealy machine in which some events are don't-cares in some states ([`Mealy`]), and the smallest
//! machine is looked for that does all that is specified. That is NP-hard (Pfleeger, "State reduction in incompletely
//! specified finite-state machines", 1973), so it is searched for, by many quick passes of a greedy method ([`cover`])
//! whose preferences differ. How long is counted in steps of work, never in time: the result is always the same.
//!
//! What comes out is a Mealy machine with don't-cares again, so it goes in once more until nothing is gained. Before, it is tried to
//! take the machine apart ([`parts`]), which also works for machines with too many states for a matrix of pairs. If that
//! fails, these are merged without one ([`fold`]).

mod compatible;
mod cover;
mod fold;
mod mealy;
mod parts;
mod random;

use cover::{Found, Policy};
pub(crate) use mealy::Mealy;

/// States for which all pairs are compared: 2 MiB of bits.
const MOST_COMPARED: usize = 1 << 12;
/// States with which every pass that gains anything is followed by another.
const MOST_REPEATED: usize = 1 << 10;
/// Steps of work of the searches at random.
const WORK: u64 = 30_000_000;
/// The same for machines with few states, for each of them and fifty more.
const WORK_PER_STATE: u64 = 20_000;
/// How much longer [`least`] looks for its set than searches do.
const EFFORT: usize = 40;
/// Searches that are not limited.
const CERTAIN: usize = 1;

/// A machine that does all that `mealy` specifies, with as few states as were found.
pub(crate) fn reduce(mealy: Mealy) -> Mealy {
    let product = parts::side_by_side(&mealy).map(searched);
    if mealy.states() > MOST_COMPARED {
        return product.unwrap_or_else(|| merged(mealy));
    }
    let merged = merged(mealy.clone());
    let size = |mealy: &Mealy| (mealy.states(), mealy.table_states());
    let found = product.into_iter().chain([searched(mealy), merged]);
    found.min_by_key(size).expect("there are two at least")
}

/// The size of a set of states of which any two are told apart by some sequence of events: no machine that does what `mealy` specifies has
/// fewer. In large machines it is looked for among the states nearest to the initial one only.
pub(crate) fn least(mealy: &Mealy) -> usize {
    let near = mealy.nearest(MOST_COMPARED << 2);
    let every = vec![true; mealy.events as usize];
    let part = mealy.part(&near, &every);
    let cliques = compatible::cliques(&compatible::incompatible(&part), part.states(), EFFORT);
    cliques.iter().map(Vec::len).max().unwrap_or(0)
}

/// First merged state by state, until that gains less than an eighth and the machine is small enough to be searched.
fn merged(mealy: Mealy) -> Mealy {
    let mut best = mealy;
    loop {
        let members = fold::fold(&best);
        let enough = members.len() > best.states() / 8 * 7;
        if members.len() < best.states() {
            best = folded(&best, &members);
        }
        if enough {
            break;
        }
    }
    searched(best)
}

/// Searches as long as they gain something; large machines stay as they are.
fn searched(mealy: Mealy) -> Mealy {
    let mut best = mealy;
    while best.states() <= MOST_COMPARED
        && let Some(better) = pass(&best)
    {
        // A pass of a large machine is not worth the last percent.
        let last = best.states() > MOST_REPEATED && better.states() > best.states() / 8 * 7;
        best = better;
        if last {
            break;
        }
    }
    best
}

/// The machine of a partition that [`fold::fold`] found.
fn folded(mealy: &Mealy, members: &[Vec<u32>]) -> Mealy {
    let mut class = vec![mealy::NOWHERE; mealy.states()];
    for (number, members) in (0..).zip(members) {
        for &state in members {
            class[state as usize] = number;
        }
    }
    mealy.quotient(members, |_, row| class[row.next as usize])
}

/// Many searches; the best machine that they find, if it is smaller.
fn pass(mealy: &Mealy) -> Option<Mealy> {
    let size = (mealy.states(), mealy.table_states());
    searches(mealy, size, CERTAIN, WORK.min(WORK_PER_STATE * (50 + mealy.states() as u64)))
}

/// A machine with at most so many states, if one is soon found.
fn at_most(mealy: &Mealy, states: usize, work: u64) -> Option<Mealy> {
    searches(mealy, (states + 1, 0), 0, work)
}

/// Searches for what is smaller than `size`: states, then states of tables. The first `certain` come to their end, whatever they take; the
/// others share `left` steps of work.
fn searches(mealy: &Mealy, mut size: (usize, usize), certain: usize, mut left: u64) -> Option<Mealy> {
    let matrix = compatible::incompatible(mealy);
    let cliques = compatible::cliques(&matrix, mealy.states(), 1);
    let least = cliques.iter().map(Vec::len).max().unwrap_or(0);
    let mut best: Option<Mealy> = None;
    for (number, policy) in policies().enumerate() {
        if left == 0 || size.0 <= least {
            break;
        }
        // The first few are what large machines have, so they come to their end.
        let mut unlimited = u64::MAX;
        let budget = if number < certain { &mut unlimited } else { &mut left };
        // As many classes may still be fewer states of tables.
        let bound = size.0 + usize::from(size.1 > 0);
        let Some(found) =
            cover::search(mealy, &matrix, &cliques[number % cliques.len()], policy, bound, budget)
        else {
            continue;
        };
        let machine = covered(mealy, &found);
        let found = (machine.states(), machine.table_states());
        if found < size {
            size = found;
            best = Some(machine);
        }
    }
    best
}

fn covered(mealy: &Mealy, found: &Found) -> Mealy {
    mealy.quotient(&found.members, |class, row| found.target[(class * mealy.events + row.event) as usize])
}

/// What is tried, in this order: first what always comes to its end, then what has proved good, at random.
fn policies() -> impl Iterator<Item = Policy> {
    let plain = Policy { growth: 16, exclusion: 0, evidence: 0, jitter: 1, constrained: false, seed: 0 };
    let certain: [Policy; CERTAIN] = [plain];
    let random = (0..).map(move |seed| {
        let (exclusion, evidence) = [(0, 0), (16, 0), (0, 8), (4, 4)][seed as usize % 4];
        let jitter = if seed < 4 { 1 } else { 8 };
        Policy { growth: 16, exclusion, evidence, jitter, constrained: seed % 3 != 2, seed }
    });
    certain.into_iter().chain(random)
}

#[cfg(test)]
mod tests;

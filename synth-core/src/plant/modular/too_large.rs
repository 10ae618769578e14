//! Products that are hopeless, told before anything is explored.
//!
//! What moves independently multiplies: of the parts of a plant that no event and no constraint connects, every combination of
//! states is explored. So where the product of their sizes is beyond the limits, nobody need wait for that.

use super::super::Plant;
use super::super::packing::Packing;
use super::super::product::{Product, Scope as Explored, initial};
use super::part::Part;
use super::scope::{clusters, scopes, union};
use crate::diagnostic::{Code, Diagnostic, counted};
use crate::explore::Limits;
use crate::syntax::Span;

/// So many states of each part are counted.
const MOST_STATES: usize = 1 << 12;

/// That the product of the whole plant is known to be beyond a limit.
pub(in super::super) fn too_large(plant: &Plant, limits: &Limits) -> Option<Diagnostic> {
    let scopes = scopes(plant);
    let clusters = clusters(&scopes);
    if clusters.len() < 2 {
        return None;
    }
    // The first may be infinite, so the second is what people are told.
    let (mut states, mut digits) = (1_f64, 0_f64);
    for cluster in &clusters {
        let part = Part::new(plant, &union(cluster.iter().map(|&scope| &scopes[scope])));
        let least = least(&part.plant, limits) as f64;
        (states, digits) = (states * least, digits + least.log10());
    }
    let words = Packing::new(plant.automata.iter().map(|automaton| automaton.states.len())).words();
    let memory = states * (words * size_of::<u64>()) as f64;
    let reached = |limit: usize, needed: f64| needed > limit as f64;
    let (limit, unit) = match limits {
        _ if reached(limits.states, states) => (limits.states, "state"),
        _ if reached(limits.memory, memory) => (limits.memory, "byte"),
        _ => return None,
    };
    let message = format!("the limit of {} is too small", counted(limit, unit));
    Some(Diagnostic::error(Code::LimitReached, Span::default(), message).note(format!(
        "the plant falls into {} independent parts, which have at least 10^{} states together",
        clusters.len(),
        digits.floor()
    )))
}

/// At least so many states of a plant are explored.
fn least(plant: &Plant, limits: &Limits) -> usize {
    let few = Limits { states: MOST_STATES, ..*limits };
    match Product::explore(plant, &initial(plant), Explored::All, &few) {
        Ok(product) => (product.rows.len() - product.bad.len()).max(1),
        Err(_) => 1,
    }
}

//! The last word on a controller: its product with the specification, explored from scratch.
//!
//! Whatever solver, extraction, super steps and minimisation did, a controller is emitted only if this stage finds
//! nothing. It shares the language with them (parsing, play-out and the packed form of its moves, `successors`, both of
//! which a naive interpreter checks in the tests), but no exploration, graph, solver or minimiser, and no table that these
//! have filled.
//!
//! A node of the product is a state of the specification, a state of the controller, and how far a super step has
//! come. `shape` asks whether it is a controller at all. `product` goes through all nodes, and `rules` looks in each for what
//! must never happen: an event of the environment that the controller refuses or that violates a guarantee, a command that is
//! not allowed, a super step that ends too early. `fairness` looks for a cycle on which every assumption is kept and some
//! guarantee starves.

mod batch;
pub mod batches;
mod fairness;
mod graph;
mod machine;
mod nodes;
mod product;
mod rules;
mod shape;
mod starving;

use crate::controller::Controller;
use crate::model::Spec;
use crate::playout::{PlayError, Semantics};

/// Why a controller is not verified.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Refutation {
    /// What goes wrong at the end of `play`, or for ever on `cycle`.
    pub reason: String,
    /// Event texts of a shortest play that leads there; a yield is `yield`.
    pub play: Vec<String>,
    /// Event texts of the cycle, if what goes wrong is that something never happens. It is empty, too, if the
    /// environment simply stays silent.
    pub cycle: Vec<String>,
}

/// Why verification could not be brought to an end.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum VerifyError {
    /// The controller does not meet the specification.
    Refuted(Refutation),
    /// The specification itself has a mistake that a play reaches.
    Play(PlayError, Vec<String>),
    /// The product has more nodes than allowed.
    TooLarge(usize),
}

/// Explores the product of `controller` and `spec`.
///
/// Returns the number of its nodes. It runs on at most `threads` threads, or on as many as the machine runs at once if that
/// is 0; the result does not depend on it.
///
/// # Errors
/// See [`VerifyError`]; a product of more than `most_nodes` nodes is given up. Of several faults the one with the shortest
/// play is told.
pub fn verify(
    spec: &Spec,
    semantics: Semantics,
    controller: &Controller,
    most_nodes: usize,
    threads: usize,
) -> Result<usize, VerifyError> {
    if let Some(reason) = shape::fault(controller) {
        return Err(VerifyError::Refuted(Refutation { reason, play: Vec::new(), cycle: Vec::new() }));
    }
    let product = product::Product::explore(spec, semantics, controller, most_nodes, threads)?;
    fairness::check(&product, threads)?;
    Ok(product.graph.nodes())
}

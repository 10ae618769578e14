//! State-feedback controllers: from automata of a plant to one Boolean formula per controllable event.
//!
//! The second route (Côté, St-Denis, Kerjean, "Generative Programming for Programmable Logic Controllers", ETFA 2005).
//! Where the state of a plant can be read from the inputs and outputs of its controller, the controller needs no state of
//! its own: a formula over inputs and outputs says when an event may fire.
//!
//! ```text
//!  .plant text or macro tokens
//!    │ syntax      the grammar                                → ast::File, diagnostics
//!    │ resolve     names become indices                       → Plant
//!    │ product     components and constraints, on the fly     → counts, edges
//!    │ supremal    what must never happen, backwards          → ClosedLoop, or a shortest play into what cannot be avoided
//!    │ memory      bits for what inputs and outputs hide      → Memory
//!    │ formulas    on and off sets, minimised, factored       → Formula per controllable event
//!    ▼ program     rungs and coils                            → Program, which the back ends write
//! ```

pub mod ast;
mod circles;
mod closed_loop;
mod condition;
mod effects;
mod entries;
pub mod event_based;
mod figures;
mod formulas;
#[cfg(feature = "json")]
mod json;
mod loaded;
mod model;
mod modular;
mod moves;
mod never_enabled;
mod packing;
mod parse;
pub mod pipeline;
mod print;
mod product;
mod program;
mod readable;
mod refusal;
pub mod remember;
mod resolve;
mod state_feedback;
mod supremal;
mod text;
mod unnoticed;
mod warnings;
mod why;

pub use closed_loop::ClosedLoop;
pub use condition::Condition;
pub use figures::Figures;
pub use formulas::{DontCare, Formula, FormulaError};
#[cfg(feature = "json")]
pub use json::{Realization, write_json};
pub use loaded::Loaded;
pub use model::{
    Automaton, AutomatonId, Command, Constraint, Edge, Event, EventId, Plant, Rule, Signal, SignalId,
    SignalKind, State, StateRef,
};
pub use modular::{Modular, ModularError, Module, Part, modular};
pub use never_enabled::never_enabled;
pub use parse::{RESERVED, parse_text, parse_tokens};
pub use print::print;
pub use program::{Coil, Drive, Program, Rung, Use, Variable};
pub use readable::unreadable;
pub use refusal::{Reason, Source, Unavoidable};
pub use resolve::resolve;
pub use state_feedback::{Options, StateFeedback, state_feedback};
pub use supremal::{SuperviseError, Synthesis, supervise};
pub use warnings::warnings;
pub use why::Why;

use crate::diagnostic::Diagnostic;
use crate::syntax::FileId;

/// Reads and resolves the text of a file; a plant comes with its warnings.
///
/// # Errors
///
/// All that is wrong with the text, in the order of places.
pub fn read(text: &str, file: FileId) -> Result<(Plant, Vec<Diagnostic>), Vec<Diagnostic>> {
    let (tree, errors) = parse_text(text, file);
    resolved(tree, errors)
}

/// What was parsed, with its names resolved.
fn resolved(
    tree: Option<ast::File>,
    mut errors: Vec<Diagnostic>,
) -> Result<(Plant, Vec<Diagnostic>), Vec<Diagnostic>> {
    // What is declared by a part that could not be read is not unknown.
    let tree = tree.filter(|tree| errors.is_empty() || tree.declares_all);
    match tree.map(|tree| resolve(&tree)) {
        Some((Some(plant), warnings)) if errors.is_empty() => Ok((plant, warnings)),
        Some((None, mut more)) => {
            errors.append(&mut more);
            errors.sort_by_key(|d| d.span.start);
            Err(errors)
        }
        _ => Err(errors),
    }
}

#[cfg(test)]
mod tests;

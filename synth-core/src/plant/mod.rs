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

mod closed_loop;
mod condition;
mod model;
mod program;
pub mod remember;

pub use closed_loop::ClosedLoop;
pub use condition::Condition;
pub use model::{
    Automaton, AutomatonId, Command, Constraint, Edge, Event, EventId, Plant, Rule, Signal, SignalId,
    SignalKind, State, StateRef,
};
pub use program::{Coil, Drive, Program, Rung, Use, Variable};

//! The yardstick: SML's play-out, exploration and GR(1) solution written straight from the language reference.
//!
//! Nothing here is shared with `synth-core` except the syntax tree. Everything is a string, a map, or a vector;
//! names are looked up when they are needed; every fixpoint is the textbook's. It is good for some ten thousand
//! states, and its only merit is that it can be read beside the language reference, section by section:
//!
//! | module | section |
//! |---|---|
//! | [`spec`], [`value`], [`eval`] | 1, the specification, its values and expressions |
//! | [`cut`], [`state`] | 2, states, scenario copies and their cuts |
//! | [`matching`], [`progress`], [`settle`], [`step`] | 3, one step |
//! | [`turn`] | 4, whose turn, and which events |
//! | [`explore()`], [`solve()`] | 5, the game and who wins it |
//!
//! A specification is assumed to be well formed; one that is not gives an error of some kind, never a panic.

pub mod cut;
pub mod eval;
pub mod explore;
pub mod matching;
pub mod product;
pub mod progress;
pub mod settle;
pub mod solve;
pub mod spec;
pub mod state;
pub mod step;
pub mod turn;
pub mod value;

pub use explore::{ExploreError, Figures, Graph, explore};
pub use solve::solve;
pub use spec::Spec;
pub use state::{Copy, State};
pub use step::{PlayError, Step};
pub use turn::{Case, Semantics};
pub use value::{Event, Value};

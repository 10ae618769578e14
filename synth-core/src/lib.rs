//! From scenario specifications to verified controllers.
//!
//! The stages, one module each, in the order in which [`pipeline`] runs them:
//! [`syntax`] → [`model`] → [`playout`]/[`explore`] → [`game`] → [`controller`] → [`verify`] → [`emit`].

pub mod controller;
pub mod diagnostic;
pub mod emit;
pub mod game;
pub mod syntax;

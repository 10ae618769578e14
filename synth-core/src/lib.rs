//! From scenario specifications to verified controllers.
//!
//! The stages, one module each, in the order in which [`pipeline`] runs them:
//! [`syntax`] → [`model`] → [`playout`]/[`explore`] → [`game`] → [`controller`] → [`verify`] → [`emit`].

pub mod controller;
pub mod diagnostic;
pub mod explore;
pub mod game;
pub mod model;
pub mod pipeline;
pub mod playout;
pub mod syntax;
pub mod verify;

//! From scenario specifications to verified controllers.
//!
//! The stages, one module each, in the order in which [`pipeline`] runs them:
//! [`syntax`] → [`model`] → [`playout`] and [`explore`] → [`game`] → [`controller`] → [`verify`] → [`emit`].
//! A stage knows the types of the one before and nothing further back; none of them prints, reads the environment or
//! touches the disk. That is left to the faces: [`embed`] for the macro, [`build`] for build scripts, both with a
//! [`cache`], and the command `sml`; and to [`external`], which explores what memory does not hold.

pub mod build;
pub mod cache;
pub mod controller;
pub mod diagnostic;
pub mod embed;
pub mod emit;
pub mod existential;
pub mod explain;
pub mod explore;
pub mod external;
mod fnv;
pub mod game;
mod index;
mod intern;
pub mod logic;
pub mod model;
mod parallel;
pub mod pipeline;
pub mod plant;
pub mod playout;
pub mod quality;
pub mod successors;
mod suggest;
pub mod symmetry;
pub mod syntax;
#[cfg(test)]
mod testing;
pub mod verdict;
pub mod verify;

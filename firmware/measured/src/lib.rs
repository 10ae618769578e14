//! Plays ten thousand events to a controller, the same on every machine, through functions that can be found in the
//! program: their instructions are counted while it runs, and their code is read.
//!
//! [`cell`] has the production cell's controller, [`line`] one of more than a thousand states.
#![no_std]
#![forbid(unsafe_code)]

mod digest;
mod play;

pub use play::{Outcome, Steps, play};

/// The production cell: 200 states.
pub mod cell {
    include!(concat!(env!("OUT_DIR"), "/production_cell.rs"));
    crate::steps!(production_cell);
}

/// The production line of two presses: more than a thousand states.
pub mod line {
    include!(concat!(env!("OUT_DIR"), "/spec.rs"));
    crate::steps!(production_line);
}

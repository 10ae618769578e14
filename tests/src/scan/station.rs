//! The distribution station's program.

use super::Plan;
use synth_core::explore::Limits;
use synth_core::pipeline::Timings;
use synth_core::plant::{self, Options, Plant, pipeline};
use synth_core::syntax::FileId;

const TEXT: &str = include_str!("../../plants/distribution_station.plant");

/// As it is in its file.
///
/// # Panics
///
/// If the plant is not what it was.
#[must_use]
pub fn plant() -> Plant {
    plant::read(TEXT, FileId::default()).expect("a plant").0
}

/// The station.
///
/// # Panics
///
/// If the plant is not what it was.
#[must_use]
pub fn station() -> Plan {
    let plant = plant();
    let supervised =
        pipeline::control(&plant, &Limits::default(), Options::default(), &mut Timings::default());
    let supervised = supervised.expect("states can be read");
    Plan::new(supervised.feedback.program, plant.events)
}

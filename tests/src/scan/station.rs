//! Programs of plants of the corpus.

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
    plan(plant())
}

/// Programs with bits for constraint automata, the second also with relays of its own.
///
/// # Panics
///
/// If the plants are not what they were.
#[must_use]
pub fn with_memory() -> [Plan; 2] {
    let texts = [include_str!("../../plants/chute.plant"), include_str!("../../plants/mixer.plant")];
    texts.map(|text| plan(plant::read(text, FileId::default()).expect("a plant").0))
}

fn plan(plant: Plant) -> Plan {
    let supervised =
        pipeline::control(&plant, &Limits::default(), Options::default(), &mut Timings::default());
    let supervised = supervised.expect("states can be read");
    Plan::new(supervised.feedback.program, plant.events)
}

//! Families of specifications and plants that grow with a number. The example `family` prints their members.

pub mod arbiter;
pub mod lift;
mod line;
mod plant_text;

pub use arbiter::arbiter;
pub use lift::{cabins, lift};
pub use line::line;
pub use plant_text::plant_text;

use crate::{plant_families, random};

/// A family.
#[derive(Clone, Copy, Debug)]
pub struct Family {
    /// What the example calls it.
    pub name: &'static str,
    /// What there are so many of.
    pub of: &'static str,
    /// The least number that makes sense.
    pub least: u32,
    /// The text of a member.
    pub text: fn(u32) -> String,
}

/// All families.
pub const ALL: [Family; 7] = [
    Family { name: "line", of: "presses", least: 1, text: line },
    Family { name: "lift", of: "floors", least: 2, text: lift },
    Family { name: "two-lifts", of: "floors", least: 2, text: |floors| cabins(floors, 2) },
    Family { name: "arbiter", of: "clients", least: 1, text: arbiter },
    Family { name: "transfer-line", of: "machines", least: 2, text: transfer_line },
    Family { name: "philosophers", of: "philosophers", least: 2, text: philosophers },
    Family { name: "random", of: "the seed", least: 0, text: random_specification },
];

/// The family of this name.
#[must_use]
pub fn by_name(name: &str) -> Option<&'static Family> {
    ALL.iter().find(|family| family.name == name)
}

fn transfer_line(machines: u32) -> String {
    plant_text("TransferLine", &plant_families::transfer_line(machines))
}

fn philosophers(count: u32) -> String {
    plant_text("Philosophers", &plant_families::philosophers(count))
}

fn random_specification(seed: u32) -> String {
    random::specification(u64::from(seed), random::Options { size: 6, features: random::Features::FULL })
}

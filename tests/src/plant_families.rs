//! Families of plants with a parameter, whose feedback is known by counting.

use crate::plant_builder::PlantBuilder;
use synth_core::plant::Plant;

/// Machines in a line, with a buffer of two places between neighbours: the feedback has `2 * 5^(machines - 1)` entries.
#[must_use]
pub fn transfer_line(machines: u32) -> Plant {
    let mut builder = PlantBuilder::new();
    for i in 1..=machines {
        builder = builder.controllable(&format!("start{i}")).uncontrollable(&format!("done{i}"));
    }
    for i in 1..=machines {
        builder = builder.component(&format!("Machine{i}"), &format!("I start{i} W, W done{i} I"));
    }
    for i in 1..machines {
        let (fill, empty) = (format!("done{i}"), format!("start{}", i + 1));
        let edges = format!("0 {fill} 1, 1 {fill} 2, 1 {empty} 0, 2 {empty} 1");
        builder = builder.constraint(&format!("Buffer{i}"), &edges);
    }
    builder.build()
}

/// Philosophers at a round table who take the left fork, then the right one, which is the left one of the next, and lay both
/// down together. All are to be able to think again.
#[must_use]
pub fn philosophers(count: u32) -> Plant {
    let mut builder = PlantBuilder::new();
    for i in 0..count {
        builder = builder.controllable(&format!("left{i} right{i}")).uncontrollable(&format!("down{i}"));
    }
    for i in 0..count {
        let edges = format!("T* left{i} L, L right{i} E, E down{i} T");
        builder = builder.component(&format!("Philosopher{i}"), &edges);
    }
    for i in 0..count {
        let before = (i + count - 1) % count;
        let edges = format!(
            "Free left{i} Left, Left down{i} Free, Free right{before} Right, Right down{before} Free"
        );
        builder = builder.component(&format!("Fork{i}"), &edges);
    }
    builder.build()
}

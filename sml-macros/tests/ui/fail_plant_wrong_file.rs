//! A specification is no plant.

sml_macros::plant!("specs/lamp.sml");

fn main() {}

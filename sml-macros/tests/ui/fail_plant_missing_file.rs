//! A file that is not there.

sml_macros::plant!("specs/gone.plant");

fn main() {}

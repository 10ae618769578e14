//! Mistakes in a file are shown as they stand there.

sml_macros::sml!("specs/wrong.sml");

fn main() {}

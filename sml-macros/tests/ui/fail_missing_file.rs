//! A file that does not exist.

sml_macros::sml!("specs/nowhere.sml");

fn main() {}

//! A folder is no specification.

sml_macros::sml!("specs");

fn main() {}

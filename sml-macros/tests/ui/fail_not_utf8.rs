//! A file in another encoding.

sml_macros::sml!("specs/latin1.sml");

fn main() {}

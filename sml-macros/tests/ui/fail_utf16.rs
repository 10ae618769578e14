//! A file that an editor stored as UTF-16.

sml_macros::sml!("specs/utf16.sml");

fn main() {}

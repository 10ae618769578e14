//! A device is no specification.

sml_macros::sml!("/dev/zero");

fn main() {}

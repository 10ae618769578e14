//! Nothing at all.

sml_macros::sml! {}

fn main() {}

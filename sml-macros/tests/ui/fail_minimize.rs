//! Attributes that choose no level.

sml_macros::sml! { #![minimize = "most"] "specs/lamp.sml" }

fn main() {}

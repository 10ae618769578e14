//! Attributes that choose no engine.

sml_macros::sml! { #![engine = "steam"] "specs/lamp.sml" }
sml_macros::sml! { #![engine(runs)] "specs/lamp.sml" }
sml_macros::sml! { #![motor = "runs"] "specs/lamp.sml" }

fn main() {}

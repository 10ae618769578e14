//! Nothing, and no path.

sml_macros::plant! {}
sml_macros::plant!(17);
sml_macros::plant!("specs/clamp.plant", "specs/bursts.plant");

fn main() {}

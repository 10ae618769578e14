//! Neither a specification nor one path.

sml_macros::sml!("specs/lamp.sml", "specs/clash.sml");
sml_macros::sml!(b"specs/lamp.sml");
sml_macros::sml!(42);

fn main() {}

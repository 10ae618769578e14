//! What one scenario makes urgent, another forbids.

sml_macros::sml!("specs/clash.sml");

fn main() {}

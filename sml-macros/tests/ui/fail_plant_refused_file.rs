//! What nobody can prevent, in a file.

sml_macros::plant!("specs/bursts.plant");

fn main() {}

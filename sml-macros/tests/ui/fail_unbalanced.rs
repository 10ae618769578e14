//! Braces that do not match are Rust's to complain about.

sml_macros::sml! {
    specification Lamp {
        controllable { Control
    }
}

fn main() {}

//! A name that an imported file declares.

sml_macros::sml! {
    import "specs/devices.sml"
    specification Lamp {
        object bulb: Bulb
        controllable { Control }
    }
}

fn main() {}

//! A mistake in an imported file is shown there, at the import.

sml_macros::sml! {
    import "specs/devices.sml"
    import "specs/imports_wrong.sml"
    specification Lamp {
        controllable { Control }
    }
}

fn main() {}

//! Turns the specifications into `$OUT_DIR/production_cell.rs` and `$OUT_DIR/spec.rs`.

use synth_core::build::{Build, compile};

fn main() {
    compile("../../examples/production-cell/specs/production_cell.sml");
    // The assumption that the controller does not need stays as a description.
    Build::new().allow("SML0099").compile("../../tests/specs/line_2/spec.sml");
}

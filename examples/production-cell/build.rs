//! Turns the specification into `$OUT_DIR/production_cell.rs`.

fn main() {
    synth_core::build::compile("specs/production_cell.sml");
}

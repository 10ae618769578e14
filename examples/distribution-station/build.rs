//! Turns the plant into `$OUT_DIR/distribution_station.rs`.

fn main() {
    synth_core::build::compile("specs/distribution_station.plant");
}

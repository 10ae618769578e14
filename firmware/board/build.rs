//! Puts the board's memory where the linker script looks for it.

use std::path::Path;
use std::{env, fs};

fn main() {
    let variable = |name| env::var(name).unwrap_or_else(|_| panic!("cargo sets {name}"));
    let large = env::var_os("CARGO_FEATURE_LARGE").is_some();
    let board = if large { "large".to_owned() } else { variable("TARGET") };
    let memory = format!("memory/{board}.x");
    println!("cargo::rerun-if-changed=memory");
    if Path::new(&memory).exists() {
        let out = variable("OUT_DIR");
        fs::copy(&memory, Path::new(&out).join("memory.x")).expect("the memory's description can be copied");
        println!("cargo::rustc-link-search={out}");
    }
}

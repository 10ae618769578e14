//! Where the texts of a log are: in the program's file, but not in its memory.

fn main() {
    println!("cargo::rustc-link-arg-bins=-Tdefmt.x");
}

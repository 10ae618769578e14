//! The core library of a target, compiled from the sources that come with the compiler, and put where the compiler
//! looks for it: from then on the target is like any other.

use super::folders::Folders;
use super::target::Target;
use super::toolchain::{self, Unpacked};
use crate::failure::{At, Failure, Result};
use crate::process;
use std::ffi::OsStr;
use std::fs;
use std::path::Path;

/// Says that a folder of libraries is complete.
const COMPLETE: &str = "complete";

/// Whether the unpacked compiler has the target's core library.
pub(crate) fn is_there(unpacked: &Unpacked, target: &Target) -> bool {
    unpacked.libraries_of(target).join(COMPLETE).is_file()
}

/// Compiles `core`, `alloc` and `compiler_builtins` with the unpacked compiler.
pub(crate) fn build(folders: &Folders, unpacked: &Unpacked, target: &Target) -> Result<()> {
    println!("compiling the core library for {}", target.triple);
    let krate = folders.core();
    write_crate(&krate)?;
    let root = folders.root();
    let mut cargo = toolchain::cargo();
    unpacked.use_in(&mut cargo);
    cargo
        .current_dir(&krate)
        // What is unstable is so here only.
        .env("RUSTC_BOOTSTRAP", "1")
        .env(
            "RUSTFLAGS",
            format!("-Cdebuginfo=0 -Cembed-bitcode=yes --remap-path-prefix={}=", root.display()),
        )
        .args(["build", "--release", "-Zbuild-std=core,alloc"])
        .args(["-Zbuild-std-features=compiler-builtins-mem", "--target", target.triple])
        .arg("--target-dir")
        .arg(krate.join("target"));
    process::text(&mut cargo)?;

    let to = unpacked.libraries_of(target);
    if to.exists() {
        fs::remove_dir_all(&to).doing(format_args!("remove `{}`", to.display()))?;
    }
    fs::create_dir_all(&to).doing(format_args!("create `{}`", to.display()))?;
    let from = krate.join("target").join(target.triple).join("release/deps");
    let mut copied = 0;
    for entry in fs::read_dir(&from).doing(format_args!("read `{}`", from.display()))? {
        let file = entry.doing(format_args!("read `{}`", from.display()))?.path();
        let name = file.file_name().unwrap_or_default();
        let is_own = name.to_string_lossy().starts_with("libempty-");
        if file.extension() == Some(OsStr::new("rlib")) && !is_own {
            fs::copy(&file, to.join(name)).doing(format_args!("copy `{}`", file.display()))?;
            copied += 1;
        }
    }
    if copied < 3 {
        return Err(Failure::new(format!("the core library for {} has only {copied} parts", target.triple)));
    }
    // What was compiled with another core library does not fit this one.
    for stale in [folders.build().join(target.triple), krate.join("target")] {
        if stale.exists() {
            fs::remove_dir_all(&stale).doing(format_args!("remove `{}`", stale.display()))?;
        }
    }
    fs::write(to.join(COMPLETE), "").doing(format_args!("write into `{}`", to.display()))
}

fn write_crate(folder: &Path) -> Result<()> {
    let manifest = "[package]\nname = \"empty\"\nedition = \"2024\"\n\n[lib]\n\n[workspace]\n";
    let write = || {
        fs::create_dir_all(folder.join("src"))?;
        fs::write(folder.join("Cargo.toml"), manifest)?;
        fs::write(folder.join("src/lib.rs"), "#![no_std]\n")
    };
    write().doing(format_args!("write a crate into `{}`", folder.display()))
}

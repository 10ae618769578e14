//! The oldest compiler that the runtime and generated modules are for, and whether it compiles them: one that rustup has, else
//! that of Debian's packages, unpacked into the target folder.

use crate::bare_metal::apt;
use crate::bare_metal::folders::Folders;
use crate::bare_metal::toolchain::{self, Unpacked};
use crate::failure::{At, Failure, Result};
use crate::process;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const RUNTIME: &str = "controller-template";
/// As `sml export --engine` names them.
const ENGINES: [&str; 4] = ["auto", "search", "runs", "comb"];
const SPECIFICATION: &str = "examples/production-cell/specs/production_cell.sml";

/// Where a compiler is.
enum Compiler {
    Rustup(PathBuf),
    Unpacked(Unpacked),
}

impl Compiler {
    /// The compiler of a version, `1.85`, if it can be had.
    fn find(folders: &Folders, version: &str) -> Result<Option<Compiler>> {
        if let Some(rustc) = of_rustup(version)? {
            return Ok(Some(Compiler::Rustup(rustc)));
        }
        let packages = ["rustc-web", "libstd-rust-web-dev"].map(|name| format!("{name}={version}."));
        let root = folders.older(version);
        if !apt::knows(&packages[0])? {
            return Ok(None);
        }
        apt::unpack(&packages.each_ref().map(String::as_str), &folders.packages(), &root)?;
        Ok(Some(Compiler::Unpacked(Unpacked::at(root))))
    }

    /// Has a command, and what it starts, use it.
    fn use_in(&self, command: &mut Command) {
        match self {
            Compiler::Rustup(rustc) => {
                command.env("RUSTC", rustc);
            }
            Compiler::Unpacked(unpacked) => unpacked.use_in(command),
        }
    }

    /// `rustc 1.85.0`; fails if it is another version.
    fn version(&self, expected: &str) -> Result<String> {
        let mut rustc = match self {
            Compiler::Rustup(rustc) => Command::new(rustc),
            Compiler::Unpacked(unpacked) => Command::new(unpacked.rustc()),
        };
        self.use_in(&mut rustc);
        let said = process::text(rustc.arg("--version"))?;
        let version = said.split(' ').take(2).collect::<Vec<_>>().join(" ");
        if version.starts_with(&format!("rustc {expected}.")) {
            Ok(version)
        } else {
            Err(Failure::new(format!("the compiler of version {expected} says that it is {version}")))
        }
    }
}

fn of_rustup(version: &str) -> Result<Option<PathBuf>> {
    if process::find("rustup").is_none() {
        return Ok(None);
    }
    let list = process::text(Command::new("rustup").args(["toolchain", "list"]))?;
    let mut names = list.lines().filter_map(|line| line.split(' ').next());
    let is_it =
        |name: &&str| name.starts_with(&format!("{version}.")) || name.starts_with(&format!("{version}-"));
    let Some(name) = names.find(is_it) else { return Ok(None) };
    let path = process::text(Command::new("rustup").args(["which", "--toolchain", name, "rustc"]))?;
    Ok(Some(path.trim_end().into()))
}

/// Compiles everything, each with the version that it states. Fails if that of the runtime cannot be had.
pub(crate) fn check() -> Result<()> {
    let folders = Folders::new();
    let metadata = metadata(&folders)?;
    let version = stated(&metadata, RUNTIME)?;
    let compiler = Compiler::find(&folders, &version)?.ok_or_else(|| {
        Failure::new(format!("there is no compiler of version {version}"))
            .help(format!("run `rustup toolchain install {version}`"))
    })?;
    let named = compiler.version(&version)?;
    let build = folders.older(&version).join("build");
    for features in ["", "names", "defmt", "serde", "defmt,names,serde"] {
        check_runtime(&folders, &compiler, &build, features)?;
        println!("{named}: {RUNTIME} with features {features:?}");
    }
    let modules = folders.older(&version).join("modules");
    write_crate(&folders, &modules, &version)?;
    for features in ["", "names", "defmt,names,serde"] {
        let mut cargo = toolchain::cargo();
        compiler.use_in(&mut cargo);
        cargo.current_dir(&modules).args(["check", "--quiet", "--offline", "--features", features]);
        process::text(cargo.arg("--target-dir").arg(&build))?;
        println!("{named}: modules of engines {} with features {features:?}", ENGINES.join(", "));
    }
    check_heapless(&folders, &stated(&metadata, "heapless")?)
}

/// With the version that `heapless` states, if there is one at hand.
fn check_heapless(folders: &Folders, version: &str) -> Result<()> {
    let Some(compiler) = Compiler::find(folders, version)? else {
        println!(
            "feature \"heapless\" is for Rust {version}, as `heapless` states; no such compiler is at hand"
        );
        return Ok(());
    };
    let named = compiler.version(version)?;
    check_runtime(folders, &compiler, &folders.older(version).join("build"), "defmt,heapless,names,serde")?;
    println!("{named}: {RUNTIME} with all features");
    Ok(())
}

fn check_runtime(folders: &Folders, compiler: &Compiler, build: &Path, features: &str) -> Result<()> {
    let mut cargo = toolchain::cargo();
    compiler.use_in(&mut cargo);
    cargo.current_dir(&folders.repository).args(["check", "--quiet", "--locked", "--package", RUNTIME]);
    process::text(cargo.args(["--features", features, "--target-dir"]).arg(build)).map(drop)
}

/// A crate with a generated module of each engine, in the versions that the workspace has of everything.
fn write_crate(folders: &Folders, folder: &Path, version: &str) -> Result<()> {
    let runtime = folders.repository.join(RUNTIME);
    let manifest = format!(
        "[package]\nname = \"modules\"\nversion = \"0.0.0\"\nedition = \"2021\"\nrust-version = \"{version}\"\n\n\
         [features]\ndefmt = [\"controller-template/defmt\"]\nnames = [\"controller-template/names\"]\n\
         serde = [\"controller-template/serde\"]\n\n\
         [dependencies]\ncontroller-template = {{ path = {runtime:?} }}\n\n[workspace]\n"
    );
    let source = folder.join("src");
    let write = || {
        fs::create_dir_all(&source)?;
        fs::write(folder.join("Cargo.toml"), manifest)?;
        fs::copy(folders.repository.join("Cargo.lock"), folder.join("Cargo.lock"))?;
        let modules =
            ENGINES.map(|engine| format!("pub mod {engine} {{\n    include!(\"{engine}.rs\");\n}}\n"));
        fs::write(source.join("lib.rs"), format!("#![no_std]\n#![forbid(unsafe_code)]\n{}", modules.concat()))
    };
    write().doing(format_args!("write a crate into `{}`", folder.display()))?;
    for engine in ENGINES {
        let mut sml = toolchain::cargo();
        sml.current_dir(&folders.repository).args(["run", "--quiet", "--package", "sml-cli", "--", "export"]);
        sml.args([SPECIFICATION, "--target", "rust", "--engine", engine, "--output"]);
        process::text(sml.arg(source.join(format!("{engine}.rs"))))?;
    }
    Ok(())
}

/// What Cargo says of the workspace.
fn metadata(folders: &Folders) -> Result<Value> {
    let mut cargo = toolchain::cargo();
    cargo.current_dir(&folders.repository).args([
        "metadata",
        "--format-version",
        "1",
        "--locked",
        "--all-features",
    ]);
    serde_json::from_str(&process::text(&mut cargo)?).doing("read what `cargo metadata` says")
}

/// The `rust-version` of a package, without a third number.
fn stated(metadata: &Value, package: &str) -> Result<String> {
    let packages = metadata["packages"].as_array().map(Vec::as_slice).unwrap_or_default();
    let stated = packages.iter().filter(|found| found["name"] == package);
    let version = stated.filter_map(|found| found["rust_version"].as_str()).next_back();
    let version = version.ok_or_else(|| Failure::new(format!("`{package}` states no `rust-version`")))?;
    Ok(version.split('.').take(2).collect::<Vec<_>>().join("."))
}

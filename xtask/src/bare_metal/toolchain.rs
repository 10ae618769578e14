//! The compiler, the linker, the emulator and the disassembler of a target: those of this machine where it has them,
//! else those that were unpacked.

use super::core;
use super::folders::Folders;
use super::target::Target;
use crate::failure::{Failure, Result};
use crate::process;
use std::env;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

/// What a program of a target is built, run and read with.
pub(crate) struct Toolchain {
    target: &'static Target,
    /// The unpacked compiler, unless the machine's own has the target.
    unpacked: Option<Unpacked>,
    linker: PathBuf,
    emulator: Tool,
    disassembler: Tool,
    /// Version of the compiler, `rustc 1.96.0`.
    pub(crate) version: String,
}

/// Packages in a folder of their own.
#[derive(Clone, Debug)]
pub(crate) struct Unpacked {
    root: PathBuf,
}

/// A program, and where its libraries are if it was unpacked.
struct Tool {
    program: PathBuf,
    unpacked: Option<Unpacked>,
}

impl Unpacked {
    pub(crate) fn new(folders: &Folders) -> Self {
        Unpacked::at(folders.root())
    }

    pub(crate) fn at(root: PathBuf) -> Self {
        Unpacked { root }
    }

    pub(crate) fn rustc(&self) -> PathBuf {
        self.root.join("usr/bin/rustc")
    }

    /// Where the compiler looks for the libraries of a target.
    pub(crate) fn libraries_of(&self, target: &Target) -> PathBuf {
        self.root.join("usr/lib/rustlib").join(target.triple).join("lib")
    }

    /// Has a command, and what it starts, use the unpacked compiler.
    pub(crate) fn use_in(&self, command: &mut Command) {
        command.env("RUSTC", self.rustc());
        self.libraries_in(command);
    }

    fn libraries_in(&self, command: &mut Command) {
        let multiarch = format!("{}-linux-gnu", env::consts::ARCH);
        let mut folders =
            vec![self.root.join("usr/lib").join(&multiarch), self.root.join("lib").join(&multiarch)];
        folders.extend(env::var_os("LD_LIBRARY_PATH").iter().flat_map(env::split_paths));
        command.env("LD_LIBRARY_PATH", env::join_paths(folders).unwrap_or_default());
    }
}

impl Tool {
    fn command(&self) -> Command {
        let mut command = Command::new(&self.program);
        if let Some(unpacked) = &self.unpacked {
            unpacked.libraries_in(&mut command);
        }
        command
    }
}

/// Cargo, without what it sets for the program that it runs, and without what would change the figures.
pub(crate) fn cargo() -> Command {
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo")));
    let variables = [
        "RUSTFLAGS",
        "CARGO_ENCODED_RUSTFLAGS",
        "RUSTC",
        "RUSTC_WRAPPER",
        "CARGO_BUILD_TARGET",
        // Incremental compilation makes other code.
        "CARGO_INCREMENTAL",
    ];
    for variable in variables {
        cargo.env_remove(variable);
    }
    cargo
}

/// The packages that are missing on this machine for `targets`.
pub(crate) fn missing(targets: &[&Target]) -> Result<Vec<&'static str>> {
    let mut packages = Vec::new();
    if targets.iter().try_fold(false, |any, target| Ok(any || !machine_has(target)?))? {
        packages.extend(["rustc-web", "rust-web-src", "libstd-rust-web-dev"]);
    }
    for target in targets {
        if process::find(target.emulator).is_none() && !packages.contains(&target.package) {
            packages.push(target.package);
        }
    }
    if machine_disassembler()?.is_none() {
        packages.push("llvm");
    }
    Ok(packages)
}

/// Whether the machine's compiler has the target's core library.
pub(crate) fn machine_has(target: &Target) -> Result<bool> {
    Ok(sysroot()?.join("lib/rustlib").join(target.triple).join("lib").is_dir())
}

impl Toolchain {
    /// Finds everything, and fails if something is missing or does not start.
    pub(crate) fn find(folders: &Folders, target: &'static Target) -> Result<Self> {
        let own = Unpacked::new(folders);
        let unpacked = (!machine_has(target)?).then(|| own.clone());
        if let Some(unpacked) = &unpacked
            && !core::is_there(unpacked, target)
        {
            return Err(absent(&format!("the core library of {}", target.triple), target));
        }
        let emulator = match process::find(target.emulator) {
            Some(program) => Tool { program, unpacked: None },
            None => {
                Tool { program: own.root.join("usr/bin").join(target.emulator), unpacked: Some(own.clone()) }
            }
        };
        let disassembler = match machine_disassembler()? {
            Some(program) => Tool { program, unpacked: None },
            None => Tool { program: unpacked_disassembler(&own.root)?, unpacked: Some(own) },
        };
        let linker = machine_tool("rust-lld")?.ok_or_else(|| {
            Failure::new("the toolchain has no `rust-lld`").help("use a toolchain that rustup installed")
        })?;
        for tool in [&emulator, &disassembler] {
            if !tool.program.is_file() {
                return Err(absent(&format!("`{}`", tool.program.display()), target));
            }
            process::text(tool.command().arg("--version"))?;
        }
        let mut rustc = Command::new("rustc");
        if let Some(unpacked) = &unpacked {
            rustc = Command::new(unpacked.rustc());
            unpacked.libraries_in(&mut rustc);
        }
        let version = process::text(rustc.arg("--version"))?;
        let version = version.split(' ').take(2).collect::<Vec<_>>().join(" ");
        Ok(Toolchain { target, unpacked, linker, emulator, disassembler, version })
    }

    /// Cargo for programs of the target, in their workspace.
    pub(crate) fn cargo(&self, folders: &Folders, subcommand: &str) -> Command {
        let mut cargo = cargo();
        let triple = self.target.triple;
        let variable = triple.to_uppercase().replace('-', "_");
        if let Some(unpacked) = &self.unpacked {
            unpacked.use_in(&mut cargo);
        }
        cargo
            .current_dir(folders.firmware())
            .env(format!("CARGO_TARGET_{variable}_LINKER"), &self.linker)
            .env("CARGO_ENCODED_RUSTFLAGS", self.flags(folders).join("\x1f"))
            .args([subcommand, "--release", "--locked", "--target", triple, "--target-dir"])
            .arg(folders.build());
        cargo
    }

    /// Paths in messages of panics must not depend on where this is built: they are in the program.
    fn flags(&self, folders: &Folders) -> Vec<String> {
        let cargo = env::var_os("CARGO_HOME").map_or_else(
            || Path::new(&env::var_os("HOME").unwrap_or_default()).join(".cargo"),
            PathBuf::from,
        );
        let remaps = [(&folders.repository, ""), (&cargo, "cargo")];
        let remaps =
            remaps.into_iter().map(|(from, to)| format!("--remap-path-prefix={}={to}", from.display()));
        let scripts = self.target.scripts.iter().map(|script| format!("-Clink-arg={script}"));
        scripts.chain(remaps).collect()
    }

    /// The emulator with the target's machine.
    pub(crate) fn emulator(&self) -> Command {
        let mut command = self.emulator.command();
        command.args(self.target.machine);
        command
    }

    /// The emulator's option to execute one instruction at a time; its name has changed.
    pub(crate) fn one_instruction_at_a_time(&self) -> Result<&'static [&'static str]> {
        let options = process::text(self.emulator.command().arg("-help"))?;
        let old = options.lines().any(|line| line.starts_with("-singlestep"));
        Ok(if old { &["-singlestep"] } else { &["-accel", "tcg,one-insn-per-tb=on"] })
    }

    pub(crate) fn disassembler(&self) -> Command {
        self.disassembler.command()
    }
}

fn absent(what: &str, target: &Target) -> Failure {
    Failure::new(format!("{what} is not there"))
        .help(format!("run `cargo xtask bare-metal setup {}`", target.triple))
}

fn sysroot() -> Result<PathBuf> {
    Ok(process::text(Command::new("rustc").args(["--print", "sysroot"]))?.trim_end().into())
}

/// A tool that the machine's toolchain brings.
fn machine_tool(name: &str) -> Result<Option<PathBuf>> {
    let version = process::text(Command::new("rustc").arg("-vV"))?;
    let host = version.lines().find_map(|line| line.strip_prefix("host: ")).unwrap_or_default();
    let tool = sysroot()?.join("lib/rustlib").join(host).join("bin").join(name);
    Ok(tool.is_file().then_some(tool))
}

fn machine_disassembler() -> Result<Option<PathBuf>> {
    Ok(machine_tool("llvm-objdump")?.or_else(|| process::find("llvm-objdump")))
}

/// Debian has a version in the folder's name; its link in `/usr/bin` may be absolute.
fn unpacked_disassembler(root: &Path) -> Result<PathBuf> {
    let folders = std::fs::read_dir(root.join("usr/lib")).into_iter().flatten().flatten();
    let mut found: Vec<PathBuf> =
        folders.map(|folder| folder.path().join("bin/llvm-objdump")).filter(|file| file.is_file()).collect();
    found.sort();
    found
        .pop()
        .ok_or_else(|| Failure::new("`llvm-objdump` is not there").help("run `cargo xtask bare-metal setup`"))
}

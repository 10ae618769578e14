//! Builds the program around a machine, runs it, and measures.

use super::figures::{Figures, Outcome};
use super::machines::{self, Machine};
use super::run::Run;
use super::subject::Subject;
use crate::bare_metal::elf::{self, Function};
use crate::bare_metal::emulator;
use crate::bare_metal::folders::Folders;
use crate::bare_metal::target::Target;
use crate::bare_metal::toolchain::Toolchain;
use crate::failure::{At, Failure, Result};
use crate::process;
use nix::sys::resource::{UsageWho, getrusage};
use nix::sys::time::TimeVal;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

/// CPU time after which the compiler is stopped, in seconds.
pub(super) const LIMIT: u64 = 240;

/// Short compilations are repeated, and the least time counts: what it takes more has other reasons.
pub(super) const REPETITIONS: usize = 7;
const SHORT: u64 = 1_000;

/// A Cortex-M3 with enough flash for what is generated from 50,000 transitions.
static BOARD: Target = Target {
    triple: "thumbv7m-none-eabi",
    emulator: "qemu-system-arm",
    package: "qemu-system-arm",
    machine: &["-M", "mps2-an385"],
    scripts: &["-Tlink.x"],
};

/// What is measured with.
pub(super) struct Bench {
    folders: Folders,
    toolchain: Toolchain,
    /// How often what is short is compiled.
    repetitions: usize,
    /// Milliseconds for an empty crate.
    empty: u64,
}

/// One controller, the run of events, and the program around every machine.
pub(super) struct Size {
    pub(super) subject: Subject,
    pub(super) run: Run,
    /// Bytes of flash and RAM of the program whose machine does nothing.
    around: (u64, u64),
}

impl Bench {
    /// Compiles what all programs have in common.
    pub(super) fn new(repetitions: usize) -> Result<Bench> {
        let folders = Folders::new();
        let toolchain = Toolchain::find(&folders, &BOARD)?;
        let folder = folders.compared();
        fs::create_dir_all(&folder).doing(format_args!("create `{}`", folder.display()))?;
        let mut bench = Bench { folders, toolchain, repetitions, empty: 0 };
        // Whatever it depends on is compiled the first time.
        bench.write("machine.rs", b"")?;
        process::text(&mut bench.cargo("machine"))?;
        bench.empty = bench.compile("")?.ok_or_else(|| Failure::new("an empty crate takes too long"))?;
        Ok(bench)
    }

    /// The compiler's version.
    pub(super) fn compiler(&self) -> &str {
        &self.toolchain.version
    }

    pub(super) fn size(&self, transitions: u32) -> Result<Size> {
        let subject = Subject::new(transitions);
        let run = Run::new(&subject);
        self.write("run", &run.events)?;
        self.write("machine.rs", machines::nothing(&subject).as_bytes())?;
        let (sizes, _) = elf::read(&self.program()?)?;
        Ok(Size { subject, run, around: (sizes.text + sizes.data, sizes.data + sizes.bss) })
    }

    /// Builds and runs a machine; fails if it does anything else than it must.
    pub(super) fn measure(&self, size: &Size, machine: Machine) -> Result<Outcome> {
        let source = machine.source(&size.subject);
        let Some(compile) = self.compile(&source)? else { return Ok(Outcome::TooSlow(LIMIT)) };
        let program = self.program()?;
        let (sizes, functions) = elf::read(&program)?;
        let steps: Vec<Function> =
            functions.into_iter().filter(|function| function.name == "machine::step").collect();
        let run = emulator::run(&self.toolchain, &program, &steps)?;
        let output = String::from_utf8_lossy(&run.output);
        let (digest, value) = output.trim_end().split_once(' ').unwrap_or_default();
        if digest != format!("{:08x}", size.run.digest) {
            let (name, right) = (machine.name(), size.run.digest);
            return Err(Failure::new(format!(
                "`{name}` does another thing: digest {digest}, not {right:08x}"
            )));
        }
        let value: u64 = value.parse().doing("read the size of the value")?;
        let count = run.counts.get("machine::step").ok_or_else(|| Failure::new("no step is taken"))?;
        if count.calls != size.run.events.len() as u64 {
            return Err(Failure::new(format!("{} steps were counted", count.calls)));
        }
        let (flash, ram) = size.around;
        Ok(Outcome::Measured(Figures {
            flash: (sizes.text + sizes.data).saturating_sub(flash),
            ram: (sizes.data + sizes.bss).saturating_sub(ram) + value,
            least: count.least,
            mean: count.mean(),
            most: count.most,
            compile: compile.saturating_sub(self.empty),
        }))
    }

    /// Milliseconds of CPU time to compile the crate of a machine; nothing if the limit stopped it.
    fn compile(&self, source: &str) -> Result<Option<u64>> {
        let mut least = u64::MAX;
        for _ in 0..self.repetitions {
            // A new file has to be compiled again.
            self.write("machine.rs", source.as_bytes())?;
            let before = children()?;
            let Output { status, stderr, .. } = process::output(&mut limited(&self.cargo("machine")))?;
            let after = children()?;
            let time = after.user - before.user;
            if !status.success() {
                // The limit goes by another clock, some percent ahead of these times.
                if time + after.system - before.system >= LIMIT * 900 {
                    return Ok(None);
                }
                let said = String::from_utf8_lossy(&stderr);
                let beginning: String = said.lines().take(30).map(|line| format!("{line}\n")).collect();
                return Err(Failure::new(format!("a machine does not compile:\n{beginning}")));
            }
            least = least.min(time);
            if time > SHORT {
                break;
            }
        }
        Ok(Some(least))
    }

    /// Builds the program around the machine.
    fn program(&self) -> Result<PathBuf> {
        process::text(&mut self.cargo("player"))?;
        Ok(self.folders.build().join(BOARD.triple).join("release/player"))
    }

    fn cargo(&self, package: &str) -> Command {
        let folder = self.folders.compared();
        let mut cargo = self.toolchain.cargo(&self.folders, "build");
        cargo
            // Else code is generated for the whole program at once, and not for the crate of the machine.
            .env("CARGO_PROFILE_RELEASE_LTO", "off")
            .env("MACHINE", folder.join("machine.rs"))
            .env("RUN", folder.join("run"))
            .args(["--package", package]);
        cargo
    }

    fn write(&self, name: &str, bytes: &[u8]) -> Result<()> {
        let path = self.folders.compared().join(name);
        fs::write(&path, bytes).doing(format_args!("write `{}`", path.display()))
    }
}

/// The same command, whose processes may use no more CPU time than the limit.
fn limited(command: &Command) -> Command {
    let mut shell = Command::new("sh");
    shell.arg("-c").arg(format!("ulimit -t {LIMIT} && exec \"$0\" \"$@\""));
    shell.arg(command.get_program()).args(command.get_args());
    if let Some(folder) = command.get_current_dir() {
        shell.current_dir(folder);
    }
    for (variable, value) in command.get_envs() {
        match value {
            Some(value) => shell.env(variable, value),
            None => shell.env_remove(variable),
        };
    }
    shell
}

/// CPU time in milliseconds.
struct Time {
    user: u64,
    system: u64,
}

/// Of all processes that have ended.
fn children() -> Result<Time> {
    let usage = getrusage(UsageWho::RUSAGE_CHILDREN).doing("ask for CPU time")?;
    let milliseconds = |time: TimeVal| (time.tv_sec() * 1_000 + time.tv_usec() / 1_000).unsigned_abs();
    Ok(Time { user: milliseconds(usage.user_time()), system: milliseconds(usage.system_time()) })
}

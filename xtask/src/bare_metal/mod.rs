//! The firmware: built for microcontrollers, run in an emulator, measured, and compared with what is expected.

pub(crate) mod apt;
mod core;
pub(crate) mod count;
mod disassembly;
pub(crate) mod elf;
pub(crate) mod emulator;
mod figures;
pub(crate) mod folders;
mod golden;
mod hook;
mod limits;
mod log;
mod panics;
mod programs;
pub(crate) mod target;
pub(crate) mod toolchain;

use crate::failure::{Failure, Result};
use crate::progress::Progress;
use elf::Function;
use folders::Folders;
use golden::Golden;
use programs::{Program, Steps};
use std::fmt::Write as _;
use target::Target;
use toolchain::{Toolchain, Unpacked};

/// Brings what the targets need; does nothing where it is there.
pub(crate) fn setup(targets: &[&'static Target]) -> Result<()> {
    let folders = Folders::new();
    let packages = toolchain::missing(targets)?;
    if !packages.is_empty() {
        apt::unpack(&packages, &folders.packages(), &folders.root())?;
    }
    let unpacked = Unpacked::new(&folders);
    for target in targets {
        if !toolchain::machine_has(target)? && !core::is_there(&unpacked, target) {
            core::build(&folders, &unpacked, target)?;
        }
        let toolchain = Toolchain::find(&folders, target)?;
        println!("{}: ready, {}", target.triple, toolchain.version);
    }
    Ok(())
}

/// Builds, runs and compares every program of the targets. Goes on after a failure, and fails at the end.
pub(crate) fn test(targets: &[&'static Target], bless: bool) -> Result<()> {
    let folders = Folders::new();
    let mut passed = 0;
    let mut failed = 0;
    for target in targets {
        let toolchain = Toolchain::find(&folders, target)?;
        let golden = Golden::new(&folders, target.triple, &toolchain.version, bless);
        let bench = Bench { folders: &folders, toolchain: &toolchain, target, golden: &golden };
        let mut judge = |what: &str, done: Result<String>| match done {
            Ok(figures) => {
                passed += 1;
                println!("{} {what}: {figures}", target.triple);
            }
            Err(failure) => {
                failed += 1;
                eprintln!("{} {what}: {failure}", target.triple);
            }
        };
        for program in programs::ALL.iter().filter(|program| program.is_for(target)) {
            judge(program.name, bench.test(program));
        }
        judge("observer costs", hook::compare(&folders, &toolchain, target));
        judge("panics", panics::prove(&folders, &toolchain).map(|()| "none can be reached".to_owned()));
    }
    if bless && failed == 0 {
        figures::write(&folders)?;
    }
    println!("{passed} passed, {failed} failed");
    if failed == 0 { Ok(()) } else { Err(Failure::new("not every program is as expected")) }
}

/// What programs are tested with.
struct Bench<'b> {
    folders: &'b Folders,
    toolchain: &'b Toolchain,
    target: &'static Target,
    golden: &'b Golden<'b>,
}

impl Bench<'_> {
    /// Builds a program, runs it and compares everything; returns what came out, in short.
    fn test(&self, program: &Program) -> Result<String> {
        let progress = Progress::new();
        progress.tell(&format!("{}: building {}", self.target.triple, program.name));
        let file = program.build(self.folders, self.toolchain, self.target)?;
        let (sizes, functions) = elf::read(&file)?;
        let is_step = |function: &&Function| program.steps.label(&function.name).is_some();
        let steps: Vec<Function> = functions.iter().filter(is_step).cloned().collect();
        progress.tell(&format!("{}: running {}", self.target.triple, program.name));
        let run = emulator::run(self.toolchain, &file, &steps)?;
        drop(progress);
        let output = if program.logs {
            log::decode(&file, &run.output)?
        } else {
            String::from_utf8_lossy(&run.output).into_owned()
        };

        if let Some(on_host) = program.on_host {
            let here = on_host();
            if here != output {
                return Err(Failure::new(format!("on this machine it writes\n{here}and there\n{output}")));
            }
        }
        self.golden.output(program.name, &output)?;
        if sizes.data != 0 {
            let bytes = sizes.data;
            return Err(Failure::new(format!("{bytes} bytes of data: tables and all else belong in flash")));
        }
        self.golden.figures(program.name, "size", &sizes.to_string())?;
        let mut said = format!("text {}, data {}, bss {}", sizes.text, sizes.data, sizes.bss);
        if !matches!(program.steps, Steps::None) {
            let roots: Vec<&Function> = steps.iter().collect();
            let code = disassembly::read(self.toolchain, &file, &functions, &roots)?;
            let mut lines = String::new();
            let labels = code.keys().filter_map(|name| program.steps.label(name));
            let width = labels.map(str::len).max().unwrap_or(0);
            for (name, bytes) in code {
                let count =
                    run.counts.get(name).ok_or_else(|| Failure::new(format!("`{name}` is not called")))?;
                let label = program.steps.label(name).unwrap_or(name);
                if let Steps::LookUps = program.steps {
                    limits::judge(self.target, label, bytes, count)?;
                }
                let _ = writeln!(lines, "{label:width$}  code {bytes:4}  {count}");
            }
            self.golden.figures(program.name, "steps", &lines)?;
            for line in lines.lines() {
                let _ = write!(said, "\n    {line}");
            }
        }
        Ok(said)
    }
}

//! Programs at work in the emulator.

use super::count::{Count, Counter};
use super::elf::Function;
use super::toolchain::Toolchain;
use crate::failure::{At, Failure, Result};
use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::process::{Child, Stdio};
use std::thread;
use std::time::{Duration, Instant};

/// A program that takes longer hangs.
const PATIENCE: Duration = Duration::from_secs(180);

/// What a program did.
pub(crate) struct Run<'f> {
    /// What it wrote.
    pub(crate) output: Vec<u8>,
    /// Instructions of the calls of each function.
    pub(crate) counts: BTreeMap<&'f str, Count>,
}

/// Runs a program to its end, and counts the instructions of `functions` if there are any. Fails if the program does.
pub(crate) fn run<'f>(toolchain: &Toolchain, program: &Path, functions: &'f [Function]) -> Result<Run<'f>> {
    let mut emulator = toolchain.emulator();
    emulator.args(["-nographic", "-monitor", "none", "-serial", "none"]);
    emulator.args(["-semihosting-config", "enable=on,target=native"]);
    if !functions.is_empty() {
        emulator.args(["-d", "exec,nochain"]).args(toolchain.one_instruction_at_a_time()?);
    }
    emulator.arg("-kernel").arg(program);
    emulator.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = emulator.spawn().doing("start the emulator")?;
    let (Some(mut stdout), Some(stderr)) = (child.stdout.take(), child.stderr.take()) else {
        return Err(Failure::new("the emulator has no output"));
    };
    let (output, counts, said, status) = thread::scope(|scope| {
        let output = scope.spawn(move || {
            let mut bytes = Vec::new();
            let _ = stdout.read_to_end(&mut bytes);
            bytes
        });
        // The log of executed instructions comes on the standard error.
        let log = scope.spawn(move || {
            let mut counter = Counter::new(functions);
            let mut said = String::new();
            for line in BufReader::new(stderr).lines() {
                let Ok(line) = line else { break };
                if line.starts_with("Trace ") {
                    counter.line(&line);
                } else {
                    said.push_str(&line);
                    said.push('\n');
                }
            }
            (counter.counts(), said)
        });
        let status = wait(&mut child);
        let (counts, said) = log.join().unwrap_or_default();
        (output.join().unwrap_or_default(), counts, said, status)
    });
    match status? {
        Some(0) => Ok(Run { output, counts }),
        code => {
            let code = code.map_or_else(|| "a signal".to_owned(), |code| code.to_string());
            Err(Failure::new(format!(
                "`{}` ended with {code}:\n{}{said}",
                program.display(),
                String::from_utf8_lossy(&output)
            )))
        }
    }
}

/// The exit code; a program that hangs is ended.
fn wait(child: &mut Child) -> Result<Option<i32>> {
    let start = Instant::now();
    loop {
        if let Some(status) = child.try_wait().doing("wait for the emulator")? {
            return Ok(status.code());
        }
        if start.elapsed() > PATIENCE {
            child.kill().doing("end the emulator")?;
            child.wait().doing("wait for the emulator")?;
            return Err(Failure::new(format!("the program has not ended within {} s", PATIENCE.as_secs())));
        }
        thread::sleep(Duration::from_millis(5));
    }
}

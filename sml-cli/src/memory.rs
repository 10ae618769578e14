//! How much memory there is and this process holds, as Linux tells it, and a watch over it.
//!
//! Exploration counts what it holds and stops by itself. What comes behind it takes several times as much, and how much
//! shows only on the way; and so do states with thousands of moves. So somebody looks at the process as a whole, and ends it
//! before the system runs out of memory and ends whatever it likes.

use crate::failure::{Exit, Failure, nowhere};
use crate::options::Format;
use crate::output;
use std::sync::{Mutex, Once, PoisonError};
use std::thread;
use std::time::Duration;
use synth_core::diagnostic::{Code, counted};

/// How often the watch looks. A process fills some ten MiB meanwhile.
const PERIOD: Duration = Duration::from_millis(10);

/// Most bytes that this process has held so far.
pub(crate) fn peak() -> Option<u64> {
    of_process("VmHWM:")
}

/// Bytes that this process holds now.
fn held() -> Option<u64> {
    of_process("VmRSS:")
}

/// Bytes that are free.
pub(crate) fn free() -> Option<u64> {
    entry("/proc/meminfo", "MemAvailable:")
}

fn of_process(name: &str) -> Option<u64> {
    entry("/proc/self/status", name)
}

/// A line of a list of sizes.
fn entry(list: &str, name: &str) -> Option<u64> {
    let text = std::fs::read_to_string(list).ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix(name))?;
    let kibibytes: u64 = line.trim().strip_suffix(" kB")?.parse().ok()?;
    kibibytes.checked_mul(1024)
}

/// Bytes that a process holds that has hardly anything to do.
const IDLE: u64 = 16 << 20;

/// From now on the command ends, as when exploration reaches its limit, once it holds more than so many bytes. `found` says how far it
/// came; another call says how far it came since. Where the system does not tell what it holds, nothing is watched.
pub(crate) fn watch(limit: usize, found: String, format: Format, color: bool) {
    static WATCHED: Once = Once::new();
    static FOUND: Mutex<String> = Mutex::new(String::new());
    let how_far = || FOUND.lock().unwrap_or_else(PoisonError::into_inner);
    *how_far() = found;
    let most = IDLE.saturating_add(limit as u64);
    let look = move || {
        while let Some(held) = held() {
            if held > most {
                output::end(&too_much(limit, how_far().clone()), format, color);
            }
            thread::sleep(PERIOD);
        }
    };
    // Without a thread there is no watch, as on other systems.
    WATCHED.call_once(|| drop(thread::Builder::new().spawn(look)));
}

fn too_much(limit: usize, found: String) -> Failure {
    let message = format!("the limit of {} was reached", counted(limit, "byte"));
    let error = nowhere(Code::LimitReached, message)
        .note(found)
        .help("raise `--max-memory`, or make what is described smaller");
    Failure::new(Exit::Limit, error)
}

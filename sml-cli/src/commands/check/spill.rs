//! `--spill DIR`: exploration with files, for games that memory does not hold.

use crate::failure::{Exit, Failure, nowhere};
use crate::options::Format;
use crate::session::Session;
use crate::{interrupt, output};
use serde_json::json;
use std::fs::{self, File, OpenOptions};
use std::io;
use std::path::Path;
use synth_core::diagnostic::Code;
use synth_core::external::Census;
use synth_core::model::Spec;
use synth_core::syntax::Loaded;

/// A process has a lock on it as long as it works in the folder.
const LOCK: &str = "sml.lock";

/// Explores in a folder, alone there, until done or asked to stop.
pub(super) fn explore(
    folder: &Path,
    loaded: &Loaded,
    spec: &Spec,
    session: &mut Session,
) -> Result<Census, Failure> {
    let cannot = |error: &io::Error| Failure::unwritable(&folder.display().to_string(), error);
    fs::create_dir_all(folder).map_err(|error| cannot(&error))?;
    let _lock = lock(&folder.join(LOCK)).map_err(|error| cannot(&error))?;
    interrupt::listening(|| session.census(folder, loaded, spec))
}

#[cfg(unix)]
fn lock(path: &Path) -> io::Result<nix::fcntl::Flock<File>> {
    use nix::fcntl::{Flock, FlockArg};
    let file = OpenOptions::new().write(true).create(true).truncate(false).open(path)?;
    Flock::lock(file, FlockArg::LockExclusiveNonblock).map_err(|(_, error)| match error {
        nix::Error::EWOULDBLOCK => io::Error::other("another process works there"),
        error => error.into(),
    })
}

#[cfg(windows)]
fn lock(path: &Path) -> io::Result<File> {
    use std::os::windows::fs::OpenOptionsExt as _;
    OpenOptions::new().write(true).create(true).truncate(false).share_mode(0).open(path)
}

#[cfg(not(any(unix, windows)))]
fn lock(path: &Path) -> io::Result<File> {
    OpenOptions::new().write(true).create(true).truncate(false).open(path)
}

/// Says how large the game is, and that nobody knows who wins.
pub(super) fn report(
    census: &Census,
    spec: &Spec,
    memory: usize,
    session: &Session,
) -> Result<Exit, Failure> {
    let needed = census.memory_to_solve();
    let message =
        format!("who wins is not known: solving takes about {needed} bytes, and the limit is {memory}");
    let error = nowhere(Code::LimitReached, message)
        .note("all states were explored and counted")
        .help("raise `--max-memory`, on a larger machine if need be, or make what is described smaller");
    let failure = Failure::new(Exit::Limit, error);
    if session.format() == Format::Json {
        let Census { states, transitions, system_states, environment_states, .. } = census;
        let Census { yielded_states, idle_states, assumption_sets, guarantee_sets, .. } = census;
        let document = json!({
            "version": 1, "states": states, "transitions": transitions, "system_states": system_states,
            "environment_states": environment_states, "yielded_states": yielded_states,
            "idle_states": idle_states, "assumption_sets": assumption_sets, "guarantee_sets": guarantee_sets,
            "depth": census.depth, "bytes_on_disk": census.bytes, "diagnostics": failure.json(),
        });
        output::print(&format!("{document}\n"))?;
        return Ok(Exit::Limit);
    }
    let mut text = format!("{}: explored\n", spec.name);
    text.push_str(&super::rows([
        ("states", census.states),
        ("transitions", census.transitions),
        ("system states", census.system_states),
        ("environment states", census.environment_states),
        ("yielded states", census.yielded_states),
        ("idle states", census.idle_states),
        ("assumption sets", census.assumption_sets),
        ("guarantee sets", census.guarantee_sets),
        ("depth", census.depth),
        ("bytes on disk", census.bytes),
    ]));
    output::print(&text)?;
    Err(failure)
}

//! Exploration with files: `sml check --spill`.

use crate::support::{Run, command, finish, listing, scratch, sml, switches};
use nix::sys::signal::{Signal, kill};
use nix::unistd::Pid;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// `check` with a limit that is too low to solve, in a folder beside the file.
fn arguments(file: &Path) -> String {
    let folder = file.with_file_name("spilled");
    format!("check {} --spill {} --max-memory 2M --format json", file.display(), folder.display())
}

#[track_caller]
fn explored(run: &Run, switches: u32) {
    assert_eq!(run.code, 3, "{}{}", run.stdout, run.stderr);
    let document = run.json();
    let states = u64::from(switches + 1) << switches;
    assert_eq!(document["states"], states, "{document}");
    assert_eq!(document["transitions"], u64::from(2 * switches) << switches, "{document}");
    assert_eq!(document["diagnostics"][0]["code"], "SML0054");
    assert!(document.get("realizable").is_none());
}

#[test]
fn what_fits_is_solved_as_ever() {
    for name in ["memory", "line_2", "unreal_clash", "production_cell"] {
        let folder = scratch(&format!("spill_{name}"));
        let plain = sml(&format!("check {name}/spec.sml --format json"));
        let spilled = sml(&format!("check {name}/spec.sml --format json --spill {}", folder.display()));
        assert_eq!((spilled.code, spilled.json()), (plain.code, plain.json()), "{name}");
    }
}

#[test]
fn what_does_not_fit_is_counted() {
    let file = switches("spill_counts", 12);
    explored(&sml(&arguments(&file)), 12);
    let again = sml(&arguments(&file).replace(" --format json", ""));
    assert_eq!(again.code, 3);
    assert!(again.stdout.contains(&format!("{:>10}", 13 << 12)), "{}", again.stdout);
    assert!(again.stderr.contains("who wins is not known"), "{}", again.stderr);
}

/// Starts the command, and sends a signal once there is a checkpoint.
#[track_caller]
fn interrupted(file: &Path, signal: Signal) -> Run {
    let mut command = command(&arguments(file));
    let child = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
    let child = child.expect("the command runs");
    let start = Instant::now();
    while !file.with_file_name("spilled").join("sml.checkpoint").exists() {
        assert!(start.elapsed() < Duration::from_secs(60), "no checkpoint");
        sleep(Duration::from_millis(1));
    }
    kill(Pid::from_raw(child.id() as i32), signal).expect("it runs");
    let output = child.wait_with_output().expect("it ends");
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    Run {
        code: output.status.code().expect("no signal ends it"),
        stdout: text(output.stdout),
        stderr: text(output.stderr),
    }
}

#[test]
fn a_signal_leaves_a_checkpoint() {
    for (name, signal) in [("spill_int", Signal::SIGINT), ("spill_term", Signal::SIGTERM)] {
        let file = switches(name, 13);
        let run = interrupted(&file, signal);
        assert_eq!((run.code, run.diagnostic().as_str()), (130, "SML0112"), "{}{}", run.stdout, run.stderr);
        assert!(run.stderr.contains("stopping"), "{}", run.stderr);
        explored(&sml(&arguments(&file)), 13);
    }
}

#[test]
fn one_process_at_a_time() {
    use nix::fcntl::{Flock, FlockArg};
    let file = switches("spill_lock", 3);
    let folder = file.with_file_name("spilled");
    fs::create_dir(&folder).expect("a folder");
    let lock = fs::File::create(folder.join("sml.lock")).expect("a file");
    let lock = Flock::lock(lock, FlockArg::LockExclusiveNonblock).expect("a lock");
    let run = sml(&arguments(&file));
    assert_eq!((run.code, run.diagnostic().as_str()), (4, "SML0103"), "{}", run.stdout);
    assert!(run.stdout.contains("another process works there"), "{}", run.stdout);
    assert_eq!(listing(&folder), ["sml.lock"]);
    drop(lock);
    assert_eq!(sml(&arguments(&file)).code, 0);
}

/// No file may be longer than 32 KiB: as on a full disk, writing fails. What was there before is as good as it was.
#[test]
fn a_full_disk_is_4_and_can_be_mended() {
    let file = switches("spill_full", 13);
    let script =
        format!("trap '' XFSZ; ulimit -f 64; exec {} {}", env!("CARGO_BIN_EXE_sml"), arguments(&file));
    let run = finish(Command::new("sh").args(["-c", &script]).stdin(Stdio::null()));
    assert_eq!((run.code, run.diagnostic().as_str()), (4, "SML0103"), "{}{}", run.stdout, run.stderr);
    explored(&sml(&arguments(&file)), 13);
}

#[test]
fn folders_of_something_else_are_refused() {
    let folder = scratch("spill_other");
    let run = |arguments: &str| sml(&format!("{arguments} --format json --spill {}", folder.display()));
    assert_eq!(run("check memory/spec.sml").code, 0);
    for arguments in ["check line_2/spec.sml", "check memory/spec.sml --classic"] {
        let run = run(arguments);
        assert_eq!((run.code, run.diagnostic().as_str()), (2, "SML0111"), "{arguments}: {}", run.stdout);
    }
    fs::write(folder.join("sml.checkpoint"), "sml exploration 1\nwhatever").expect("written");
    let damaged = run("check memory/spec.sml");
    assert_eq!((damaged.code, damaged.diagnostic().as_str()), (2, "SML0111"), "{}", damaged.stdout);
    let file = folder.join("sml.checkpoint");
    let run = sml(&format!("check memory/spec.sml --format json --spill {}", file.display()));
    assert_eq!((run.code, run.diagnostic().as_str()), (4, "SML0103"), "{}", run.stdout);
    let plant = crate::support::plant("tank");
    let run = sml(&format!("check {plant} --format json --spill {}", folder.display()));
    assert_eq!((run.code, run.diagnostic().as_str()), (2, "SML0100"), "{}", run.stdout);
}

//! Being asked to stop while something runs that can be gone on with.

use crate::failure::Exit;
use crate::output;
use std::process;
use std::sync::atomic::{AtomicBool, Ordering};

/// Somebody looks at [`ASKED`].
static LISTENING: AtomicBool = AtomicBool::new(false);
static ASKED: AtomicBool = AtomicBool::new(false);

/// Runs something that looks at [`asked`] now and then. Meanwhile Ctrl-C and the signals that ask to end only raise a flag, the
/// first time.
pub(crate) fn listening<T>(run: impl FnOnce() -> T) -> T {
    let handler = || {
        if !LISTENING.load(Ordering::SeqCst) || ASKED.swap(true, Ordering::SeqCst) {
            process::exit(Exit::Interrupted as i32);
        }
        output::note("stopping; once more stops at once, and goes back to the last checkpoint");
    };
    // Where the system has none of it, the command ends as usual, and the last checkpoint is as good.
    let _ = ctrlc::set_handler(handler);
    LISTENING.store(true, Ordering::SeqCst);
    let result = run();
    LISTENING.store(false, Ordering::SeqCst);
    result
}

/// Whether somebody asked to stop.
pub(crate) fn asked() -> bool {
    ASKED.load(Ordering::SeqCst)
}

//! What is going on, on a terminal only.

use std::io::{IsTerminal, Write, stderr};

/// A line on the terminal that is replaced by the next, and gone at the end.
pub(crate) struct Progress(bool);

impl Progress {
    pub(crate) fn new() -> Self {
        Progress(stderr().is_terminal())
    }

    pub(crate) fn tell(&self, what: &str) {
        if self.0 {
            eprint!("\r\x1b[K{what}");
            let _ = stderr().flush();
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.tell("");
    }
}

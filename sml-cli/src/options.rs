//! What can be asked on the command line: the subcommands and the options that all of them share.

use crate::commands::Command;
use crate::memory;
use clap::{Args, Parser, ValueEnum};
use std::num::NonZeroUsize;
use synth_core::controller::Level;
use synth_core::explore::Limits;
use synth_core::playout::Semantics;

/// From scenario specifications to verified controllers.
///
/// Exit codes: 0 done; 1 unrealizable, not verified, stale or not executable; 2 wrong content or wrong usage;
/// 3 a limit was reached; 4 a file cannot be opened or written; 130 interrupted, and can be resumed.
#[derive(Debug, Parser)]
#[command(name = "sml", version, propagate_version = true)]
pub(crate) struct Cli {
    #[command(flatten)]
    pub(crate) common: Common,
    #[command(subcommand)]
    pub(crate) command: Command,
}

/// Options of every subcommand.
#[derive(Args, Clone, Debug)]
pub(crate) struct Common {
    /// Output for people or for programs
    #[arg(long, global = true, value_enum, default_value_t = Format::Text)]
    pub(crate) format: Format,
    /// Literal GR(1) reading: the system may win by breaking an assumption, and the environment is silent only where
    /// it has no event
    #[arg(long, global = true)]
    classic: bool,
    /// Give up when there are more states than this
    #[arg(long, global = true, value_name = "N")]
    max_states: Option<usize>,
    /// Give up when more bytes than this are needed; K, M and G may follow the number. Without it, three quarters of the memory
    /// that is free at the start, where the system says how much that is
    #[arg(long, global = true, value_name = "BYTES", value_parser = bytes)]
    max_memory: Option<usize>,
    /// Number of threads that explore and verify; by default as many as the machine runs at once. No result depends on it
    #[arg(long, global = true, value_name = "N")]
    threads: Option<NonZeroUsize>,
    /// Print time and size of every stage to stderr
    #[arg(long, global = true)]
    pub(crate) timings: bool,
    /// Colors in messages; `auto` also honours the variable NO_COLOR
    #[arg(long, global = true, value_enum, default_value_t = Color::Auto)]
    pub(crate) color: Color,
}

impl Common {
    /// How the winning condition is read.
    pub(crate) fn semantics(&self) -> Semantics {
        Semantics { classic: self.classic }
    }

    /// When to give up.
    pub(crate) fn limits(&self) -> Limits {
        let unlimited = Limits::default();
        Limits {
            states: self.max_states.map_or(unlimited.states, |states| states.min(unlimited.states)),
            memory: self.max_memory.or_else(most_of_free_memory).unwrap_or(unlimited.memory),
            threads: self.threads.map_or(unlimited.threads, NonZeroUsize::get),
        }
    }
}

/// Three quarters of the free memory.
fn most_of_free_memory() -> Option<usize> {
    memory::free().map(|bytes| usize::try_from(bytes / 4 * 3).unwrap_or(usize::MAX))
}

/// Who reads the output.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub(crate) enum Format {
    /// People
    Text,
    /// Programs
    Json,
}

/// When messages are colored.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub(crate) enum Color {
    /// On a terminal
    Auto,
    /// Always
    Always,
    /// Never
    Never,
}

/// How the controller is made smaller.
#[derive(Args, Clone, Copy, Debug)]
pub(crate) struct Minimize {
    /// How the controller is made smaller
    #[arg(long, value_enum, default_value_t = Minimization::Exact)]
    pub(crate) minimize: Minimization,
    /// The same as `--minimize none`
    #[arg(long, conflicts_with = "minimize")]
    no_minimize: bool,
}

impl Minimize {
    pub(crate) fn level(self) -> Level {
        match self.minimize {
            _ if self.no_minimize => Level::None,
            Minimization::None => Level::None,
            Minimization::Exact => Level::Exact,
            Minimization::Assume => Level::Assume,
            Minimization::Ordered => Level::Ordered,
        }
    }
}

impl Minimize {
    /// Whether something other than the default is asked for.
    pub(crate) fn is_given(self) -> bool {
        self.no_minimize || self.minimize != Minimization::Exact
    }
}

/// Values of `--minimize`.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub(crate) enum Minimization {
    /// Every state of the strategy
    None,
    /// Merges states that no environment can tell apart
    Exact,
    /// Also merges states that differ only in events that cannot be pending there, however many come in one scan
    Assume,
    /// Also merges states that differ only in events that cannot happen there if each is answered before the next; for programs
    /// that feed one event at a time
    Ordered,
}

/// A number of bytes: decimal digits, and perhaps K, M or G for powers of 1024.
fn bytes(text: &str) -> Result<usize, String> {
    let (digits, shift) = match text.char_indices().next_back() {
        Some((end, 'K' | 'k')) => (&text[..end], 10),
        Some((end, 'M' | 'm')) => (&text[..end], 20),
        Some((end, 'G' | 'g')) => (&text[..end], 30),
        _ => (text, 0),
    };
    let number: usize = digits.parse().map_err(|_| "expected a number, perhaps with K, M or G".to_owned())?;
    number.checked_mul(1 << shift).ok_or_else(|| "more than there can be".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory as _;

    #[test]
    fn options_do_not_contradict_each_other() {
        Cli::command().debug_assert();
    }

    #[track_caller]
    fn check(text: &str, expect: Option<usize>) {
        assert_eq!(bytes(text).ok(), expect, "{text}");
    }

    #[test]
    fn sizes() {
        check("17", Some(17));
        check("2K", Some(2048));
        check("3m", Some(3 << 20));
        check("1G", Some(1 << 30));
        for wrong in ["", "K", "-1", "1.5G", "1KB", "é", "99999999999999999999", "99999999999999999G"] {
            check(wrong, None);
        }
    }
}

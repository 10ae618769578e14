//! Options of the program that is made for a plant.

use clap::ValueEnum;
use synth_core::plant::{self, Options};

/// What program is made.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(crate) struct Rungs {
    /// Plants: what formulas may do where the plant cannot be; `none` otherwise
    #[arg(long, value_enum)]
    dont_care: Option<DontCare>,
    /// Plants: conditions are disjunctions of terms, not factored
    #[arg(long)]
    two_level: bool,
    /// Plants: what several conditions have in common is found once, where that takes fewer instructions
    #[arg(long)]
    share: bool,
    /// Plants: at most one event a scan, the first in the order of the file
    #[arg(long)]
    extract: bool,
    /// Plants: a supervisor per constraint, with the components that it is about, where the product of all is too large
    #[arg(long, conflicts_with = "share")]
    modular: bool,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum DontCare {
    /// Values that are no state issue no command
    None,
    /// Free in states of the components that are never reached
    Decodable,
    /// Free for all values that are no reachable state
    All,
}

impl Rungs {
    /// The options, and whether they are given.
    pub(crate) fn given(self) -> [(&'static str, bool); 5] {
        let Rungs { dont_care, two_level, share, extract, modular } = self;
        [
            ("--dont-care", dont_care.is_some()),
            ("--two-level", two_level),
            ("--share", share),
            ("--extract", extract),
            ("--modular", modular),
        ]
    }

    pub(super) fn options(self) -> Options {
        Options {
            dont_care: match self.dont_care {
                Some(DontCare::All) => plant::DontCare::All,
                Some(DontCare::Decodable) => plant::DontCare::Decodable,
                Some(DontCare::None) | None => plant::DontCare::None,
            },
            two_level: self.two_level,
            share: self.share,
            extract: self.extract,
        }
    }

    /// Whether every constraint is supervised by itself.
    pub(super) fn is_modular(self) -> bool {
        self.modular
    }

    /// As in a command line, as far as they are not the defaults.
    pub(super) fn words(self) -> String {
        format!("{}{}", self.options().words(), if self.modular { " --modular" } else { "" })
    }
}

//! Options of Structured Text.

use super::target::Xml;
use clap::ValueEnum;
use synth_core::emit::st;

/// Options of Structured Text.
#[derive(Debug, clap::Args)]
pub(super) struct StructuredText {
    #[command(flatten)]
    pub(super) xml: Xml,
    /// Structured Text: an input raises its event when it becomes TRUE, or in every call in which it is
    #[arg(long, value_enum)]
    trigger: Option<Trigger>,
    /// Structured Text: what becomes of events that fit nowhere
    #[arg(long, value_enum)]
    unexpected: Option<Unexpected>,
    /// Structured Text: the integer types of states
    #[arg(long, value_enum)]
    integers: Option<Integers>,
    /// Structured Text: a call does all super steps that are due, up to a second command to a component
    #[arg(long)]
    drain: bool,
    /// Structured Text: how the tables hold transitions
    #[arg(long, value_enum)]
    pub(super) encoding: Option<Encoding>,
    /// Structured Text: one more output, `owed`: which events the environment owes
    #[arg(long)]
    owed: bool,
    /// Structured Text: state and pending events survive a power cycle, unless the tables are others afterwards
    #[arg(long)]
    retain: bool,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Trigger {
    Edge,
    Level,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Unexpected {
    Keep,
    Drop,
    Fault,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Integers {
    Unsigned,
    Signed,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum Encoding {
    /// One array of targets, and runs of consecutive states
    Runs,
    /// Two arrays per event, as published
    Rows,
}

impl StructuredText {
    /// The options, and whether they are given.
    pub(super) fn given(&self) -> [(&'static str, bool); 7] {
        let StructuredText { trigger, unexpected, integers, drain, encoding, owed, retain, .. } = self;
        [
            ("--trigger", trigger.is_some()),
            ("--unexpected", unexpected.is_some()),
            ("--integers", integers.is_some()),
            ("--drain", *drain),
            ("--encoding", encoding.is_some()),
            ("--owed", *owed),
            ("--retain", *retain),
        ]
    }

    pub(super) fn owed(&self) -> bool {
        self.owed
    }

    pub(super) fn is_given(&self) -> bool {
        self.given().into_iter().any(|(_, is_given)| is_given)
    }

    pub(super) fn options(&self, target: st::Target) -> st::Options {
        st::Options {
            target,
            trigger: match self.trigger {
                Some(Trigger::Level) => st::Trigger::Level,
                Some(Trigger::Edge) | None => st::Trigger::Edge,
            },
            integers: match self.integers {
                Some(Integers::Signed) => st::Integers::Signed,
                Some(Integers::Unsigned) | None => st::Integers::Unsigned,
            },
            drain: self.drain,
            unexpected: match self.unexpected {
                Some(Unexpected::Drop) => st::Unexpected::Drop,
                Some(Unexpected::Fault) => st::Unexpected::Fault,
                Some(Unexpected::Keep) | None => st::Unexpected::Keep,
            },
            encoding: match self.encoding {
                Some(Encoding::Rows) => st::Encoding::Rows,
                Some(Encoding::Runs) | None => st::Encoding::Runs,
            },
            owed: self.owed,
            retain: self.retain,
        }
    }
}

//! What `sml export` writes, and whose Structured Text it is.

use crate::failure::Failure;
use clap::ValueEnum;
use std::fmt;
use synth_core::emit::st;
use synth_core::emit::st::plcopen;

/// What can be written; some are to come.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub(crate) enum Target {
    Rust,
    Iec,
    Codesys,
    Twincat,
    Siemens,
    Case,
    Plcopen,
    Ladder,
    Il,
    Dot,
    Mermaid,
    Svg,
    Html,
    Json,
}

impl Target {
    /// Whose Structured Text it is.
    pub(crate) fn structured_text(self, xml: Xml) -> Option<st::Target> {
        match self {
            Target::Iec => Some(st::Target::Iec),
            Target::Codesys => Some(st::Target::Codesys),
            Target::Twincat => Some(st::Target::Twincat),
            Target::Siemens => Some(st::Target::Siemens),
            Target::Case => Some(st::Target::Case),
            Target::Plcopen => Some(xml.dialect().target()),
            _ => None,
        }
    }
}

impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.to_possible_value().as_ref().map_or("", |value| value.get_name()))
    }
}

/// Options of PLCopen XML.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(crate) struct Xml {
    /// PLCopen XML: whose Structured Text it holds; `iec` otherwise
    #[arg(long, value_enum)]
    dialect: Option<Dialect>,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
enum Dialect {
    Iec,
    Codesys,
}

impl Xml {
    /// Refuses a dialect for a target that has none to choose.
    pub(crate) fn fits(self, target: Target) -> Result<(), Failure> {
        match self.dialect {
            Some(_) if target != Target::Plcopen => {
                Err(Failure::usage(format!("`--dialect` means nothing to target `{target}`")))
            }
            _ => Ok(()),
        }
    }

    pub(crate) fn dialect(self) -> plcopen::Dialect {
        match self.dialect {
            Some(Dialect::Codesys) => plcopen::Dialect::Codesys,
            Some(Dialect::Iec) | None => plcopen::Dialect::Iec,
        }
    }
}

//! `sml verify`: any controller against a specification.

use crate::failure::{Exit, Failure};
use crate::options::Format;
use crate::session::Session;
use crate::{input, output};
use serde::Serialize;
use std::path::PathBuf;
use synth_core::controller::Level;
use synth_core::diagnostic::counted;
use synth_core::pipeline;
use synth_core::verify::Refutation;

/// Arguments of `sml verify`.
#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    /// The specification; `-` is stdin
    file: PathBuf,
    /// The controller, as `sml synth` writes it
    controller: PathBuf,
}

#[derive(Serialize)]
struct Document<'a> {
    version: u32,
    verified: bool,
    reason: &'a str,
    play: &'a [String],
    r#loop: &'a [String],
}

pub(super) fn run(arguments: &Arguments, session: &mut Session) -> Result<Exit, Failure> {
    input::one_stdin([&arguments.file, &arguments.controller])?;
    let loaded = session.load(&arguments.file)?;
    let spec = session.specification(&loaded)?;
    let (controller, level) = input::controller(&arguments.controller)?;
    let (exit, text) = match session.verify(&spec, &controller) {
        Ok(nodes) => (Exit::Done, accepted(nodes, level, session.format())),
        Err(pipeline::Failure::Unverified(refutation)) => (Exit::No, refuted(&refutation, session.format())),
        Err(failure) => return Err(Failure::of(&failure, &loaded.sources)),
    };
    output::print(&text)?;
    Ok(exit)
}

fn accepted(nodes: usize, level: Level, format: Format) -> String {
    // One at a time is all that is verified here: for a scan with several, more must be known of its strategy.
    let only = if level == Level::Ordered { ", for one event at a time" } else { "" };
    match format {
        Format::Text => {
            format!("verified{only}: the product with the specification has {}\n", counted(nodes, "node"))
        }
        Format::Json => json(&Document { version: 1, verified: true, reason: "", play: &[], r#loop: &[] }),
    }
}

fn refuted(refutation: &Refutation, format: Format) -> String {
    let Refutation { reason, play, cycle } = refutation;
    if format == Format::Json {
        return json(&Document { version: 1, verified: false, reason, play, r#loop: cycle });
    }
    let mut text = format!("not verified: {reason}\n");
    for (title, events) in [("the shortest play that leads there:", play), ("and then for ever:", cycle)] {
        if !events.is_empty() {
            text.push_str(&format!("{title}\n  {}\n", events.join("\n  ")));
        }
    }
    text
}

fn json(document: &Document<'_>) -> String {
    format!("{}\n", serde_json::to_string(document).expect("strings always serialize"))
}

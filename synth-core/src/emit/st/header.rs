//! The comment at the top: origin, options, the map of names, requirements.

use super::block::Block;
use super::names::{NameMap, STATE_NO};
use super::writer::Writer;
use super::{Encoding, Integers, Options, Trigger, Unexpected, bound};
use crate::controller::tables::{FORMAT_VERSION, Requirement, Tables};
use crate::emit::shell;

/// What stands at the top, a line each; empty ones part paragraphs.
#[derive(Default)]
pub(super) struct Header {
    pub(super) lines: Vec<String>,
}

impl Header {
    fn comment(&mut self, text: &str) {
        self.lines.push(text.to_owned());
    }

    fn gap(&mut self) {
        self.lines.push(String::new());
    }

    /// Writes comments, an empty line last.
    pub(super) fn write(&self, out: &mut Writer) {
        for line in &self.lines {
            match line.as_str() {
                "" => out.gap(),
                line => out.comment(line),
            }
        }
    }
}

/// The header of a text for `target`, as on the command line; `notes` tell how to load it.
pub(super) fn header(block: &Block<'_>, target: &str, notes: &[&str]) -> Header {
    let mut out = Header::default();
    write(&mut out, block, target, notes);
    out
}

fn write(out: &mut Header, block: &Block<'_>, target: &str, notes: &[&str]) {
    origin(out, block, target, notes);
    out.gap();
    behaviour(out, block.options);
    cost(out, block);
    out.gap();
    name_map(out, &NameMap::new(block.tables, block.options.target, &block.names));
    out.gap();
    requirements(out, block.tables);
}

fn origin(out: &mut Header, block: &Block<'_>, target: &str, notes: &[&str]) {
    let provenance = &block.tables.provenance;
    let version = env!("CARGO_PKG_VERSION");
    out.comment(&format!("Controller {}: generated, changes get lost.", block.tables.specification));
    out.comment(&format!("Generator: sml {version}, table format {FORMAT_VERSION}"));
    out.comment(&format!("Specification: {}, input hash {}", provenance.file, provenance.hash));
    out.comment(&format!(
        "To generate it again: sml export {}{}{}",
        shell::input(&provenance.file),
        arguments(target, block.options),
        provenance.options
    ));
    for note in notes {
        out.comment(note);
    }
}

/// What the command line said, without what it need not say.
fn arguments(target: &str, options: &Options) -> String {
    let mut arguments = format!(" --target {target}");
    arguments += match options.trigger {
        Trigger::Edge => "",
        Trigger::Level => " --trigger level",
    };
    arguments += match options.integers {
        Integers::Unsigned => "",
        Integers::Signed => " --integers signed",
    };
    arguments += if options.drain { " --drain" } else { "" };
    arguments += match options.unexpected {
        Unexpected::Keep => "",
        Unexpected::Drop => " --unexpected drop",
        Unexpected::Fault => " --unexpected fault",
    };
    arguments += match options.encoding {
        Encoding::Runs => "",
        Encoding::Rows => " --encoding rows",
    };
    arguments += if options.owed { " --owed" } else { "" };
    arguments += if options.retain { " --retain" } else { "" };
    arguments
}

fn cost(out: &mut Header, block: &Block<'_>) {
    let bound = bound::call(block);
    out.comment(&format!(
        "A call takes at most {} statements, {} loop iterations and {} probes (computed from the tables).",
        bound.statements, bound.iterations, bound.probes
    ));
}

fn behaviour(out: &mut Header, options: &Options) {
    out.comment(match options.trigger {
        Trigger::Edge => "An input raises its event in the call in which it becomes TRUE (trigger: edge).",
        Trigger::Level => "An input raises its event in every call in which it is TRUE (trigger: level).",
    });
    out.comment(if options.drain {
        "A call repeats the cycle until no super step is due, or one whose component has a command already (drain)."
    } else {
        "A call is one cycle: events until none fits, then at most one super step."
    });
    out.comment(match options.unexpected {
        Unexpected::Keep => "Events that fit nowhere stay pending, and unexpected is TRUE meanwhile (unexpected: keep).",
        Unexpected::Drop => "Events that fit nowhere are forgotten, and unexpected is TRUE in that call (unexpected: drop).",
        Unexpected::Fault => {
            "After an event that fits nowhere unexpected is TRUE and nothing is done until reset (unexpected: fault)."
        }
    });
    out.comment(
        "Events raised in a call with enable FALSE or reset TRUE are lost. reset leads to the initial state, enabled or not.",
    );
    if options.owed {
        out.comment("owed tells which events the assumptions promise in the state, in the order of pending. No safety function.");
    }
    if options.retain {
        out.comment(
            "State and pending events survive a power cycle if the tables are the same afterwards (retain).",
        );
    }
    if options.integers == Integers::Signed {
        out.comment("No unsigned integer types are used (integers: signed).");
    }
}

fn name_map(out: &mut Header, names: &NameMap) {
    out.comment(&format!(
        "Function block {}, program {}, state in {STATE_NO}",
        names.function_block, names.program
    ));
    out.comment("Inputs and their events, in the order of pending:");
    for (text, input) in &names.events {
        out.comment(&format!("  {input}: {text}"));
    }
    if names.events.is_empty() {
        out.comment("  none; pending has one element, which stays FALSE");
    }
    for component in &names.components {
        out.comment(&format!("Codes of {}, commands to {}:", component.output, component.object));
        for (text, code) in &component.codes {
            out.comment(&format!("  {code}: {text}"));
        }
    }
}

fn requirements(out: &mut Header, tables: &Tables) {
    let requirements = &tables.provenance.requirements;
    if requirements.is_empty() {
        return;
    }
    out.comment("Requirements:");
    for requirement in requirements {
        let Requirement { kind, scenario, file, line, .. } = requirement;
        out.comment(&format!("  {kind} {scenario}, {file}:{line}"));
        for line in &requirement.text {
            out.comment(&format!("    {}", line.trim_start()));
        }
    }
    out.gap();
}

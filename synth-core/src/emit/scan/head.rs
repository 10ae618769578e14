//! What texts say about where they come from and what rungs are for.

use super::Source;
use crate::emit::shell;
use crate::plant::{Drive, Rung};

/// Where a text comes from, a line each.
pub(in crate::emit) fn origin(source: &Source<'_>, what: &str, target: &str) -> Vec<String> {
    let provenance = source.provenance;
    let mut lines = vec![
        format!("{what} {}: generated, changes get lost.", source.program.name),
        format!("Generator: sml {}", env!("CARGO_PKG_VERSION")),
        format!("Plant: {}, input hash {}", provenance.file, provenance.hash),
        format!(
            "To generate it again: sml export {} --target {target}{}",
            shell::input(&provenance.file),
            provenance.options
        ),
    ];
    lines.extend(source.program.doc.iter().map(|line| line.trim().to_owned()));
    lines
}

/// What a rung is for: its number and event, what the event is, and why it may fire.
pub(in crate::emit) fn rung_lines(source: &Source<'_>, number: usize, rung: &Rung) -> Vec<String> {
    let event = source.event(rung);
    let title = match event {
        Some(event) => format!("Rung {number}: {}", event.name),
        None => format!("Rung {number}"),
    };
    let doc = event.into_iter().flat_map(|event| &event.doc);
    let lines = doc.chain(&rung.comment).map(|line| line.trim().to_owned());
    std::iter::once(title).chain(lines).collect()
}

/// What the coils of a rung do: `set Y1, reset Y0`.
pub(in crate::emit) fn commands(source: &Source<'_>, rung: &Rung) -> String {
    let command = |verb: &str, variable| format!("{verb} {}", source.name(variable));
    let coils = rung.coils.iter().map(|coil| match coil.drive {
        Drive::Set => command("set", coil.variable),
        Drive::Reset => command("reset", coil.variable),
        Drive::Out => command("drive", coil.variable),
    });
    coils.collect::<Vec<_>>().join(", ")
}

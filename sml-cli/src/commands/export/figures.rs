//! `sml export -o OUT --format json`: how large the output is, and what a call of it costs at most.

use serde::Serialize;
use synth_core::controller::tables::Tables;
use synth_core::emit::st;

use super::Target;

#[derive(Serialize)]
struct Document<'a> {
    version: u32,
    target: &'a str,
    lines: usize,
    bytes: usize,
    transitions: usize,
    bounds: Option<Bounds>,
}

/// Of Structured Text.
#[derive(Serialize)]
struct Bounds {
    cycle: Option<Bound>,
    /// None if draining would not end.
    drain: Option<Bound>,
}

#[derive(Serialize)]
struct Bound {
    statements: u64,
    iterations: u64,
    probes: u64,
}

/// The figures of `text`, written with `options` if it is Structured Text.
pub(super) fn json(target: Target, text: &str, tables: &Tables, options: &st::Options) -> String {
    let rows = tables.events.iter().map(|table| table.mapping.source.len()).sum::<usize>();
    let bound = |drain| {
        let cost = st::bound(tables, &st::Options { drain, ..*options }).ok()?;
        Some(Bound { statements: cost.statements, iterations: cost.iterations, probes: cost.probes })
    };
    let document = Document {
        version: 1,
        target: &target.to_string(),
        lines: text.lines().count(),
        bytes: text.len(),
        transitions: rows + tables.super_steps.source.len(),
        bounds: target.structured_text().map(|_| Bounds { cycle: bound(false), drain: bound(true) }),
    };
    format!("{}\n", serde_json::to_string(&document).expect("strings and numbers always serialize"))
}

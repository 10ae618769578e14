//! Beside an output that `sml export` has written to a file: how large it is, and what a call of it costs at most.

use serde::Serialize;
use synth_core::controller::tables::Tables;
use synth_core::diagnostic::counted;
use synth_core::emit::st;

use super::Target;

#[derive(Serialize)]
struct Document<'a> {
    version: u32,
    target: &'a str,
    lines: usize,
    bytes: usize,
    transitions: usize,
    /// None if there are no transitions.
    bytes_per_transition: Option<f64>,
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

/// For people: `cell.st: 275 lines, 11200 bytes, 33.7 bytes per transition`.
pub(super) fn line(path: &str, text: &str, tables: &Tables) -> String {
    let each = per_transition(text, tables)
        .map_or_else(String::new, |each| format!(", {each:.1} bytes per transition"));
    format!("{path}: {}, {}{each}", counted(text.lines().count(), "line"), counted(text.len(), "byte"))
}

/// As JSON; `text` was written with `options` if it holds Structured Text.
pub(super) fn json(target: Target, text: &str, tables: &Tables, options: Option<&st::Options>) -> String {
    let bound = |options: &st::Options, drain| {
        let cost = st::bound(tables, &st::Options { drain, ..*options }).ok()?;
        Some(Bound { statements: cost.statements, iterations: cost.iterations, probes: cost.probes })
    };
    let document = Document {
        version: 1,
        target: &target.to_string(),
        lines: text.lines().count(),
        bytes: text.len(),
        transitions: transitions(tables),
        bytes_per_transition: per_transition(text, tables),
        bounds: options.map(|options| Bounds { cycle: bound(options, false), drain: bound(options, true) }),
    };
    format!("{}\n", serde_json::to_string(&document).expect("strings and numbers always serialize"))
}

/// Rows of events, and super steps.
fn transitions(tables: &Tables) -> usize {
    let rows = tables.events.iter().map(|table| table.mapping.source.len()).sum::<usize>();
    rows + tables.super_steps.source.len()
}

/// Rounded to tenths.
fn per_transition(text: &str, tables: &Tables) -> Option<f64> {
    let transitions = transitions(tables);
    (transitions > 0).then(|| (10.0 * text.len() as f64 / transitions as f64).round() / 10.0)
}

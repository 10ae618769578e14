//! What `--timings` prints: a row for each stage, or the same as JSON.

use crate::options::Format;
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::time::Duration;
use synth_core::diagnostic::counted;
use synth_core::pipeline::{Size, Stage, Timings};

/// What is printed.
pub(crate) fn shown(timings: &Timings, format: Format) -> String {
    match format {
        Format::Text => text(timings),
        Format::Json => as_json(timings).to_string(),
    }
}

fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}

/// Bytes each.
fn each(bytes: usize, count: usize) -> f64 {
    bytes as f64 / count.max(1) as f64
}

fn text(timings: &Timings) -> String {
    let mut text = format!(
        "{:<19} {:>12} {:>12} {:>12} {:>14} {:>10}\n",
        "stage", "ms", "states", "transitions", "bytes", "peak MiB"
    );
    for Stage { name, time, size, peak } in timings.stages() {
        let or_blank = |number: Option<usize>| number.map(|number| number.to_string()).unwrap_or_default();
        let Size { edges, of_states, of_edges, .. } = size.unwrap_or_default();
        let bytes = of_states.map(|of_states| of_states + of_edges.unwrap_or(0));
        let peak = peak.map(|bytes| format!("{:.1}", bytes as f64 / f64::from(1 << 20))).unwrap_or_default();
        let row = format!(
            "{name:<19} {:>12.3} {:>12} {:>12} {:>14} {peak:>10}",
            milliseconds(*time),
            or_blank(size.map(|size| size.states)),
            or_blank(edges),
            or_blank(bytes),
        );
        let _ = writeln!(text, "{}", row.trim_end());
    }
    let _ = writeln!(text, "{:<19} {:>12.3}", "total", milliseconds(timings.total()));
    let game = timings.stages().iter().find(|stage| stage.name == "explore").and_then(|stage| stage.size);
    if let Some(Size { states, edges: Some(edges), of_states: Some(of_states), of_edges: Some(of_edges) }) =
        game
    {
        let _ = writeln!(
            text,
            "{}, {}: {:.1} bytes for a state, {:.1} for a transition",
            counted(states, "state"),
            counted(edges, "transition"),
            each(of_states, states),
            each(of_edges, edges)
        );
    }
    text
}

fn as_json(timings: &Timings) -> Value {
    let stage = |Stage { name, time, size, peak }: &Stage| {
        let mut stage = json!({ "stage": name, "milliseconds": milliseconds(*time), "peak_bytes": peak });
        if let Some(Size { states, edges, of_states, of_edges }) = *size {
            stage["states"] = states.into();
            for (field, number) in
                [("transitions", edges), ("bytes_of_states", of_states), ("bytes_of_transitions", of_edges)]
            {
                if let Some(number) = number {
                    stage[field] = number.into();
                }
            }
        }
        stage
    };
    let stages: Vec<Value> = timings.stages().iter().map(stage).collect();
    json!({ "version": 1, "milliseconds": milliseconds(timings.total()), "timings": stages })
}

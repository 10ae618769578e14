//! The annotated counter-play in outputs: as JSON, and as a sequence diagram in a file.

use crate::failure::Failure;
use crate::output;
use serde::Serialize;
use std::path::Path;
use synth_core::explain::{Explanation, Mention, PlayStep, sequence};
use synth_core::syntax::{Loaded, Sources};

/// A step of the play or of its loop.
#[derive(Serialize)]
pub(super) struct Step<'a> {
    event: &'a str,
    side: &'static str,
    case: u8,
    wanted_by: Vec<Place<'a>>,
    forbidden: Vec<Forbidden<'a>>,
    violates: Vec<Place<'a>>,
    in_loop: bool,
}

#[derive(Serialize)]
struct Forbidden<'a> {
    event: &'a str,
    by: Vec<Place<'a>>,
}

#[derive(Serialize)]
struct Place<'a> {
    scenario: &'a str,
    file: &'a str,
    line: u32,
    column: u32,
}

/// All steps, those of the loop last.
pub(super) fn steps<'a>(explanation: &'a Explanation, sources: &'a Sources) -> Vec<Step<'a>> {
    let places = |mentions: &'a [Mention]| mentions.iter().map(|mention| place(mention, sources)).collect();
    let step = |step: &'a PlayStep| Step {
        event: &step.event,
        side: if step.turn.is_system() { "system" } else { "environment" },
        case: step.turn as u8,
        wanted_by: places(&step.wanted_by),
        forbidden: step
            .forbidden
            .iter()
            .map(|refusal| Forbidden { event: &refusal.event, by: places(&refusal.by) })
            .collect(),
        violates: places(&step.violates),
        in_loop: step.in_loop,
    };
    explanation.steps.iter().map(step).collect()
}

fn place<'a>(mention: &'a Mention, sources: &'a Sources) -> Place<'a> {
    let start = mention.place.start;
    Place {
        scenario: &mention.scenario,
        file: sources.path(mention.place.file),
        line: start.line,
        column: start.column,
    }
}

/// Draws the counter-play into a file; where there is none, says so and leaves the file alone.
pub(super) fn draw(path: &Path, explanation: Option<&Explanation>, loaded: &Loaded) -> Result<(), Failure> {
    match explanation {
        Some(explanation) => {
            output::product(Some(path), &sequence(explanation, &|span| loaded.sources.place(span)))
        }
        None => {
            output::note("the specification is realizable: there is no counter-play to draw");
            Ok(())
        }
    }
}

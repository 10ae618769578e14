//! `sml names` of a plant: what generated code calls signals and events.

use super::control;
use crate::commands::export::{Target, Xml};
use crate::failure::{Exit, Failure};
use crate::input::Given;
use crate::output;
use crate::session::{ReadPlant, Session};
use serde::Serialize;
use synth_core::emit::scan::{NameMap, Source, list};
use synth_core::emit::{rust, st};
use synth_core::pipeline;
use synth_core::plant::{Options, Program};

#[derive(Serialize)]
struct Document<'a> {
    version: u32,
    target: String,
    function_block: &'a str,
    program: &'a str,
    /// Also those that synthesis added.
    signals: Vec<Named<'a>>,
    analogues: Vec<Named<'a>>,
    events: Vec<Named<'a>>,
}

/// A name of the plant, and that of the target.
#[derive(Serialize)]
struct Named<'a> {
    name: &'a str,
    identifier: &'a str,
}

pub(in crate::commands) fn run(
    given: &Given,
    target: Target,
    xml: Xml,
    session: &mut Session,
) -> Result<Exit, Failure> {
    let names: Box<dyn Fn(&Source<'_>) -> NameMap> = match (target, target.structured_text(xml)) {
        (Target::Case, _) => return Err(super::export::no_tables(target)),
        (Target::Html, _) => return Err(Failure::unsupported(&format!("--target {target}"))),
        (_, Some(dialect)) => Box::new(move |source| st::scan::names(source, dialect)),
        (Target::Rust, _) => Box::new(rust::scan::names),
        (Target::Il, _) => Box::new(list::names),
        _ => return Err(Failure::usage(format!("target `{target}` gives nothing a name"))),
    };
    let ReadPlant { sources, plant, provenance, .. } = session.plant(given)?;
    if plant.signals.is_empty() {
        return Err(super::export::no_signals(&plant.name, target));
    }
    let program = match control(&plant, Options::default(), session) {
        Ok(controlled) => controlled.feedback.map(|feedback| feedback.program),
        // Names are the plant's, whether or not something can keep its constraints.
        Err(pipeline::Failure::Refused(_)) => None,
        Err(failure) => return Err(Failure::of(&failure, &sources)),
    };
    let program = &program.unwrap_or_else(|| Program::without_rungs(&plant));
    let map = names(&Source { program, events: &plant.events, provenance: &provenance });
    let events: Vec<&str> =
        plant.events.iter().filter(|event| event.controllable).map(|event| event.name.as_str()).collect();
    output::print(&json(target, &map, program, &events))?;
    Ok(Exit::Done)
}

fn json(target: Target, map: &NameMap, program: &Program, events: &[&str]) -> String {
    let signals = program.variables.iter().map(|variable| variable.name.as_str());
    let document = Document {
        version: 1,
        target: target.to_string(),
        function_block: &map.function_block,
        program: &map.program,
        signals: named(signals, &map.variables),
        analogues: named(program.analogues.iter().map(String::as_str), &map.analogues),
        events: named(events.iter().copied(), &map.events),
    };
    format!("{}\n", serde_json::to_string(&document).expect("strings always serialize"))
}

fn named<'a>(names: impl Iterator<Item = &'a str>, identifiers: &'a [String]) -> Vec<Named<'a>> {
    names.zip(identifiers).map(|(name, identifier)| Named { name, identifier }).collect()
}

//! `sml check --symmetry`: who wins, on one state for all that differ only by interchangeable objects.

use crate::failure::{Exit, Failure};
use crate::options::Format;
use crate::output;
use crate::session::Session;
use serde::Serialize;
use synth_core::diagnostic::counted;
use synth_core::model::Spec;
use synth_core::symmetry::{Reduced, Symmetry, WholeFigures};
use synth_core::syntax::Loaded;

#[derive(Serialize)]
struct Document<'a> {
    version: u32,
    realizable: bool,
    interchangeable: Vec<Vec<&'a str>>,
    representatives: usize,
    representative_transitions: usize,
    #[serde(flatten)]
    figures: Option<Figures>,
}

#[derive(Serialize)]
struct Figures {
    states: u128,
    transitions: u128,
    system_states: u128,
    environment_states: u128,
    yielded_states: u128,
    idle_states: u128,
    winning_states: u128,
    assumption_sets: u128,
    guarantee_sets: u128,
}

/// Decides a specification, and prints the verdict and the figures of the whole game.
pub(super) fn run(loaded: &Loaded, session: &mut Session) -> Result<Exit, Failure> {
    let spec = session.specification(loaded)?;
    let symmetry = session.stage("symmetry", || Symmetry::of(&spec));
    let reduced = if symmetry.groups().is_empty() {
        // Nothing is gained, and the usual way is faster.
        let solved = session.solve(loaded, &spec)?;
        Reduced::unreduced(&solved)
    } else {
        session.decide_reduced(loaded, &spec, &symmetry)?
    };
    let groups: Vec<Vec<&str>> = symmetry
        .groups()
        .iter()
        .map(|group| group.iter().map(|&object| spec.domain.objects[object].name.as_str()).collect())
        .collect();
    output::print(&match session.format() {
        Format::Json => json(&reduced, groups),
        Format::Text => text(&spec, &reduced, &groups),
    })?;
    Ok(if reduced.realizable { Exit::Done } else { Exit::No })
}

fn json(reduced: &Reduced, groups: Vec<Vec<&str>>) -> String {
    let document = Document {
        version: 1,
        realizable: reduced.realizable,
        interchangeable: groups,
        representatives: reduced.representatives,
        representative_transitions: reduced.transitions,
        figures: reduced.figures.map(|whole| {
            let WholeFigures { states, transitions, system_states, environment_states, .. } = whole;
            let WholeFigures { yielded_states, idle_states, winning_states, .. } = whole;
            let WholeFigures { assumption_sets, guarantee_sets, .. } = whole;
            Figures {
                states,
                transitions,
                system_states,
                environment_states,
                yielded_states,
                idle_states,
                winning_states,
                assumption_sets,
                guarantee_sets,
            }
        }),
    };
    format!("{}\n", serde_json::to_string(&document).expect("strings and numbers always serialize"))
}

fn text(spec: &Spec, reduced: &Reduced, groups: &[Vec<&str>]) -> String {
    let realizable = if reduced.realizable { "realizable" } else { "not realizable" };
    let mut text = format!("{}: {realizable}\n", spec.name);
    match &reduced.figures {
        Some(figures) => text.push_str(&super::whole(figures)),
        None => text.push_str("how many states there are is not known\n"),
    }
    for group in groups {
        text.push_str(&format!(
            "{} are interchangeable: {}\n",
            counted(group.len(), "object"),
            listed(group)
        ));
    }
    if groups.is_empty() {
        text.push_str("no objects are interchangeable: all states were explored\n");
    } else {
        let explored = counted(reduced.representatives, "state");
        let transitions = counted(reduced.transitions, "transition");
        text.push_str(&format!("{explored} and {transitions} were explored, which stand for all\n"));
    }
    if !reduced.realizable {
        text.push_str("`sml check` without `--symmetry` says why\n");
    }
    text
}

/// The names, or the ends of a long list.
fn listed(names: &[&str]) -> String {
    let quoted = |names: &[&str]| names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    match names {
        [first, second, _, .., last] if names.len() > 4 => {
            format!("{}, …, `{last}`", quoted(&[first, second]))
        }
        _ => quoted(names),
    }
}

//! What `sml supervise` says, for programs.
//!
//! ```json
//! {"version":1,"plant_states":128,"plant_transitions":512,"constrained_states":52,"constrained_transitions":120,"entries":52,
//! "feedback":[
//! {"state":{"Injector":"I2B","Barrel":"BE"},"inhibited":["inject"],"enabled":[]}
//! ],
//! "formulas":{"inject":"!Y2 && X0"},"instructions":116,"stack_depth":2,"rungs":6}
//! ```
//!
//! A state names all components, and behind them the constraint automata that carry memory ([`ClosedLoop::memory`]), so that
//! states are distinct. `enabled` are controllable events. The plant's figures are `null` if they were not counted. Without
//! a program `formulas` is empty, and its figures are `null`.

use super::{AutomatonId, ClosedLoop, EventId, Figures, Plant, StateFeedback};
use serde_json::{Value as Json, json};
use std::io::{self, Write};

/// What formulas and programs add.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Realization {
    /// Per controllable event, by its name, when it may fire.
    pub formulas: Vec<(String, String)>,
    /// What the program costs.
    pub figures: Figures,
}

impl Realization {
    /// Of a feedback as formulas and as a program.
    #[must_use]
    pub fn new(plant: &Plant, feedback: &StateFeedback) -> Self {
        let formulas = feedback.formulas.iter().map(|formula| {
            (plant.events[formula.event as usize].name.clone(), formula.text(&feedback.program))
        });
        Realization { formulas: formulas.collect(), figures: feedback.program.figures() }
    }
}

/// Writes figures, feedback and formulas as one object; without a realization if the plant has no inputs and outputs.
///
/// # Errors
/// Those of `out`.
pub fn write_json(
    plant: &Plant,
    closed: &ClosedLoop,
    realization: Option<&Realization>,
    out: &mut dyn Write,
) -> io::Result<()> {
    let (states, transitions) = closed.plant.unzip();
    let (constrained_states, constrained_transitions) = closed.constrained;
    writeln!(
        out,
        "{{\"version\":1,\"plant_states\":{},\"plant_transitions\":{},\"constrained_states\":{constrained_states},\
         \"constrained_transitions\":{constrained_transitions},\"entries\":{},\n\"feedback\":[",
        json!(states),
        json!(transitions),
        closed.len(),
    )?;
    let shown = shown(plant, closed);
    for entry in 0..closed.len() {
        let end = if entry + 1 == closed.len() { "\n" } else { ",\n" };
        write!(
            out,
            "{{\"state\":{},\"inhibited\":{},\"enabled\":{}}}{end}",
            state(plant, closed, &shown, entry),
            names(plant, closed.inhibited(entry).iter().copied()),
            names(plant, closed.enabled(plant, entry)),
        )?;
    }
    let figures = realization.map(|one| one.figures);
    writeln!(
        out,
        "],\n\"formulas\":{},\"instructions\":{},\"stack_depth\":{},\"rungs\":{}}}",
        formulas(realization.map_or(&[], |one| &one.formulas)),
        json!(figures.map(|figures| figures.instructions)),
        json!(figures.map(|figures| figures.stack_depth)),
        json!(figures.map(|figures| figures.rungs)),
    )
}

/// The automata that are shown in a state.
fn shown(plant: &Plant, closed: &ClosedLoop) -> Vec<AutomatonId> {
    (0..plant.components as AutomatonId).chain(closed.memory(plant)).collect()
}

/// An object, written by hand to keep its members in this order.
fn state(plant: &Plant, closed: &ClosedLoop, shown: &[AutomatonId], entry: usize) -> String {
    let states = closed.entry(entry);
    let members = shown.iter().map(|&id| {
        let automaton = &plant.automata[id as usize];
        let state = &automaton.states[states[id as usize] as usize];
        format!("{}:{}", json!(automaton.name), json!(state.name))
    });
    format!("{{{}}}", members.collect::<Vec<_>>().join(","))
}

fn names(plant: &Plant, events: impl Iterator<Item = EventId>) -> Json {
    json!(events.map(|event| plant.events[event as usize].name.as_str()).collect::<Vec<_>>())
}

fn formulas(formulas: &[(String, String)]) -> String {
    let members = formulas.iter().map(|(event, text)| format!("{}:{}", json!(event), json!(text)));
    format!("{{{}}}", members.collect::<Vec<_>>().join(","))
}

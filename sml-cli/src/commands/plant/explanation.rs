//! Why there is no feedback, for programs.

use serde::Serialize;
use serde_json::{Map, Value as Json, json};
use synth_core::plant::{EventId, Plant, Reason, Source, Unavoidable};

#[derive(Serialize)]
pub(super) struct Explanation<'p> {
    /// `never`, `forbidden` or `blocked`.
    cause: &'static str,
    /// What is violated, or forbids what would lead on.
    constraints: Vec<&'p str>,
    /// The uncontrollable event that can happen at the end and is forbidden.
    #[serde(skip_serializing_if = "Option::is_none")]
    event: Option<&'p str>,
    /// Automata no marked state of which can be reached.
    unmarked: Vec<&'p str>,
    play: Vec<&'p str>,
    /// The events of the play with what there is to say of each.
    steps: Vec<Step<'p>>,
    /// The automata's states at the end.
    state: Map<String, Json>,
}

#[derive(Serialize)]
struct Step<'p> {
    event: &'p str,
    side: &'static str,
    /// Nobody can prevent it, nor any that follows.
    forced: bool,
}

impl<'p> Explanation<'p> {
    pub(super) fn new(plant: &'p Plant, unavoidable: &Unavoidable) -> Self {
        let Unavoidable { play, forced, states, reason } = unavoidable;
        let name = |event: EventId| plant.events[event as usize].name.as_str();
        let (cause, constraints, event, unmarked) = match reason {
            Reason::Never(condition) => {
                ("never", vec![Source::Condition(*condition).name(plant)], None, Vec::new())
            }
            Reason::Forbidden(event, source) => {
                ("forbidden", vec![source.name(plant)], Some(name(*event)), Vec::new())
            }
            Reason::Blocked { unmarked, forbidden } => {
                let mut constraints: Vec<&str> =
                    forbidden.iter().map(|(_, source)| source.name(plant)).collect();
                constraints.sort_unstable();
                constraints.dedup();
                let unmarked = unmarked.iter().map(|&id| plant.automata[id as usize].name.as_str());
                ("blocked", constraints, None, unmarked.collect())
            }
        };
        let steps = play.iter().enumerate().map(|(step, &event)| Step {
            event: name(event),
            side: if plant.events[event as usize].controllable { "system" } else { "environment" },
            forced: step + forced >= play.len(),
        });
        let state = plant.automata.iter().zip(states).map(|(automaton, &state)| {
            (automaton.name.clone(), json!(automaton.states[state as usize].name))
        });
        Explanation {
            cause,
            constraints,
            event,
            unmarked,
            play: play.iter().map(|&event| name(event)).collect(),
            steps: steps.collect(),
            state: state.collect(),
        }
    }
}

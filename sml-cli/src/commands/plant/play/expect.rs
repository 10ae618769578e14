//! What a script expects of a play: `expect …` lines.

use super::position::Position;
use super::{known, view};
use synth_core::plant::{EventId, Plant, StateRef};

/// An expectation, with names as the plant has them.
pub(super) struct Expectation {
    /// The opposite is expected; of several things, that none of them is so.
    negated: bool,
    what: What,
}

enum What {
    Enabled(Vec<EventId>),
    Inhibited(Vec<EventId>),
    /// These can happen, and no others.
    Only(Vec<EventId>),
    State(Vec<StateRef>),
}

impl Expectation {
    /// Reads what stands behind the word `expect`.
    pub(super) fn parse(text: &str, plant: &Plant) -> Result<Self, String> {
        let rest = text.strip_prefix("not").filter(|rest| rest.starts_with(char::is_whitespace));
        let (negated, text) = rest.map_or((false, text), |rest| (true, rest.trim()));
        let (word, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
        let names: Vec<&str> = rest.split(';').map(str::trim).filter(|name| !name.is_empty()).collect();
        if names.is_empty() && word != "only" {
            return Err(
                "`expect` needs `enabled`, `inhibited`, `only` or `state`, and names behind it".to_owned()
            );
        }
        let events = || names.iter().map(|name| known(name, plant)).collect::<Result<Vec<EventId>, String>>();
        let what = match word {
            "enabled" => What::Enabled(events()?),
            "inhibited" => What::Inhibited(events()?),
            "only" => What::Only(events()?),
            "state" => What::State(names.iter().map(|name| state(name, plant)).collect::<Result<_, _>>()?),
            other => return Err(format!("nothing can be expected of `{other}`")),
        };
        Ok(Expectation { negated, what })
    }

    /// What is so instead; `None` if the expectation holds.
    pub(super) fn check(&self, position: &Position<'_>) -> Option<String> {
        let plant = position.plant;
        let enabled: Vec<EventId> = position.enabled().collect();
        let is_all = |mut each: Box<dyn Iterator<Item = bool> + '_>| {
            if self.negated { each.all(|so| !so) } else { each.all(|so| so) }
        };
        let holds = match &self.what {
            What::Enabled(events) => is_all(Box::new(events.iter().map(|event| enabled.contains(event)))),
            What::Inhibited(events) => {
                is_all(Box::new(events.iter().map(|event| position.inhibited().contains(event))))
            }
            What::Only(events) => {
                let same = enabled.iter().all(|event| events.contains(event))
                    && events.iter().all(|event| enabled.contains(event));
                same != self.negated
            }
            What::State(states) => is_all(Box::new(
                states.iter().map(|at| u32::from(position.states()[at.automaton as usize]) == at.state),
            )),
        };
        if holds {
            return None;
        }
        let names = |events: &[EventId]| {
            let names: Vec<&str> =
                events.iter().map(|&event| plant.events[event as usize].name.as_str()).collect();
            if names.is_empty() { "nothing".to_owned() } else { names.join(", ") }
        };
        Some(match &self.what {
            What::State(_) => format!("the state: {}", view::states(position).join(", ")),
            What::Inhibited(_) => format!("inhibited: {}", names(position.inhibited())),
            What::Enabled(_) | What::Only(_) => format!("can happen: {}", names(&enabled)),
        })
    }
}

/// `Automaton.State`.
fn state(text: &str, plant: &Plant) -> Result<StateRef, String> {
    let unknown = || format!("`{text}` is no state of an automaton");
    let (automaton, state) = text.split_once('.').ok_or_else(unknown)?;
    let mut automata = (0..).zip(&plant.automata);
    let (automaton, found) = automata.find(|(_, one)| one.name == automaton.trim()).ok_or_else(unknown)?;
    let mut states = (0..).zip(&found.states);
    let (state, _) = states.find(|(_, one)| one.name == state.trim()).ok_or_else(unknown)?;
    Ok(StateRef { automaton, state })
}

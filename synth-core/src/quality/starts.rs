//! Scenarios that never start.

use super::reads::{could_be, players};
use crate::diagnostic::{Code, Diagnostic};
use crate::explore::Explored;
use crate::game::YIELD;
use crate::model::{Argument, EventRef, Kind, Message, NodeKind, ObjectId, RoleRef, Scenario, Spec};
use crate::playout::Event;
use fixedbitset::FixedBitSet;

/// The assumptions and guarantees of which no play has a copy.
pub(super) fn never(explored: &Explored<'_>) -> Vec<Diagnostic> {
    let Explored { playout, store, game } = explored;
    let spec = playout.spec();
    let mut unstarted: Vec<usize> = (0..spec.scenarios.len())
        .filter(|&index| {
            spec.scenarios[index].kind != Kind::Existential && !spec.scenarios[index].initial.is_empty()
        })
        .collect();
    // An event that could start it is as good as a copy, which may be gone at once.
    let mut happens = FixedBitSet::with_capacity(playout.event_count());
    game.actions.labels().filter(|&label| label != YIELD).for_each(|event| happens.insert(event as usize));
    unstarted.retain(|&index| {
        !happens.ones().any(|event| could_start(spec, &spec.scenarios[index], playout.event(event as u32)))
    });
    let mut copies = Vec::new();
    for state in 0..store.len() as u32 {
        if unstarted.is_empty() {
            break;
        }
        store.copies(state, &mut copies);
        for &copy in &copies {
            unstarted.retain(|&index| index != playout.copy(copy).scenario);
        }
    }
    unstarted.into_iter().map(|index| warning(spec, &spec.scenarios[index])).collect()
}

/// Whether the event can be an initial message of the scenario, if arguments that are not constant fit.
pub(super) fn could_start(spec: &Spec, scenario: &Scenario, event: &Event) -> bool {
    let mut initial = scenario.initial.iter().filter_map(|&node| scenario.message(node));
    initial.any(|message| could_be(spec, scenario, message, event))
}

fn warning(spec: &Spec, scenario: &Scenario) -> Diagnostic {
    let message = format!("scenario `{}` can never start", scenario.name);
    let mut warning = Diagnostic::warning(Code::NeverStarts, scenario.span, message);
    for message in scenario.initial.iter().filter_map(|&node| scenario.message(node)) {
        warning = warning.also(message.span, reason(spec, scenario, message));
    }
    warning.help("remove it, or mend what keeps its first message from happening")
}

/// Why no play contains the message.
fn reason(spec: &Spec, scenario: &Scenario, message: &Message) -> String {
    let senders: Vec<ObjectId> = players(spec, scenario, message.sender).collect();
    let receivers: Vec<ObjectId> = players(spec, scenario, message.receiver).collect();
    if senders.is_empty() || receivers.is_empty() {
        return "there is no object that could send or receive this".to_owned();
    }
    if let Some(parameter) = out_of_range(spec, message, &senders, &receivers) {
        return format!("the value of `{parameter}` is outside its parameter range");
    }
    if !is_linked(spec, message, &senders, &receivers) {
        return "no channel ever links sender and receiver".to_owned();
    }
    let refers = |event: &EventRef| receivers.iter().all(|&r| spec.refers(*event, r, message.operation));
    if senders.iter().all(|&sender| spec.controllable[sender]) {
        let asked = spec.scenarios.iter().filter(|other| other.kind == Kind::Guarantee).any(|other| {
            other.nodes.iter().any(|node| match &node.kind {
                NodeKind::Message { modality: Some(_), monitored: false, message: wanted, .. } => {
                    overlaps(spec, (scenario, message), (other, wanted))
                }
                _ => false,
            })
        });
        if !asked {
            return "no guarantee ever asks the system to send this".to_owned();
        }
        return "the system is never allowed to send this, or never asked to".to_owned();
    }
    if spec.non_spontaneous.iter().any(refers) {
        return "this is not spontaneous, and no assumption causes it in any play".to_owned();
    }
    "whenever this could happen, it would violate an assumption, or it is never the environment's turn"
        .to_owned()
}

/// A parameter whose constant no event of the environment can have.
fn out_of_range<'a>(
    spec: &'a Spec,
    message: &Message,
    senders: &[ObjectId],
    receivers: &[ObjectId],
) -> Option<&'a str> {
    if senders.iter().any(|&sender| spec.controllable[sender]) {
        return None;
    }
    let excluded = |parameter: usize, value: i64| {
        receivers.iter().all(|&receiver| {
            let ranges = spec.ranges.iter().filter(|range| {
                range.parameter == parameter && spec.refers(range.event, receiver, message.operation)
            });
            let mut ranges = ranges.peekable();
            ranges.peek().is_some() && ranges.all(|range| !range.values.contains(&value))
        })
    };
    let outside = message.arguments.iter().enumerate().find(|(parameter, argument)| match argument {
        Argument::Value(value) => value.constant().is_some_and(|value| excluded(*parameter, value)),
        Argument::Any | Argument::Bind(_) => false,
    })?;
    Some(&spec.domain.operations[message.operation].parameters[outside.0].0)
}

/// Whether some pair can have a link, as far as references that never change tell.
fn is_linked(spec: &Spec, message: &Message, senders: &[ObjectId], receivers: &[ObjectId]) -> bool {
    senders.iter().any(|&sender| {
        receivers.iter().any(|&receiver| {
            let rules = spec.channels.iter();
            let mut rules =
                rules.filter(|channel| spec.refers(channel.event, receiver, message.operation)).peekable();
            rules.peek().is_none()
                || rules.any(|channel| {
                    if !spec.domain.is_a(spec.domain.objects[sender].class, channel.class) {
                        return false;
                    }
                    let slot = spec.domain.slot(sender, channel.reference);
                    spec.domain.mutable[slot] || spec.domain.initial[slot] == receiver as i64
                })
        })
    })
}

fn overlaps(spec: &Spec, a: (&Scenario, &Message), b: (&Scenario, &Message)) -> bool {
    let shares = |one: RoleRef, other: RoleRef| {
        players(spec, a.0, one).any(|object| players(spec, b.0, other).any(|player| player == object))
    };
    a.1.operation == b.1.operation && shares(a.1.sender, b.1.sender) && shares(a.1.receiver, b.1.receiver)
}

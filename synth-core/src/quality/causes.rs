//! Events that are not spontaneous and have no cause.

use crate::diagnostic::{Code, Diagnostic};
use crate::model::{EventRef, Kind, NodeId, NodeKind, Scenario, Spec};
use crate::syntax::ast;

use super::reads::{patterns, players};

/// The entries under `non-spontaneous events` that no assumption ever causes.
pub(super) fn uncaused(files: &[ast::File], spec: &Spec) -> Vec<Diagnostic> {
    let sections = files.iter().flat_map(|file| &file.sections);
    let entries = sections.filter_map(|section| match section {
        ast::Section::NonSpontaneous(entries) => Some(entries),
        _ => None,
    });
    // Every entry was resolved, in this order.
    let entries = entries.flatten().zip(&spec.non_spontaneous);
    entries.filter_map(|(written, &event)| uncaused_event(spec, written, event)).collect()
}

fn uncaused_event(spec: &Spec, written: &ast::EventRef, event: EventRef) -> Option<Diagnostic> {
    let causes = spec.scenarios.iter().filter(|scenario| scenario.kind == Kind::Assumption);
    let mut near = Vec::new();
    for scenario in causes {
        for (node, causes) in environment_messages(spec, scenario, event) {
            if causes {
                return None;
            }
            near.push((scenario, node));
        }
    }
    // Where no scenario mentions it, it is reported as unused; what only the system sends needs no cause.
    let mut scenarios = spec.scenarios.iter();
    let is_sent = |s: &Scenario| {
        patterns(s).any(|m| {
            players(spec, s, m.sender).any(|sender| !spec.controllable[sender])
                && refers(spec, s, m.operation, m.receiver, event)
        })
    };
    if !scenarios.any(is_sent) {
        return None;
    }
    let name = format!("{}.{}", written.class.text, written.operation.text);
    let span = written.class.span.to(written.operation.span);
    let message = format!("no assumption causes `{name}`, so the environment never sends it");
    let mut warning = Diagnostic::warning(Code::NeverCaused, span, message);
    for &(scenario, node) in &near {
        let text = if scenario.initial.contains(&node) {
            "this only starts the scenario when it happens"
        } else {
            "this only waits for it: it has no modality"
        };
        warning = warning.also(scenario.nodes[usize::from(node)].span, text);
    }
    let unmarked = near.iter().any(|(scenario, node)| !scenario.initial.contains(node));
    Some(warning.help(if unmarked {
        "write `eventually` in front of the message that promises it".to_owned()
    } else {
        format!("let an assumption promise it: `eventually … -> ….{}`", written.operation.text)
    }))
}

/// The messages of an assumption that such an event of the environment can be, and whether they cause it.
fn environment_messages(
    spec: &Spec,
    scenario: &Scenario,
    event: EventRef,
) -> impl Iterator<Item = (NodeId, bool)> {
    scenario.nodes.iter().enumerate().filter_map(move |(node, each)| {
        let NodeKind::Message { modality, message, .. } = &each.kind else { return None };
        let sent = players(spec, scenario, message.sender).any(|sender| !spec.controllable[sender]);
        if !sent || !refers(spec, scenario, message.operation, message.receiver, event) {
            return None;
        }
        let node = node as NodeId;
        Some((node, modality.is_some() && !scenario.initial.contains(&node)))
    })
}

/// Whether an assumption causes an event that is not spontaneous.
pub(super) fn causes_events(spec: &Spec, scenario: &Scenario) -> bool {
    spec.non_spontaneous
        .iter()
        .any(|&event| environment_messages(spec, scenario, event).any(|(_, causes)| causes))
}

fn refers(
    spec: &Spec,
    scenario: &Scenario,
    operation: usize,
    receiver: crate::model::RoleRef,
    event: EventRef,
) -> bool {
    players(spec, scenario, receiver).any(|receiver| spec.refers(event, receiver, operation))
}

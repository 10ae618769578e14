//! How control flows through a body: initial messages, and loops that could spin.

use super::super::scenario::{NodeId, NodeKind, Scenario};
use crate::syntax::Span;
use crate::syntax::ast::{Body, FragmentKind, Message};

/// The places of the messages with which a scenario starts; empty if it starts at once.
///
/// The first fragment (behind variable declarations) must be a message, or an `alternative` or `parallel` each of
/// whose branches begins with a message. Deeper nesting starts at once: the language reference is read to the letter.
pub(super) fn initial_messages(body: &Body) -> Vec<Span> {
    let mut initial = Vec::new();
    if collect_initial(body, &mut |message| initial.push(message.span)) { initial } else { Vec::new() }
}

fn collect_initial(body: &Body, visit: &mut dyn FnMut(&Message)) -> bool {
    let message = |body| match first_fragment(body) {
        Some(FragmentKind::Message(_, message)) => Some(message),
        _ => None,
    };
    let messages: Option<Vec<&Message>> = match first_fragment(body) {
        Some(FragmentKind::Message(_, message)) => Some(vec![message]),
        Some(FragmentKind::Alternative(cases)) => cases.iter().map(|case| message(&case.body)).collect(),
        Some(FragmentKind::Parallel(branches)) => branches.iter().map(message).collect(),
        _ => None,
    };
    messages.map(|messages| messages.into_iter().for_each(visit)).is_some()
}

fn first_fragment(body: &Body) -> Option<&FragmentKind> {
    let mut kinds = body.fragments.iter().map(|fragment| &fragment.kind);
    kinds.find(|kind| !matches!(kind, FragmentKind::Variable(..)))
}

/// The names of the roles that every one of the initial messages mentions, so that each start binds them.
pub(super) fn surely_bound(body: &Body, initial: &[Span]) -> Vec<String> {
    let mut bound: Option<Vec<String>> = None;
    if !initial.is_empty() {
        collect_initial(body, &mut |message| {
            let mentioned = [&message.sender.text, &message.receiver.text];
            match &mut bound {
                None => bound = Some(mentioned.map(Clone::clone).to_vec()),
                Some(bound) => bound.retain(|name| mentioned.contains(&name)),
            }
        });
    }
    bound.unwrap_or_default()
}

/// The place of a `while` whose body can complete without a message or `wait`.
pub(super) fn silent_loop(scenario: &Scenario) -> Option<Span> {
    scenario.nodes.iter().find_map(|node| match node.kind {
        NodeKind::While(_, body) if passes_silently(scenario, body) => Some(node.span),
        _ => None,
    })
}

fn passes_silently(scenario: &Scenario, node: NodeId) -> bool {
    let passes = |node: &NodeId| passes_silently(scenario, *node);
    match &scenario.nodes[usize::from(node)].kind {
        NodeKind::Message { .. } | NodeKind::Wait { .. } => false,
        NodeKind::Interrupt(_) | NodeKind::Violation(_) | NodeKind::Assign(..) => true,
        NodeKind::Body { children, .. } => children.iter().all(passes),
        NodeKind::Parallel(branches) => branches.iter().all(passes),
        NodeKind::While(condition, body) => condition.is_some() || passes(body),
        // Where every case has a condition, none may hold.
        NodeKind::Alternative(cases) => {
            cases.iter().all(|case| case.condition.is_some()) || cases.iter().any(|case| passes(&case.body))
        }
    }
}

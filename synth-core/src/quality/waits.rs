//! `wait eventually` in an assumption that the environment cannot make true.

use super::reads::{Place, attributes, has_effect, patterns, players};
use crate::diagnostic::{Code, Diagnostic};
use crate::model::{
    ClassId, Expr, Kind, Message, Moment, NodeKind, Reads, Scenario, Scope, Snapshot, Spec, UNSET,
};

/// The waits of assumptions over what only the system changes, or nothing at all.
pub(super) fn hopeless(spec: &Spec) -> Vec<Diagnostic> {
    let assumptions = spec.scenarios.iter().filter(|scenario| scenario.kind == Kind::Assumption);
    let waits = assumptions.flat_map(|scenario| {
        scenario.nodes.iter().filter_map(move |node| match &node.kind {
            NodeKind::Wait { eventually: true, condition, .. } => Some((scenario, node.span, condition)),
            _ => None,
        })
    });
    let mut warnings = Vec::new();
    for (scenario, span, condition) in waits {
        // What another branch assigns meanwhile can make it true.
        let mut reads_variable = false;
        condition.walk(&mut |part| reads_variable |= matches!(part, Expr::Variable(_)));
        if reads_variable && scenario.nodes.iter().any(|node| matches!(node.kind, NodeKind::Parallel(_))) {
            continue;
        }
        let mut read = Vec::new();
        attributes(spec, Place::Scenario(scenario), condition, &mut |class, at| read.push((class, at)));
        if read.iter().any(|&(class, at)| writers(spec, class, at, false).next().is_some()) {
            continue;
        }
        let by_system: Vec<&Message> =
            read.iter().flat_map(|&(class, at)| writers(spec, class, at, true)).collect();
        let Some(label) = hopelessness(spec, condition, by_system.is_empty()) else { continue };
        let message = "an assumption waits for what the environment cannot change";
        let mut warning = Diagnostic::warning(Code::SystemOnlyWait, span, message).label(label);
        if let Some(writer) = by_system.first() {
            warning = warning.also(writer.span, "the system changes it here");
        }
        warnings.push(
            warning.help("make it a guarantee, or let an event of the environment change the condition"),
        );
    }
    warnings
}

/// What there is to say of a condition that the environment does not change.
fn hopelessness(spec: &Spec, condition: &Expr, is_constant: bool) -> Option<&'static str> {
    if !is_constant {
        return Some("only the system changes this");
    }
    // A condition that never changes is met at once or never, which may depend on the copy.
    let unset = (UNSET, UNSET, [].as_slice());
    let mut reads_copy = false;
    condition.walk(&mut |part| reads_copy |= matches!(part, Expr::Variable(_) | Expr::Role(_)));
    let scope = Scope {
        domain: &spec.domain,
        attributes: Snapshot {
            values: &spec.domain.initial,
            moment: Moment::Before,
            reads: &Reads::default(),
        },
        roles: &[],
        variables: &[],
        event: unset,
    };
    (!reads_copy && scope.eval(condition) == Ok(0)).then_some("this is false and never changes")
}

/// The messages with a sender of one side whose event changes an attribute.
fn writers(
    spec: &Spec,
    class: ClassId,
    attribute: usize,
    controllable: bool,
) -> impl Iterator<Item = &Message> {
    let messages = spec.scenarios.iter().filter(|scenario| scenario.kind != Kind::Existential);
    let messages = messages.flat_map(|scenario| patterns(scenario).map(move |message| (scenario, message)));
    let writing = messages.filter(move |(scenario, message)| {
        players(spec, scenario, message.sender).any(|sender| spec.controllable[sender] == controllable)
            && writes(spec, scenario, message, class, attribute)
    });
    writing.map(|(_, message)| message)
}

fn writes(spec: &Spec, scenario: &Scenario, message: &Message, class: ClassId, attribute: usize) -> bool {
    let domain = &spec.domain;
    let related = |other: ClassId| domain.is_a(other, class) || domain.is_a(class, other);
    let sets = domain.operations[message.operation].sets == Some(attribute)
        && players(spec, scenario, message.receiver).any(|receiver| related(domain.objects[receiver].class));
    sets || spec.effects.iter().any(|effect| {
        let assigns = effect.assignments.iter().any(|a| a.attribute == attribute && related(a.owner_class));
        assigns && has_effect(spec, scenario, message, effect)
    })
}

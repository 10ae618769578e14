//! What one event does to one copy, and which copies it starts.

use super::copies::{Copies, CopyId, Identity};
use super::cut::{Rest, Walker};
use super::events::{Event, EventId};
use super::keys::{KeyId, Keys};
use super::memo::Memo;
use super::pattern::Matcher;
use super::reasons::{Breach, Ground};
use super::{PlayError, ValuationId};
use crate::model::{
    Argument, ConstraintKind, Kind, Moment, NodeId, NodeKind, Reads, RoleRef, Scenario, Snapshot, Spec,
    UNSET, Value,
};

/// What becomes of a copy, or what an event starts.
#[derive(Clone, Debug, Default)]
pub(crate) struct Outcome {
    /// The copies afterwards: for a reaction one or none.
    pub(crate) copies: Vec<CopyId>,
    /// What the event itself violates or gets wrong.
    pub(crate) at_once: Consequence,
    /// What only shows while copies settle after the effects. It means nothing if an earlier stage of the step went
    /// wrong.
    pub(crate) in_settling: Consequence,
    /// Keys that the copy had and met, ascending.
    pub(crate) discharged: Vec<KeyId>,
    /// A copy of an existential scenario came to its end.
    pub(crate) completed: bool,
}

/// Violations and mistakes of one stage.
#[derive(Clone, Debug, Default)]
pub(crate) struct Consequence {
    /// How scenarios are violated: for a reaction in one way or none.
    pub(crate) breaches: Vec<Breach>,
    /// The first mistake met.
    pub(crate) error: Option<PlayError>,
}

impl Consequence {
    fn note(&mut self, mistake: Option<PlayError>) {
        self.error = self.error.take().or(mistake);
    }
}

/// What was found out so far.
#[derive(Debug, Default)]
pub(super) struct Reactions {
    started: Memo<EventId, Outcome>,
    reacted: Memo<(CopyId, EventId), Outcome>,
}

/// The surroundings of one event: everything that an outcome can depend on.
pub(super) struct Occasion<'a> {
    pub(super) spec: &'a Spec,
    /// The existential scenario that is followed.
    pub(super) followed: Option<usize>,
    pub(super) id: EventId,
    pub(super) event: &'a Event,
    /// The valuation before the event, and its values.
    pub(super) valuation: ValuationId,
    pub(super) before: &'a [Value],
    /// The values after its effects.
    pub(super) after: &'a [Value],
}

impl<'a> Occasion<'a> {
    /// Patterns see the state before the effects.
    fn matcher(
        &'a self,
        scenario: &'a Scenario,
        roles: &'a [Value],
        variables: &'a [Value],
        reads: &'a Reads,
    ) -> Matcher<'a> {
        Matcher {
            spec: self.spec,
            event: self.event,
            attributes: self.before(reads),
            scenario,
            roles,
            variables,
        }
    }

    fn before(&self, reads: &'a Reads) -> Snapshot<'a> {
        Snapshot { values: self.before, moment: Moment::Before, reads }
    }

    fn after(&self, reads: &'a Reads) -> Snapshot<'a> {
        Snapshot { values: self.after, moment: Moment::After, reads }
    }
}

impl Reactions {
    /// What becomes of `copy`.
    pub(super) fn react(
        &mut self,
        copies: &mut Copies,
        keys: &mut Keys,
        copy: CopyId,
        occasion: &Occasion<'_>,
    ) -> &Outcome {
        self.reacted.get((copy, occasion.id), occasion.valuation, |reads| {
            reaction(copies, keys, copy, occasion, reads)
        })
    }

    /// Which copies the event starts.
    pub(super) fn start(
        &mut self,
        copies: &mut Copies,
        keys: &mut Keys,
        occasion: &Occasion<'_>,
    ) -> &Outcome {
        self.started.get(occasion.id, occasion.valuation, |reads| starts(copies, keys, occasion, reads))
    }

    /// Bytes held, about.
    pub(super) fn memory(&self) -> usize {
        // An outcome seldom owns more than one list of one element.
        self.started.memory(size_of::<CopyId>()) + self.reacted.memory(size_of::<CopyId>())
    }
}

/// The rows of the reaction table between that of an enabled message and that of any other message, in their order.
const ROWS: [ConstraintKind; 4] =
    [ConstraintKind::Ignore, ConstraintKind::Forbidden, ConstraintKind::Interrupt, ConstraintKind::Consider];

/// The first row of the reaction table that applies to the copy.
#[derive(Clone, Copy)]
enum Reaction {
    Moves(NodeId),
    Stays,
    Ends,
    Violates(Ground),
}

pub(super) fn reaction(
    copies: &mut Copies,
    keys: &mut Keys,
    id: CopyId,
    occasion: &Occasion<'_>,
    reads: &Reads,
) -> Outcome {
    let copy = copies.get(id);
    let scenario = &occasion.spec.scenarios[copy.scenario];
    let mut outcome = Outcome::default();
    let matcher = occasion.matcher(scenario, &copy.roles, &copy.variables, reads);
    let reaction = first_row(&matcher, &copy.cut, &mut outcome.at_once.error);
    let mut walker = walker(occasion, scenario, reads, copy.roles.to_vec(), copy.variables.to_vec());
    walker.cut = copy.cut.to_vec();
    let rest = match reaction {
        Reaction::Ends | Reaction::Violates(_) => Rest::Ended,
        Reaction::Stays => walker.settle(),
        Reaction::Moves(node) => {
            bind(&mut walker, node, occasion.event);
            outcome.at_once.note(walker.error.take());
            walker.passed.push(node);
            walker.move_past(node);
            walker.settle()
        }
    };
    for &(node, key) in &copy.obligations {
        if walker.passed.contains(&node) {
            outcome.discharged.push(key);
        }
    }
    outcome.discharged.sort_unstable();
    let scenario = copy.scenario;
    match reaction {
        Reaction::Violates(ground) if occasion.spec.scenarios[scenario].kind != Kind::Existential => {
            outcome.at_once.breaches.push(Breach { scenario, ground });
        }
        Reaction::Violates(_) | Reaction::Ends => {}
        Reaction::Stays | Reaction::Moves(_) => {
            conclude(copies, keys, scenario, walker, rest, &mut outcome);
        }
    }
    outcome
}

fn first_row(matcher: &Matcher<'_>, cut: &[NodeId], error: &mut Option<PlayError>) -> Reaction {
    for &node in cut {
        let Some(message) = matcher.scenario.message(node) else { continue };
        match matcher.is_message(message) {
            Ok(true) => return Reaction::Moves(node),
            Ok(false) => {}
            Err(mistake) => *error = error.take().or(Some(mistake)),
        }
    }
    for kind in ROWS {
        if let Some(constraint) = matcher.constraint(cut, kind) {
            return match kind {
                ConstraintKind::Ignore => Reaction::Stays,
                ConstraintKind::Forbidden => Reaction::Violates(Ground::Forbidden(constraint.message.span)),
                ConstraintKind::Interrupt => Reaction::Ends,
                ConstraintKind::Consider => out_of_order(matcher.scenario, cut),
            };
        }
    }
    if matcher.scenario.messages().any(|message| matcher.is_like(message)) {
        out_of_order(matcher.scenario, cut)
    } else {
        Reaction::Stays
    }
}

/// What an event does that a copy knows but does not wait for.
fn out_of_order(scenario: &Scenario, cut: &[NodeId]) -> Reaction {
    let strict = cut.iter().map(|&node| &scenario.nodes[usize::from(node)]).find(|node| node.is_strict());
    strict.map_or(Reaction::Ends, |node| Reaction::Violates(Ground::OutOfOrder(node.span)))
}

fn walker<'a>(
    occasion: &'a Occasion<'a>,
    scenario: &'a Scenario,
    reads: &'a Reads,
    roles: Vec<Value>,
    variables: Vec<Value>,
) -> Walker<'a> {
    Walker {
        spec: occasion.spec,
        scenario,
        attributes: occasion.after(reads),
        roles,
        variables,
        cut: Vec::new(),
        passed: Vec::new(),
        error: None,
    }
}

/// Binds what the message leaves open to what the event says.
fn bind(walker: &mut Walker<'_>, node: NodeId, event: &Event) {
    let scenario = walker.scenario;
    let Some(message) = scenario.message(node) else { return };
    for (role, object) in [(message.sender, event.sender), (message.receiver, event.receiver)] {
        if let RoleRef::Dynamic(role) = role {
            walker.roles[role] = object as Value;
        }
    }
    for (argument, &value) in message.arguments.iter().zip(&event.arguments) {
        if let Argument::Bind(variable) = argument {
            walker.assign(*variable, value, message.span);
        }
    }
}

/// Files the copy under its outcome.
fn conclude(
    copies: &mut Copies,
    keys: &mut Keys,
    scenario: usize,
    walker: Walker<'_>,
    rest: Rest,
    outcome: &mut Outcome,
) {
    let is_existential = walker.spec.scenarios[scenario].kind == Kind::Existential;
    outcome.completed |= is_existential && walker.is_completed(rest);
    let Walker { spec, roles, variables, cut, error, .. } = walker;
    outcome.in_settling.note(error);
    match rest {
        Rest::Waits => {
            let identity =
                Identity { scenario, roles: roles.into(), variables: variables.into(), cut: cut.into() };
            outcome.copies.push(copies.intern(spec, keys, identity));
        }
        Rest::Violated(node) if !is_existential => {
            let ground = Ground::Condition(spec.scenarios[scenario].nodes[usize::from(node)].span);
            outcome.in_settling.breaches.push(Breach { scenario, ground });
        }
        Rest::Violated(_) | Rest::Ended => {}
    }
}

/// What the event starts in all scenarios.
pub(super) fn starts(
    copies: &mut Copies,
    keys: &mut Keys,
    occasion: &Occasion<'_>,
    reads: &Reads,
) -> Outcome {
    let mut outcome = Outcome::default();
    for scenario in 0..occasion.spec.scenarios.len() {
        start(copies, keys, scenario, occasion, reads, &mut outcome);
    }
    outcome
}

/// Starts a copy of the scenario if one of its initial messages is the event; the textually first one counts.
fn start(
    copies: &mut Copies,
    keys: &mut Keys,
    index: usize,
    occasion: &Occasion<'_>,
    reads: &Reads,
    outcome: &mut Outcome,
) {
    let scenario = &occasion.spec.scenarios[index];
    if !plays(scenario, index, occasion.followed) {
        return;
    }
    let operation = occasion.event.operation;
    for &node in &scenario.initial {
        // The cheap test first: most scenarios have nothing to do with most events.
        let Some(message) = scenario.message(node).filter(|m| m.operation == operation) else { continue };
        let roles = vec![UNSET; scenario.roles.len()];
        if !occasion.matcher(scenario, &roles, &[], reads).ends(message) {
            continue;
        }
        let mut walker = walker(occasion, scenario, reads, roles, vec![UNSET; scenario.variables.len()]);
        // Conditions, declarations and arguments in front of the message see the state before the effects.
        walker.attributes = occasion.before(reads);
        if !declare_in_front(&mut walker, node) {
            outcome.at_once.note(walker.error);
            continue;
        }
        let matcher = occasion.matcher(scenario, &walker.roles, &walker.variables, reads);
        match matcher.is_message(message) {
            Ok(true) => {}
            Ok(false) => continue,
            Err(mistake) => {
                outcome.at_once.note(Some(mistake));
                continue;
            }
        }
        bind(&mut walker, node, occasion.event);
        walker.attributes = occasion.after(reads);
        let starts = bind_roles(&mut walker);
        outcome.at_once.note(walker.error.take());
        if starts {
            enter_siblings(&mut walker, node);
            walker.move_past(node);
            let rest = walker.settle();
            conclude(copies, keys, index, walker, rest, outcome);
        }
        return;
    }
}

/// Whether copies of the scenario are part of the states: existential ones are only followed on demand.
pub(super) fn plays(scenario: &Scenario, index: usize, followed: Option<usize>) -> bool {
    scenario.kind != Kind::Existential || followed == Some(index)
}

/// Runs the declarations in front of an initial message; `false` if it lies in a case that is not offered now.
fn declare_in_front(walker: &mut Walker<'_>, node: NodeId) -> bool {
    let scenario = walker.scenario;
    let mut path = vec![node];
    while path[path.len() - 1] != 0 {
        path.push(scenario.nodes[usize::from(path[path.len() - 1])].parent);
    }
    path.reverse();
    for step in path.windows(2) {
        let (parent, child) = (step[0], step[1]);
        match &scenario.nodes[usize::from(parent)].kind {
            NodeKind::Body { children, .. } => {
                for &declaration in children.iter().take_while(|&&c| c != child) {
                    walker.run_declaration(declaration);
                }
            }
            NodeKind::Alternative(cases) => {
                let case = cases.iter().find(|case| case.body == child);
                if !case.is_some_and(|case| walker.is_offered(case)) {
                    return false;
                }
            }
            _ => {}
        }
    }
    true
}

/// Evaluates `bindings`; `false` if one gives `null` or contradicts the message, and no copy starts.
pub(super) fn bind_roles(walker: &mut Walker<'_>) -> bool {
    let scenario = walker.scenario;
    for (role, value, span) in &scenario.bindings {
        let Some(value) = walker.value(value, *span) else { return false };
        let class = scenario.roles[*role].class;
        let fits = walker.spec.domain.is_instance(value, class);
        if !fits || (walker.roles[*role] != UNSET && walker.roles[*role] != value) {
            return false;
        }
        walker.roles[*role] = value;
    }
    true
}

/// Enters the other branches of every `parallel` around an initial message.
fn enter_siblings(walker: &mut Walker<'_>, node: NodeId) {
    let scenario = walker.scenario;
    let mut child = node;
    while child != 0 {
        let parent = scenario.nodes[usize::from(child)].parent;
        if let NodeKind::Parallel(branches) = &scenario.nodes[usize::from(parent)].kind {
            for &branch in branches.iter().filter(|&&branch| branch != child) {
                walker.enter(branch);
            }
        }
        child = parent;
    }
}

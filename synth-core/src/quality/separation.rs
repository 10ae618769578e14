//! Events that guarantees ask for and that violate something: assumptions that the system can break (well-separation),
//! and messages with `bind` that catch more than the value that they bind.

use super::plays::{note, play_to};
use super::reads::{patterns, players};
use crate::diagnostic::{Code, Diagnostic};
use crate::explore::Explored;
use crate::game::Turn;
use crate::model::{Argument, Kind, Message, NodeId, NodeKind, RoleRef, Scenario, Spec, UNSET};
use crate::playout::{Config, Copy, CopyId, EventId, Playout, Step, Transgression};
use std::collections::BTreeSet;

/// Looks at every state of the game.
pub(super) fn breaches(explored: &mut Explored<'_>) -> Vec<Diagnostic> {
    let spec = explored.playout.spec();
    let mut search = Search {
        breakable: indices(spec, |scenario| scenario.kind == Kind::Assumption && can_break(spec, scenario)),
        binding: indices(spec, |scenario| scenario.kind != Kind::Existential && binds(scenario)),
        warnings: Vec::new(),
    };
    let mut siblings = Siblings::new(&explored.playout);
    if search.breakable.is_empty() && search.binding.is_empty() {
        return Vec::new();
    }
    let (mut config, mut breaches) = (Config::default(), Vec::new());
    for state in 0..explored.store.len() as u32 {
        let Explored { playout, store, game } = &mut *explored;
        store.load(playout, state, &mut config);
        let target = |edge: usize| game.turn[game.target[edge] as usize];
        let is_fine = |event: EventId| {
            game.edges_of(state).any(|edge| game.label(edge) == event && target(edge) != Turn::Won)
        };
        breaches.clear();
        playout.transgressions(&config, game.turn[state as usize], is_fine, &mut breaches);
        if game.turn[state as usize] == Turn::EnvironmentAny {
            siblings.excluded(playout, &config, &search.binding, is_fine, &mut breaches);
        }
        if !search.binding.is_empty() {
            let lost = game.edges_of(state).filter(|&edge| target(edge) == Turn::Lost);
            breaches.extend(lost.map(|edge| violation(playout, &config, game.label(edge))));
        }
        for breach in &breaches {
            search.look_at(explored, state, &config, breach);
        }
        if search.breakable.is_empty() && search.binding.is_empty() {
            break;
        }
    }
    search.warnings
}

fn indices(spec: &Spec, which: impl Fn(&Scenario) -> bool) -> BTreeSet<usize> {
    (0..spec.scenarios.len()).filter(|&index| which(&spec.scenarios[index])).collect()
}

/// Whether an event of the system could violate the scenario at all.
fn can_break(spec: &Spec, scenario: &Scenario) -> bool {
    let mut nodes = scenario.nodes.iter();
    nodes.any(|node| matches!(node.kind, NodeKind::Violation(_)))
        || patterns(scenario)
            .any(|message| players(spec, scenario, message.sender).any(|sender| spec.controllable[sender]))
}

fn binds(scenario: &Scenario) -> bool {
    scenario.messages().any(has_bind)
}

fn has_bind(message: &Message) -> bool {
    message.arguments.iter().any(|argument| matches!(argument, Argument::Bind(_)))
}

fn violation(playout: &mut Playout<'_>, config: &Config, event: EventId) -> Transgression {
    let mut step = Step::default();
    playout.step(config, event, &mut step);
    Transgression { event, violated: step.violated }
}

/// The environment's events that a message with `bind` of an assumption takes.
struct Siblings {
    /// Per such assumption, by its index.
    events: Vec<(usize, Vec<EventId>)>,
    /// Copies that were asked already. What a copy excludes hardly depends on the rest of the state.
    asked: BTreeSet<CopyId>,
}

impl Siblings {
    fn new(playout: &Playout<'_>) -> Self {
        let assumptions =
            indices(playout.spec(), |scenario| scenario.kind == Kind::Assumption && binds(scenario));
        let of = |index: usize| {
            let bound = playout.spec().scenarios[index].messages().filter(|message| has_bind(message));
            let operations: BTreeSet<usize> = bound.map(|message| message.operation).collect();
            operations.into_iter().flat_map(|operation| playout.spontaneous(operation)).collect()
        };
        let events = assumptions.into_iter().map(|index| (index, of(index))).collect();
        Siblings { events, asked: BTreeSet::new() }
    }

    /// Those that violate the assumption, where a copy of it is at something strict for the first time.
    fn excluded(
        &mut self,
        playout: &mut Playout<'_>,
        config: &Config,
        binding: &BTreeSet<usize>,
        is_fine: impl Fn(EventId) -> bool,
        found: &mut Vec<Transgression>,
    ) {
        for (index, events) in self.events.iter().filter(|(index, _)| binding.contains(index)) {
            let scenario = &playout.spec().scenarios[*index];
            let mut new = false;
            for &id in &config.copies {
                let copy = playout.copy(id);
                let is_due =
                    copy.scenario == *index && copy.cut.iter().any(|&node| is_strict(scenario, node));
                new |= is_due && self.asked.insert(id);
            }
            if new {
                playout.excluded(config, events, &is_fine, found);
            }
        }
    }
}

struct Search {
    /// Assumptions that were not seen to be violated by the system yet, as far as that is possible.
    breakable: BTreeSet<usize>,
    /// Scenarios with a `bind` that was not seen to catch too much yet.
    binding: BTreeSet<usize>,
    warnings: Vec<Diagnostic>,
}

impl Search {
    fn look_at(&mut self, explored: &mut Explored<'_>, state: u32, config: &Config, breach: &Transgression) {
        let spec = explored.playout.spec();
        let is_guarantee = |&scenario: &usize| spec.scenarios[scenario].kind == Kind::Guarantee;
        for &scenario in &breach.violated {
            if self.binding.contains(&scenario)
                && let Some(warning) = covered(&explored.playout, config, breach.event, scenario)
            {
                self.binding.remove(&scenario);
                self.warn(explored, state, breach.event, warning);
            }
        }
        // What violates a guarantee, too, is forbidden to the system anyway.
        if !explored.playout.event(breach.event).controllable || breach.violated.iter().any(is_guarantee) {
            return;
        }
        for &scenario in &breach.violated {
            if self.breakable.remove(&scenario) {
                let warning = broken(&mut explored.playout, config, breach.event, scenario);
                self.warn(explored, state, breach.event, warning);
            }
        }
    }

    fn warn(&mut self, explored: &Explored<'_>, state: u32, event: EventId, warning: Diagnostic) {
        self.warnings.push(warning.note(note(&play_to(explored, state, event))));
    }
}

/// An assumption that the event violates although a guarantee asks for it.
fn broken(playout: &mut Playout<'_>, config: &Config, event: EventId, index: usize) -> Diagnostic {
    let spec = playout.spec();
    let scenario = &spec.scenarios[index];
    let reasons = playout.reasons(config, event);
    let text = &playout.event(event).text;
    let message = format!("an event of the system can violate assumption `{}`", scenario.name);
    let mut warning = Diagnostic::warning(Code::SystemBreaksAssumption, scenario.span, message)
        .label(format!("`{text}` would violate this"));
    if let Some(objection) = reasons.objections.iter().find(|objection| objection.scenario == index) {
        warning = warning.also(objection.ground.span(), objection.ground.describe());
    }
    if let Some(stake) = reasons.wanted_by.first() {
        warning = warning.also(stake.span, "a guarantee asks for it here");
    }
    let consequence = if playout.semantics().classic {
        "with `--classic` the system may do this, and wins by it"
    } else {
        "the system may not do this; the guarantee has to wait"
    };
    warning
        .note(consequence)
        .help("let the guarantee wait until the assumption is over, or forbid the event in a guarantee")
}

fn copies<'a>(
    playout: &'a Playout<'_>,
    config: &'a Config,
    scenario: usize,
) -> impl Iterator<Item = &'a Copy> {
    config.copies.iter().map(|&copy| playout.copy(copy)).filter(move |copy| copy.scenario == scenario)
}

fn is_strict(scenario: &Scenario, node: NodeId) -> bool {
    match scenario.nodes[usize::from(node)].kind {
        NodeKind::Message { strict, .. } | NodeKind::Wait { strict, .. } => strict,
        _ => false,
    }
}

/// A scenario that the event violates because a message with `bind`, which is past, takes any value.
fn covered(playout: &Playout<'_>, config: &Config, event: EventId, index: usize) -> Option<Diagnostic> {
    let spec = playout.spec();
    let scenario = &spec.scenarios[index];
    let event = playout.event(event);
    // Where the scenario speaks of other values expressly, that is what was meant.
    let same = |operation: usize| operation == event.operation;
    if scenario.constraints().any(|constraint| same(constraint.message.operation)) {
        return None;
    }
    copies(playout, config, index).find_map(|copy| {
        let &strict = copy.cut.iter().find(|&&node| is_strict(scenario, node))?;
        let message = scenario.messages().find(|message| {
            let values = message.arguments.iter().zip(&event.arguments);
            let mut bound = values.filter_map(|(argument, &given)| match argument {
                Argument::Bind(variable) => Some((copy.variables[*variable], given)),
                Argument::Any | Argument::Value(_) => None,
            });
            same(message.operation) && bound.any(|(held, given)| held != UNSET && held != given)
        })?;
        let operation = &spec.domain.operations[event.operation].name;
        let place = scenario.nodes[usize::from(strict)].span;
        let text = format!("`{}` violates `{}`, although it has another argument", event.text, scenario.name);
        let label = "with `bind` this stands for every value, and counts as long as the scenario is active";
        let warning = Diagnostic::warning(Code::CoveredSiblings, message.span, text)
            .label(label)
            .also(place, format!("while this is due, any other `{operation}` is a violation"))
            .help(format!(
                "write `constraints [ ignore {0} ]` if other values are none of its business, or `forbidden` if they are",
                pattern(spec, scenario, message)
            ));
        let is_promise = scenario.kind == Kind::Assumption && !event.controllable;
        let promise = "so this promises that the environment does not send it then";
        Some(if is_promise { warning.note(promise) } else { warning })
    })
}

/// The message with `*` for every argument.
fn pattern(spec: &Spec, scenario: &Scenario, message: &Message) -> String {
    let role = |role| match role {
        RoleRef::Object(object) => &spec.domain.objects[object].name,
        RoleRef::Dynamic(role) => &scenario.roles[role].name,
    };
    let stars = vec!["*"; message.arguments.len()].join(", ");
    let operation = &spec.domain.operations[message.operation].name;
    format!("{} -> {}.{operation}({stars})", role(message.sender), role(message.receiver))
}

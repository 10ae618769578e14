//! Assumptions that would help: a few standard shapes, each put into the specification and tried.
//!
//! Only those are tried that rule the counter-play out. The parts are messages that the scenarios of the core, and of what
//! else is involved, speak of, as they stand there, and the events of the game. An assumption is suggested if with it
//!
//! * the specification is realizable,
//! * there is no state in which the system could keep the environment from meeting its assumptions: nothing is won
//!   because something impossible was assumed,
//! * the guarantee that was violated or starved still comes into play: from some state in which the system wins, with
//!   the obligation open if one starved,
//! * the assumption can do its work: its last message happens while a copy of it is active.
//!
//! The system cannot violate any of them by their shape: none is strict, and they forbid events of the environment only.

use super::Replay;
use super::probe::Budget;
use crate::explore::{Explored, explore};
use crate::game::{Loss, YIELD, overpowered, solve, wins};
use crate::model::{
    Argument, Constraint, ConstraintKind, Expr, Kind, Message, Modality, Node, NodeId, NodeKind, RoleRef,
    Scenario, Spec, UNSET,
};
use crate::pipeline::Solved;
use crate::playout::{Event, Key};
use std::collections::BTreeSet;

/// An assumption with which the specification is realizable.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Suggestion {
    /// The collaboration that it goes into.
    pub collaboration: String,
    /// The scenario, as it is to be written there.
    pub text: String,
}

impl Suggestion {
    /// What to do with it.
    pub(super) fn as_edit(&self) -> String {
        let Suggestion { collaboration, text } = self;
        let text = text.replace('\n', "\n  ");
        format!("add this assumption to collaboration `{collaboration}`, if it holds:\n  {text}")
    }
}

/// Most assumptions of one shape that are looked at: with which the counter-play is played out once more.
const MOST_REPLAYED: usize = 200;
/// Most assumptions of one shape that are tried: with which the whole game is explored.
const MOST_TRIED: usize = 16;

/// What there is to build on.
pub(super) struct Basis<'a, 's> {
    pub(super) solved: &'a Solved<'s>,
    pub(super) loss: Loss,
    /// Edges of the counter-play.
    pub(super) play: &'a [u32],
    /// Edges of its loop.
    pub(super) cycle: &'a [u32],
    /// The obligation that starves.
    pub(super) starved: Option<&'a Key>,
    /// Scenarios to take messages from; the first is the one that is violated or starves.
    pub(super) scenarios: &'a [usize],
}

/// One assumption of each shape for which one was found.
pub(super) fn suggest(basis: &Basis<'_, '_>, mut budget: Budget) -> Vec<Suggestion> {
    let mut suggestions = Vec::new();
    for shape in basis.candidates() {
        let promising = shape.iter().filter(|candidate| basis.is_ruled_out_by(candidate));
        let found = promising.take(MOST_TRIED).find(|candidate| basis.works(candidate, &mut budget));
        suggestions.extend(found.map(|found| found.suggestion(basis.spec())));
    }
    suggestions
}

impl<'s> Basis<'_, 's> {
    fn spec(&self) -> &'s Spec {
        self.solved.explored.playout.spec()
    }

    /// The event of an edge, none for a yield.
    fn event(&self, edge: u32) -> Option<&Event> {
        let label = self.solved.explored.game.label(edge as usize);
        (label != YIELD).then(|| self.solved.explored.playout.event(label))
    }

    fn text(&self, edge: u32) -> &str {
        self.solved.explored.text(edge as usize)
    }

    fn events<'b>(&'b self, edges: &'b [u32]) -> impl DoubleEndedIterator<Item = &'b Event> {
        edges.iter().filter_map(|&edge| self.event(edge))
    }

    /// What is to be tried, by shape.
    fn candidates(&self) -> Vec<Vec<Candidate>> {
        match (self.loss, self.play.split_last()) {
            (Loss::Violation, Some((&last, before))) => match self.event(last) {
                Some(event) => self.not_before(event, before),
                None => Vec::new(),
            },
            (Loss::Starvation(_), _) => vec![self.answers(), self.not_again()],
            (Loss::Violation | Loss::Endless, _) => Vec::new(),
        }
    }

    /// The messages of the scenarios, and with constraints those of constraints.
    fn phrases(&self, constraints: bool) -> Vec<Phrase> {
        let spec = self.spec();
        let mut phrases: Vec<Phrase> = Vec::new();
        for &home in self.scenarios {
            let scenario = &spec.scenarios[home];
            let forbidden = scenario.constraints().map(|constraint| &constraint.message);
            let messages =
                scenario.messages().chain(forbidden.take(if constraints { usize::MAX } else { 0 }));
            for message in messages {
                add(&mut phrases, Phrase::of_message(spec, home, message));
            }
        }
        phrases
    }

    /// What the copies of the scenarios wait for at the end of a play, with the objects that play their roles there.
    fn awaited(&self, play: &[u32]) -> Vec<Phrase> {
        let (spec, mut awaited) = (self.spec(), Vec::new());
        let Some(mut replay) = Replay::of(self.solved) else {
            return awaited;
        };
        if play.iter().any(|&edge| replay.follow(self.text(edge)).is_none()) {
            return awaited;
        }
        for &home in self.scenarios {
            let copies = replay.config.copies.iter().map(|&copy| replay.playout.copy(copy));
            for copy in copies.filter(|copy| copy.scenario == home) {
                let bound = |role| match role {
                    RoleRef::Dynamic(r) if copy.roles[r] != UNSET => RoleRef::Object(copy.roles[r] as usize),
                    role => role,
                };
                for message in copy.cut.iter().filter_map(|&node| spec.scenarios[home].message(node)) {
                    let (sender, receiver) = (bound(message.sender), bound(message.receiver));
                    let message = Message { sender, receiver, ..message.clone() };
                    add(&mut awaited, Phrase::of_message(spec, home, &message));
                }
            }
        }
        awaited
    }

    /// Everything that happens in the game.
    fn happenings(&self) -> Vec<Phrase> {
        let Explored { playout, game, .. } = &self.solved.explored;
        let labels: BTreeSet<u32> = game.actions.labels().filter(|&label| label != YIELD).collect();
        labels.iter().map(|&label| Phrase::of_event(self.spec(), playout.event(label))).collect()
    }

    /// The messages that happen in the play, the latest first.
    fn happened(&self, pool: &[Phrase], edges: &[u32]) -> Vec<Phrase> {
        let mut happened = Vec::new();
        for event in self.events(edges).rev() {
            for phrase in pool.iter().filter(|phrase| phrase.matches(self.spec(), event)) {
                add(&mut happened, phrase.clone());
            }
        }
        happened
    }

    /// The environment answers eventually.
    fn answers(&self) -> Vec<Candidate> {
        let pool = self.phrases(false);
        let whole: Vec<u32> = self.play.iter().chain(self.cycle).copied().collect();
        let causes = self.happened(&pool, &whole);
        let mut answers: Vec<Phrase> = Vec::new();
        if let Some(key) = self.starved
            && let Some(message) = self.spec().scenarios[key.scenario].message(key.node)
        {
            answers.push(Phrase::of_message(self.spec(), key.scenario, message));
        }
        let comes = |phrase: &Phrase| self.events(self.cycle).any(|event| phrase.matches(self.spec(), event));
        for mut phrases in [self.awaited(self.play), pool, self.happenings()] {
            phrases.retain(|phrase| !comes(phrase));
            add_all(&mut answers, phrases);
        }
        answers.retain(|answer| answer.by_environment);
        let pairs = answers.iter().flat_map(|answer| causes.iter().map(move |cause| (cause, answer)));
        let candidates = pairs.filter_map(|(cause, answer)| Candidate::new(cause, answer, None));
        candidates.take(MOST_REPLAYED).collect()
    }

    /// What the environment repeats in the loop comes once, until something else happens.
    fn not_again(&self) -> Vec<Candidate> {
        let pool = self.phrases(true);
        let repeated = self.happened(&pool, self.cycle);
        self.delays(&repeated, |again| vec![again.clone()], self.play)
    }

    /// The event that violates does not come again, or not at all, until something else happens.
    fn not_before(&self, violating: &Event, before: &[u32]) -> Vec<Vec<Candidate>> {
        let pool = self.phrases(true);
        let mut too_early: Vec<Phrase> =
            pool.iter().filter(|phrase| phrase.matches(self.spec(), violating)).cloned().collect();
        add(&mut too_early, Phrase::of_event(self.spec(), violating));
        let happened = self.happened(&pool, before);
        let again: Vec<Phrase> = too_early.iter().filter(|&each| happened.contains(each)).cloned().collect();
        let causes = |early: &Phrase| happened.iter().filter(|&cause| cause != early).cloned().collect();
        vec![
            self.delays(&again, |again| vec![again.clone()], before),
            self.delays(&too_early, causes, before),
        ]
    }

    /// Some event does not come, from a cause on until something else happens: best what is awaited at the end of `play`.
    fn delays(
        &self,
        events: &[Phrase],
        causes: impl Fn(&Phrase) -> Vec<Phrase>,
        play: &[u32],
    ) -> Vec<Candidate> {
        let awaited = self.awaited(play);
        let mut ends = self.phrases(false);
        add_all(&mut ends, self.happenings());
        let mut candidates = Vec::new();
        for event in events.iter().filter(|event| event.by_environment) {
            for cause in causes(event) {
                // Next best is what comes after the cause in its scenario.
                let behind = ends.iter().position(|end| *end == cause).map_or(0, |cause| cause + 1);
                let rotated = ends[behind..].iter().chain(&ends[..behind]);
                let ends = awaited.iter().chain(rotated.filter(|end| !awaited.contains(end)));
                let ends = ends.filter(|&end| end != event);
                let more = ends.filter_map(|end| Candidate::new(&cause, end, Some(event)));
                candidates.extend(more.take(MOST_REPLAYED - candidates.len()));
            }
        }
        candidates
    }

    /// The specification with the assumption as its last scenario.
    fn with(&self, candidate: &Candidate) -> Spec {
        let mut spec = self.spec().clone();
        spec.scenarios.push(candidate.scenario(&spec));
        spec
    }

    /// Whether the counter-play is none any more with the assumption: the environment may not go that way, or the loop is
    /// not fair to it. It could help otherwise, too, but then it would be hard to see why; and this is quick to find out.
    fn is_ruled_out_by(&self, candidate: &Candidate) -> bool {
        let spec = self.with(candidate);
        let Some(mut replay) = Replay::new(&spec, self.solved.explored.playout.semantics()) else {
            return false;
        };
        if self.play.iter().any(|&edge| replay.follow(self.text(edge)).is_none()) {
            return true;
        }
        let owes = |replay: &Replay<'_>| {
            let mut open = replay.open().into_iter();
            open.any(|key| replay.playout.key(key).scenario + 1 == spec.scenarios.len())
        };
        if !owes(&replay) {
            return false;
        }
        for &edge in self.cycle {
            if replay.follow(self.text(edge)).is_none() {
                return true;
            }
            if !owes(&replay) {
                return false;
            }
        }
        true
    }

    /// Whether the specification with the assumption is as it should be.
    fn works(&self, candidate: &Candidate, budget: &mut Budget) -> bool {
        let spec = self.with(candidate);
        let assumption = spec.scenarios.len() - 1;
        let limits = budget.limits();
        let Ok(explored) = explore(&spec, self.solved.explored.playout.semantics(), &limits) else {
            budget.spend(limits.states);
            return false;
        };
        budget.spend(explored.game.states());
        wins(&explored.game)
            && overpowered(&explored.game).is_clear()
            && self.is_exercised(candidate, &explored, assumption)
    }

    /// Whether both the guarantee and the assumption come into play where the system wins.
    fn is_exercised(&self, candidate: &Candidate, explored: &Explored<'_>, assumption: usize) -> bool {
        let Explored { playout, store, game } = explored;
        let solution = solve(game);
        let (mut opens, mut ends) = (false, false);
        let mut there = Vec::new();
        for state in (0..store.len() as u32).filter(|&state| solution.wins(state)) {
            store.copies(state, &mut there);
            let copies = || there.iter().map(|&copy| playout.copy(copy));
            opens = opens
                || copies().any(|copy| match self.starved {
                    Some(key) => {
                        copy.scenario == key.scenario
                            && copy.obligations.iter().any(|&(node, _)| node == key.node)
                    }
                    None => self.scenarios.first() == Some(&copy.scenario),
                });
            ends = ends
                || copies().any(|copy| copy.scenario == assumption)
                    && game.edges_of(state).any(|edge| {
                        let label = game.label(edge);
                        label != YIELD && candidate.end.matches(playout.spec(), playout.event(label))
                    });
            if opens && ends {
                return true;
            }
        }
        false
    }
}

/// A message for a suggested scenario.
#[derive(Clone, Debug)]
struct Phrase {
    text: String,
    message: Message,
    /// The scenario whose dynamic roles it mentions.
    home: Option<usize>,
    by_environment: bool,
}

/// They read the same, in the same scenario.
impl PartialEq for Phrase {
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text && self.home == other.home
    }
}

fn add(phrases: &mut Vec<Phrase>, phrase: Phrase) {
    if !phrases.contains(&phrase) {
        phrases.push(phrase);
    }
}

/// Adds what is not there yet; `more` has no duplicates of its own.
fn add_all(phrases: &mut Vec<Phrase>, mut more: Vec<Phrase>) {
    more.retain(|phrase| !phrases.contains(phrase));
    phrases.append(&mut more);
}

impl Phrase {
    /// As it stands in a scenario; an argument that is not constant is left open.
    fn of_message(spec: &Spec, home: usize, message: &Message) -> Self {
        let constant = |argument: &Argument| match argument {
            Argument::Value(value) => value.constant(),
            Argument::Any | Argument::Bind(_) => None,
        };
        let open = |argument: &Argument| {
            constant(argument).map_or(Argument::Any, |value| Argument::Value(Expr::Const(value)))
        };
        let arguments = message.arguments.iter().map(open).collect();
        Phrase::new(spec, home, Message { arguments, ..message.clone() })
    }

    fn of_event(spec: &Spec, event: &Event) -> Self {
        let message = Message {
            sender: RoleRef::Object(event.sender),
            receiver: RoleRef::Object(event.receiver),
            operation: event.operation,
            arguments: event.arguments.iter().map(|&value| Argument::Value(Expr::Const(value))).collect(),
            span: spec.scenarios.first().map_or_else(Default::default, |scenario| scenario.span),
        };
        Phrase::new(spec, 0, message)
    }

    fn new(spec: &Spec, home: usize, message: Message) -> Self {
        let name = |role| match role {
            RoleRef::Object(object) => spec.domain.objects[object].name.as_str(),
            RoleRef::Dynamic(role) => spec.scenarios[home].roles[role].name.as_str(),
        };
        let operation = &spec.domain.operations[message.operation];
        let argument = |(argument, (_, ty)): (&Argument, &(String, _))| match argument {
            Argument::Value(Expr::Const(value)) => spec.domain.show(*value, *ty),
            _ => "*".to_owned(),
        };
        let arguments: Vec<String> =
            message.arguments.iter().zip(&operation.parameters).map(argument).collect();
        let (sender, receiver) = (name(message.sender), name(message.receiver));
        let text = format!("{sender} -> {receiver}.{}({})", operation.name, arguments.join(", "));
        let is_dynamic = |role| matches!(role, RoleRef::Dynamic(_));
        let has_role = is_dynamic(message.sender) || is_dynamic(message.receiver);
        let by_environment = match message.sender {
            RoleRef::Object(object) => !spec.controllable[object],
            RoleRef::Dynamic(role) => {
                let class = spec.scenarios[home].roles[role].class;
                let mut objects = spec.domain.objects.iter().zip(&spec.controllable);
                !objects.any(|(object, &controllable)| controllable && spec.domain.is_a(object.class, class))
            }
        };
        Phrase { text, message, home: has_role.then_some(home), by_environment }
    }

    /// Whether the event can be this message.
    fn matches(&self, spec: &Spec, event: &Event) -> bool {
        let role = |role: RoleRef, object: usize| match (role, self.home) {
            (RoleRef::Object(named), _) => named == object,
            (RoleRef::Dynamic(role), Some(home)) => {
                spec.domain.is_a(spec.domain.objects[object].class, spec.scenarios[home].roles[role].class)
            }
            (RoleRef::Dynamic(_), None) => false,
        };
        let fits = |(argument, value): (&Argument, &_)| match argument {
            Argument::Value(Expr::Const(constant)) => constant == value,
            _ => true,
        };
        self.message.operation == event.operation
            && role(self.message.sender, event.sender)
            && role(self.message.receiver, event.receiver)
            && self.message.arguments.iter().zip(&event.arguments).all(fits)
    }
}

/// `cause`, then `end`: eventually, or with an event forbidden until then.
struct Candidate {
    cause: Phrase,
    end: Phrase,
    forbidden: Option<Phrase>,
    /// The scenario whose collaboration it goes into, and whose roles it uses.
    home: Option<usize>,
}

impl Candidate {
    /// None if the messages speak of roles of different scenarios, or both are the same.
    fn new(cause: &Phrase, end: &Phrase, forbidden: Option<&Phrase>) -> Option<Self> {
        let homes =
            [Some(cause), Some(end), forbidden].into_iter().flatten().filter_map(|phrase| phrase.home);
        let homes: BTreeSet<usize> = homes.collect();
        let is_sound = homes.len() <= 1 && cause.text != end.text;
        is_sound.then(|| Candidate {
            cause: cause.clone(),
            end: end.clone(),
            forbidden: forbidden.cloned(),
            home: homes.first().copied(),
        })
    }

    /// `None` if the messages mention no role: then any place would do.
    fn home(&self, spec: &Spec) -> usize {
        let is_guarantee = |scenario: &Scenario| scenario.kind == Kind::Guarantee;
        self.home.or_else(|| spec.scenarios.iter().position(is_guarantee)).unwrap_or_default()
    }

    fn scenario(&self, spec: &Spec) -> Scenario {
        let home = &spec.scenarios[self.home(spec)];
        let message = |phrase: &Phrase, modality| Node {
            parent: 0,
            kind: NodeKind::Message {
                strict: false,
                monitored: false,
                modality,
                message: phrase.message.clone(),
            },
            span: home.span,
        };
        let constraints = self
            .forbidden
            .iter()
            .map(|phrase| Constraint { kind: ConstraintKind::Forbidden, message: phrase.message.clone() });
        let children: Vec<NodeId> = vec![1, 2];
        let body = NodeKind::Body { children, variables: Vec::new(), constraints: constraints.collect() };
        let modality = self.forbidden.is_none().then_some(Modality::Eventually);
        Scenario {
            name: String::new(),
            kind: Kind::Assumption,
            span: home.span,
            requirement: Vec::new(),
            roles: self.home.map_or(Vec::new(), |_| home.roles.clone()),
            variables: Vec::new(),
            bindings: Vec::new(),
            nodes: vec![
                Node { parent: 0, kind: body, span: home.span },
                message(&self.cause, None),
                message(&self.end, modality),
            ],
            initial: vec![1],
        }
    }

    fn suggestion(&self, spec: &Spec) -> Suggestion {
        let home = &spec.scenarios[self.home(spec)].name;
        let collaboration = home.split_once('.').map_or(home.as_str(), |(collaboration, _)| collaboration);
        let word = |phrase: &Phrase| capitalised(&spec.domain.operations[phrase.message.operation].name);
        let (cause, end) = (&self.cause, &self.end);
        let name = match &self.forbidden {
            None => format!("{}Follows{}", word(end), word(cause)),
            Some(forbidden) => format!("No{}Before{}", word(forbidden), word(end)),
        };
        let name = free_name(spec, collaboration, name);
        let (eventually, constraints) = match &self.forbidden {
            None => ("eventually ", String::new()),
            Some(forbidden) => ("", format!(" constraints [ forbidden {} ]", forbidden.text)),
        };
        let text = format!(
            "assumption scenario {name} {{\n  {}\n  {eventually}{}\n}}{constraints}",
            cause.text, end.text
        );
        Suggestion { collaboration: collaboration.to_owned(), text }
    }
}

fn capitalised(name: &str) -> String {
    let mut letters = name.chars();
    letters.next().map_or(String::new(), |first| first.to_ascii_uppercase().to_string() + letters.as_str())
}

/// The name, with a number if the collaboration has such a scenario already.
fn free_name(spec: &Spec, collaboration: &str, name: String) -> String {
    let is_free = |name: &String| {
        let full = format!("{collaboration}.{name}");
        spec.scenarios.iter().all(|scenario| scenario.name != full)
    };
    let numbered = (2..).map(|number| format!("{name}{number}"));
    std::iter::once(name.clone()).chain(numbered).find(is_free).unwrap_or(name)
}

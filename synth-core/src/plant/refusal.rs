//! What cannot be avoided from some state, shown by a shortest play.

use super::moves::{Candidates, holds, marks};
use super::product::Product;
use super::supremal::Fate;
use super::{AutomatonId, EventId, Plant, Rule};
use crate::diagnostic::{Code, Diagnostic};
use crate::syntax::Span;

/// A constraint.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Source {
    /// A condition, by its position among [`Plant::constraints`].
    Condition(u32),
    /// A constraint automaton.
    Automaton(AutomatonId),
}

impl Source {
    /// As written.
    #[must_use]
    pub fn name(self, plant: &Plant) -> &str {
        match self {
            Source::Condition(condition) => &plant.constraints[condition as usize].name,
            Source::Automaton(automaton) => &plant.automata[automaton as usize].name,
        }
    }

    pub(super) fn span(self, plant: &Plant) -> Span {
        match self {
            Source::Condition(condition) => plant.constraints[condition as usize].span,
            Source::Automaton(automaton) => plant.automata[automaton as usize].span,
        }
    }
}

/// Why a state goes by itself.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Reason {
    /// This `never` holds.
    Never(u32),
    /// This uncontrollable event can happen, and this forbids it.
    Forbidden(EventId, Source),
    /// No state in which all automata are marked can be reached any more, whatever is enabled.
    Blocked {
        /// The automata none of whose marked states can be reached; empty if each can, but not all at one time.
        unmarked: Vec<AutomatonId>,
        /// What the components allow in this state, and what forbids it.
        forbidden: Vec<(EventId, Source)>,
    },
}

/// A shortest play that shows why a state has to be avoided, or cannot be.
///
/// It ends in a state that is bad, or from which no marked state can be reached. On the way, every event is either one that
/// nobody can prevent, or a step in the direction of marked states that leads to such events: from the states in
/// between, no other way to a marked state is any better.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Unavoidable {
    /// The events.
    pub play: Vec<EventId>,
    /// How many of the last ones nobody can prevent, since they are uncontrollable.
    pub forced: usize,
    /// The automata's states at the end.
    pub states: Vec<u16>,
    /// What is wrong there.
    pub reason: Reason,
}

impl Unavoidable {
    /// From a state that goes.
    pub(super) fn find(plant: &Plant, product: &Product<'_>, fates: &[Fate], start: u32) -> Self {
        let is_end = |state: u32| fates[state as usize].round() == 1 && fates[state as usize].by_itself();
        let follows = |state: u32, edge: usize| {
            let target = product.target[edge];
            if fates[state as usize].by_itself() {
                !is_end(target)
            } else {
                !plant.events[product.event[edge] as usize].controllable && fates[target as usize].is_gone()
            }
        };
        let (play, end) = shortest(product, start, follows, is_end);
        Unavoidable::new(plant, product, play, end)
    }

    /// From state 0 to the first bad state.
    pub(super) fn to_bad(plant: &Plant, product: &Product<'_>) -> Option<Self> {
        let &bad = product.bad.first()?;
        let (play, end) = shortest(product, 0, |_, _| true, |state| state == bad);
        Some(Unavoidable::new(plant, product, play, end))
    }

    fn new(plant: &Plant, product: &Product<'_>, play: Vec<EventId>, end: u32) -> Self {
        let forced = play.iter().rev().take_while(|&&event| !plant.events[event as usize].controllable);
        let forced = forced.count();
        Unavoidable { forced, play, states: product.states(end), reason: reason(plant, product, end) }
    }

    /// As a message about a plant whose initial state goes.
    #[must_use]
    pub fn diagnostic(&self, plant: &Plant) -> Diagnostic {
        let end = if self.play.is_empty() { "in the initial state" } else { "at the end of the play" };
        let refused = |source: Source, label: String| {
            let name = source.name(plant);
            let message = format!("no feedback can keep `{name}`");
            Diagnostic::error(Code::NoFeedback, source.span(plant), message).label(label)
        };
        let diagnostic = match &self.reason {
            Reason::Never(condition) => refused(Source::Condition(*condition), format!("this holds {end}")),
            Reason::Forbidden(event, source) => {
                let event = &plant.events[*event as usize];
                refused(*source, format!("forbids `{}` {end}", event.name))
                    .also(event.span, "uncontrollable, so that it can happen all the same")
            }
            Reason::Blocked { unmarked, forbidden } => {
                blocked(plant, unmarked, forbidden).note(format!("this is so {end}"))
            }
        };
        let diagnostic = if self.play.is_empty() { diagnostic } else { diagnostic.note(self.steps(plant)) };
        diagnostic.note(self.place(plant, end)).help(match self.reason {
            Reason::Blocked { .. } => "mark more states, or allow more",
            Reason::Forbidden(_, Source::Automaton(_)) => {
                "add an edge for the event, to the same state if it changes nothing there; or weaken the constraint otherwise"
            }
            _ => "weaken the constraint, or make an event of the play controllable",
        })
    }

    /// The play, a line an event.
    fn steps(&self, plant: &Plant) -> String {
        let mut text = "the play:".to_owned();
        for (step, &event) in self.play.iter().enumerate() {
            let event = &plant.events[event as usize];
            let by = match (event.controllable, step + self.forced >= self.play.len()) {
                (true, _) => "the controller",
                (false, false) => "the plant",
                (false, true) => "the plant, and nobody can prevent it",
            };
            text.push_str(&format!("\n  {}  ({by})", event.name));
        }
        text
    }

    /// Where the automata are.
    fn place(&self, plant: &Plant, end: &str) -> String {
        format!("the automata {end}: {}", plant.state_names(&self.states).join(", "))
    }

    /// As a reason not to go there, in a few words.
    pub(super) fn text(&self, plant: &Plant) -> String {
        let names = |events: &[EventId]| -> String {
            let names = events.iter().map(|&event| format!("`{}`", plant.events[event as usize].name));
            names.collect::<Vec<_>>().join(", ")
        };
        let (before, forced) = self.play.split_at(self.play.len() - self.forced);
        let mut text = String::new();
        if !before.is_empty() {
            text = format!("it leads on to marked states only by {}; ", names(before));
        }
        if !forced.is_empty() {
            text.push_str(&format!("nobody could then prevent {}, and ", names(forced)));
        }
        match &self.reason {
            Reason::Never(condition) => {
                text.push_str(&format!("`{}` would be violated", Source::Condition(*condition).name(plant)));
            }
            Reason::Forbidden(event, source) => {
                let (event, source) = (names(&[*event]), source.name(plant));
                text.push_str(&format!("{event} could happen, which `{source}` forbids"));
            }
            Reason::Blocked { unmarked, .. } if unmarked.is_empty() => {
                text.push_str("no state in which all automata are marked could be reached any more");
            }
            Reason::Blocked { unmarked, .. } => {
                let name = &plant.automata[unmarked[0] as usize].name;
                text.push_str(&format!("no marked state of `{name}` could be reached any more"));
            }
        }
        text
    }
}

fn blocked(plant: &Plant, unmarked: &[AutomatonId], forbidden: &[(EventId, Source)]) -> Diagnostic {
    // Where all could be marked, but not at one time, the first that is not always marked has a part in it.
    let mut partly = (0..plant.automata.len() as AutomatonId).filter(|&id| marks(plant, id).is_some());
    let place = unmarked.first().copied().or_else(|| partly.next());
    let place = place.map_or_else(Span::default, |automaton| plant.automata[automaton as usize].span);
    let mut diagnostic = Diagnostic::error(Code::NoFeedback, place, "no feedback is nonblocking");
    diagnostic = match unmarked {
        [] => diagnostic.note("each automaton can reach a marked state, but not all at one time"),
        _ => diagnostic.label("no marked state of this can be reached"),
    };
    for &automaton in unmarked.iter().skip(1) {
        diagnostic = diagnostic.also(plant.automata[automaton as usize].span, "nor of this");
    }
    for &(event, source) in forbidden {
        let event = &plant.events[event as usize].name;
        diagnostic = diagnostic.also(source.span(plant), format!("forbids `{event}` there"));
    }
    diagnostic
}

/// A shortest way from a state to an end along edges that are followed, and that end, which must exist.
fn shortest(
    product: &Product<'_>,
    start: u32,
    follows: impl Fn(u32, usize) -> bool,
    is_end: impl Fn(u32) -> bool,
) -> (Vec<EventId>, u32) {
    const UNSEEN: u32 = u32::MAX;
    // Per state the edge that it was reached by, and where this begins.
    let mut by = vec![(UNSEEN, UNSEEN); product.rows.len()];
    by[start as usize].0 = start;
    let mut queue = vec![start];
    let mut next = 0;
    let mut end = start;
    while let Some(&state) = queue.get(next) {
        next += 1;
        end = state;
        if is_end(state) {
            break;
        }
        for edge in product.edges_of(state).filter(|&edge| follows(state, edge)) {
            let target = product.target[edge];
            if by[target as usize].0 == UNSEEN {
                by[target as usize] = (state, edge as u32);
                queue.push(target);
            }
        }
    }
    let mut play = Vec::new();
    let mut state = end;
    while state != start {
        let (source, edge) = by[state as usize];
        play.push(product.event[edge as usize]);
        state = source;
    }
    play.reverse();
    (play, end)
}

/// What is wrong with a state that is bad or from which no marked state can be reached.
fn reason(plant: &Plant, product: &Product<'_>, state: u32) -> Reason {
    let states = product.states(state);
    for (position, constraint) in (0..).zip(&plant.constraints) {
        if matches!(&constraint.rule, Rule::Never(condition) if holds(condition, &states)) {
            return Reason::Never(position);
        }
    }
    let mut candidates = Candidates::default();
    product.moves.collect(&states, &mut candidates);
    let mut forbidden: Vec<EventId> =
        candidates.all.iter().filter(|candidate| candidate.forbidden).map(|one| one.event).collect();
    forbidden.sort_unstable();
    let mut forbidden: Vec<(EventId, Source)> = forbidden
        .into_iter()
        .filter_map(|event| Some((event, *forbidding(plant, &states, event).first()?)))
        .collect();
    match forbidden.iter().position(|(event, _)| !plant.events[*event as usize].controllable) {
        Some(position) => {
            let (event, source) = forbidden.swap_remove(position);
            Reason::Forbidden(event, source)
        }
        None => Reason::Blocked { unmarked: never_marked(plant, product, state), forbidden },
    }
}

/// The constraints that forbid an event in this state of all automata: conditions, then automata.
pub(super) fn forbidding(plant: &Plant, states: &[u16], event: EventId) -> Vec<Source> {
    let conditions = (0..).zip(&plant.constraints).filter(|(_, constraint)| {
        matches!(&constraint.rule, Rule::Only { event: of, when } if *of == event && !holds(when, states))
    });
    let automata = (0..).zip(&plant.automata).skip(plant.components).filter(|(id, automaton)| {
        let state = &automaton.states[states[*id as usize] as usize];
        automaton.alphabet.binary_search(&event).is_ok()
            && !state.edges.iter().any(|edge| edge.event == event)
    });
    let conditions = conditions.map(|(position, _)| Source::Condition(position));
    conditions.chain(automata.map(|(id, _)| Source::Automaton(id))).collect()
}

/// The automata that are marked in no state that can be reached from this one.
fn never_marked(plant: &Plant, product: &Product<'_>, start: u32) -> Vec<AutomatonId> {
    let marks: Vec<Option<Vec<bool>>> =
        (0..plant.automata.len() as AutomatonId).map(|automaton| marks(plant, automaton)).collect();
    let mut marked: Vec<bool> = marks.iter().map(Option::is_none).collect();
    let mut seen = vec![false; product.rows.len()];
    seen[start as usize] = true;
    let mut open = vec![start];
    while let Some(state) = open.pop() {
        for ((marked, marks), &state) in marked.iter_mut().zip(&marks).zip(&product.states(state)) {
            *marked |= marks.as_ref().is_some_and(|marks| marks[state as usize]);
        }
        for &target in &product.target[product.edges_of(state)] {
            if !std::mem::replace(&mut seen[target as usize], true) {
                open.push(target);
            }
        }
    }
    (0..plant.automata.len() as AutomatonId).filter(|&automaton| !marked[automaton as usize]).collect()
}

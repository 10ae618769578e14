//! Whether commands are seen: which states can be read right after an event of the controller.
//!
//! A rung that has fired has changed outputs, and no inputs. The rungs below it and the scans that follow read these values
//! until the plant moves. So state feedback is right only if they show the target of the edge, or what the plant can come to
//! from there by itself, or no state at all, with which no rung fires. They must not show the source any longer: events
//! would fire that the feedback enables in the source and perhaps inhibits in the target.
//!
//! All of this is judged for one component at a time. With `P` for the values right after the event, that is those for which
//! the formula of the source holds, and then commanded, the source is read in some of `P` just if its formula can hold
//! together with what is commanded.

use super::readable::Search;
use super::{Automaton, ClosedLoop, Condition, Edge, Event, EventId, Plant, SignalId, State};
use crate::diagnostic::{Code, Diagnostic};

/// Edges of controllable events that certainly do not lead to their target as it is read.
pub(super) fn unseen(plant: &Plant, search: &mut Search<'_>, found: &mut Vec<Diagnostic>) {
    for component in &plant.automata[..plant.components] {
        for source in &component.states {
            for edge in &source.edges {
                let event = &plant.events[edge.event as usize];
                if causes(plant, edge.event) {
                    let step = Step { plant, component, event, edge, source };
                    found.extend(step.error(search));
                }
            }
        }
    }
}

/// Whether the program can do something to cause an event. What commands nothing has a rung only if a constraint counts it.
fn causes(plant: &Plant, event: EventId) -> bool {
    let Event { controllable, commands, .. } = &plant.events[event as usize];
    let counted = || {
        let mut constraints = plant.automata[plant.components..].iter();
        constraints.any(|constraint| constraint.alphabet.binary_search(&event).is_ok())
    };
    *controllable && (!commands.is_empty() || counted())
}

/// What is commanded of a signal.
fn commanded(event: &Event, signal: SignalId) -> Option<bool> {
    event.commands.iter().find(|command| command.signal == signal).map(|command| command.set)
}

/// Whether an event commands what the formula reads.
fn reads(formula: &Condition<SignalId>, event: &Event) -> bool {
    let mut reads = false;
    formula.atoms(&mut |&signal| reads |= commanded(event, signal).is_some());
    reads
}

/// Values, in words, for which `before` holds, and `now` once the event has commanded.
fn values_after(
    search: &mut Search<'_>,
    before: &[&Condition<SignalId>],
    now: &Condition<SignalId>,
    event: &Event,
) -> Option<String> {
    match now.rest(&|&signal| commanded(event, signal)) {
        Err(false) => None,
        Err(true) => search.satisfied(before),
        Ok(rest) => search.satisfied(&[before, &[&rest]].concat()),
    }
}

/// An edge of a component.
struct Step<'a> {
    plant: &'a Plant,
    component: &'a Automaton,
    event: &'a Event,
    edge: &'a Edge,
    source: &'a State,
}

impl Step<'_> {
    fn target(&self) -> &State {
        &self.component.states[self.edge.target as usize]
    }

    fn stays(&self) -> bool {
        std::ptr::eq(self.target(), self.source)
    }

    fn error(&self, search: &mut Search<'_>) -> Option<Diagnostic> {
        let (Some(source), Some(target)) = (&self.source.formula, &self.target().formula) else {
            return None;
        };
        if values_after(search, &[], target, self.event).is_none() {
            return Some(self.contradicts(search, target));
        }
        if self.stays() {
            return None;
        }
        if let Some(values) = values_after(search, &[], source, self.event) {
            return Some(self.still_read(&values));
        }
        if values_after(search, &[source], target, self.event).is_some() {
            return None;
        }
        let mut others =
            self.component.states.iter().filter_map(|state| Some((state, state.formula.as_ref()?)));
        others.find_map(|(other, formula)| {
            values_after(search, &[source], formula, self.event).map(|values| self.read_as(other, &values))
        })
    }

    /// The formula of the target cannot hold with what is commanded.
    fn contradicts(&self, search: &mut Search<'_>, target: &Condition<SignalId>) -> Diagnostic {
        let (event, to) = (&self.event.name, &self.target().name);
        // One of the commands alone, if possible.
        let alone = self.event.commands.iter().find(|command| {
            match target.rest(&|&signal| (signal == command.signal).then_some(command.set)) {
                Err(value) => !value,
                Ok(rest) => search.satisfied(&[&rest]).is_none(),
            }
        });
        let (what, help) = match alone {
            None => (
                "what it commands".to_owned(),
                format!("change what `{event}` commands, or the formula of `{to}`"),
            ),
            Some(command) => {
                let name = &self.plant.signals[command.signal as usize].name;
                let verb = |set| if set { "set" } else { "reset" };
                let (is, other) = (verb(command.set), verb(!command.set));
                let formula = if command.set { name.clone() } else { format!("!{name}") };
                (
                    format!("`{is} {name}`"),
                    format!("write `{other} {name}` in `{event}`, or `{formula}` in the formula of `{to}`"),
                )
            }
        };
        let message = format!("`{event}` leads to `{to}`, and {what} makes its formula false");
        let error = Diagnostic::error(Code::Contradicted, self.edge.span, message);
        error
            .also(self.target().span, "never read after it")
            .also(self.event.span, "commands this")
            .help(help)
    }

    /// The formula of the source can hold with what is commanded.
    fn still_read(&self, values: &str) -> Diagnostic {
        let (component, event, from) = (&self.component.name, &self.event.name, &self.source.name);
        let to = &self.target().name;
        let message = format!("`{event}` has fired, and `{component}` is still read as `{from}`");
        let mut error = Diagnostic::error(Code::Misread, self.edge.span, message)
            .also(self.source.span, "read before it");
        if !values.is_empty() {
            error = error.note(format!("its formula holds with all commands given, where {values}"));
        }
        let error = error.note(format!(
            "whatever may happen in `{from}` could follow in the same scan, even if it must not in `{to}`"
        ));
        let Some(command) = self.event.commands.first() else {
            return error
                .help(format!("give `{event}` a command, and read its output in `{from}` and `{to}`"));
        };
        let name = &self.plant.signals[command.signal as usize].name;
        let (literal, is) = if command.set { (format!("!{name}"), "set") } else { (name.clone(), "reset") };
        error.help(format!(
            "add `{literal}` to the formula of `{from}`, and let that of `{to}` hold as soon as `{name}` is {is}"
        ))
    }

    /// Another state is read, and the target never.
    fn read_as(&self, other: &State, values: &str) -> Diagnostic {
        let (event, to) = (&self.event.name, &self.target().name);
        let message = format!("`{event}` leads to `{to}`, but right after it `{}` is read", other.name);
        let error = Diagnostic::error(Code::Misread, self.edge.span, message);
        error
            .also(self.target().span, "not read before the plant moves")
            .also(other.span, "read instead")
            .note(format!("it fires where {values}"))
            .help(format!(
                "let the formula of `{to}` hold as soon as `{event}` has fired, and that of `{}` not",
                other.name
            ))
    }
}

/// A state that may be read after an event although the component is not there, or none that is.
struct Doubt {
    event: EventId,
    component: usize,
    /// Where the component is when the event happens.
    before: u32,
    warning: Diagnostic,
}

/// Events of the controller after which a component may be read in a state to which the plant does not come from the right
/// one by itself; and after which its state is not seen until the plant moves. Told only where the feedback enables them.
pub(super) fn doubtful(plant: &Plant, closed: &ClosedLoop, found: &mut Vec<Diagnostic>) {
    let mut doubts = Vec::new();
    let mut search = Search::new(plant);
    for (event, id) in plant.events.iter().zip(0..) {
        if !event.controllable || event.commands.is_empty() {
            continue;
        }
        for (number, component) in plant.automata[..plant.components].iter().enumerate() {
            let of = Effect { plant, event, id, number, component };
            if component.alphabet.binary_search(&id).is_ok() {
                of.taking_part(&mut search, &mut doubts);
            } else {
                of.looking_on(&mut search, &mut doubts);
            }
        }
    }
    if doubts.is_empty() {
        return;
    }
    let mut arises = vec![false; doubts.len()];
    for entry in 0..closed.len() {
        let states = closed.entry(entry);
        for (doubt, arises) in doubts.iter().zip(&mut arises).filter(|(_, arises)| !**arises) {
            *arises = u32::from(states[doubt.component]) == doubt.before
                && closed.edges(entry).binary_search_by_key(&doubt.event, |edge| edge.0).is_ok();
        }
    }
    found
        .extend(doubts.into_iter().zip(arises).filter(|(_, arises)| *arises).map(|(doubt, _)| doubt.warning));
}

/// What an event does to the states of a component as they are read.
struct Effect<'a> {
    plant: &'a Plant,
    event: &'a Event,
    id: EventId,
    number: usize,
    component: &'a Automaton,
}

impl<'a> Effect<'a> {
    fn taking_part(&self, search: &mut Search<'_>, doubts: &mut Vec<Doubt>) {
        for (state, before) in self.component.states.iter().zip(0..) {
            let edge = state.edges.iter().find(|edge| edge.event == self.id);
            let (Some(edge), Some(formula)) = (edge, &state.formula) else { continue };
            let to = &self.component.states[edge.target as usize];
            let warning = self.wrong(search, &[formula], edge.target).map(|(other, values)| {
                let message = format!(
                    "right after `{}`, `{}` may be read instead of `{}`",
                    self.event.name, other.name, to.name
                );
                let warning = Diagnostic::warning(Code::Misreadable, edge.span, message);
                warning.also(other.span, "read instead").note(format!("it may fire where {values}")).help(
                    format!(
                        "add to the formula of `{}` what cannot be there: a switch that is open",
                        state.name
                    ),
                )
            });
            let warning = warning.or_else(|| {
                let target = to.formula.as_ref()?;
                let is_seen = values_after(search, &[formula], target, self.event).is_some();
                (!is_seen).then(|| self.unread(edge, to))
            });
            doubts.extend(warning.map(|warning| self.doubt(before, warning)));
        }
    }

    fn unread(&self, edge: &Edge, to: &State) -> Diagnostic {
        let message = format!("after `{}`, `{}` is not read until the plant moves", self.event.name, to.name);
        let warning = Diagnostic::warning(Code::Misreadable, edge.span, message);
        warning
            .also(to.span, "needs other inputs than there are before")
            .note("while no state of a component is read, no event fires, not even one of another component")
            .help(format!("let the formula of `{}` hold as soon as the commands are given", to.name))
    }

    /// A component that does not take part, but reads what is commanded.
    fn looking_on(&self, search: &mut Search<'_>, doubts: &mut Vec<Doubt>) {
        let states = &self.component.states;
        if !states
            .iter()
            .any(|state| state.formula.as_ref().is_some_and(|formula| reads(formula, self.event)))
        {
            return;
        }
        // What is read of one component that does.
        let takes_part = |component: &&Automaton| component.alphabet.binary_search(&self.id).is_ok();
        let Some(actor) = self.plant.automata[..self.plant.components].iter().find(takes_part) else {
            return;
        };
        let sources: Vec<&Condition<SignalId>> = actor
            .states
            .iter()
            .filter(|state| state.edges.iter().any(|edge| edge.event == self.id))
            .filter_map(|state| state.formula.as_ref())
            .collect();
        for (state, before) in states.iter().zip(0..) {
            let Some(formula) = &state.formula else { continue };
            let wrong = sources.iter().find_map(|source| self.wrong(search, &[source, formula], before));
            let Some((other, values)) = wrong else { continue };
            let (event, name) = (&self.event.name, &self.component.name);
            let message = format!(
                "`{event}` takes `{name}` from `{}` to `{}` as they are read",
                state.name, other.name
            );
            let warning = Diagnostic::warning(Code::Misreadable, self.event.span, message);
            let warning = warning
                .also(state.span, "without an edge for it")
                .also(other.span, "not reached by itself")
                .note(format!("it may fire where {values}"))
                .help(format!("let `{name}` take part: `{event} -> {}` in `{}`", other.name, state.name));
            doubts.push(self.doubt(before, warning));
        }
    }

    fn doubt(&self, before: u32, warning: Diagnostic) -> Doubt {
        Doubt { event: self.id, component: self.number, before, warning }
    }

    /// A state that may be read after the event, other than `right` and what follows it by itself; and where.
    fn wrong(
        &self,
        search: &mut Search<'_>,
        before: &[&Condition<SignalId>],
        right: u32,
    ) -> Option<(&'a State, String)> {
        let mut follows: Option<Vec<bool>> = None;
        for (other, number) in self.component.states.iter().zip(0u32..) {
            let Some(formula) = other.formula.as_ref().filter(|formula| reads(formula, self.event)) else {
                continue;
            };
            if number == right || follows.as_ref().is_some_and(|follows| follows[number as usize]) {
                continue;
            }
            let Some(values) = values_after(search, before, formula, self.event) else { continue };
            let follows = follows.get_or_insert_with(|| self.following(right));
            if !follows[number as usize] {
                return Some((other, values));
            }
        }
        None
    }

    /// What the component can come to from a state by itself.
    fn following(&self, state: u32) -> Vec<bool> {
        let mut follows = vec![false; self.component.states.len()];
        follows[state as usize] = true;
        let mut open = vec![state];
        while let Some(state) = open.pop() {
            for edge in &self.component.states[state as usize].edges {
                let by_itself = !self.plant.events[edge.event as usize].controllable;
                if by_itself && !std::mem::replace(&mut follows[edge.target as usize], true) {
                    open.push(edge.target);
                }
            }
        }
        follows
    }
}

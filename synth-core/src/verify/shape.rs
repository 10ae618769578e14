//! Is it a controller at all? What every back end relies on, whoever made the controller.
//!
//! A look-up must have at most one answer, whichever way it is searched, and a super step at most one command for each
//! component. The product could not see a breach: it looks rows up in one of several possible ways.

use crate::controller::{Component, Controller, Event};
use crate::diagnostic::counted;

/// What is wrong, if anything.
pub(super) fn fault(controller: &Controller) -> Option<String> {
    let Controller { states, initial, events, commands, components, environment, super_steps, .. } =
        controller;
    let below = |state: u32, what: &str| {
        let all = || counted(*states as usize, "state");
        (state >= *states).then(|| format!("{what} is {state}, but the controller has {}", all()))
    };
    below(*initial, "the initial state")
        .or_else(|| ascending_texts(events))
        .or_else(|| ascending_texts(commands))
        .or_else(|| (environment.len() != events.len()).then(|| "an event has no table".to_owned()))
        .or_else(|| {
            events.iter().zip(environment).find_map(|(event, rows)| {
                let outside = rows.iter().map(|row| row.0.max(row.1)).find(|state| state >= states);
                let out = outside.and_then(|state| below(state, &format!("a state of `{}`", event.text)));
                let sources =
                    || ascending(rows.iter().map(|row| row.0), &format!("the table of `{}`", event.text));
                out.or_else(sources)
            })
        })
        .or_else(|| {
            super_steps.iter().find_map(|step| below(step.source.max(step.target), "a state of a super step"))
        })
        .or_else(|| ascending(super_steps.iter().map(|step| step.source), "the table of super steps"))
        .or_else(|| components.iter().find_map(|component| wrong_component(component, commands)))
        .or_else(|| ascending_names(components))
        .or_else(|| super_steps.iter().find_map(|step| wrong_step(step.source, step.events, controller)))
}

fn ascending_texts(events: &[Event]) -> Option<String> {
    let pair = events.windows(2).find(|pair| pair[0].text >= pair[1].text)?;
    Some(format!("`{}` does not stand in front of `{}`", pair[0].text, pair[1].text))
}

fn ascending_names(components: &[Component]) -> Option<String> {
    let pair = components.windows(2).find(|pair| pair[0].object >= pair[1].object)?;
    Some(format!("component `{}` does not stand in front of `{}`", pair[0].object, pair[1].object))
}

fn ascending(mut sources: impl Iterator<Item = u32>, what: &str) -> Option<String> {
    let mut last = sources.next()?;
    let (before, state) = sources.find_map(|state| {
        let before = std::mem::replace(&mut last, state);
        (before >= state).then_some((before, state))
    })?;
    Some(format!("{what} has state {state} behind state {before}"))
}

fn wrong_component(component: &Component, commands: &[Event]) -> Option<String> {
    let Component { object, commands: own } = component;
    for (place, &command) in own.iter().enumerate() {
        match commands.get(command as usize) {
            Some(event) if event.receiver == *object && !own[..place].contains(&command) => {}
            Some(event) => return Some(format!("`{}` is no command of its own to `{object}`", event.text)),
            None => return Some(format!("`{object}` has a command that does not exist")),
        }
    }
    None
}

fn wrong_step(source: u32, events: &[u32], controller: &Controller) -> Option<String> {
    let Controller { commands, components, .. } = controller;
    if events.is_empty() {
        return Some(format!("the super step in state {source} is empty"));
    }
    let receiver = |event: &u32| commands.get(*event as usize).map(|event| event.receiver.as_str());
    for (place, event) in events.iter().enumerate() {
        let Some(object) = receiver(event) else {
            return Some(format!("the super step in state {source} sends what does not exist"));
        };
        let is_component =
            components.binary_search_by(|component| component.object.as_str().cmp(object)).is_ok();
        if is_component && events[..place].iter().any(|earlier| receiver(earlier) == Some(object)) {
            return Some(format!("the super step in state {source} commands `{object}` twice"));
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::fault;
    use crate::controller::{Component, Controller, Event, Lists, SuperStep};

    fn event(text: &str) -> Event {
        Event::from_text(text).expect("an event")
    }

    /// A button that lights a lamp and rings a bell.
    fn controller() -> Controller {
        Controller {
            states: 2,
            initial: 0,
            events: vec![event("a -> c.off()"), event("a -> c.on()")],
            commands: vec![event("c -> bell.ring()"), event("c -> lamp.dim()"), event("c -> lamp.light()")],
            components: vec![
                Component { object: "bell".to_owned(), commands: vec![0] },
                Component { object: "lamp".to_owned(), commands: vec![1, 2] },
            ],
            environment: vec![Vec::new(), vec![(0, 1)]],
            super_steps: [SuperStep { source: 1, target: 0, events: &[2, 0] }].into_iter().collect(),
            owed: Lists::empty(2),
        }
    }

    #[track_caller]
    fn check(spoil: impl FnOnce(&mut Controller), expected: &str) {
        let mut controller = controller();
        spoil(&mut controller);
        assert_eq!(fault(&controller).as_deref().unwrap_or("fine"), expected);
    }

    #[test]
    fn every_rule() {
        check(|_| {}, "fine");
        check(|c| c.initial = 2, "the initial state is 2, but the controller has 2 states");
        check(
            |c| c.environment[1][0].1 = 5,
            "a state of `a -> c.on()` is 5, but the controller has 2 states",
        );
        check(|c| c.environment[1].push((0, 0)), "the table of `a -> c.on()` has state 0 behind state 0");
        check(|c| drop(c.environment.pop()), "an event has no table");
        check(|c| c.events.swap(0, 1), "`a -> c.on()` does not stand in front of `a -> c.off()`");
        check(
            |c| c.super_steps.target[0] = 9,
            "a state of a super step is 9, but the controller has 2 states",
        );
        check(
            |c| c.super_steps.push(SuperStep { source: 1, target: 0, events: &[2, 0] }),
            "the table of super steps has state 1 behind state 1",
        );
        check(|c| c.super_steps.events.set(0, &[]), "the super step in state 1 is empty");
        check(|c| c.super_steps.events.set(0, &[1, 2]), "the super step in state 1 commands `lamp` twice");
        check(
            |c| c.super_steps.events.set(0, &[7, 0]),
            "the super step in state 1 sends what does not exist",
        );
        check(|c| c.components[0].commands[0] = 2, "`c -> lamp.light()` is no command of its own to `bell`");
        check(|c| c.components[1].commands[1] = 1, "`c -> lamp.dim()` is no command of its own to `lamp`");
        check(|c| c.components.swap(0, 1), "component `lamp` does not stand in front of `bell`");
    }
}

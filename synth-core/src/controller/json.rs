//! Controllers as JSON, the format of `sml synth` and `sml verify`:
//!
//! ```json
//! {"version":1,"states":2,"initial":0,
//!  "environment":{"a -> c.go()":[[0,1]]},
//!  "supersteps":[[1,0,["c -> b.stop()"]]],
//!  "components":{"b":{"c -> b.stop()":1}},
//!  "owed":{"a -> c.go()":[0]}}
//! ```
//!
//! `"monitor":true` is in the file of a [monitor](mod@super::monitor) only. `owed` lists per environment event the states in which assumptions promise it; it may be absent. `"minimize":"ordered"` or
//! `"assume"` says that states were merged by don't-cares, and what the controller is for; it is absent otherwise. Unknown fields
//! are passed over. A system event between controllable objects that no super step has is not in the format.

use super::{Component, Controller, Event, Level, Lists, SuperStep, SuperSteps};
use crate::diagnostic::counted;
use serde::de::{Deserialize, Deserializer, MapAccess, Visitor};
use serde::ser::{Serialize, Serializer};
use std::collections::BTreeMap;
use std::fmt;
use std::io::{self, Write as _};
use std::marker::PhantomData;

/// The version of the format. To be raised when an old reader would misunderstand a new file; a new field that it may
/// pass over is no reason.
pub const VERSION: u32 = 1;

/// How many states a file may have that no row mentions: a controller takes memory per state, so that a number alone
/// must not be able to ask for any amount.
const MAX_BARE_STATES: usize = 1_000_000;

/// A controller as one line of JSON; everything in table order.
#[must_use]
pub fn to_json(controller: &Controller) -> String {
    to_json_at(controller, Level::default())
}

/// The same, with the level of minimisation where a reader must know it: [`Level::Assume`] and [`Level::Ordered`].
#[must_use]
pub fn to_json_at(controller: &Controller, level: Level) -> String {
    text(controller, level, false)
}

/// A monitor, which says so: nobody must take it for a controller.
#[must_use]
pub fn monitor_to_json(monitor: &Controller) -> String {
    text(monitor, Level::default(), true)
}

fn text(controller: &Controller, level: Level, monitor: bool) -> String {
    let mut bytes = Vec::new();
    write(controller, level, monitor, &mut bytes).expect("memory takes everything");
    String::from_utf8(bytes).expect("JSON is text")
}

/// Writes what [`to_json_at`] returns, piece by piece.
///
/// # Errors
/// Those of `out`.
pub fn write_json_at(controller: &Controller, level: Level, out: &mut dyn io::Write) -> io::Result<()> {
    let mut out = io::BufWriter::with_capacity(1 << 16, out);
    write(controller, level, false, &mut out)?;
    out.flush()
}

fn write(controller: &Controller, level: Level, monitor: bool, out: &mut impl io::Write) -> io::Result<()> {
    #[derive(serde::Serialize)]
    struct Document<'a> {
        version: u32,
        states: u32,
        initial: u32,
        environment: BTreeMap<&'a str, &'a [(u32, u32)]>,
        supersteps: Steps<'a>,
        components: BTreeMap<&'a str, BTreeMap<&'a str, u32>>,
        owed: BTreeMap<&'a str, States<'a>>,
        #[serde(skip_serializing_if = "Option::is_none")]
        minimize: Option<&'static str>,
        #[serde(skip_serializing_if = "std::ops::Not::not")]
        monitor: bool,
    }
    let command = |&index: &u32| controller.commands[index as usize].text.as_str();
    let document = Document {
        version: VERSION,
        states: controller.states,
        initial: controller.initial,
        environment: controller
            .events
            .iter()
            .zip(&controller.environment)
            .map(|(event, rows)| (event.text.as_str(), rows.as_slice()))
            .collect(),
        supersteps: Steps(controller),
        components: controller
            .components
            .iter()
            .map(|component| {
                (component.object.as_str(), component.commands.iter().map(command).zip(1..).collect())
            })
            .collect(),
        owed: owed(controller),
        minimize: matches!(level, Level::Assume | Level::Ordered).then(|| level.name()),
        monitor,
    };
    serde_json::to_writer(&mut *out, &document)?;
    out.write_all(b"\n")
}

/// The super steps of a controller, with the texts of their events.
struct Steps<'a>(&'a Controller);

impl Serialize for Steps<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Controller { super_steps, commands, .. } = self.0;
        let texts = |list: u32| {
            let events = super_steps.events.list(list).iter();
            events.map(|&event| commands[event as usize].text.as_str()).collect::<Vec<_>>()
        };
        let lists: Vec<Vec<&str>> = (0..super_steps.events.distinct() as u32).map(texts).collect();
        let rows = super_steps.source.iter().zip(&super_steps.target).zip(super_steps.events.numbers());
        serializer.collect_seq(rows.map(|((source, target), &list)| (source, target, &lists[list as usize])))
    }
}

/// The states in which an event is owed.
struct States<'a> {
    owed: &'a Lists,
    /// Per list whether it has the event.
    has: Vec<bool>,
}

impl Serialize for States<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let states = (0..).zip(self.owed.numbers()).filter(|(_, list)| self.has[**list as usize]);
        serializer.collect_seq(states.map(|(state, _): (u32, _)| state))
    }
}

/// The events that are owed anywhere.
fn owed(controller: &Controller) -> BTreeMap<&str, States<'_>> {
    let lists = &controller.owed;
    let mut used = vec![false; lists.distinct()];
    lists.numbers().iter().for_each(|&list| used[list as usize] = true);
    let mut owed = BTreeMap::new();
    for list in (0..lists.distinct() as u32).filter(|&list| used[list as usize]) {
        for &event in lists.list(list) {
            let states: &mut States<'_> = owed
                .entry(controller.events[event as usize].text.as_str())
                .or_insert_with(|| States { owed: lists, has: vec![false; lists.distinct()] });
            states.has[list as usize] = true;
        }
    }
    owed
}

/// How a controller that [`from_json`] reads was minimised, as far as its file says: [`Level::Assume`], [`Level::Ordered`], or otherwise
/// [`Level::Exact`], which stands for no don't-cares.
///
/// # Errors
///
/// One line, if the text is not in this format, names another level, or is that of a monitor.
pub fn level_of(text: &str) -> Result<Level, String> {
    let document = parse(text)?;
    if document.monitor {
        return Err("this is a monitor, which gives no commands, and no controller".to_owned());
    }
    match document.minimize.as_deref() {
        None | Some("none") => Ok(Level::Exact),
        Some(name) => name.parse().map_err(|why| format!("`minimize`: {why}")),
    }
}

/// Reads a controller from any source.
///
/// Rows may come in any order. Codes may be in another order than that of the event texts.
///
/// # Errors
///
/// One line that says what is wrong and where, if the text is not JSON, not in this format or its version, or not a
/// controller: every state in range, at most one row per event and state, at most one super step, no empty super
/// step, no component commanded twice in one, codes from 1 without gaps. A row of the environment in a state whose
/// super step is due is read: what is wrong with it is for verification to say.
pub fn from_json(text: &str) -> Result<Controller, String> {
    let document = parse(text)?;
    let rows =
        document.environment.0.iter().map(|(_, rows)| rows.len()).sum::<usize>() + document.supersteps.len();
    let states = document.states;
    if document.initial >= states {
        return Err(not_below("initial", "state", document.initial, states));
    }
    if states as usize > MAX_BARE_STATES.saturating_add(2 * rows) {
        return Err(format!("`states` is {states}, but the controller has {}", counted(rows, "row")));
    }
    let (events, environment) = read_environment(document.environment, states)?;
    let commands = read_commands(&document.components, &document.supersteps, &events)?;
    let components = read_components(document.components, &commands)?;
    let super_steps = read_super_steps(&document.supersteps, states, &components, &commands)?;
    let owed = read_owed(document.owed, states, &events)?;
    Ok(Controller {
        states,
        initial: document.initial,
        events,
        commands,
        components,
        environment,
        super_steps,
        owed,
    })
}

#[derive(serde::Deserialize)]
#[serde(expecting = "a controller as an object")]
struct Document {
    version: u32,
    states: u32,
    initial: u32,
    environment: Entries<Vec<Row>>,
    supersteps: Vec<Step>,
    components: Entries<Entries<u32>>,
    #[serde(default)]
    owed: Entries<Vec<u32>>,
    #[serde(default)]
    minimize: Option<String>,
    #[serde(default)]
    monitor: bool,
}

#[derive(serde::Deserialize)]
#[serde(expecting = "`[source, target]`")]
struct Row(u32, u32);

#[derive(serde::Deserialize)]
#[serde(expecting = "`[source, target, [events]]`")]
struct Step(u32, u32, Vec<String>);

/// A JSON object in the order of the file, with its duplicates.
struct Entries<V>(Vec<(String, V)>);

impl<V> Default for Entries<V> {
    fn default() -> Self {
        Entries(Vec::new())
    }
}

impl<'de, V: Deserialize<'de>> Deserialize<'de> for Entries<V> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Collect<V>(PhantomData<V>);
        impl<'de, V: Deserialize<'de>> Visitor<'de> for Collect<V> {
            type Value = Entries<V>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
                let mut entries = Vec::new();
                while let Some(entry) = map.next_entry()? {
                    entries.push(entry);
                }
                Ok(Entries(entries))
            }
        }
        deserializer.deserialize_map(Collect(PhantomData))
    }
}

fn parse(text: &str) -> Result<Document, String> {
    #[derive(serde::Deserialize)]
    struct Version {
        version: u32,
    }
    // Fields in their order would pass for the object otherwise.
    if text.trim_start().starts_with('[') {
        return Err("invalid type: array, expected a controller as an object at line 1".to_owned());
    }
    let other_version = |version| format!("`version` is {version}, but only {VERSION} is known");
    match serde_json::from_str::<Document>(text) {
        Ok(document) if document.version == VERSION => Ok(document),
        Ok(document) => Err(other_version(document.version)),
        // What another version looks like is not known: its number explains more than the first difference.
        Err(error) => match serde_json::from_str::<Version>(text) {
            Ok(Version { version }) if version != VERSION => Err(other_version(version)),
            _ => Err(error.to_string()),
        },
    }
}

fn not_below(place: impl fmt::Display, what: &str, state: u32, states: u32) -> String {
    format!("{place}: {what} {state} is not below `states` {states}")
}

fn check_row(place: impl fmt::Display, source: u32, target: u32, states: u32) -> Result<(), String> {
    if source >= states {
        return Err(not_below(place, "source", source, states));
    }
    if target >= states {
        return Err(not_below(place, "target", target, states));
    }
    Ok(())
}

fn read_event(place: impl fmt::Display, text: &str) -> Result<Event, String> {
    Event::from_text(text)
        .ok_or_else(|| format!("{place}: {text:?} is not of the form `sender -> receiver.operation(a, b)`"))
}

fn position(events: &[Event], text: &str) -> Option<u32> {
    events.binary_search_by(|event| event.text.as_str().cmp(text)).ok().map(|index| index as u32)
}

/// Sorts entries by name; an error if one is there twice.
fn sort_entries<V>(place: &str, entries: &mut [(String, V)]) -> Result<(), String> {
    entries.sort_by(|a, b| a.0.cmp(&b.0));
    match entries.windows(2).find(|pair| pair[0].0 == pair[1].0) {
        Some(pair) => Err(format!("{place}: {:?} is there twice", pair[0].0)),
        None => Ok(()),
    }
}

type Environment = (Vec<Event>, Vec<Vec<(u32, u32)>>);

fn read_environment(mut entries: Entries<Vec<Row>>, states: u32) -> Result<Environment, String> {
    sort_entries("environment", &mut entries.0)?;
    let mut events = Vec::with_capacity(entries.0.len());
    let mut environment = Vec::with_capacity(entries.0.len());
    for (text, rows) in entries.0 {
        events.push(read_event("environment", &text)?);
        for (i, &Row(source, target)) in rows.iter().enumerate() {
            check_row(format_args!("environment[{text:?}][{i}]"), source, target, states)?;
        }
        let mut rows: Vec<(u32, u32)> =
            rows.into_iter().map(|Row(source, target)| (source, target)).collect();
        rows.sort_unstable();
        if let Some(pair) = rows.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            return Err(format!("environment[{text:?}]: two rows for state {}", pair[0].0));
        }
        environment.push(rows);
    }
    Ok((events, environment))
}

/// The system events of components and super steps, in table order.
fn read_commands(
    components: &Entries<Entries<u32>>,
    steps: &[Step],
    events: &[Event],
) -> Result<Vec<Event>, String> {
    let mut commands = BTreeMap::new();
    let mut add = |place: fmt::Arguments<'_>, text| {
        if commands.contains_key(text) {
            return Ok(());
        }
        if position(events, text).is_some() {
            return Err(format!("{place}: {text:?} is an event of the environment"));
        }
        commands.insert(text, read_event(place, text)?);
        Ok(())
    };
    for (object, codes) in &components.0 {
        for (text, _) in &codes.0 {
            add(format_args!("components[{object:?}]"), text.as_str())?;
        }
    }
    for (i, Step(_, _, texts)) in steps.iter().enumerate() {
        for text in texts {
            add(format_args!("supersteps[{i}]"), text.as_str())?;
        }
    }
    Ok(commands.into_values().collect())
}

fn read_components(mut entries: Entries<Entries<u32>>, commands: &[Event]) -> Result<Vec<Component>, String> {
    sort_entries("components", &mut entries.0)?;
    entries.0.into_iter().map(|(object, codes)| read_component(object, codes, commands)).collect()
}

fn read_component(object: String, mut codes: Entries<u32>, commands: &[Event]) -> Result<Component, String> {
    let place = format!("components[{object:?}]");
    sort_entries(&place, &mut codes.0)?;
    let count = codes.0.len();
    if count == 0 {
        return Err(format!("{place}: there is no command"));
    }
    let mut by_code = vec![None; count];
    for (text, code) in &codes.0 {
        let command = position(commands, text).expect("all commands were collected");
        if commands[command as usize].receiver != object {
            return Err(format!("{place}: {text:?} has another receiver"));
        }
        let Some(entry) = code.checked_sub(1).and_then(|index| by_code.get_mut(index as usize)) else {
            return Err(format!("{place}[{text:?}]: code {code} is not one of 1 to {count}"));
        };
        if entry.replace(command).is_some() {
            return Err(format!("{place}[{text:?}]: code {code} is there twice"));
        }
    }
    Ok(Component { object, commands: by_code.into_iter().flatten().collect() })
}

fn read_super_steps(
    steps: &[Step],
    states: u32,
    components: &[Component],
    commands: &[Event],
) -> Result<SuperSteps, String> {
    let mut component_of = vec![None; commands.len()];
    for (component, indices) in (0..).zip(components.iter().map(|component| &component.commands)) {
        for &command in indices {
            component_of[command as usize] = Some(component);
        }
    }
    // Per component: the last super step that commands it.
    let mut commanded = vec![usize::MAX; components.len()];
    let mut super_steps = SuperSteps::default();
    let mut events = Vec::new();
    for (i, Step(source, target, texts)) in steps.iter().enumerate() {
        let place = format_args!("supersteps[{i}]");
        check_row(place, *source, *target, states)?;
        if texts.is_empty() {
            return Err(format!("{place}: there is no event"));
        }
        events.clear();
        for text in texts {
            let command = position(commands, text).expect("all commands were collected");
            events.push(command);
            let receiver = &commands[command as usize].receiver;
            if let Some(component) = component_of[command as usize] {
                if std::mem::replace(&mut commanded[component], i) == i {
                    return Err(format!("{place}: `{receiver}` is commanded twice"));
                }
            } else if components.binary_search_by(|component| component.object.cmp(receiver)).is_ok() {
                return Err(format!("{place}: {text:?} has no code in components[{receiver:?}]"));
            }
        }
        super_steps.push(SuperStep { source: *source, target: *target, events: &events });
    }
    super_steps.sort();
    if let Some(pair) = super_steps.source.windows(2).find(|pair| pair[0] == pair[1]) {
        return Err(format!("supersteps: two rows for state {}", pair[0]));
    }
    Ok(super_steps)
}

fn read_owed(mut entries: Entries<Vec<u32>>, states: u32, events: &[Event]) -> Result<Lists, String> {
    sort_entries("owed", &mut entries.0)?;
    let mut owed = vec![Vec::new(); states as usize];
    for (text, mut list) in entries.0 {
        let event =
            position(events, &text).ok_or_else(|| format!("owed: {text:?} is not in `environment`"))?;
        list.sort_unstable();
        list.dedup();
        for state in list {
            let place = format_args!("owed[{text:?}]");
            let events: &mut Vec<u32> =
                owed.get_mut(state as usize).ok_or_else(|| not_below(place, "state", state, states))?;
            events.push(event);
        }
    }
    Ok(owed.into_iter().collect())
}

#[cfg(test)]
mod tests {
    use super::super::fixtures::{controller, controllers};
    use super::*;
    use proptest::prelude::*;

    const EXAMPLE: &str = concat!(
        r#"{"version":1,"states":4,"initial":0,"#,
        r#""environment":{"env -> ctl.a()":[[0,1],[2,1]],"env -> ctl.b()":[[0,3]]},"#,
        r#""supersteps":[[1,2,["ctl -> log.x()","ctl -> arm.stop()"]],[3,0,["ctl -> arm.go()","ctl -> press.go()"]]],"#,
        r#""components":{"arm":{"ctl -> arm.go()":1,"ctl -> arm.stop()":2},"press":{"ctl -> press.go()":1}},"#,
        r#""owed":{"env -> ctl.a()":[0,2]}}"#,
        "\n"
    );

    fn example() -> Controller {
        let mut controller =
            controller("0: a 1, b 3 \n 1! log.x arm.stop 2 \n 2: a 1 \n 3! arm.go press.go 0");
        controller.owed.set(0, &[0]);
        controller.owed.set(2, &[0]);
        controller
    }

    /// Replaces something in the example and expects an error; the column of one from the JSON reader is left out.
    #[track_caller]
    fn check_error(from: &str, to: &str, expected: &str) {
        assert!(EXAMPLE.contains(from));
        let message = from_json(&EXAMPLE.replacen(from, to, 1)).expect_err("malformed");
        let end = message.find(" column ").unwrap_or(message.len());
        assert_eq!(&message[..end], expected);
    }

    #[track_caller]
    fn check_same(from: &str, to: &str) {
        assert!(EXAMPLE.contains(from));
        assert_eq!(from_json(&EXAMPLE.replacen(from, to, 1)), Ok(example()));
    }

    #[test]
    fn writes_the_contract() {
        assert_eq!(to_json(&example()), EXAMPLE);
    }

    #[test]
    fn says_for_what_it_was_minimised() {
        for level in [Level::None, Level::Exact] {
            assert_eq!(to_json_at(&example(), level), EXAMPLE);
            assert_eq!(level_of(EXAMPLE), Ok(Level::Exact));
        }
        for level in [Level::Assume, Level::Ordered] {
            let text = to_json_at(&example(), level);
            assert_eq!(level_of(&text), Ok(level));
            assert_eq!(from_json(&text), Ok(example()));
        }
        let other = to_json_at(&example(), Level::Ordered).replace("ordered", "all");
        assert!(level_of(&other).is_err_and(|why| why.starts_with("`minimize`: unknown level `all`")));
    }

    #[test]
    fn a_monitor_is_no_controller() {
        assert!(!EXAMPLE.contains("monitor"));
        assert!(
            level_of(&monitor_to_json(&example())).is_err_and(|why| why.starts_with("this is a monitor"))
        );
    }

    #[test]
    fn reads_what_it_writes() {
        check_same("", "");
    }

    #[test]
    fn order_and_unknown_fields_do_not_matter() {
        check_same("[[0,1],[2,1]]", "[[2,1],[0,1]]");
        check_same(r#""version":1,"#, r#" "by" : {"tool":[1.5e300,null]}, "version" : 1 ,"#);
        check_same(
            r#"[1,2,["ctl -> log.x()","ctl -> arm.stop()"]],[3,0,["ctl -> arm.go()","ctl -> press.go()"]]"#,
            r#"[3,0,["ctl -> arm.go()","ctl -> press.go()"]],[1,2,["ctl -> log.x()","ctl -> arm.stop()"]]"#,
        );
        check_same(
            r#""env -> ctl.a()":[[0,1],[2,1]],"env -> ctl.b()":[[0,3]]"#,
            r#""env -> ctl.b()":[[0,3]],"env -> ctl.a()":[[0,1],[2,1]]"#,
        );
        check_same(
            r#""components":{"arm":{"ctl -> arm.go()":1,"ctl -> arm.stop()":2},"press":{"ctl -> press.go()":1}}"#,
            r#""components":{"press":{"ctl -> press.go()":1},"arm":{"ctl -> arm.stop()":2,"ctl -> arm.go()":1}}"#,
        );
    }

    #[test]
    fn owed_may_be_absent() {
        let text = EXAMPLE.replace(r#","owed":{"env -> ctl.a()":[0,2]}"#, "");
        assert_eq!(from_json(&text).expect("a controller").owed, Lists::empty(4));
    }

    #[test]
    fn codes_in_another_order_are_kept() {
        let text = EXAMPLE.replace(r#"go()":1,"ctl -> arm.stop()":2"#, r#"go()":2,"ctl -> arm.stop()":1"#);
        assert_eq!(from_json(&text).expect("a controller").components[0].commands, [1, 0]);
    }

    #[test]
    fn other_versions() {
        check_error(r#""version":1"#, r#""version":2"#, "`version` is 2, but only 1 is known");
        check_error(
            r#""version":1,"states":4"#,
            r#""version":7,"number":4"#,
            "`version` is 7, but only 1 is known",
        );
        check_error(r#""version":1,"#, "", "missing field `version` at line 1");
        check_error(
            r#""version":1"#,
            r#""version":"1""#,
            "invalid type: string \"1\", expected u32 at line 1",
        );
    }

    #[test]
    fn numbers_that_are_no_states() {
        check_error(r#""states":4"#, r#""states":-4"#, "invalid value: integer `-4`, expected u32 at line 1");
        check_error(
            r#""states":4"#,
            r#""states":4.0"#,
            "invalid type: floating point `4.0`, expected u32 at line 1",
        );
        check_error(
            r#""states":4"#,
            r#""states":4294967296"#,
            "invalid value: integer `4294967296`, expected u32 at line 1",
        );
        check_error(r#""states":4"#, r#""states":1e999"#, "number out of range at line 1");
        check_error(
            r#""states":4"#,
            r#""states":4294967295"#,
            "`states` is 4294967295, but the controller has 5 rows",
        );
        check_error(r#""states":4"#, r#""states":4,"states":4"#, "duplicate field `states` at line 1");
    }

    #[test]
    fn states_out_of_range() {
        check_error(r#""states":4"#, r#""states":0"#, "initial: state 0 is not below `states` 0");
        check_error(r#""initial":0"#, r#""initial":4"#, "initial: state 4 is not below `states` 4");
        check_error(
            "[2,1]]",
            "[4,1]]",
            r#"environment["env -> ctl.a()"][1]: source 4 is not below `states` 4"#,
        );
        check_error(
            "[2,1]]",
            "[2,9]]",
            r#"environment["env -> ctl.a()"][1]: target 9 is not below `states` 4"#,
        );
        check_error("[3,0,", "[4,0,", "supersteps[1]: source 4 is not below `states` 4");
        check_error("[3,0,", "[3,9,", "supersteps[1]: target 9 is not below `states` 4");
        check_error("[0,2]}}", "[0,4]}}", r#"owed["env -> ctl.a()"]: state 4 is not below `states` 4"#);
    }

    #[test]
    fn several_rows_for_a_state() {
        check_error("[2,1]]", "[0,2]]", r#"environment["env -> ctl.a()"]: two rows for state 0"#);
        check_error("[2,1]]", "[0,1]]", r#"environment["env -> ctl.a()"]: two rows for state 0"#);
        check_error("[3,0,", "[1,0,", "supersteps: two rows for state 1");
        check_error("ctl.b()", "ctl.a()", r#"environment: "env -> ctl.a()" is there twice"#);
        check_error("press\":", "arm\":", r#"components: "arm" is there twice"#);
        check_error(
            r#"arm.stop()":2"#,
            r#"arm.go()":2"#,
            r#"components["arm"]: "ctl -> arm.go()" is there twice"#,
        );
    }

    #[test]
    fn malformed_rows() {
        check_error("[2,1]]", "[2]]", "invalid length 1, expected `[source, target]` at line 1");
        check_error("[2,1]]", "[2,1,0]]", "trailing characters at line 1");
        check_error("[2,1]]", "2]", "invalid type: integer `2`, expected `[source, target]` at line 1");
        check_error(
            r#"[3,0,["ctl -> arm.go()","ctl -> press.go()"]]"#,
            "[3,0]",
            "invalid length 2, expected `[source, target, [events]]` at line 1",
        );
    }

    #[test]
    fn malformed_events() {
        check_error(
            "env -> ctl.b()",
            "ctl.b()",
            r#"environment: "ctl.b()" is not of the form `sender -> receiver.operation(a, b)`"#,
        );
        check_error(
            "ctl -> log.x()",
            "yield",
            r#"supersteps[0]: "yield" is not of the form `sender -> receiver.operation(a, b)`"#,
        );
        check_error(
            r#""ctl -> arm.go()":1"#,
            r#""go\n":1"#,
            r#"components["arm"]: "go\n" is not of the form `sender -> receiver.operation(a, b)`"#,
        );
        check_error(
            "ctl -> log.x()",
            "env -> ctl.a()",
            r#"supersteps[0]: "env -> ctl.a()" is an event of the environment"#,
        );
        check_error(
            r#""owed":{"env -> ctl.a()""#,
            r#""owed":{"env -> ctl.c()""#,
            r#"owed: "env -> ctl.c()" is not in `environment`"#,
        );
    }

    #[test]
    fn malformed_super_steps() {
        check_error(r#"["ctl -> log.x()","ctl -> arm.stop()"]"#, "[]", "supersteps[0]: there is no event");
        check_error("ctl -> log.x()", "ctl -> arm.go()", "supersteps[0]: `arm` is commanded twice");
        check_error(
            "ctl -> log.x()",
            "ctl -> press.stop()",
            r#"supersteps[0]: "ctl -> press.stop()" has no code in components["press"]"#,
        );
    }

    #[test]
    fn malformed_components() {
        let code = |code| format!(r#"components["arm"]["ctl -> arm.stop()"]: code {code}"#);
        check_error("()\":2", "()\":3", &format!("{} is not one of 1 to 2", code(3)));
        check_error("()\":2", "()\":0", &format!("{} is not one of 1 to 2", code(0)));
        check_error("()\":2", "()\":1", &format!("{} is there twice", code(1)));
        check_error(r#"{"ctl -> press.go()":1}"#, "{}", r#"components["press"]: there is no command"#);
        check_error(
            r#"{"ctl -> press.go()":1}"#,
            r#"{"ctl -> pump.go()":1}"#,
            r#"components["press"]: "ctl -> pump.go()" has another receiver"#,
        );
    }

    #[test]
    fn what_is_no_controller() {
        for text in ["", "null", "[]", "{", "{}", "1", "\u{0}", "[1,2,0,{},[],{},{}]"] {
            let message = from_json(text).expect_err(text);
            assert!(!message.contains('\n') && message.contains("line"), "{message}");
        }
        assert!(from_json(&"[".repeat(100_000)).is_err());
        let nested = EXAMPLE
            .replace(r#""initial""#, &format!(r#""x":{}1{},"initial""#, "[".repeat(5000), "]".repeat(5000)));
        let _ = from_json(&nested);
    }

    proptest! {
        #[test]
        fn every_controller_comes_back(controller in controllers(12)) {
            prop_assert_eq!(from_json(&to_json(&controller)), Ok(controller));
        }

        #[test]
        fn damaged_text_is_no_panic(place in 0..EXAMPLE.len(), byte in prop::sample::select(&b"0129-.,:[]{}\"exX \\"[..])) {
            let mut text = EXAMPLE.as_bytes().to_vec();
            text[place] = byte;
            if let Err(message) = from_json(std::str::from_utf8(&text).expect("ASCII")) {
                prop_assert!(!message.contains('\n'));
            }
        }
    }
}

//! What a script expects of a play: `expect …` lines.

use super::player::{Player, squeezed};
use super::table::Table;
use synth_core::model::{Spec, Type};

/// An expectation, with names as the specification has them.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Expectation {
    /// The opposite is expected.
    negated: bool,
    what: What,
}

#[derive(Clone, PartialEq, Eq, Debug)]
enum What {
    /// All of these events can happen.
    Enabled(Vec<String>),
    /// Exactly these can.
    Only(Vec<String>),
    Turn(&'static str),
    /// `object.attribute` and its value.
    Attribute(String, String),
    Violated(Vec<String>),
    /// A scenario's name, and `role=object` of roles that are bound.
    Active(String, Vec<String>),
}

/// Expected and found, item by item, where an expectation does not hold.
#[derive(Debug)]
pub(super) struct Difference(Vec<String>);

impl Difference {
    /// `-` for what is missing, `+` for what should not be there.
    pub(super) fn show(&self) -> String {
        format!("expected (-) and found (+):\n{}", self.0.join("\n"))
    }
}

impl Expectation {
    /// Reads what stands behind the word `expect`.
    pub(super) fn parse(text: &str, spec: &Spec) -> Result<Self, String> {
        let text = text.trim();
        let (negated, text) =
            match text.strip_prefix("not").filter(|rest| rest.starts_with(char::is_whitespace)) {
                Some(rest) => (true, rest.trim()),
                None => (false, text),
            };
        let (word, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
        let what = match word {
            "enabled" => What::Enabled(some(events(rest, spec)?)?),
            "only" => What::Only(events(rest, spec)?),
            "turn" => What::Turn(side(rest.trim())?),
            "violated" => What::Violated(some(scenarios(rest, spec)?)?),
            "active" => active(rest.trim(), spec)?,
            _ => match text.split_once('=') {
                Some((attribute, value)) if !attribute.trim().is_empty() => {
                    self::attribute(attribute.trim(), value.trim(), spec)?
                }
                _ => {
                    let found = if word.is_empty() { "nothing".to_owned() } else { format!("`{word}`") };
                    return Err(format!(
                        "expected `enabled`, `only`, `turn`, `violated`, `active` or an attribute, found {found}"
                    ));
                }
            },
        };
        Ok(Expectation { negated, what })
    }

    /// Why it does not hold; `None` if it does.
    pub(super) fn check(&self, table: &Table<'_>) -> Option<Difference> {
        let player = &table.player;
        let (wanted, found, exactly) = match &self.what {
            What::Enabled(events) | What::Only(events) => {
                let found = player.enabled().into_iter().map(str::to_owned).collect();
                (events.clone(), found, matches!(self.what, What::Only(_)))
            }
            What::Turn(side) => (vec![format!("turn {side}")], vec![format!("turn {}", turn(player))], true),
            What::Attribute(name, value) => {
                let all = player.attributes();
                let found = all.iter().filter(|(other, _)| other == name);
                let found = found.map(|(name, value)| format!("{name} = {value}")).collect();
                (vec![format!("{name} = {value}")], found, true)
            }
            What::Violated(scenarios) => (scenarios.clone(), table.violated().to_vec(), false),
            What::Active(scenario, roles) => {
                let playout = player.playout();
                let found: Vec<String> =
                    player.copies().into_iter().map(|copy| playout.copy_name(copy)).collect();
                let fitting: Vec<String> =
                    found.iter().filter(|name| fits(name, scenario, roles)).cloned().collect();
                let bound = if roles.is_empty() { String::new() } else { format!("[{}]", roles.join(",")) };
                let wanted = if fitting.is_empty() { vec![format!("{scenario}{bound}")] } else { fitting };
                (wanted, found, false)
            }
        };
        difference(&wanted, &found, exactly, self.negated)
    }
}

fn difference(wanted: &[String], found: &[String], exactly: bool, negated: bool) -> Option<Difference> {
    let all_found = wanted.iter().all(|one| found.contains(one));
    let holds = match (negated, exactly) {
        (false, false) => all_found,
        (false, true) => all_found && found.iter().all(|one| wanted.contains(one)),
        (true, false) => !wanted.iter().any(|one| found.contains(one)),
        (true, true) => !(all_found && found.iter().all(|one| wanted.contains(one))),
    };
    if holds {
        return None;
    }
    let mut lines = Vec::new();
    if !negated {
        lines.extend(wanted.iter().filter(|one| !found.contains(one)).map(|one| format!("- {one}")));
    }
    lines.extend(found.iter().map(|one| match (wanted.contains(one), negated) {
        (true, true) => format!("+ {one}"),
        (false, false) if exactly => format!("+ {one}"),
        _ => format!("  {one}"),
    }));
    Some(Difference(lines))
}

fn turn(player: &Player<'_>) -> &'static str {
    match player.turn() {
        None => "nobody",
        Some(turn) if turn.is_system() => "system",
        Some(_) => "environment",
    }
}

fn side(text: &str) -> Result<&'static str, String> {
    ["system", "environment", "nobody"]
        .into_iter()
        .find(|&side| side == text)
        .ok_or_else(|| format!("expected `system`, `environment` or `nobody`, found `{text}`"))
}

/// The items between semicolons.
fn items(text: &str) -> impl Iterator<Item = &str> {
    text.split(';').map(str::trim).filter(|item| !item.is_empty())
}

fn some(items: Vec<String>) -> Result<Vec<String>, String> {
    if items.is_empty() { Err("this expects nothing at all".to_owned()) } else { Ok(items) }
}

/// Events of the specification.
fn events(text: &str, spec: &Spec) -> Result<Vec<String>, String> {
    items(text).map(|item| event(item, spec)).collect()
}

/// The event as it is written in outputs; everything that it names must exist.
fn event(text: &str, spec: &Spec) -> Result<String, String> {
    let text = squeezed(text);
    if text == "yield" {
        return Ok(text);
    }
    let parts = text.split_once("->").and_then(|(sender, rest)| {
        let (receiver, call) = rest.split_once('.')?;
        let (operation, arguments) = call.strip_suffix(')')?.split_once('(')?;
        Some((sender, receiver, operation, arguments))
    });
    let Some((sender, receiver, operation, arguments)) = parts else {
        return Err(format!("`{text}` is no event: write `sender -> receiver.operation(…)`, or `yield`"));
    };
    let object = |name: &str| {
        let object = spec.domain.objects.iter().find(|object| object.name == name);
        object.ok_or_else(|| format!("there is no object `{name}`"))
    };
    object(sender)?;
    let class = &spec.domain.classes[object(receiver)?.class];
    let arguments: Vec<&str> = if arguments.is_empty() { Vec::new() } else { arguments.split(',').collect() };
    let mut declared = class.operations.iter().map(|&one| &spec.domain.operations[one]);
    let Some(declared) = declared.find(|one| one.name == operation) else {
        return Err(format!("`{receiver}` has no operation `{operation}`"));
    };
    if declared.parameters.len() != arguments.len() {
        let expected = declared.parameters.len();
        return Err(format!("`{operation}` takes {expected} arguments, found {}", arguments.len()));
    }
    for (argument, (name, ty)) in arguments.iter().zip(&declared.parameters) {
        if !can_be(argument, *ty, spec) {
            let ty = spec.domain.show_type(*ty);
            return Err(format!("`{name}` can never be `{argument}`: its type is `{ty}`"));
        }
    }
    Ok(format!("{sender} -> {receiver}.{operation}({})", arguments.join(", ")))
}

/// Whether this is how a value of the type is written.
fn can_be(text: &str, ty: Type, spec: &Spec) -> bool {
    match ty {
        Type::Int(low, high) => text.parse().is_ok_and(|value: i64| (low..=high).contains(&value)),
        Type::Class(_) if text == "null" => true,
        _ => spec.domain.values(ty).any(|value| spec.domain.show(value, ty) == text),
    }
}

fn scenarios(text: &str, spec: &Spec) -> Result<Vec<String>, String> {
    items(text).map(|item| scenario(item, spec)).collect()
}

/// The full name of a scenario; its collaboration may be left out where that is clear.
fn scenario(name: &str, spec: &Spec) -> Result<String, String> {
    let names = || spec.scenarios.iter().map(|scenario| scenario.name.as_str());
    if names().any(|one| one == name) {
        return Ok(name.to_owned());
    }
    let short: Vec<&str> =
        names().filter(|one| one.rsplit_once('.').is_some_and(|(_, short)| short == name)).collect();
    match short.as_slice() {
        [one] => Ok((*one).to_owned()),
        [] => Err(format!("there is no scenario `{name}`")),
        several => Err(format!("`{name}` may be `{}`", several.join("` or `"))),
    }
}

/// `Scenario` or `Scenario[role=object,…]`.
fn active(text: &str, spec: &Spec) -> Result<What, String> {
    let Some((name, bindings)) = text.split_once('[') else {
        return Ok(What::Active(scenario(text, spec)?, Vec::new()));
    };
    let name = scenario(name.trim(), spec)?;
    let Some(bindings) = bindings.trim_end().strip_suffix(']') else {
        return Err(format!("`{text}` lacks a `]`"));
    };
    let declared = spec.scenarios.iter().find(|scenario| scenario.name == name);
    let roles = declared.map_or(&[][..], |scenario| &scenario.roles);
    let binding = |text: &str| {
        let text = squeezed(text);
        let (role, object) = text.split_once('=').ok_or(format!("`{text}` is no binding `role=object`"))?;
        if !roles.iter().any(|one| one.name == role) {
            return Err(format!("`{name}` has no role `{role}`"));
        }
        if !spec.domain.objects.iter().any(|one| one.name == object) {
            return Err(format!("there is no object `{object}`"));
        }
        Ok(text)
    };
    let bindings = bindings.split(',').filter(|one| !one.trim().is_empty()).map(binding);
    Ok(What::Active(name.clone(), bindings.collect::<Result<_, _>>()?))
}

/// Whether a copy of this name is one of the scenario with these bindings.
fn fits(copy: &str, scenario: &str, roles: &[String]) -> bool {
    let (name, bound) = copy.split_once('[').unwrap_or((copy, "]"));
    let bound: Vec<&str> = bound.trim_end_matches(']').split(',').collect();
    name == scenario && roles.iter().all(|role| bound.contains(&role.as_str()))
}

fn attribute(name: &str, value: &str, spec: &Spec) -> Result<What, String> {
    let name = squeezed(name);
    let (object, attribute) = name.split_once('.').ok_or(format!("`{name}` is no attribute of an object"))?;
    let found = spec.domain.objects.iter().find(|one| one.name == object);
    let class = &spec.domain.classes[found.ok_or(format!("there is no object `{object}`"))?.class];
    let declared = class.attributes.iter().find(|one| one.name == attribute);
    let ty = declared.ok_or(format!("`{object}` has no attribute `{attribute}`"))?.ty;
    // An enum's literal may be written with its enum.
    let value = value.rsplit(':').next().unwrap_or(value).trim();
    // `=` or `==`.
    let value = value.trim_start_matches('=').trim();
    if can_be(value, ty, spec) {
        Ok(What::Attribute(name.clone(), value.to_owned()))
    } else {
        Err(format!("`{name}` can never be `{value}`: its type is `{}`", spec.domain.show_type(ty)))
    }
}

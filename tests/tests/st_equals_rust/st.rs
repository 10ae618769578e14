//! Reads generated Structured Text, with the map of its names.

use synth_core::emit::st::NameMap;

use super::super::{Component, Controller, Event, Mapping};

/// Everything that the function block of `text` says of the controller.
#[track_caller]
pub(crate) fn read(text: &str, names: &NameMap) -> Controller {
    let block = &text[text.find("FUNCTION_BLOCK").expect("a block")..];
    let block = without_comments(&block[..block.find("END_FUNCTION_BLOCK").expect("an end")]);
    check_interface(&block, names);
    check_comments(text, names);
    let arrays = arrays(&block);
    let array = |name: String| arrays.iter().find(|(known, _)| *known == name).map(|(_, v)| v.clone());
    let mapping = |prefix: &str| Mapping {
        source: array(format!("{prefix}source")).unwrap_or_default(),
        target: array(format!("{prefix}target")).unwrap_or_default(),
    };
    // The codes follow the super steps, in order of the components.
    let steps = arrays.iter().position(|(name, _)| name == "target").map_or(arrays.len(), |at| at + 1);
    let mut codes = arrays[steps..].iter().map(|(_, values)| values.clone());
    Controller {
        initial: initial(&block),
        events: names
            .events
            .iter()
            .map(|(text, input)| Event { text: text.clone(), mapping: mapping(&format!("{input}_")) })
            .collect(),
        super_steps: mapping(""),
        components: names
            .components
            .iter()
            .map(|component| Component {
                object: component.object.clone(),
                commands: component.codes.clone(),
                codes: codes.next().unwrap_or_default(),
            })
            .collect(),
    }
}

/// The declared inputs and outputs are those of the map, in its order.
#[track_caller]
fn check_interface(block: &str, names: &NameMap) {
    let inputs = names.events.iter().map(|(_, input)| input.as_str());
    let expected: Vec<&str> = ["enable", "reset"].into_iter().chain(inputs).collect();
    assert_eq!(declared(block, "VAR_INPUT"), expected);
    let outputs = names.components.iter().map(|component| component.output.as_str());
    let expected: Vec<&str> =
        outputs.chain([names.state.as_str(), "pending", "unexpected", "overrun"]).collect();
    assert_eq!(declared(block, "VAR_OUTPUT"), expected);
}

/// The comments say which event an input raises and which command a code is.
#[track_caller]
fn check_comments(text: &str, names: &NameMap) {
    let flat = text.replace("(*", " ").replace("*)", " ");
    let flat = flat.split_whitespace().collect::<Vec<_>>().join(" ");
    for (event, input) in &names.events {
        assert!(flat.contains(&format!("{input}: {event}")), "{event}");
    }
    for component in &names.components {
        let all: Vec<String> = component.codes.iter().map(|(text, code)| format!("{code}: {text}")).collect();
        let (object, output) = (&component.object, &component.output);
        let comment = format!("Codes of {output}, commands to {object}: {}", all.join(" "));
        assert!(flat.contains(comment.trim_end()), "{comment}");
    }
}

fn declared<'t>(block: &'t str, section: &str) -> Vec<&'t str> {
    let section = &block[block.find(section).expect("a section") + section.len()..];
    let section = &section[..section.find("END_VAR").expect("an end")];
    section.split(';').filter_map(|line| Some(line.split_once(':')?.0.trim())).collect()
}

/// The state at first, which three places must agree on.
#[track_caller]
fn initial(block: &str) -> u32 {
    let declared = |name: &str| {
        let line = block.lines().map(str::trim).find(|line| line.starts_with(&format!("{name} : ")));
        let value = line.expect("a declaration").trim_end_matches(';').rsplit(":=").next();
        value.expect("a value").trim().parse::<u32>().expect("a number")
    };
    let state = declared("state");
    assert_eq!(declared("state_no"), state);
    assert!(block.contains(&format!("IF reset THEN\n  state := {state};")), "{block}");
    state
}

/// Every array with values, in textual order.
#[track_caller]
fn arrays(block: &str) -> Vec<(String, Vec<u32>)> {
    block
        .split(';')
        .filter_map(|declaration| {
            let (left, values) = declaration.split_once(":= [")?;
            let (name, ty) = left.split_once(':').expect("a declaration");
            let name = name.split_whitespace().last().expect("a name").to_owned();
            let values: Vec<u32> = values
                .trim()
                .trim_end_matches(']')
                .split(',')
                .map(|value| value.trim().parse().expect("a number"))
                .collect();
            assert!(ty.contains(&format!("ARRAY [0..{}] OF", values.len() - 1)), "{name}: {ty}");
            Some((name, values))
        })
        .collect()
}

fn without_comments(text: &str) -> String {
    text.split("(*").map(|part| part.split_once("*)").map_or(part, |(_, rest)| rest)).collect()
}

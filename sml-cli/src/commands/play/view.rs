//! What a play looks like: events as they happen, and the state between them, for people and for programs.

use super::player::{Choice, Happened, Player};
use super::table::Table;
use serde::Serialize;
use serde_json::{Value as Json, json};
use synth_core::explain::Mention;
use synth_core::playout::CopyId;
use synth_core::syntax::{Sources, Span};

/// An event in JSON.
#[derive(Serialize)]
struct Line<'a> {
    event: &'a str,
    turn: &'a str,
    violated: &'a [String],
    enabled: &'a [String],
    #[serde(skip_serializing_if = "Option::is_none")]
    outcome: Option<&'a str>,
}

/// What happened, an object a line.
pub(super) fn event_json(happened: &Happened) -> String {
    let Happened { event, turn, violated, enabled, outcome, .. } = happened;
    let line = Line { event, turn: turn.name(), violated, enabled, outcome: outcome.as_deref() };
    format!("{}\n", serde_json::to_string(&line).expect("strings always serialize"))
}

/// What happened, for people.
pub(super) fn event_text(happened: &Happened, sources: &Sources) -> String {
    let mut text = format!("{}: {}\n", happened.turn.name(), happened.event);
    for mention in &happened.breaches {
        text.push_str(&format!("  violates {}\n", explained(mention, sources)));
    }
    text
}

/// The whole state, for people.
pub(super) fn state(table: &mut Table<'_>, color: bool) -> String {
    let sources = &table.loaded.sources;
    let mut text = String::from("\n");
    text.push_str(&copies(&table.player, sources));
    text.push_str(&attributes(&table.player.attributes(), table.before(), color));
    text.push_str(&turn(&mut table.player, sources));
    text
}

/// Whose turn it is and why, and what can be chosen.
pub(super) fn turn(player: &mut Player<'_>, sources: &Sources) -> String {
    let Some(turn) = player.turn() else {
        return format!("the play is over: {}\n", player.over().unwrap_or_default());
    };
    let side = if turn.is_system() { "system" } else { "environment" };
    let mut text = format!("turn of the {side}, case {}: {}\n", turn as u8, player.turn_reason());
    let choices = player.choices();
    let width = choices.iter().map(|choice| choice.event.chars().count()).max().unwrap_or(0);
    let mut number = 0;
    for choice in &choices {
        let mark = if choice.enabled {
            number += 1;
            number.to_string()
        } else {
            "-".to_owned()
        };
        let mut why = roles(choice, sources);
        if !choice.enabled && !is_refused(choice) {
            why.push("not its turn".to_owned());
        }
        let why = why.join("; ");
        let line = format!("  {mark:>2}  {:<width$}   {why}", choice.event);
        text.push_str(line.trim_end());
        text.push('\n');
    }
    if number == 0 {
        text.push_str("  nothing can happen\n");
    }
    text
}

/// Everything about one event, a line for each scenario.
pub(super) fn why(choice: &Choice, player: &Player<'_>, sources: &Sources) -> String {
    let verdict = match (choice.enabled, player.over()) {
        (true, _) => "can happen now".to_owned(),
        (false, Some(why)) => format!("cannot happen, the play is over: {why}"),
        (false, None) => "cannot happen now".to_owned(),
    };
    let mut text = format!("{} {verdict}\n", choice.event);
    let mut reasons = roles(choice, sources);
    if let Some(turn) = player.turn().filter(|_| !choice.enabled && !is_refused(choice)) {
        let side = if turn.is_system() { "system" } else { "environment" };
        if choice.wanted_by.is_empty() {
            reasons.push("no active scenario wants it".to_owned());
        }
        reasons.push(format!("it is the turn of the {side}, case {}: {}", turn as u8, player.turn_reason()));
    }
    for reason in reasons {
        text.push_str(&format!("  {reason}\n"));
    }
    text
}

fn is_refused(choice: &Choice) -> bool {
    choice.unlinked || !choice.refused_by.is_empty()
}

/// What scenarios have to do with an event.
fn roles(choice: &Choice, sources: &Sources) -> Vec<String> {
    let shown = |mentions: &[Mention]| {
        let places = mentions.iter().map(|mention| mention.show(&|span| sources.place(span)));
        places.collect::<Vec<_>>().join(", ")
    };
    let mut roles = Vec::new();
    if !choice.wanted_by.is_empty() {
        roles.push(format!("wanted by {}", shown(&choice.wanted_by)));
    }
    if !choice.awaited_by.is_empty() {
        roles.push(format!("awaited by {}", shown(&choice.awaited_by)));
    }
    if !choice.starts.is_empty() {
        roles.push(format!("starts {}", choice.starts.join(", ")));
    }
    roles.extend(
        choice.refused_by.iter().map(|mention| format!("would violate {}", explained(mention, sources))),
    );
    if choice.unlinked {
        roles.push("its channel has no link".to_owned());
    }
    roles.extend(choice.violates.iter().map(|mention| format!("violates {}", explained(mention, sources))));
    roles
}

/// `Scenario (file:line): why`.
fn explained(mention: &Mention, sources: &Sources) -> String {
    format!("{}: {}", mention.show(&|span| sources.place(span)), mention.says)
}

/// Every active copy with its cut marked in the source.
fn copies(player: &Player<'_>, sources: &Sources) -> String {
    let mut text = String::new();
    for copy in player.copies() {
        if text.is_empty() {
            text.push_str("active:\n");
        }
        let playout = player.playout();
        let variables = playout.variables(copy);
        let variables = variables.iter().map(|(name, value)| format!("  {name} = {value}"));
        text.push_str(&format!("  {}{}\n", playout.copy_name(copy), variables.collect::<String>()));
        let mut places = cut(player, copy);
        places.sort_unstable();
        for line in places.chunk_by(|a, b| (a.file, a.start.line) == (b.file, b.start.line)) {
            text.push_str(&marked(line, sources));
        }
    }
    text
}

/// The places at which a copy stands.
fn cut(player: &Player<'_>, copy: CopyId) -> Vec<Span> {
    let copy = player.playout().copy(copy);
    let scenario = &player.spec().scenarios[copy.scenario];
    copy.cut.iter().map(|&node| scenario.nodes[usize::from(node)].span).collect()
}

/// A line of the source with a mark under every span, all of which begin there, as far as it lies in this line.
fn marked(spans: &[Span], sources: &Sources) -> String {
    let Some(&first) = spans.first() else { return String::new() };
    let line = first.start.line;
    let text = sources.text(first.file).lines().nth((line as usize).saturating_sub(1)).unwrap_or_default();
    let is_marked = |column: u32| {
        let behind = |span: &Span| span.end.line > line || column < span.end.column;
        spans.iter().any(|span| span.start.column == column || span.start.column < column && behind(span))
    };
    let lead = text.chars().take_while(|c| c.is_whitespace()).count();
    // A mark behind a tab stands behind a tab as well.
    let marks = (1..).zip(text.trim_end().chars()).skip(lead).map(|(column, c)| match c {
        _ if is_marked(column) => '^',
        '\t' => '\t',
        _ => ' ',
    });
    let marks: String = marks.collect();
    let number = sources.place(first);
    let gutter = " ".repeat(number.chars().count());
    format!("    {number} | {}\n    {gutter} | {}\n", text.trim(), marks.trim_end())
}

/// Every attribute; those that have changed with their value before.
fn attributes(now: &[(String, String)], before: &[(String, String)], color: bool) -> String {
    let mut text = String::new();
    for ((name, value), (_, old)) in now.iter().zip(before) {
        if text.is_empty() {
            text.push_str("attributes:\n");
        }
        text.push_str(&match (value == old, color) {
            (true, _) => format!("  {name} = {value}\n"),
            (false, true) => format!("  \u{1b}[1m{name} = {value}\u{1b}[0m (was {old})\n"),
            (false, false) => format!("  {name} = {value} (was {old})\n"),
        });
    }
    text
}

/// The whole state, for programs.
pub(super) fn state_json(table: &mut Table<'_>) -> String {
    let sources = &table.loaded.sources;
    let choices: Vec<Json> = table.player.choices().iter().map(|one| choice_json(one, sources)).collect();
    let player = &table.player;
    let turn = player.turn();
    let copy = |copy: CopyId| {
        let places = cut(player, copy).into_iter().map(|span| place_json(span, sources));
        let variables = player.playout().variables(copy).into_iter();
        json!({
            "scenario": player.playout().copy_name(copy),
            "variables": variables.map(|(name, value)| json!([name, value])).collect::<Vec<_>>(),
            "cut": places.collect::<Vec<_>>(),
        })
    };
    let attributes: serde_json::Map<String, Json> =
        player.attributes().into_iter().map(|(name, value)| (name, json!(value))).collect();
    let state = json!({
        "turn": turn.map(|turn| if turn.is_system() { "system" } else { "environment" }),
        "case": turn.map(|turn| turn as u8),
        "enabled": player.enabled(),
        "choices": choices,
        "copies": player.copies().into_iter().map(copy).collect::<Vec<_>>(),
        "attributes": attributes,
    });
    format!("{state}\n")
}

/// Everything about one event, for programs.
pub(super) fn why_json(choice: &Choice, sources: &Sources) -> String {
    format!("{}\n", choice_json(choice, sources))
}

fn choice_json(choice: &Choice, sources: &Sources) -> Json {
    let places = |mentions: &[Mention]| {
        let of = |mention: &Mention| {
            let mut place = place_json(mention.place, sources);
            place["scenario"] = json!(mention.scenario);
            place
        };
        mentions.iter().map(of).collect::<Vec<Json>>()
    };
    json!({
        "event": choice.event,
        "can_happen": choice.enabled,
        "wanted_by": places(&choice.wanted_by),
        "awaited_by": places(&choice.awaited_by),
        "starts": choice.starts,
        "refused_by": places(&choice.refused_by),
        "violates": places(&choice.violates),
        "has_channel": !choice.unlinked,
    })
}

fn place_json(span: Span, sources: &Sources) -> Json {
    json!({ "file": sources.path(span.file), "line": span.start.line, "column": span.start.column })
}

#[cfg(test)]
mod tests {
    use super::*;
    use synth_core::syntax::{FileId, Pos};

    /// The line and its marks, as they are shown for spans from and to these lines and columns.
    #[track_caller]
    fn check(text: &str, spans: &[[u32; 4]], expect: &str) {
        let mut sources = Sources::new();
        sources.add("s", text);
        let span = |&[line, column, end, behind]: &[u32; 4]| Span {
            file: FileId(0),
            start: Pos { line, column },
            end: Pos { line: end, column: behind },
        };
        let spans: Vec<Span> = spans.iter().map(span).collect();
        assert_eq!(marked(&spans, &sources), expect);
    }

    #[test]
    fn marks_stand_below_what_they_mark() {
        check("  ab cd", &[[1, 6, 1, 8]], "    s:1 | ab cd\n        |    ^^\n");
        check("ab cd", &[[1, 1, 1, 3], [1, 4, 1, 6]], "    s:1 | ab cd\n        | ^^ ^^\n");
        check("\ta\tb", &[[1, 4, 1, 5]], "    s:1 | a\tb\n        |  \t^\n");
        check("é €uro", &[[1, 3, 1, 7]], "    s:1 | é €uro\n        |   ^^^^\n");
    }

    #[test]
    fn a_fragment_of_several_lines_is_marked_to_the_end_of_its_first() {
        check("a\n  wait [\n  b ]", &[[2, 3, 3, 6]], "    s:2 | wait [\n        | ^^^^^^\n");
    }

    #[test]
    fn a_place_outside_the_text_is_no_panic() {
        check("", &[[9, 9, 9, 9]], "    s:9 | \n        | \n");
        assert_eq!(marked(&[], &Sources::new()), "");
    }
}

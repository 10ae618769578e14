//! The counter-play as a Mermaid sequence diagram.
//!
//! Participants have ids of our own, so that no name of the specification is read as a keyword; names and notes are
//! escaped by Mermaid's entity codes.

use super::steps::{Mention, PlayStep, Refusal};
use super::{Explanation, SILENCE};
use crate::syntax::Span;

/// Draws play and loop; `place` shows where something stands. The objects are the participants, in the order in which
/// they take part; notes say what wants an event, what it violates and what was refused instead.
#[must_use]
pub fn sequence(explanation: &Explanation, place: &dyn Fn(Span) -> String) -> String {
    let mut participants: Vec<&str> = Vec::new();
    for name in explanation.steps.iter().filter_map(ends).flat_map(|(sender, receiver, _)| [sender, receiver])
    {
        if !participants.contains(&name) {
            participants.push(name);
        }
    }
    if participants.is_empty() {
        participants.push("environment");
    }
    let mut out = String::from("sequenceDiagram\n");
    for (id, name) in participants.iter().enumerate() {
        out.push_str(&format!("    participant p{id} as {}\n", escape(name)));
    }
    let mut drawing = Drawing { participants, place, out, indent: 1 };
    let mut looping = false;
    for step in &explanation.steps {
        if step.in_loop && !looping {
            looping = true;
            drawing.line("loop for ever");
            drawing.indent += 1;
        }
        drawing.step(step);
    }
    if let Some(starved) = &explanation.starved {
        drawing.note(None, &format!("never met: {} ({})", starved.scenario, place(starved.fragment)));
    }
    if looping {
        drawing.indent -= 1;
        drawing.line("end");
    }
    drawing.out
}

/// Sender, receiver and the rest of an event's text; `None` for a yield or silence.
fn ends(step: &PlayStep) -> Option<(&str, &str, &str)> {
    let (sender, rest) = step.event.split_once(" -> ")?;
    let (receiver, call) = rest.split_once('.')?;
    Some((sender, receiver, call))
}

struct Drawing<'a> {
    participants: Vec<&'a str>,
    place: &'a dyn Fn(Span) -> String,
    out: String,
    indent: usize,
}

impl<'a> Drawing<'a> {
    fn line(&mut self, text: &str) {
        self.out.push_str(&"    ".repeat(self.indent));
        self.out.push_str(text);
        self.out.push('\n');
    }

    /// A note over those who take part in an event, or over all.
    fn note(&mut self, over: Option<(usize, usize)>, text: &str) {
        let (first, last) = over.unwrap_or((0, self.participants.len() - 1));
        let over = if first == last { format!("p{first}") } else { format!("p{first},p{last}") };
        self.line(&format!("Note over {over}: {}", escape(text)));
    }

    fn step(&mut self, step: &'a PlayStep) {
        let id = |name| self.participants.iter().position(|&one| one == name).unwrap_or(0);
        let over = ends(step).map(|(sender, receiver, _)| (id(sender), id(receiver)));
        match (ends(step), over) {
            (Some((_, _, call)), Some((sender, receiver))) => {
                self.line(&format!("p{sender}->>p{receiver}: {}", escape(call)));
            }
            _ if step.event == SILENCE => self.note(None, "nothing happens any more"),
            _ => self.note(None, "the system yields"),
        }
        let named = |mentions: &[Mention]| {
            mentions.iter().map(|mention| mention.show(self.place)).collect::<Vec<_>>().join(", ")
        };
        let mut notes = Vec::new();
        if !step.wanted_by.is_empty() {
            notes.push(format!("wanted by {}", named(&step.wanted_by)));
        }
        notes.extend(
            step.violates
                .iter()
                .map(|mention| format!("violates {}: {}", mention.show(self.place), mention.says)),
        );
        notes.extend(step.forbidden.iter().map(|Refusal { event, by }| match by.as_slice() {
            [] => format!("refused: {event}, which has no channel"),
            by => format!("refused: {event} by {}", named(by)),
        }));
        for note in notes {
            self.note(over, &note);
        }
    }
}

/// What Mermaid would take for something else, as entities: `;` ends a statement, `#` begins an entity, `%%` a
/// comment, quotes and `<` are HTML, and the word `end` ends a block.
fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut word_before = false;
    for (at, c) in text.char_indices() {
        let is_word = |c: char| c.is_alphanumeric() || c == '_';
        let rest = &text[at..];
        let is_end = !word_before
            && rest.get(..3).is_some_and(|word| word.eq_ignore_ascii_case("end"))
            && !rest[3..].starts_with(is_word);
        word_before = is_word(c);
        match c {
            _ if is_end => out.push_str(&format!("#{};", u32::from(c))),
            '#' | ';' | '"' | '<' | '%' | '&' | '`' | '\\' => {
                out.push_str(&format!("#{};", u32::from(c)));
            }
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, expect: &str) {
        assert_eq!(escape(text), expect);
    }

    #[test]
    fn what_mermaid_reads_as_syntax_is_escaped() {
        check("go(1, red)", "go(1, red)");
        check("a;b#c", "a#59;b#35;c");
        check("say \"x\" <b>", "say #34;x#34; #60;b>");
        check("%%{init}%%", "#37;#37;{init}#37;#37;");
        check("end", "#101;nd");
        check("the End.", "the #69;nd.");
        check("the_end bend ender", "the_end bend ender");
        check("a\nb", "a b");
        check("été", "été");
    }
}

//! What every machine needs that is not of this project: events and commands.

use super::super::line::ORDERS;
use super::super::subject::Subject;
use std::fmt::Write as _;

/// `Event` with `event`, a command type for each component, `Commands` and `NONE`. Types have the shape of those that this
/// project generates.
pub(super) fn items(subject: &Subject, derives: &str) -> String {
    let mut text =
        format!("#[derive({derives})]\n#[repr(u8)]\npub enum Event {{ {} }}\n", event_variants(subject));
    text.push_str(&after_events(subject));
    text
}

/// The same where a macro declares `Event`.
pub(super) fn after_events(subject: &Subject) -> String {
    let mut text = String::from("pub fn event(number: u8) -> Option<Event> {\n    Some(match number {\n");
    for event in 0..subject.events.len() {
        let _ = writeln!(text, "        {event} => Event::E{event},");
    }
    text.push_str("        _ => return None,\n    })\n}\n");
    let mut fields = String::new();
    for component in 0..subject.components.len() {
        let variants: Vec<String> =
            (1..).zip(ORDERS).map(|(code, order)| format!("{} = {code}", variant(order))).collect();
        let _ = writeln!(
            text,
            "#[derive(Clone, Copy, Hash)]\n#[repr(u8)]\npub enum Station{component} {{ {} }}",
            variants.join(", ")
        );
        let _ = write!(fields, " pub station{component}: Option<Station{component}>,");
    }
    let none: Vec<String> =
        (0..subject.components.len()).map(|component| format!("station{component}: None")).collect();
    let _ = writeln!(
        text,
        "#[derive(Clone, Copy, Hash)]\npub struct Commands {{{fields} }}\nconst NONE: Commands = Commands {{ {} }};",
        none.join(", ")
    );
    text
}

fn event_variants(subject: &Subject) -> String {
    let variants: Vec<String> = (0..subject.events.len()).map(|event| format!("E{event}")).collect();
    variants.join(", ")
}

/// `S0, S1, …`
pub(super) fn states(subject: &Subject) -> String {
    (0..subject.states).map(|state| format!("S{state}")).collect::<Vec<_>>().join(", ")
}

/// An expression of type `Commands`.
pub(super) fn commands(codes: &[u8]) -> String {
    let some = codes.iter().enumerate().filter(|(_, code)| **code != 0);
    let fields: Vec<String> = some
        .map(|(component, &code)| {
            format!(
                "station{component}: Some(Station{component}::{})",
                variant(ORDERS[usize::from(code) - 1])
            )
        })
        .collect();
    match fields.len() {
        0 => "NONE".to_owned(),
        count if count == codes.len() => format!("Commands {{ {} }}", fields.join(", ")),
        _ => format!("Commands {{ {}, ..NONE }}", fields.join(", ")),
    }
}

/// `take` is `Take`.
fn variant(order: &str) -> String {
    let (first, rest) = order.split_at(1);
    format!("{}{rest}", first.to_uppercase())
}

#[cfg(test)]
mod tests {
    use super::commands;

    #[test]
    fn commands_are_an_expression() {
        assert_eq!(commands(&[0, 0]), "NONE");
        assert_eq!(commands(&[0, 3]), "Commands { station1: Some(Station1::Take), ..NONE }");
        assert_eq!(commands(&[1]), "Commands { station0: Some(Station0::Discard) }");
    }
}

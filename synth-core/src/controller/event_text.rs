//! Event texts: `sender -> receiver.operation(a, b)`.

use super::Event;

impl Event {
    /// Takes an event text apart; `None` unless it is exactly `sender -> receiver.operation(a, b)` with one space
    /// where shown, names for the first three and names or integers as arguments.
    #[must_use]
    pub fn from_text(text: &str) -> Option<Event> {
        let (sender, rest) = text.split_once(" -> ")?;
        let (receiver, rest) = rest.split_once('.')?;
        let (operation, rest) = rest.split_once('(')?;
        let inner = rest.strip_suffix(')')?;
        let arguments: Vec<&str> = if inner.is_empty() { Vec::new() } else { inner.split(", ").collect() };
        let valid = [sender, receiver, operation].into_iter().all(is_name)
            && arguments.iter().all(|argument| is_name(argument) || is_integer(argument));
        valid.then(|| Event {
            text: text.to_owned(),
            sender: sender.to_owned(),
            receiver: receiver.to_owned(),
            operation: operation.to_owned(),
            arguments: arguments.into_iter().map(str::to_owned).collect(),
        })
    }
}

fn is_name(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_alphabetic())
        && text.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_')
}

fn is_integer(text: &str) -> bool {
    let digits = text.strip_prefix('-').unwrap_or(text);
    !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, parts: [&str; 3], arguments: &[&str]) {
        let event = Event::from_text(text).expect("an event text");
        assert_eq!(event.text, text);
        assert_eq!([&*event.sender, &*event.receiver, &*event.operation], parts);
        assert_eq!(event.arguments, arguments);
    }

    #[test]
    fn takes_texts_apart() {
        check("a -> b.c()", ["a", "b", "c"], &[]);
        check("a1 -> b_2.move(x)", ["a1", "b_2", "move"], &["x"]);
        check("a -> b.c(-1, true, null, 20)", ["a", "b", "c"], &["-1", "true", "null", "20"]);
    }

    #[test]
    fn refuses_everything_else() {
        for text in [
            "",
            "yield",
            "a->b.c()",
            "a  -> b.c()",
            " a -> b.c()",
            "a -> b.c",
            "a -> b.c() ",
            "a -> b()",
            "a -> b.c(x,y)",
            "a -> b.c(x, )",
            "a -> b.c(, x)",
            "a -> b.c(-)",
            "a -> b.c(1x)",
            "a -> b.c(*)",
            "a -> b.c.d()",
            "a -> b.c(()",
            "1 -> b.c()",
            "_a -> b.c()",
            "é -> b.c()",
            "a -> b -> c.d()",
        ] {
            assert_eq!(Event::from_text(text), None, "{text}");
        }
    }
}

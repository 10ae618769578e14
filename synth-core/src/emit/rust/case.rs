//! Rust's cases, from identifiers in any case.

/// `feedBelt_arm1` → `feed_belt_arm1`.
pub(super) fn snake(identifier: &str) -> String {
    join(&words(identifier), str::to_owned)
}

/// `feedBelt_arm1` → `FEED_BELT_ARM1`.
pub(super) fn screaming(identifier: &str) -> String {
    snake(identifier).to_ascii_uppercase()
}

/// `feedBelt_arm1` → `FeedBeltArm1`; an underscore stays between digits.
pub(super) fn camel(identifier: &str) -> String {
    let mut name = String::with_capacity(identifier.len());
    for word in words(identifier) {
        if name.ends_with(|c: char| c.is_ascii_digit()) && word.starts_with(|c: char| c.is_ascii_digit()) {
            name.push('_');
        }
        name.push_str(&word[..1].to_ascii_uppercase());
        name.push_str(&word[1..]);
    }
    name
}

/// Numbers a name in camel case without leaving it: `Event2`, `Arm1_2`.
pub(super) fn numbered_camel(name: &str, number: u32) -> String {
    let separator = if name.ends_with(|c: char| c.is_ascii_digit()) { "_" } else { "" };
    format!("{name}{separator}{number}")
}

fn join(words: &[String], part: impl Fn(&str) -> String) -> String {
    words.iter().map(|word| part(word)).collect::<Vec<_>>().join("_")
}

/// The words of an identifier in lower case: they end at underscores, before a capital after a small letter or digit,
/// and before the last capital of a run that a small letter follows.
fn words(identifier: &str) -> Vec<String> {
    let letters = identifier.as_bytes();
    let mut words = Vec::new();
    let mut word = String::new();
    for (i, &letter) in letters.iter().enumerate() {
        let before = i.checked_sub(1).map(|i| letters[i]);
        let after = letters.get(i + 1);
        let begins = letter.is_ascii_uppercase()
            && before.is_some_and(|before| {
                !before.is_ascii_uppercase() || after.is_some_and(u8::is_ascii_lowercase)
            });
        if (letter == b'_' || begins) && !word.is_empty() {
            words.push(std::mem::take(&mut word));
        }
        if letter != b'_' {
            word.push(char::from(letter.to_ascii_lowercase()));
        }
    }
    if !word.is_empty() {
        words.push(word);
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(identifier: &str, snake_case: &str, camel_case: &str) {
        assert_eq!(snake(identifier), snake_case);
        assert_eq!(camel(identifier), camel_case);
        assert_eq!(screaming(identifier), snake_case.to_ascii_uppercase());
    }

    #[test]
    fn cases() {
        check("feedBelt", "feed_belt", "FeedBelt");
        check("ProductionCell", "production_cell", "ProductionCell");
        check(
            "feedBelt_controller_arrivedAt_m1",
            "feed_belt_controller_arrived_at_m1",
            "FeedBeltControllerArrivedAtM1",
        );
        check("PLC", "plc", "Plc");
        check("PLCInput", "plc_input", "PlcInput");
        check("press1Done", "press1_done", "Press1Done");
        check("a_1_2", "a_1_2", "A1_2");
        check("x", "x", "X");
    }

    #[test]
    fn numbers() {
        assert_eq!(numbered_camel("Event", 2), "Event2");
        assert_eq!(numbered_camel("Arm1", 2), "Arm1_2");
    }
}

//! Identifiers that back ends share (controller contract, section 2).

use std::collections::BTreeSet;

/// The identifier of an event text, an object or any other text: runs of anything but ASCII letters and digits
/// become one `_`, none at the ends, and the sign of a negative number becomes `m`.
///
/// Texts that come from a specification begin with a letter; any other gets an `x` in front.
///
/// ```
/// use synth_core::emit::names::identifier;
///
/// assert_eq!(identifier("feedBelt -> controller.arrived(-1, press)"), "feedBelt_controller_arrived_m1_press");
/// ```
#[must_use]
pub fn identifier(text: &str) -> String {
    let mut name = String::with_capacity(text.len());
    let mut gap = false;
    let mut characters = text.chars().peekable();
    while let Some(character) = characters.next() {
        let sign = character == '-' && characters.peek().is_some_and(char::is_ascii_digit);
        if !sign && !character.is_ascii_alphanumeric() {
            gap = true;
            continue;
        }
        if gap && !name.is_empty() {
            name.push('_');
        }
        gap = false;
        name.push(if sign { 'm' } else { character });
    }
    if !name.starts_with(|first: char| first.is_ascii_alphabetic()) {
        name.insert(0, 'x');
    }
    name
}

/// Hands out the names of one scope, each once.
///
/// A name that is taken or reserved gets `_2`, `_3`, …, the first that is free.
pub struct Namer {
    reserved: fn(&str) -> bool,
    numbered: fn(&str, u32) -> String,
    fold_case: bool,
    taken: BTreeSet<String>,
}

impl Namer {
    /// A scope in which names for which `reserved` holds are never given.
    #[must_use]
    pub fn new(reserved: fn(&str) -> bool) -> Self {
        Namer {
            reserved,
            numbered: |name, number| format!("{name}_{number}"),
            fold_case: false,
            taken: BTreeSet::new(),
        }
    }

    /// Takes names that differ only in case as the same.
    #[must_use]
    pub fn fold_case(self) -> Self {
        Namer { fold_case: true, ..self }
    }

    /// Numbers names another way than by `_2`.
    #[must_use]
    pub fn numbered(self, numbered: fn(&str, u32) -> String) -> Self {
        Namer { numbered, ..self }
    }

    /// `wanted` if it is free, else the first numbered one that is.
    pub fn name(&mut self, wanted: &str) -> String {
        let mut name = wanted.to_owned();
        let mut number = 2;
        while (self.reserved)(&name) || !self.taken.insert(self.key(&name)) {
            name = (self.numbered)(wanted, number);
            number += 1;
        }
        name
    }

    fn key(&self, name: &str) -> String {
        if self.fold_case { name.to_ascii_lowercase() } else { name.to_owned() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, expected: &str) {
        assert_eq!(identifier(text), expected);
    }

    #[test]
    fn event_texts() {
        check("a -> b.c()", "a_b_c");
        check("feedBelt -> arm_1.moveTo(press, true)", "feedBelt_arm_1_moveTo_press_true");
        check("a -> b.c(-1, 2)", "a_b_c_m1_2");
        check("a -> b.c(-1, -20)", "a_b_c_m1_m20");
        check("a->b.c(1)", "a_b_c_1");
    }

    #[test]
    fn runs_and_ends() {
        check("a__b", "a_b");
        check("_a_", "a");
        check("a_ -> _b", "a_b");
        check("a__b_ -> _c.d_()", "a_b_c_d");
        check("", "x");
        check("1a", "x1a");
        check("-1", "m1");
        check("(é)", "x");
        check("3 -> 4", "x3_4");
    }

    #[track_caller]
    fn check_names(mut namer: Namer, wanted: &[&str], expected: &[&str]) {
        let names: Vec<String> = wanted.iter().map(|name| namer.name(name)).collect();
        assert_eq!(names, expected);
    }

    #[test]
    fn clashes_are_numbered() {
        check_names(Namer::new(|_| false), &["a", "a", "A", "a"], &["a", "a_2", "A", "a_3"]);
        check_names(Namer::new(|_| false), &["a_2", "a", "a"], &["a_2", "a", "a_3"]);
    }

    #[test]
    fn case_can_be_folded() {
        check_names(Namer::new(|_| false).fold_case(), &["a", "A", "a_2"], &["a", "A_2", "a_2_2"]);
    }

    #[test]
    fn reserved_words_are_numbered() {
        check_names(Namer::new(|name| name == "if"), &["if", "if", "IF"], &["if_2", "if_3", "IF"]);
    }

    #[test]
    fn numbering_can_be_another() {
        let namer = Namer::new(|_| false).numbered(|name, number| format!("{name}{number}"));
        check_names(namer, &["A", "A"], &["A", "A2"]);
    }
}

//! Templates: files that are written once and then belong to whoever fills them in.
//!
//! A template says in its head which [`Interface`] it was written for, so that it can be told later whether the
//! specification still has that interface, and what changed.

use crate::controller::tables::{ComponentTable, Tables};
use crate::fnv::Fnv;

/// A file to be filled in.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Template {
    /// The component that it is for.
    pub object: String,
    /// The name of the file, without a folder.
    pub file: String,
    /// What it holds at first.
    pub text: String,
    /// What it relies on.
    pub interface: Interface,
}

/// What a secondary and its primary have to agree about, an entry per name, command and event.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Interface {
    entries: Vec<String>,
}

/// Why a file that was once a template does not fit its specification.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Stale {
    /// Its head does not say what it was written for.
    Unknown,
    /// It was written for another interface; both lists are empty if only its fingerprint, or their order, says so.
    Changed {
        /// Entries that it does not know.
        new: Vec<String>,
        /// Entries that are no more.
        gone: Vec<String>,
    },
}

/// How the first line of a template begins.
const OPENING: &str = "Secondary of ";
const HEAD: &str = "Interface ";
const END: &str = "End of the interface.";

impl Interface {
    pub(super) fn new(entries: Vec<String>) -> Interface {
        Interface { entries }
    }

    /// 16 hexadecimal digits.
    #[must_use]
    pub fn fingerprint(&self) -> String {
        let mut hash = Fnv::new();
        self.entries.iter().for_each(|entry| hash.text(&bare(entry)));
        hash.hex()
    }

    /// The lines of a comment that [`Template::stale`] understands, in whatever way a language marks them and breaks
    /// those that are too long.
    pub(super) fn lines(&self) -> impl Iterator<Item = String> {
        let first =
            format!("{HEAD}{}, which sml compares with that of the specification:", self.fingerprint());
        let entries = self.entries.iter().map(|entry| format!("- {entry}"));
        std::iter::once(first).chain(entries).chain([END.to_owned()])
    }

    /// The fingerprint and the entries in a head.
    fn read(text: &str) -> Option<(String, Interface)> {
        let mut lines = text.lines().map(uncommented);
        let fingerprint = lines.by_ref().find_map(|line| {
            let digits = line.strip_prefix(HEAD)?.get(..16)?;
            digits.chars().all(|c| c.is_ascii_hexdigit()).then(|| digits.to_owned())
        })?;
        let mut entries: Vec<String> = Vec::new();
        for line in lines.take_while(|line| *line != END) {
            match (line.strip_prefix("- "), entries.last_mut()) {
                (Some(entry), _) => entries.push(entry.to_owned()),
                // The rest of a line that was too long.
                (None, Some(entry)) => *entry = format!("{entry} {line}"),
                (None, None) => {}
            }
        }
        Some((fingerprint, Interface { entries }))
    }

    /// The entries that `other` does not have.
    fn without(&self, other: &Interface) -> Vec<String> {
        let known: Vec<String> = other.entries.iter().map(|entry| bare(entry)).collect();
        self.entries.iter().filter(|entry| !known.contains(&bare(entry))).cloned().collect()
    }
}

impl Template {
    /// Why `text`, which stands in its file now, does not fit; `None` if it does. Only the head counts.
    #[must_use]
    pub fn stale(&self, text: &str) -> Option<Stale> {
        let Some((fingerprint, written_for)) = Interface::read(text) else { return Some(Stale::Unknown) };
        let own = self.interface.fingerprint();
        (fingerprint != own || written_for.fingerprint() != own).then(|| Stale::Changed {
            new: self.interface.without(&written_for),
            gone: written_for.without(&self.interface),
        })
    }
}

/// Whether a text looks like a template that has been written: it says so in its head.
#[must_use]
pub fn is_template(text: &str) -> bool {
    text.lines().map(uncommented).any(|line| line.starts_with(OPENING)) && Interface::read(text).is_some()
}

/// What follows a component's commands: per command the events (indices, ascending) that are owed after it and were not
/// before, and that the component sends, or an object that no command goes to and that has no secondary of its own.
pub(super) fn answers(tables: &Tables, component: &ComponentTable) -> Vec<Vec<u32>> {
    let is_of_another = |event: &u32| {
        let sender = &tables.events[*event as usize].event.sender;
        *sender != component.object && tables.components.iter().any(|other| other.object == *sender)
    };
    let mut answers = vec![Vec::new(); component.commands.len()];
    let steps = tables.super_steps.source.iter().zip(&tables.super_steps.target);
    for (&code, (&source, &target)) in component.codes.iter().zip(steps).filter(|(code, _)| **code != 0) {
        let before = &tables.owed[source as usize];
        let new = tables.owed[target as usize].iter().filter(|event| !before.contains(event));
        answers[code as usize - 1].extend(new.copied().filter(|event| !is_of_another(event)));
    }
    for events in &mut answers {
        events.sort_unstable();
        events.dedup();
    }
    answers
}

/// What counts of an entry: where a line was broken does not.
fn bare(entry: &str) -> String {
    entry.split_whitespace().collect()
}

/// A line without the marks of a comment around it.
fn uncommented(line: &str) -> &str {
    let line = line.trim_start_matches('\u{feff}').trim();
    let line = line.strip_prefix("(*").or_else(|| line.strip_prefix("//")).unwrap_or(line);
    line.strip_suffix("*)").unwrap_or(line).trim()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn template(entries: &[&str]) -> Template {
        let interface = Interface::new(entries.iter().map(|&entry| entry.to_owned()).collect());
        let text = interface.lines().map(|line| format!("(* {line} *)\n")).collect();
        Template { object: "arm".to_owned(), file: "arm.st".to_owned(), text, interface }
    }

    /// `text` in the file of a template for `a` and `b b`.
    #[track_caller]
    fn check(text: &str, expected: Option<&Stale>) {
        assert_eq!(template(&["a", "b b"]).stale(text).as_ref(), expected, "{text}");
    }

    fn changed(new: &[&str], gone: &[&str]) -> Stale {
        let [new, gone] = [new, gone].map(|list| list.iter().map(|&entry| entry.to_owned()).collect());
        Stale::Changed { new, gone }
    }

    #[test]
    fn what_is_written_is_not_stale() {
        let text = template(&["a", "b b"]).text;
        check(&text, None);
        check(&format!("(* Mine. *)\n\n{text}\nFUNCTION_BLOCK x"), None);
        check(&text.replace("(*", "//").replace(" *)", ""), None);
        check(&text.replace("(* - b b *)", "  (* - b *)\r\n(*\tb   *)"), None);
    }

    #[test]
    fn changes_are_named() {
        check(&template(&["a"]).text, Some(&changed(&["b b"], &[])));
        check(&template(&["a", "b b", "c"]).text, Some(&changed(&[], &["c"])));
        check(&template(&["a", "b c"]).text, Some(&changed(&["b b"], &["b c"])));
        check(&template(&[]).text, Some(&changed(&["a", "b b"], &[])));
        check(&template(&["b b", "a"]).text, Some(&changed(&[], &[])));
    }

    #[test]
    fn heads_that_say_nothing() {
        for text in [
            "",
            "FUNCTION_BLOCK x",
            "(* Interface *)",
            "(* Interface 0123456789abcdeg, *)",
            "(* Interface é *)",
        ] {
            check(text, Some(&Stale::Unknown));
        }
    }

    #[test]
    fn the_fingerprint_decides() {
        let other = template(&["x"]).interface.fingerprint();
        let text = template(&["a", "b b"]).text;
        let own = template(&["a", "b b"]).interface.fingerprint();
        check(&text.replace(&own, &other), Some(&changed(&[], &[])));
        check(&format!("(* Interface {own} *)"), Some(&changed(&["a", "b b"], &[])));
    }

    #[test]
    fn the_list_has_to_be_that_of_the_fingerprint() {
        let text = template(&["a", "b b"]).text;
        check(&text.replace("- a", "- c"), Some(&changed(&["a"], &["c"])));
        check(&text.replace("(* - a *)\n", ""), Some(&changed(&["a"], &[])));
    }

    #[test]
    fn templates_are_known_by_their_heads() {
        let text = template(&["a"]).text;
        assert!(is_template(&format!("(* Mine. *)\n(* Secondary of arm, to be filled in *)\n{text}")));
        assert!(is_template(&format!("\u{feff}// Secondary of arm, to be filled in\n{text}")));
        assert!(!is_template(&text) && !is_template("(* Secondary of arm *)"));
    }
}

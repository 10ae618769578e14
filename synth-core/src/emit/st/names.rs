//! Identifiers of Structured Text, and the map from events and commands to them.
//!
//! Everything that a text names shares one name space, although blocks have scopes of their own: strict compilers
//! confuse a variable with a type or a block of its name. Identifiers do not distinguish case.

use std::collections::BTreeSet;

use super::Target;
use super::dialect::{IDENTIFIER_LIMIT, Words};
use super::owed::OWED;
use crate::controller::tables::Tables;
use crate::emit::names::identifier;

/// What the text of a controller calls things; made for people and tools, see `sml names`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct NameMap {
    /// The target's name.
    pub target: &'static str,
    /// The function block.
    pub function_block: String,
    /// The program.
    pub program: String,
    /// The output with the number of the state.
    pub state: String,
    /// What the events that the environment owes are in, if that is asked for.
    pub owed: String,
    /// Every event's text and input, in table order.
    pub events: Vec<(String, String)>,
    /// In order of the objects' names.
    pub components: Vec<ComponentNames>,
}

/// The names of a component.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ComponentNames {
    /// Its object.
    pub object: String,
    /// Its output.
    pub output: String,
    /// Its secondary: the function block of the template, or the trait.
    pub secondary: String,
    /// The file of the template, without a folder.
    pub file: String,
    /// The event text of every command and its code, ascending from 1.
    pub codes: Vec<(String, u32)>,
}

impl NameMap {
    pub(super) fn new(tables: &Tables, target: Target, names: &Names) -> NameMap {
        let events = tables.events.iter().zip(&names.events);
        let components = tables.components.iter().zip(&names.components);
        NameMap {
            target: target.name(),
            function_block: names.function_block.clone(),
            program: names.program.clone(),
            state: STATE_NO.to_owned(),
            owed: OWED.to_owned(),
            events: events.map(|(table, name)| (table.event.text.clone(), name.input.clone())).collect(),
            components: components
                .zip(&names.secondaries)
                .map(|((table, name), secondary)| ComponentNames {
                    object: table.object.clone(),
                    output: name.output.clone(),
                    secondary: secondary.function_block.clone(),
                    file: secondary.file.clone(),
                    codes: table.commands.iter().map(|command| command.text.clone()).zip(1..).collect(),
                })
                .collect(),
        }
    }
}

/// The output with the number of the state.
pub(super) const STATE_NO: &str = "state_no";

/// The primary beside the instances of secondaries, in comments.
pub(super) const PRIMARY: &str = "primary";

/// The text's own names, those of the fixed interface first.
const OWN: &[&str] = &[
    "enable",
    "reset",
    STATE_NO,
    "pending",
    "unexpected",
    "overrun",
    "changed",
    "controller",
    "done",
    "due",
    "event",
    "event_base",
    "event_run",
    "first",
    "first_row",
    "index",
    "last",
    "last_row",
    "middle",
    "kept",
    "next",
    "owed",
    "owed_event",
    "owed_first",
    "owed_row",
    "owed_set",
    "previous",
    PRIMARY,
    "raised",
    "row",
    "run_row",
    "run_state",
    "source",
    "state",
    "stopped",
    "table_version",
    "target",
    "Config0",
    "Res0",
    "PLC",
    "Cyclic",
    "Main0",
];

/// The identifiers of an event.
#[derive(Debug)]
pub(super) struct EventNames {
    pub(super) input: String,
    pub(super) source: String,
    pub(super) target: String,
}

/// The identifiers of a component.
#[derive(Debug)]
pub(super) struct OutputNames {
    pub(super) output: String,
    /// The array of its codes.
    pub(super) codes: String,
}

/// The names of a component's secondary.
#[derive(Debug)]
pub(super) struct SecondaryNames {
    /// The template's function block.
    pub(super) function_block: String,
    /// The template's file.
    pub(super) file: String,
    /// An instance, in comments.
    pub(super) instance: String,
}

/// All identifiers that depend on the controller.
#[derive(Debug)]
pub(super) struct Names {
    pub(super) function_block: String,
    pub(super) program: String,
    pub(super) events_type: String,
    /// The function that searches, where there is one.
    pub(super) search: String,
    /// What holds the program, where that is a block of the project.
    pub(super) data_block: String,
    /// What runs it there.
    pub(super) organization_block: String,
    pub(super) events: Vec<EventNames>,
    pub(super) components: Vec<OutputNames>,
    /// Per component.
    pub(super) secondaries: Vec<SecondaryNames>,
}

impl Names {
    /// Names everything: the interface first, so that only internal names give way to it.
    pub(super) fn new(tables: &Tables, target: Target) -> Names {
        let mut scope = Scope::new(target.dialect().words, OWN);
        let specification = identifier(&tables.specification);
        let function_block = scope.claim(&specification, "_Controller");
        let program = scope.claim(&specification, "_Main");
        let events_type = scope.claim(&specification, "_Events");
        let inputs: Vec<_> =
            tables.events.iter().map(|table| scope.claim(&identifier(&table.event.text), "")).collect();
        let outputs: Vec<_> =
            tables.components.iter().map(|table| scope.claim(&identifier(&table.object), "_cmd")).collect();
        let events = inputs
            .into_iter()
            .map(|input| EventNames {
                source: scope.claim(&input, "_source"),
                target: scope.claim(&input, "_target"),
                input,
            })
            .collect();
        let components = tables
            .components
            .iter()
            .zip(outputs)
            .map(|(table, output)| OutputNames {
                codes: scope.claim(&identifier(&table.object), "Target"),
                output,
            })
            .collect();
        let search = scope.claim(&specification, "_BinarySearch");
        let secondaries = tables
            .components
            .iter()
            .map(|table| {
                let object = identifier(&table.object);
                let function_block = scope.claim(&format!("{specification}_{object}"), "");
                let file = format!("{function_block}.{}", target.dialect().frame.extension());
                SecondaryNames { function_block, file, instance: scope.claim(&object, "") }
            })
            .collect();
        Names {
            function_block,
            program,
            events_type,
            search,
            data_block: scope.claim(&specification, "_Main_DB"),
            organization_block: scope.claim(&specification, "_Cyclic"),
            events,
            components,
            secondaries,
        }
    }
}

/// What runs the program.
pub(super) struct Runner<'a> {
    pub(super) program: &'a str,
    /// What holds the program, where that is a block of the project.
    pub(super) data_block: &'a str,
    /// What runs it there.
    pub(super) organization_block: &'a str,
}

impl Names {
    /// What runs the program.
    pub(super) fn runner(&self) -> Runner<'_> {
        let Names { program, data_block, organization_block, .. } = self;
        Runner { program, data_block, organization_block }
    }
}

/// The names in use, in capitals.
pub(super) struct Scope {
    used: BTreeSet<String>,
    words: &'static Words,
    limit: usize,
}

impl Scope {
    /// A scope of a target with these words, in which some names are used already.
    pub(super) fn new(words: &'static Words, own: &[&str]) -> Scope {
        let own = own.iter().map(|name| name.to_ascii_uppercase());
        Scope { used: own.chain(words.iter().map(str::to_owned)).collect(), words, limit: IDENTIFIER_LIMIT }
    }

    /// `base` + `suffix`, shortened to the limit, with `_2`, `_3`, … where that is taken or reserved.
    pub(super) fn claim(&mut self, base: &str, suffix: &str) -> String {
        for number in 1u64.. {
            let tail = if number == 1 { suffix.to_owned() } else { format!("{suffix}_{number}") };
            let name = shortened(base, self.limit - tail.len()) + &tail;
            let capitals = name.to_ascii_uppercase();
            if !self.words.is_conversion(&capitals) && self.used.insert(capitals) {
                return name;
            }
        }
        unreachable!("there are more numbers than names")
    }
}

/// At most `limit` characters: who acts stands at the start of a name and what happens at its end, so the middle
/// goes. `name` is ASCII.
fn shortened(name: &str, limit: usize) -> String {
    if name.len() <= limit {
        return name.to_owned();
    }
    let head = (limit - 1) / 2;
    let tail = limit - 1 - head;
    format!("{}_{}", name[..head].trim_end_matches('_'), name[name.len() - tail..].trim_start_matches('_'))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clashes_ignore_case_and_skip_taken_numbers() {
        let mut scope = Scope::new(Target::Iec.dialect().words, OWN);
        assert_eq!(scope.claim("a_b", ""), "a_b");
        assert_eq!(scope.claim("a_b_2", ""), "a_b_2");
        assert_eq!(scope.claim("A_B", ""), "A_B_3");
        assert_eq!(scope.claim("a", "_B"), "a_B_4");
    }

    #[test]
    fn reserved_and_own_words_give_way() {
        let mut scope = Scope::new(Target::Iec.dialect().words, OWN);
        assert_eq!(scope.claim("end_if", ""), "end_if_2");
        assert_eq!(scope.claim("Ton", ""), "Ton_2");
        assert_eq!(scope.claim("int_to_real", ""), "int_to_real_2");
        assert_eq!(scope.claim("Pending", ""), "Pending_2");
        assert_eq!(scope.claim("plc", ""), "plc_2");
    }

    /// Every word of every target, as the text of an event, of a command's object, and of the specification.
    #[test]
    fn no_name_is_a_word_of_the_target() {
        for target in Target::ALL {
            let words = target.dialect().words;
            assert!(words.iter().count() > 200, "{}", target.name());
            let mut scope = Scope::new(words, OWN);
            let mut given = BTreeSet::new();
            for word in words.iter() {
                for spelling in [word.to_owned(), word.to_lowercase()] {
                    let name = scope.claim(&identifier(&spelling), "");
                    assert!(name.starts_with(&identifier(&spelling)), "{name} is readable");
                    assert!(!words.iter().any(|other| other.eq_ignore_ascii_case(&name)), "{name}");
                    assert!(given.insert(name.to_ascii_uppercase()), "{name} twice");
                }
            }
        }
    }

    #[test]
    fn words_of_other_targets_are_free() {
        let name = |target: Target, word: &str| Scope::new(target.dialect().words, OWN).claim(word, "");
        for (word, target) in [
            ("persistent", Target::Codesys),
            ("interface", Target::Twincat),
            ("pvoid", Target::Twincat),
            ("region", Target::Siemens),
            ("to_int", Target::Codesys),
            ("dint_to_ltime", Target::Siemens),
        ] {
            assert_eq!(name(target, word), format!("{word}_2"), "{}", target.name());
            assert_eq!(name(Target::Iec, word), word);
            assert_eq!(name(Target::Case, word), word);
        }
        assert_eq!(name(Target::Codesys, "pvoid"), "pvoid");
        assert_eq!(name(Target::Siemens, "persistent"), "persistent");
    }

    #[test]
    fn long_names_keep_both_ends() {
        let mut scope = Scope { limit: 20, ..Scope::new(Target::Iec.dialect().words, OWN) };
        let long = "feedArm_controller_arrivedAt_press";
        assert_eq!(scope.claim(long, ""), "feedArm_c_edAt_press");
        assert_eq!(scope.claim(long, ""), "feedArm_dAt_press_2");
        assert_eq!(scope.claim(long, "_source"), "feedAr_press_source");
        assert_eq!(shortened("ab_cdefgh", 7), "ab_fgh");
    }
}

//! The machines that are compared: one controller, written in several ways, each as well as it can be.
//!
//! Every module has the same interface, which `firmware/player` calls:
//!
//! ```text
//! pub enum Event { … }     pub struct Commands { … }     pub type Machine = …;
//! pub fn new() -> Machine
//! pub fn event(number: u8) -> Option<Event>
//! pub fn step(machine: &mut Machine, event: Event) -> Option<Commands>
//! ```
//!
//! `step` goes to the state after the super step and returns its commands, or changes nothing and returns `None`.

mod dense;
mod items;
mod matching;
mod own;
mod smlang;
mod statig;

use super::subject::Subject;
use synth_core::emit::rust::Engine;

/// A way to write a machine.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Machine {
    /// Of this project.
    Own(Engine),
    Match,
    Smlang,
    Statig,
    Dense,
}

/// In the order of the tables.
pub(crate) const ALL: [Machine; 7] = [
    Machine::Own(Engine::Search),
    Machine::Own(Engine::Runs),
    Machine::Own(Engine::Comb),
    Machine::Match,
    Machine::Smlang,
    Machine::Statig,
    Machine::Dense,
];

impl Machine {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Machine::Own(engine) => engine.name(),
            Machine::Match => "match",
            Machine::Smlang => "smlang",
            Machine::Statig => "statig",
            Machine::Dense => "dense",
        }
    }

    /// Whether it is of this project.
    pub(crate) fn is_own(self) -> bool {
        matches!(self, Machine::Own(_))
    }

    /// The module.
    pub(super) fn source(self, subject: &Subject) -> String {
        match self {
            Machine::Own(engine) => own::source(subject, engine),
            Machine::Match => matching::source(subject),
            Machine::Smlang => smlang::source(subject),
            Machine::Statig => statig::source(subject),
            Machine::Dense => dense::source(subject),
        }
    }
}

/// The machine of a name.
pub(crate) fn by_name(name: &str) -> Result<Machine, String> {
    let known = || ALL.map(Machine::name).join(", ");
    ALL.into_iter()
        .find(|machine| machine.name() == name)
        .ok_or_else(|| format!("the machines are {}", known()))
}

/// What a program has around its machine: `step` refuses everything.
pub(super) fn nothing(subject: &Subject) -> String {
    format!(
        "{}
pub struct Machine;
pub fn new() -> Machine {{ Machine }}
#[inline(never)]
pub fn step(machine: &mut Machine, event: Event) -> Option<Commands> {{
    core::hint::black_box((machine, event));
    None
}}
",
        items::items(subject, "Copy, Clone")
    )
}

#[cfg(test)]
mod tests {
    use super::{ALL, Subject, by_name, nothing};

    #[test]
    fn names_are_known() {
        for machine in ALL {
            assert_eq!(by_name(machine.name()), Ok(machine));
        }
        assert!(by_name("other").unwrap_err().ends_with("match, smlang, statig, dense"));
    }

    #[test]
    fn every_machine_is_rust_with_the_interface() {
        let subject = Subject::new(50);
        for source in ALL.map(|machine| machine.source(&subject)).into_iter().chain([nothing(&subject)]) {
            let file = syn::parse_file(&source).expect("Rust");
            let functions = file.items.iter().filter_map(|item| match item {
                syn::Item::Fn(function) => Some(function.sig.ident.to_string()),
                _ => None,
            });
            let mut functions: Vec<_> =
                functions.filter(|name| ["event", "new", "step"].contains(&name.as_str())).collect();
            functions.sort();
            assert_eq!(functions, ["event", "new", "step"]);
        }
    }
}

//! Every name of the generated module, given once so that none clash.
//!
//! A Rust keyword gets `_2` like any clash; names in camel case get `2`, which keeps their case.

use proc_macro2::{Ident, Span};

use super::case::{camel, numbered_camel, screaming, snake};
use crate::controller::Event;
use crate::controller::tables::{ComponentTable, Tables};
use crate::emit::names::{Namer, identifier};

/// Names of one controller.
pub(super) struct Idents {
    /// The module.
    pub(super) module: Ident,
    /// Per event the variant of `Event`.
    pub(super) events: Vec<Ident>,
    /// Per component.
    pub(super) components: Vec<ComponentIdents>,
}

/// Names of a component.
pub(super) struct ComponentIdents {
    /// Enum of its commands.
    pub(super) command: Ident,
    /// Trait of its secondary.
    pub(super) secondary: Ident,
    /// Field of `Commands`, and parameter of `dispatch`.
    pub(super) field: Ident,
    /// Static of its codes.
    pub(super) codes: Ident,
    /// Per command, without sender and receiver.
    pub(super) commands: Vec<CommandIdents>,
}

/// Names of a command.
pub(super) struct CommandIdents {
    /// Variant of the command enum.
    pub(super) variant: Ident,
    /// Method of the secondary.
    pub(super) method: Ident,
}

impl Idents {
    pub(super) fn new(tables: &Tables) -> Self {
        let mut types = camel_namer();
        let mut statics = Namer::new(is_own_static);
        let mut fields = snake_namer();
        let commands: Vec<Ident> = tables
            .components
            .iter()
            .map(|component| {
                ident(&types.name(&camel(&identifier(&format!("{}_command", component.object)))))
            })
            .collect();
        let mut variants = camel_namer();
        let events = tables.events.iter();
        let events =
            events.map(|table| ident(&variants.name(&camel(&identifier(&table.event.text))))).collect();
        let components = tables
            .components
            .iter()
            .zip(commands)
            .map(|(table, command)| component(table, command, &mut types, &mut statics, &mut fields))
            .collect();
        let module = ident(&snake_namer().name(&snake(&identifier(&tables.specification))));
        Idents { module, events, components }
    }
}

fn component(
    table: &ComponentTable,
    command: Ident,
    types: &mut Namer,
    statics: &mut Namer,
    fields: &mut Namer,
) -> ComponentIdents {
    let object = identifier(&table.object);
    let mut variants = camel_namer();
    let mut methods = snake_namer();
    let commands = table
        .commands
        .iter()
        .map(|event| {
            let name = operation(event);
            CommandIdents {
                variant: ident(&variants.name(&camel(&name))),
                method: ident(&methods.name(&snake(&name))),
            }
        })
        .collect();
    ComponentIdents {
        command,
        secondary: ident(&types.name(&camel(&object))),
        field: ident(&fields.name(&snake(&object))),
        codes: ident(&statics.name(&screaming(&format!("{object}_target")))),
        commands,
    }
}

/// `moveTo(press)` → `moveTo_press`: a component's own commands need no more.
fn operation(event: &Event) -> String {
    identifier(&format!("{}({})", event.operation, event.arguments.join(", ")))
}

pub(super) fn ident(name: &str) -> Ident {
    Ident::new(name, Span::call_site())
}

pub(super) fn camel_namer() -> Namer {
    Namer::new(is_own_type).numbered(numbered_camel)
}

fn snake_namer() -> Namer {
    Namer::new(is_keyword)
}

/// Types of every generated module; `Self` is a keyword and `ALL` in no danger.
fn is_own_type(name: &str) -> bool {
    matches!(name, "Commands" | "Controller" | "Event" | "Saved" | "Self" | "Tables")
}

/// Statics of every generated module.
fn is_own_static(name: &str) -> bool {
    matches!(
        name,
        "COMB"
            | "COMMAND_SET"
            | "EVENTS"
            | "FORMAT_VERSION"
            | "OWED"
            | "OWED_SET"
            | "ROWS"
            | "RUNS"
            | "SUPER_STEPS"
    )
}

/// Keywords of every edition, reserved ones too; those in snake case, since nothing else is asked.
pub(super) fn is_keyword(name: &str) -> bool {
    matches!(
        name,
        "abstract"
            | "as"
            | "async"
            | "await"
            | "become"
            | "box"
            | "break"
            | "const"
            | "continue"
            | "crate"
            | "do"
            | "dyn"
            | "else"
            | "enum"
            | "extern"
            | "false"
            | "final"
            | "fn"
            | "for"
            | "gen"
            | "if"
            | "impl"
            | "in"
            | "let"
            | "loop"
            | "macro"
            | "match"
            | "mod"
            | "move"
            | "mut"
            | "override"
            | "priv"
            | "pub"
            | "ref"
            | "return"
            | "self"
            | "static"
            | "struct"
            | "super"
            | "trait"
            | "true"
            | "try"
            | "type"
            | "typeof"
            | "unsafe"
            | "unsized"
            | "use"
            | "virtual"
            | "where"
            | "while"
            | "yield"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keywords_are_never_names() {
        assert_eq!(snake_namer().name("move"), "move_2");
        assert_eq!(camel_namer().name("Self"), "Self2");
        assert_eq!(camel_namer().name("Event"), "Event2");
    }
}

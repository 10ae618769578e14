//! Templates of secondaries: a type per component that implements its trait and does nothing yet.

use std::fmt::Write as _;

use super::docs::code;
use super::idents::{ComponentIdents, Idents};
use crate::controller::tables::{ComponentTable, Tables};
use crate::emit::template::{Interface, Template, answers};

/// A template for every component.
pub(super) fn templates(tables: &Tables, idents: &Idents) -> Vec<Template> {
    let components = tables.components.iter().zip(&idents.components);
    components.map(|(table, names)| template(tables, idents, table, names)).collect()
}

/// The name of the template's file.
pub(super) fn file(names: &ComponentIdents) -> String {
    format!("{}.rs", names.field)
}

fn template(tables: &Tables, idents: &Idents, table: &ComponentTable, names: &ComponentIdents) -> Template {
    let (module, secondary) = (&idents.module, &names.secondary);
    let variants: Vec<String> = idents.events.iter().map(ToString::to_string).collect();
    let sent: Vec<usize> =
        (0..variants.len()).filter(|&event| tables.events[event].event.sender == table.object).collect();
    let interface = {
        let methods = table.commands.iter().zip(&names.commands);
        let methods = methods.map(|(command, names)| format!("method {}: {}", names.method, command.text));
        let events = sent
            .iter()
            .map(|&event| format!("event {}: {}", variants[event], tables.events[event].event.text));
        Interface::new(
            std::iter::once(format!("trait {module}::{secondary}")).chain(methods).chain(events).collect(),
        )
    };
    let object = code(&table.object);
    let mut text = head(tables, &object, &interface);
    let event = if sent.is_empty() { "" } else { ", Event" };
    let _ = write!(
        text,
        "\n// Where the generated module is.\nuse crate::{module}::{{self{event}}};\n\n\
         /// Secondary of {object}.\n#[derive(Debug, Default)]\npub struct {secondary};\n\n\
         impl {module}::{secondary} for {secondary} {{\n"
    );
    let answers = answers(tables, table);
    for ((command, names), answers) in table.commands.iter().zip(&names.commands).zip(answers) {
        let _ = writeln!(text, "    /// {}", code(&command.text));
        for event in answers.into_iter().map(|event| event as usize).filter(|event| sent.contains(event)) {
            let _ = writeln!(text, "    ///\n    /// Then [`Event::{}`] is owed.", variants[event]);
        }
        let _ = writeln!(
            text,
            "    fn {}(&mut self) {{\n        // To be filled in: start it.\n    }}\n",
            names.method
        );
    }
    close(&mut text);
    if !sent.is_empty() {
        let _ = write!(
            text,
            "\nimpl {secondary} {{\n    /// What the sensors tell, for `Controller::raise` before a cycle.\n    \
             pub fn sense(&mut self) -> Option<Event> {{\n        // To be filled in.\n        None\n    }}\n}}\n"
        );
    }
    Template { object: table.object.clone(), file: file(names), text, interface }
}

fn head(tables: &Tables, object: &str, interface: &Interface) -> String {
    let (version, file) = (env!("CARGO_PKG_VERSION"), &tables.provenance.file);
    let mut text = format!(
        "// Secondary of {object}, to be filled in: how it does what the controller commands.\n\
         // Written once by `sml` {version} from {}; never overwritten.\n//\n",
        code(&file.split_whitespace().collect::<Vec<_>>().join(" "))
    );
    for line in interface.lines() {
        let _ = writeln!(text, "// {line}");
    }
    text
}

/// Ends a block whose last item is followed by an empty line.
fn close(text: &mut String) {
    text.truncate(text.trim_end().len());
    text.push_str("\n}\n");
}

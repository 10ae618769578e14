//! Documentation of the generated module: origin, costs, requirements, and a diagram of small controllers.

use std::fmt::Write as _;

use proc_macro2::TokenStream;
use quote::quote;

use super::Options;
use super::controller::Bounds;
use super::engine::Rows;
use crate::controller::Level;
use crate::controller::tables::{Requirement, Tables};
use crate::diagnostic::counted;

/// Controllers of more states get no diagram: nobody could read it.
const MAX_DIAGRAM_STATES: u32 = 24;

/// Diagrams of more arrows neither.
const MAX_DIAGRAM_ROWS: usize = 96;

/// Text as inline code, for names and event texts.
pub(super) fn code(text: &str) -> String {
    format!("`{}`", text.replace('`', "'"))
}

/// The module's doc attributes.
pub(super) fn module(tables: &Tables, options: &Options, engine: &dyn Rows) -> TokenStream {
    let name = code(&tables.specification);
    let mut text = if tables.provenance.monitor {
        format!("Monitor {name}: which events are expected. It gives no commands.\n")
    } else {
        format!("Controller of the specification {name}.\n")
    };
    costs(&mut text, tables, options, engine);
    level(&mut text, tables.provenance.level);
    requirements(&mut text, &tables.provenance.requirements);
    diagram(&mut text, tables);
    let lines = text.lines().map(|line| if line.is_empty() { String::new() } else { format!(" {line}") });
    quote!(#(#[doc = #lines])*)
}

fn costs(text: &mut String, tables: &Tables, options: &Options, engine: &dyn Rows) {
    let events = tables.events.len();
    let (event, step) = engine.probes();
    let cycle = Bounds::new(tables, engine).cycle;
    let rows = tables.events.iter().map(|table| table.mapping.source.len()).sum::<usize>();
    let _ = write!(
        text,
        "\n{}, {} with {}, {}.\n\n\
         Looking up an event takes at most {} of its table, a super step {step}.",
        counted(tables.states as usize, "state"),
        counted(events, "environment event"),
        counted(rows, "row"),
        counted(tables.super_steps.source.len(), "super step"),
        counted(event as usize, "probe"),
    );
    if !options.ordered {
        let _ = write!(text, " A cycle takes at most {}.", counted(cycle as usize, "probe"));
    }
    text.push('\n');
}

/// What a controller minimised by don't-cares needs of the program.
fn level(text: &mut String, level: Level) {
    text.push_str(match level {
        Level::None | Level::Exact => return,
        Level::Assume => {
            "\nMinimised by what cannot be pending together (`--minimize assume`): events that the assumptions exclude may be \
             taken for others.\n"
        }
        Level::Ordered => {
            "\nMinimised for one event at a time (`--minimize ordered`): events must be given in the order in which they \
             happened, and each only when the commands of the one before are issued. Events that the assumptions exclude may be \
             taken for others.\n"
        }
    });
}

fn requirements(text: &mut String, requirements: &[Requirement]) {
    if requirements.is_empty() {
        return;
    }
    text.push_str("\n# Requirements\n\n");
    for requirement in requirements {
        let Requirement { scenario, kind, line, .. } = requirement;
        let _ = match line {
            0 => write!(text, "- {} ({kind})", code(scenario)),
            line => write!(text, "- {} ({kind}, line {line})", code(scenario)),
        };
        let prose = requirement.text.join(" ");
        let mut words = prose.split_whitespace().peekable();
        if words.peek().is_some() {
            text.push(':');
        }
        for word in words {
            text.push(' ');
            escape(text, word);
        }
        text.push('\n');
    }
}

/// Appends prose so that Markdown takes none of it as markup.
fn escape(text: &mut String, prose: &str) {
    for character in prose.chars() {
        if matches!(
            character,
            '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '#' | '~' | '|' | '&' | '$' | '!'
        ) {
            text.push('\\');
        }
        text.push(character);
    }
}

/// A Mermaid state diagram: events on the arrows, commands after a slash.
fn diagram(text: &mut String, tables: &Tables) {
    let rows = tables.events.iter().map(|table| table.mapping.source.len()).sum::<usize>();
    if tables.states > MAX_DIAGRAM_STATES || rows + tables.super_steps.source.len() > MAX_DIAGRAM_ROWS {
        return;
    }
    let _ = write!(text, "\n# States\n\n```mermaid\nstateDiagram-v2\n    [*] --> {}\n", tables.initial);
    for table in &tables.events {
        for (source, target) in table.mapping.source.iter().zip(&table.mapping.target) {
            let _ = writeln!(text, "    {source} --> {target} : {}", table.event.text);
        }
    }
    for (row, (source, target)) in
        tables.super_steps.source.iter().zip(&tables.super_steps.target).enumerate()
    {
        let commands = tables.components.iter().filter_map(|component| {
            let code = *component.codes.get(row)? as usize;
            Some(component.commands.get(code.checked_sub(1)?)?.text.as_str())
        });
        let _ = writeln!(text, "    {source} --> {target} : / {}", commands.collect::<Vec<_>>().join(", "));
    }
    text.push_str("```\n");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(lines: &[&str], expected: &str) {
        let requirement = Requirement {
            scenario: "Line.Deliver".into(),
            kind: "guarantee",
            text: lines.iter().map(|&line| line.to_owned()).collect(),
            file: "specs/line.sml".into(),
            line: 7,
        };
        let mut text = String::new();
        requirements(&mut text, &[requirement]);
        assert_eq!(text, format!("\n# Requirements\n\n- `Line.Deliver` (guarantee, line 7){expected}\n"));
    }

    #[test]
    fn requirement_texts() {
        check(&[], "");
        check(&[" Blanks come", " one by one."], ": Blanks come one by one.");
        check(&["\ta [b](c) <d> *e*"], r": a \[b\](c) \<d\> \*e\*");
    }
}

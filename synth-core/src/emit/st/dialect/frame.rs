//! What stands around declarations and statements: types, heads of units, and what runs the program.

use crate::emit::st::names::{Names, Runner};
use crate::emit::st::program::configuration;
use crate::emit::st::unit::{Item, Kind, Section, Type, Unit, Value};
use crate::emit::st::writer::Writer;

/// The units of a language.
pub(in crate::emit::st) trait Frame: Sync {
    /// Whether local names are marked `#` in statements.
    fn marks_locals(&self) -> bool;

    /// The longest line of numbers, in characters. Nobody reads them, so the fewer lines the better.
    fn numbers_limit(&self) -> usize;

    /// The section of variables that holds arrays that never change.
    fn constants(&self) -> &'static str;

    /// Declares the type of `pending`, an array, if it needs a declaration.
    fn declare_events(&self, out: &mut Writer, names: &Names, array: &Type);

    /// The type of `pending`, an array.
    fn events_type(&self, names: &Names, array: Type) -> Type;

    /// A function block or program used as a type.
    fn block_type(&self, name: &str) -> Type;

    /// The function block that waits.
    fn timer(&self) -> &'static str;

    /// Whether a text with other characters than those of ASCII needs a byte order mark.
    fn marks_bytes(&self) -> bool;

    /// How the names of files end.
    fn extension(&self) -> &'static str;

    /// A unit, an empty line last.
    fn unit(&self, out: &mut Writer, unit: &Unit<'_>);

    /// Runs the program every 10 ms.
    fn configuration(&self, out: &mut Writer, runner: &Runner<'_>);
}

/// A section of variables.
fn section(out: &mut Writer, section: &Section) {
    out.block(section.keyword, "END_VAR", |out| {
        for item in &section.items {
            match item {
                Item::Comment(text) => out.comment(text),
                Item::Variable { name, of, initial: None } => out.line(format_args!("{name} : {of};")),
                Item::Variable { name, of, initial: Some(Value::Simple(value)) } => {
                    out.line(format_args!("{name} : {of} := {value};"));
                }
                Item::Variable { name, of, initial: Some(Value::Array(values)) } => {
                    out.array(format_args!("{name} : {of} :="), values);
                }
            }
        }
    });
}

/// The units of the standard.
pub(super) struct Standard;

impl Frame for Standard {
    fn marks_locals(&self) -> bool {
        false
    }

    fn numbers_limit(&self) -> usize {
        // Compilers that read a line at a time into a buffer give it a thousand characters.
        400
    }

    fn constants(&self) -> &'static str {
        "VAR CONSTANT"
    }

    fn declare_events(&self, out: &mut Writer, names: &Names, array: &Type) {
        // Strict compilers assign only arrays whose type has a name.
        out.block("TYPE", "END_TYPE", |out| {
            out.line(format_args!("{} : {array};", names.events_type));
        });
        out.gap();
    }

    fn events_type(&self, names: &Names, _: Type) -> Type {
        Type::Derived(names.events_type.clone())
    }

    fn block_type(&self, name: &str) -> Type {
        Type::Derived(name.to_owned())
    }

    fn timer(&self) -> &'static str {
        "TON"
    }

    fn marks_bytes(&self) -> bool {
        false
    }

    fn extension(&self) -> &'static str {
        "st"
    }

    fn unit(&self, out: &mut Writer, unit: &Unit<'_>) {
        if let Some(comment) = unit.comment {
            out.comment(comment);
        }
        let (keyword, name) = (unit.kind.keyword(), unit.name);
        match &unit.kind {
            Kind::Function(returned) => out.line(format_args!("{keyword} {name} : {returned}")),
            Kind::FunctionBlock | Kind::Program => out.line(format_args!("{keyword} {name}")),
        }
        for variables in &unit.declarations.sections {
            section(out, variables);
        }
        out.gap();
        (unit.body)(out);
        out.line(format_args!("END_{keyword}"));
        out.gap();
    }

    fn configuration(&self, out: &mut Writer, runner: &Runner<'_>) {
        use configuration::{INSTANCE, INTERVAL_MS, NAME, PRIORITY, RESOURCE, TASK};
        out.block(format_args!("CONFIGURATION {NAME}"), "END_CONFIGURATION", |out| {
            out.block(format_args!("RESOURCE {RESOURCE} ON PLC"), "END_RESOURCE", |out| {
                out.line(format_args!("TASK {TASK}(INTERVAL := T#{INTERVAL_MS}ms, PRIORITY := {PRIORITY});"));
                out.line(format_args!("PROGRAM {INSTANCE} WITH {TASK} : {};", runner.program));
            });
        });
    }
}

/// The units of SCL.
///
/// A data type of its own is always a structure there, so `pending` is an array without a name. Organization blocks have
/// neither inputs nor outputs, so the program is a function block, with an instance that one of them calls.
pub(super) struct Scl;

impl Frame for Scl {
    fn marks_locals(&self) -> bool {
        true
    }

    fn numbers_limit(&self) -> usize {
        // That of the sources of STEP 7.
        200
    }

    // There are no constant arrays.
    fn constants(&self) -> &'static str {
        "VAR"
    }

    fn declare_events(&self, _: &mut Writer, _: &Names, _: &Type) {}

    fn events_type(&self, _: &Names, array: Type) -> Type {
        array
    }

    fn block_type(&self, name: &str) -> Type {
        Type::Derived(quoted(name))
    }

    fn timer(&self) -> &'static str {
        "TON_TIME"
    }

    // TIA Portal reads sources without one in the code page of Windows.
    fn marks_bytes(&self) -> bool {
        true
    }

    // External source files of TIA Portal end so.
    fn extension(&self) -> &'static str {
        "scl"
    }

    fn unit(&self, out: &mut Writer, unit: &Unit<'_>) {
        if let Some(comment) = unit.comment {
            out.comment(comment);
        }
        let name = quoted(unit.name);
        let closing = match &unit.kind {
            Kind::Function(returned) => {
                out.line(format_args!("FUNCTION {name} : {returned}"));
                "END_FUNCTION"
            }
            Kind::FunctionBlock | Kind::Program => {
                out.line(format_args!("FUNCTION_BLOCK {name}"));
                "END_FUNCTION_BLOCK"
            }
        };
        out.line("{ S7_Optimized_Access := 'TRUE' }");
        out.line("VERSION : 0.1");
        for variables in &unit.declarations.sections {
            section(out, variables);
        }
        out.gap();
        out.line("BEGIN");
        out.indented(&unit.body);
        out.line(closing);
        out.gap();
    }

    fn configuration(&self, out: &mut Writer, runner: &Runner<'_>) {
        let (instance, task) = (quoted(runner.data_block), quoted(runner.organization_block));
        out.line(format_args!("DATA_BLOCK {instance}"));
        out.line("{ S7_Optimized_Access := 'TRUE' }");
        out.line("VERSION : 0.1");
        out.line(quoted(runner.program));
        out.line("BEGIN");
        out.line("END_DATA_BLOCK");
        out.gap();
        out.line(format_args!("ORGANIZATION_BLOCK {task}"));
        out.line("{ S7_Optimized_Access := 'TRUE' }");
        out.line("VERSION : 0.1");
        out.line("BEGIN");
        out.indented(|out| out.line(format_args!("{instance}();")));
        out.line("END_ORGANIZATION_BLOCK");
    }
}

fn quoted(name: &str) -> String {
    format!("\"{name}\"")
}

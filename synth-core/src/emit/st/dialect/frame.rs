//! What stands around declarations and statements: types, heads of blocks, and what runs the program.

use crate::emit::st::names::Names;
use crate::emit::st::writer::Writer;

/// The blocks of a language.
pub(in crate::emit::st) trait Frame: Sync {
    /// Whether local names are marked `#` in statements.
    fn marks_locals(&self) -> bool;

    /// The section of variables that holds arrays that never change.
    fn constants(&self) -> &'static str;

    /// Declares the type of `pending`, an array up to `last`, if it needs a declaration.
    fn declare_events(&self, out: &mut Writer, names: &Names, last: usize);

    /// The type of `pending`.
    fn events_type(&self, names: &Names, last: usize) -> String;

    /// A function block or program used as a type.
    fn block_type(&self, name: &str) -> String;

    /// The function block that waits.
    fn timer(&self) -> &'static str;

    /// How the names of files end.
    fn extension(&self) -> &'static str;

    /// A function block: its variables, then its statements.
    fn function_block(
        &self,
        out: &mut Writer,
        name: &str,
        variables: &dyn Fn(&mut Writer),
        statements: &dyn Fn(&mut Writer),
    );

    /// A program: its variables, then its statements.
    fn program(
        &self,
        out: &mut Writer,
        name: &str,
        variables: &dyn Fn(&mut Writer),
        statements: &dyn Fn(&mut Writer),
    );

    /// Runs the program every 10 ms.
    fn configuration(&self, out: &mut Writer, names: &Names);
}

/// The blocks of the standard.
pub(super) struct Standard;

impl Frame for Standard {
    fn marks_locals(&self) -> bool {
        false
    }

    fn constants(&self) -> &'static str {
        "VAR CONSTANT"
    }

    fn declare_events(&self, out: &mut Writer, names: &Names, last: usize) {
        // Strict compilers assign only arrays whose type has a name.
        out.block("TYPE", "END_TYPE", |out| {
            out.line(format_args!("{} : ARRAY [0..{last}] OF BOOL;", names.events_type));
        });
        out.gap();
    }

    fn events_type(&self, names: &Names, _: usize) -> String {
        names.events_type.clone()
    }

    fn block_type(&self, name: &str) -> String {
        name.to_owned()
    }

    fn timer(&self) -> &'static str {
        "TON"
    }

    fn extension(&self) -> &'static str {
        "st"
    }

    fn function_block(
        &self,
        out: &mut Writer,
        name: &str,
        variables: &dyn Fn(&mut Writer),
        statements: &dyn Fn(&mut Writer),
    ) {
        unit(out, ["FUNCTION_BLOCK", "END_FUNCTION_BLOCK"], name, variables, statements);
    }

    fn program(
        &self,
        out: &mut Writer,
        name: &str,
        variables: &dyn Fn(&mut Writer),
        statements: &dyn Fn(&mut Writer),
    ) {
        unit(out, ["PROGRAM", "END_PROGRAM"], name, variables, statements);
    }

    fn configuration(&self, out: &mut Writer, names: &Names) {
        out.block("CONFIGURATION Config0", "END_CONFIGURATION", |out| {
            out.block("RESOURCE Res0 ON PLC", "END_RESOURCE", |out| {
                out.line("TASK Cyclic(INTERVAL := T#10ms, PRIORITY := 1);");
                out.line(format_args!("PROGRAM Main0 WITH Cyclic : {};", names.program));
            });
        });
    }
}

fn unit(
    out: &mut Writer,
    [opening, closing]: [&str; 2],
    name: &str,
    variables: &dyn Fn(&mut Writer),
    statements: &dyn Fn(&mut Writer),
) {
    out.line(format_args!("{opening} {name}"));
    variables(out);
    out.gap();
    statements(out);
    out.line(closing);
    out.gap();
}

/// The blocks of SCL.
///
/// A data type of its own is always a structure there, so `pending` is an array without a name. Organization blocks have
/// neither inputs nor outputs, so the program is a function block, with an instance that one of them calls.
pub(super) struct Scl;

impl Frame for Scl {
    fn marks_locals(&self) -> bool {
        true
    }

    // There are no constant arrays.
    fn constants(&self) -> &'static str {
        "VAR"
    }

    fn declare_events(&self, _: &mut Writer, _: &Names, _: usize) {}

    fn events_type(&self, _: &Names, last: usize) -> String {
        format!("ARRAY [0..{last}] OF BOOL")
    }

    fn block_type(&self, name: &str) -> String {
        quoted(name)
    }

    fn timer(&self) -> &'static str {
        "TON_TIME"
    }

    // External source files of TIA Portal end so.
    fn extension(&self) -> &'static str {
        "scl"
    }

    fn function_block(
        &self,
        out: &mut Writer,
        name: &str,
        variables: &dyn Fn(&mut Writer),
        statements: &dyn Fn(&mut Writer),
    ) {
        out.line(format_args!("FUNCTION_BLOCK {}", quoted(name)));
        out.line("{ S7_Optimized_Access := 'TRUE' }");
        out.line("VERSION : 0.1");
        variables(out);
        out.gap();
        out.line("BEGIN");
        out.indented(statements);
        out.line("END_FUNCTION_BLOCK");
        out.gap();
    }

    fn program(
        &self,
        out: &mut Writer,
        name: &str,
        variables: &dyn Fn(&mut Writer),
        statements: &dyn Fn(&mut Writer),
    ) {
        self.function_block(out, name, variables, statements);
    }

    fn configuration(&self, out: &mut Writer, names: &Names) {
        out.line("DATA_BLOCK \"Main0\"");
        out.line("{ S7_Optimized_Access := 'TRUE' }");
        out.line("VERSION : 0.1");
        out.line(quoted(&names.program));
        out.line("BEGIN");
        out.line("END_DATA_BLOCK");
        out.gap();
        out.line("ORGANIZATION_BLOCK \"Cyclic\"");
        out.line("{ S7_Optimized_Access := 'TRUE' }");
        out.line("VERSION : 0.1");
        out.line("BEGIN");
        out.indented(|out| out.line("\"Main0\"();"));
        out.line("END_ORGANIZATION_BLOCK");
    }
}

fn quoted(name: &str) -> String {
    format!("\"{name}\"")
}

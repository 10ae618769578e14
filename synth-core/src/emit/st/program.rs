//! The program that passes everything through, and the configuration that runs it.

use super::block::interface;
use super::integer::Types;
use super::names::{Names, STATE_NO};
use super::writer::{LINE_LIMIT, Writer};
use crate::controller::tables::Tables;

/// Writes both.
pub(super) fn write(out: &mut Writer, tables: &Tables, names: &Names, types: &Types) {
    out.line(format_args!("PROGRAM {}", names.program));
    interface(out, tables, names, types.state_no, false);
    out.block("VAR", "END_VAR", |out| out.line(format_args!("controller : {};", names.function_block)));
    out.gap();
    call(out, names);
    for output in outputs(names) {
        out.line(format_args!("{output} := controller.{output};"));
    }
    out.line("END_PROGRAM");
    out.gap();
    configuration(out, names);
}

fn call(out: &mut Writer, names: &Names) {
    let inputs: Vec<&str> = ["enable", "reset"]
        .into_iter()
        .chain(names.events.iter().map(|event| event.input.as_str()))
        .collect();
    out.line("controller(");
    out.indented(|out| {
        for (index, input) in inputs.iter().enumerate() {
            let end = if index + 1 == inputs.len() { ");" } else { "," };
            let line = format!("{input} := {input}{end}");
            if line.len() <= LINE_LIMIT - 2 {
                out.line(line);
            } else {
                out.line(format_args!("{input} :="));
                out.indented(|out| out.line(format_args!("{input}{end}")));
            }
        }
    });
}

fn outputs(names: &Names) -> impl Iterator<Item = &str> {
    let components = names.components.iter().map(|component| component.output.as_str());
    components.chain([STATE_NO, "pending", "unexpected", "overrun"])
}

fn configuration(out: &mut Writer, names: &Names) {
    out.block("CONFIGURATION Config0", "END_CONFIGURATION", |out| {
        out.block("RESOURCE Res0 ON PLC", "END_RESOURCE", |out| {
            out.line("TASK Cyclic(INTERVAL := T#10ms, PRIORITY := 1);");
            out.line(format_args!("PROGRAM Main0 WITH Cyclic : {};", names.program));
        });
    });
}

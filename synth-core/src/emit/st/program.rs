//! The program that passes everything through, and what runs it.

use super::block::Block;
use super::names::{Names, STATE_NO};
use super::owed::OWED;
use super::writer::Writer;

/// Writes both.
pub(super) fn write(out: &mut Writer, block: &Block<'_>) {
    let (names, frame) = (&block.names, block.dialect().frame);
    let variables = |out: &mut Writer| {
        block.interface(out, false);
        let controller = frame.block_type(&names.function_block);
        out.block("VAR", "END_VAR", |out| out.line(format_args!("controller : {controller};")));
    };
    let statements = |out: &mut Writer| {
        call(out, names);
        for output in outputs(block) {
            out.code_in_parts(&[format!("#{output} :="), format!("#controller.{output};")]);
        }
    };
    frame.program(out, &names.program, &variables, &statements);
    frame.configuration(out, names);
}

fn call(out: &mut Writer, names: &Names) {
    let inputs: Vec<&str> = ["enable", "reset"]
        .into_iter()
        .chain(names.events.iter().map(|event| event.input.as_str()))
        .collect();
    out.code("#controller(");
    out.indented(|out| {
        for (index, input) in inputs.iter().enumerate() {
            let end = if index + 1 == inputs.len() { ");" } else { "," };
            out.code_in_parts(&[format!("{input} :="), format!("#{input}{end}")]);
        }
    });
}

fn outputs<'a>(block: &'a Block<'_>) -> impl Iterator<Item = &'a str> {
    let components = block.names.components.iter().map(|component| component.output.as_str());
    let owed = block.options.owed.then_some(OWED);
    components.chain([STATE_NO, "pending", "unexpected", "overrun"]).chain(owed)
}

//! The program that passes everything through, and what runs it.

use super::block::Block;
use super::names::{Names, STATE_NO};
use super::owed::OWED;
use super::unit::{Declarations, Kind, Unit};
use super::writer::Writer;

/// What runs the program, except in SCL, where blocks of several machines share one name space. All names are [`Names`]'
/// own.
pub(super) mod configuration {
    pub(in crate::emit::st) const NAME: &str = "Config0";
    pub(in crate::emit::st) const RESOURCE: &str = "Res0";
    pub(in crate::emit::st) const TASK: &str = "Cyclic";
    pub(in crate::emit::st) const INSTANCE: &str = "Main0";
    pub(in crate::emit::st) const INTERVAL_MS: u32 = 10;
    pub(in crate::emit::st) const PRIORITY: u32 = 1;
}

/// The program.
pub(super) fn unit<'a>(block: &'a Block<'_>) -> Unit<'a> {
    let names = &block.names;
    let mut declarations = Declarations::default();
    block.interface(&mut declarations, false);
    let controller = block.dialect().frame.block_type(&names.function_block);
    declarations.section("VAR", |out| out.variable("controller", controller));
    let body = |out: &mut Writer| {
        call(out, names);
        for output in outputs(block) {
            out.code_in_parts(&[format!("#{output} :="), format!("#controller.{output};")]);
        }
    };
    Unit { comment: None, kind: Kind::Program, name: &names.program, declarations, body: Box::new(body) }
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

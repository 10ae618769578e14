//! Looking for the super step that is due in tables, and doing it, whatever the tables look like.

use crate::emit::st::block::Block;
use crate::emit::st::bound::{Cost, LayoutCost};
use crate::emit::st::integer::Integer;
use crate::emit::st::writer::Writer;

/// Where the tables have a super step.
pub(super) struct Place<'a> {
    /// The index of its codes.
    pub(super) codes: &'a str,
    /// The expression of its target.
    pub(super) target: &'a str,
}

/// Sets `due`, and does the super step if there is one; `hit` writes the statements that it is given for that case. When
/// draining, sets `done` if there is none, or if it would command a component again, and does nothing then.
pub(super) fn write(
    out: &mut Writer,
    block: &Block<'_>,
    place: &Place<'_>,
    hit: impl FnOnce(&mut Writer, &dyn Fn(&mut Writer)),
) {
    out.code("#due := FALSE;");
    if block.drains() {
        out.code("#done := TRUE;");
    }
    hit(out, &|out| {
        out.code("#due := TRUE;");
        if block.drains() {
            out.code("#done := FALSE;");
            for names in &block.names.components {
                let coded = format!("#{}[{}] <> 0", names.codes, place.codes);
                let again = [format!("#{} <> 0", names.output), coded];
                out.when_all(&again, |out| out.code("#done := TRUE;"));
            }
            out.when("NOT #done", |out| perform(out, block, place));
        } else {
            perform(out, block, place);
        }
    });
}

fn perform(out: &mut Writer, block: &Block<'_>, place: &Place<'_>) {
    for (names, integer) in block.components() {
        let output = &names.output;
        let code = integer.converted(Integer::Int, &format!("#{}[{}]", names.codes, place.codes));
        let command = [format!("#{output} :="), format!("{code};")];
        if block.drains() {
            // A command of an earlier super step stays.
            out.when(format_args!("#{output} = 0"), |out| out.code_in_parts(&command));
        } else {
            out.code_in_parts(&command);
        }
    }
    out.code(format_args!("#state := {};", place.target));
}

/// Adds what it costs, if `found` is the cost of looking for it.
pub(super) fn add_cost(cost: &mut LayoutCost, block: &Block<'_>, found: Cost) {
    let components = block.names.components.len() as u64;
    let drains = u64::from(block.drains());
    // `due`, `done`, and `IF NOT due` behind.
    let around = Cost::statements(1 + drains + u64::from(!block.names.events.is_empty()));
    cost.seek = found + around;
    // `due`; when draining `done`, an `IF` per component that looks at its code, `IF NOT done`.
    let decided =
        Cost { statements: 1 + drains * (2 + components), iterations: 0, probes: drains * components };
    // `state`, and per component its output, in an `IF` when draining.
    cost.perform = decided + Cost::statements(1 + (1 + drains) * components);
    cost.leave = decided + Cost::statements(components);
}

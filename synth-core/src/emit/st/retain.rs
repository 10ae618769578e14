//! `--retain`: the controller goes on after a power cycle where it was, if its tables are still the same.
//!
//! Retained are the state, what inputs were, and copies of the outputs that the next call builds on. The outputs
//! themselves are not: not every system can retain outputs, and a command must not come twice.

use super::block::Block;
use super::bound::Cost;
use super::unit::Section;
use super::writer::Writer;
use super::{Trigger, Unexpected};

/// Whether a stop has to be remembered.
fn faults(block: &Block<'_>) -> bool {
    block.options.unexpected == Unexpected::Fault
}

/// The copies, among the retained variables.
pub(super) fn variables(out: &mut Section, block: &Block<'_>) {
    out.variable("table_version", block.types.state_no);
    if !block.names.events.is_empty() {
        out.variable("kept", block.events_type());
    }
    if faults(block) {
        out.variable("stopped", "BOOL");
    }
}

/// At the start of a call: what was kept, or the initial state if other tables kept it.
pub(super) fn restore(out: &mut Writer, block: &Block<'_>) {
    let version = block.tables.version();
    out.when(format_args!("#table_version <> {version}"), |out| {
        out.code(format_args!("#table_version := {version};"));
        out.code(format_args!("#state := {};", block.tables.initial));
        block.for_each_event(out, |out| {
            out.code("#kept[#index] := FALSE;");
            if block.options.trigger == Trigger::Edge {
                out.code("#previous[#index] := FALSE;");
            }
        });
        if faults(block) {
            out.code("#stopped := FALSE;");
        }
    });
    copy(out, block, ["pending", "kept"], ["unexpected", "stopped"]);
    out.gap();
}

/// At the end of a call.
pub(super) fn keep(out: &mut Writer, block: &Block<'_>) {
    copy(out, block, ["kept", "pending"], ["stopped", "unexpected"]);
}

fn copy(out: &mut Writer, block: &Block<'_>, [pending, kept]: [&str; 2], [unexpected, stopped]: [&str; 2]) {
    if !block.names.events.is_empty() {
        out.code(format_args!("#{pending} := #{kept};"));
    }
    if faults(block) {
        out.code(format_args!("#{unexpected} := #{stopped};"));
    }
}

/// What both cost at most.
pub(super) fn cost(block: &Block<'_>) -> Cost {
    let stop = u64::from(faults(block));
    let copies = u64::from(!block.names.events.is_empty()) + stop;
    let edges = u64::from(block.options.trigger == Trigger::Edge);
    // The `IF`, `table_version`, `state`.
    Cost::statements(3 + stop + 2 * copies) + super::bound::each_event(block, 1 + edges)
}

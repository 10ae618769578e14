//! One branch of a `CASE` per state: the older layout, many times longer.

use super::Layout;
use crate::controller::runs::Runs;
use crate::controller::tables::Tables;
use crate::emit::st::block::Block;
use crate::emit::st::bound::{Cost, LayoutCost};
use crate::emit::st::header;
use crate::emit::st::unit::{Declarations, Section, Unit};
use crate::emit::st::writer::Writer;

/// Branches instead of tables.
///
/// A branch follows one event, the first in table order from `next` on. A pass that finds none starts again at the
/// first event; one that started there ends the loop. That is the order of the published cycle, in which an event
/// does not look back at those before it until the round is over.
pub(in crate::emit::st) struct CaseLayout;

impl Layout for CaseLayout {
    fn functions<'a>(&self, _: &'a Block<'_>) -> Vec<Unit<'a>> {
        Vec::new()
    }

    fn tables(&self, _: &mut Declarations, _: &Block<'_>) {}

    fn variables(&self, out: &mut Section, block: &Block<'_>) {
        if block.has_rows() {
            header::reminder(out, block);
            out.variable("event", block.types.index);
            out.variable("next", block.types.index);
        }
    }

    fn consume(&self, out: &mut Writer, block: &Block<'_>) {
        let none = block.names.events.len();
        out.code("#next := 0;");
        out.repeat("NOT #changed", |out| {
            out.code("#changed := TRUE;");
            out.code(format_args!("#event := {none};"));
            branches(out, block);
            out.code(format_args!("IF #event < {none} THEN"));
            out.indented(|out| {
                out.code("#pending[#event] := FALSE;");
                out.code("#next := #event + 1;");
            });
            out.code("ELSIF #next > 0 THEN");
            out.indented(|out| out.code("#next := 0;"));
            out.code("ELSE");
            out.indented(|out| out.code("#changed := FALSE;"));
            out.code("END_IF;");
        });
    }

    fn super_step(&self, out: &mut Writer, block: &Block<'_>) {
        let steps = &block.tables.super_steps;
        out.code("#due := TRUE;");
        if block.drains() {
            out.code("#done := TRUE;");
        }
        out.code("CASE #state OF");
        out.indented(|out| {
            for (row, (source, target)) in steps.source.iter().zip(&steps.target).enumerate() {
                out.code(format_args!("{source}:"));
                out.indented(|out| super_step(out, block, row, *target));
            }
        });
        out.code("ELSE");
        out.indented(|out| out.code("#due := FALSE;"));
        out.code("END_CASE;");
    }

    fn largest_index(&self, _: &Tables, _: &Runs) -> u64 {
        0
    }

    fn cost(&self, block: &Block<'_>) -> LayoutCost {
        let mut cost = LayoutCost::default();
        if block.has_rows() {
            // `next`, and the loop.
            cost.entry = Cost::statements(2);
            // One pass follows the event, another starts again.
            cost.rounds_per_event = 2;
            let branch = branches_of(block).iter().map(Vec::len).max().unwrap_or(0) as u64;
            // `changed`, `event`, `CASE`, its branch's `IF`, the `IF` behind it, and what starts or ends a round.
            cost.round = Cost { statements: 6, iterations: 1, probes: branch };
            // `state`, `event`, and one more behind.
            cost.event = Cost::statements(3);
        }
        if block.has_super_steps() {
            let rows = 0..block.tables.super_steps.source.len();
            let commands = rows.map(|row| commands(block, row).count() as u64).max().unwrap_or(0);
            let drains = u64::from(block.drains());
            let asks = drains * u64::from(commands > 0);
            // `due`, `done`, `CASE`, and `IF NOT due` behind.
            cost.seek = Cost::statements(2 + drains + u64::from(!block.names.events.is_empty()));
            // An `IF` where something is commanded, the outputs, `state`, `done`.
            cost.perform = Cost::statements(asks + commands + 1 + drains);
            cost.leave = Cost::statements(asks);
            cost.wait = Cost::statements(1);
        }
        cost
    }
}

/// Per state its rows: event and target, in table order.
fn branches_of(block: &Block<'_>) -> Vec<Vec<(usize, u32)>> {
    let mut branches = vec![Vec::new(); block.tables.states as usize];
    for (index, mapping, ..) in block.events() {
        for (&source, &target) in mapping.source.iter().zip(&mapping.target) {
            branches[source as usize].push((index, target));
        }
    }
    branches
}

fn branches(out: &mut Writer, block: &Block<'_>) {
    out.code("CASE #state OF");
    out.indented(|out| {
        for (state, rows) in branches_of(block).iter().enumerate().filter(|(_, rows)| !rows.is_empty()) {
            out.code(format_args!("{state}:"));
            out.indented(|out| {
                for (row, (event, target)) in rows.iter().enumerate() {
                    let word = if row == 0 { "IF" } else { "ELSIF" };
                    out.code(format_args!("{word} #pending[{event}] AND #next <= {event} THEN"));
                    out.indented(|out| {
                        out.code(format_args!("#state := {target};"));
                        out.code(format_args!("#event := {event};"));
                    });
                }
                out.code("END_IF;");
            });
        }
    });
    out.code("END_CASE;");
}

/// The outputs that a super step commands, with their codes.
fn commands<'a>(block: &'a Block<'_>, row: usize) -> impl Iterator<Item = (&'a str, u32)> {
    let components = block.tables.components.iter().zip(&block.names.components);
    components
        .map(move |(table, names)| (names.output.as_str(), table.codes[row]))
        .filter(|(_, code)| *code != 0)
}

fn super_step(out: &mut Writer, block: &Block<'_>, row: usize, target: u32) {
    let perform = |out: &mut Writer| {
        for (output, code) in commands(block, row) {
            out.code(format_args!("#{output} := {code};"));
        }
        out.code(format_args!("#state := {target};"));
        if block.drains() {
            out.code("#done := FALSE;");
        }
    };
    let free: Vec<String> = commands(block, row).map(|(output, _)| format!("#{output} = 0")).collect();
    if block.drains() && !free.is_empty() {
        out.when_all(&free, perform);
    } else {
        perform(out);
    }
}

//! Two arrays per event and a binary search, as published.

use super::Layout;
use super::search::{Entries, Search};
use super::step::{self, Place};
use crate::controller::runs::Runs;
use crate::controller::tables::{Mapping, Tables};
use crate::emit::st::block::Block;
use crate::emit::st::bound::{Cost, LayoutCost};
use crate::emit::st::header;
use crate::emit::st::names::EventNames;
use crate::emit::st::unit::{Declarations, Section, Unit};
use crate::emit::st::writer::Writer;

/// Mapping functions as arrays.
pub(in crate::emit::st) struct RowLayout {
    /// How a row is found.
    pub(in crate::emit::st) search: &'static dyn Search,
    /// The section of variables that holds the arrays.
    pub(in crate::emit::st) section: &'static str,
}

impl Layout for RowLayout {
    fn functions<'a>(&self, block: &'a Block<'_>) -> Vec<Unit<'a>> {
        let searches = block.has_rows() || block.has_super_steps();
        if searches { self.search.functions(block, None) } else { Vec::new() }
    }

    fn tables(&self, out: &mut Declarations, block: &Block<'_>) {
        if !block.has_rows() && !block.has_super_steps() {
            return;
        }
        let state = block.types.state;
        out.section(self.section, |out| {
            header::reminder(out, block);
            for (_, mapping, names, text) in block.events() {
                out.comment(text);
                out.array(&names.source, state, &mapping.source);
                out.array(&names.target, state, &mapping.target);
            }
            if block.has_super_steps() {
                out.comment("super steps");
                out.array("source", state, &block.tables.super_steps.source);
                out.array("target", state, &block.tables.super_steps.target);
                for (table, (names, codes)) in block.tables.components.iter().zip(block.components()) {
                    out.array(&names.codes, codes, &table.codes);
                }
            }
        });
    }

    fn variables(&self, out: &mut Section, block: &Block<'_>) {
        if block.has_rows() || block.has_super_steps() {
            let mappings = block.events().map(|(_, mapping, ..)| mapping);
            let several = mappings.chain([&block.tables.super_steps]).any(|mapping| mapping.source.len() > 1);
            self.search.variables(out, block.types.index, several);
        }
    }

    fn consume(&self, out: &mut Writer, block: &Block<'_>) {
        out.repeat("NOT #changed", |out| {
            out.code("#changed := FALSE;");
            for (index, mapping, names, text) in block.events() {
                out.comment(text);
                out.when(format_args!("#pending[{index}]"), |out| {
                    self.follow(out, block, index, mapping, names);
                });
            }
        });
    }

    fn super_step(&self, out: &mut Writer, block: &Block<'_>) {
        self.find(out, block, "source", &block.tables.super_steps);
        let place = Place { codes: "#first", target: "#target[#first]" };
        step::write(out, block, &place, |out, inside| out.when("#source[#first] = #state", inside));
    }

    fn largest_index(&self, tables: &Tables, _: &Runs) -> u64 {
        let mappings = tables.events.iter().map(|table| &table.mapping).chain([&tables.super_steps]);
        // A search adds two indices.
        2 * mappings.map(|mapping| mapping.source.len() as u64).max().unwrap_or(0)
    }

    fn cost(&self, block: &Block<'_>) -> LayoutCost {
        let mut cost = LayoutCost::default();
        // The search, and the statement that compares what it found.
        let compared = |rows: usize| {
            self.search.cost(rows as u64, rows > 1) + Cost { statements: 1, probes: 1, iterations: 0 }
        };
        if block.has_rows() {
            cost.entry = Cost::statements(1);
            cost.rounds_per_event = 1;
            cost.searches = block.events().map(|(_, mapping, ..)| compared(mapping.source.len())).collect();
            // `changed`, and an `IF` per event.
            cost.round = Cost { statements: 1 + cost.searches.len() as u64, iterations: 1, probes: 0 };
            // `state`, `pending`, `changed`.
            cost.event = Cost::statements(3);
        }
        if block.has_super_steps() {
            step::add_cost(&mut cost, block, compared(block.tables.super_steps.source.len()));
        }
        cost
    }
}

impl RowLayout {
    /// Makes `first` the row of the state, if there is one.
    fn find(&self, out: &mut Writer, block: &Block<'_>, array: &str, mapping: &Mapping) {
        let last = mapping.source.len() - 1;
        let entries = Entries { array, first: "0", last: &last.to_string(), several: last > 0 };
        self.search.find(out, block, &entries);
    }

    /// Follows event `index`, which is pending, if the state has a row for it.
    fn follow(
        &self,
        out: &mut Writer,
        block: &Block<'_>,
        index: usize,
        mapping: &Mapping,
        names: &EventNames,
    ) {
        self.find(out, block, &names.source, mapping);
        out.when(format_args!("#{}[#first] = #state", names.source), |out| {
            out.code(format_args!("#state := #{}[#first];", names.target));
            out.code(format_args!("#pending[{index}] := FALSE;"));
            out.code("#changed := TRUE;");
        });
    }
}

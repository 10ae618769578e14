//! Two arrays per event and a binary search, as published.

use super::Layout;
use crate::controller::tables::Mapping;
use crate::emit::st::block::Block;
use crate::emit::st::bound::{Cost, LayoutCost};
use crate::emit::st::integer::Integer;
use crate::emit::st::names::EventNames;
use crate::emit::st::writer::Writer;

/// Mapping functions as arrays.
pub(in crate::emit::st) struct TableLayout {
    /// How a row is found.
    pub(in crate::emit::st) search: &'static dyn Search,
    /// The section of variables that holds the arrays.
    pub(in crate::emit::st) section: &'static str,
}

/// A way to make `first` the first row whose source is not below the state, or the last row.
pub(in crate::emit::st) trait Search: Sync {
    /// Declarations in front of the function block.
    fn functions(&self, out: &mut Writer, block: &Block<'_>);

    /// Its variables in the function block.
    fn variables(&self, out: &mut Writer, index: Integer);

    /// The search in an array of at least one row.
    fn find(&self, out: &mut Writer, block: &Block<'_>, source: &str, rows: usize);

    /// What it costs at most.
    fn cost(&self, rows: usize) -> Cost;
}

impl Layout for TableLayout {
    fn functions(&self, out: &mut Writer, block: &Block<'_>) {
        if block.has_rows() || block.has_super_steps() {
            self.search.functions(out, block);
        }
    }

    fn tables(&self, out: &mut Writer, block: &Block<'_>) {
        if !block.has_rows() && !block.has_super_steps() {
            return;
        }
        let state = block.types.state.keyword();
        out.block(self.section, "END_VAR", |out| {
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
                    out.array(&names.codes, codes.keyword(), &table.codes);
                }
            }
        });
    }

    fn variables(&self, out: &mut Writer, block: &Block<'_>) {
        if block.has_rows() || block.has_super_steps() {
            self.search.variables(out, block.types.index);
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
        self.search.find(out, block, "source", block.tables.super_steps.source.len());
        out.code("#due := #source[#first] = #state;");
        if block.drains() {
            out.code("#done := NOT #due;");
            for component in &block.names.components {
                let (output, codes) = (&component.output, &component.codes);
                let again = [format!("#{output} <> 0"), format!("#{codes}[#first] <> 0")];
                out.when_all(&again, |out| {
                    out.code("#done := TRUE;");
                });
            }
        }
        out.when(if block.drains() { "NOT #done" } else { "#due" }, |out| {
            for (names, codes) in block.components() {
                let output = &names.output;
                let code = codes.converted(Integer::Int, &format!("#{}[#first]", names.codes));
                let command = [format!("#{output} :="), format!("{code};")];
                if block.drains() {
                    // A command of an earlier super step stays.
                    out.when(format_args!("#{output} = 0"), |out| out.code_in_parts(&command));
                } else {
                    out.code_in_parts(&command);
                }
            }
            out.code("#state := #target[#first];");
        });
    }

    fn cost(&self, block: &Block<'_>) -> LayoutCost {
        let mut cost = LayoutCost::default();
        // The search, and the statement that compares what it found.
        let compared = |rows| self.search.cost(rows) + Cost { statements: 1, probes: 1, iterations: 0 };
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
            let components = block.names.components.len() as u64;
            let looked = compared(block.tables.super_steps.source.len());
            if block.drains() {
                // `done`, an `IF` per component, `IF NOT done`.
                cost.seek = looked + Cost::statements(2 + components);
                // `state`, and per component an `IF` around its output.
                cost.perform = Cost::statements(1 + 2 * components);
                cost.leave = Cost::statements(components);
            } else {
                // `IF due`.
                cost.seek = looked + Cost::statements(1);
                cost.perform = Cost::statements(1 + components);
            }
            // `IF NOT due`, behind.
            cost.seek += Cost::statements(u64::from(!block.names.events.is_empty()));
        }
        cost
    }
}

impl TableLayout {
    /// Follows event `index`, which is pending, if the state has a row for it.
    fn follow(
        &self,
        out: &mut Writer,
        block: &Block<'_>,
        index: usize,
        mapping: &Mapping,
        names: &EventNames,
    ) {
        self.search.find(out, block, &names.source, mapping.source.len());
        out.when(format_args!("#{}[#first] = #state", names.source), |out| {
            out.code(format_args!("#state := #{}[#first];", names.target));
            out.code(format_args!("#pending[{index}] := FALSE;"));
            out.code("#changed := TRUE;");
        });
    }
}

/// Times that a binary search halves.
fn halvings(rows: usize) -> u64 {
    u64::from(rows.max(1).next_power_of_two().ilog2())
}

/// The loop of a binary search, up to `last`.
fn halve(out: &mut Writer, source: &str, last: &str) {
    out.code(format_args!("WHILE #first < {last} DO"));
    out.indented(|out| {
        out.code(format_args!("#middle := (#first + {last}) / 2;"));
        out.code(format_args!("IF #{source}[#middle] < #state THEN"));
        out.indented(|out| out.code("#first := #middle + 1;"));
        out.code("ELSE");
        out.indented(|out| out.code(format_args!("{last} := #middle;")));
        out.code("END_IF;");
    });
    out.code("END_WHILE;");
}

/// The search where it is needed: a function of the standard would copy its array at every call.
pub(in crate::emit::st) struct Inline;

impl Search for Inline {
    fn functions(&self, _: &mut Writer, _: &Block<'_>) {}

    fn variables(&self, out: &mut Writer, index: Integer) {
        for name in ["first", "last", "middle"] {
            out.line(format_args!("{name} : {};", index.keyword()));
        }
    }

    fn find(&self, out: &mut Writer, _: &Block<'_>, source: &str, rows: usize) {
        out.code("#first := 0;");
        if rows > 1 {
            out.code(format_args!("#last := {};", rows - 1));
            halve(out, source, "#last");
        }
    }

    fn cost(&self, rows: usize) -> Cost {
        let halvings = halvings(rows);
        let around = if rows > 1 { 3 } else { 1 };
        Cost { statements: around + 3 * halvings, iterations: halvings, probes: halvings }
    }
}

/// One function for all arrays, which gets the address of one. The address is taken for every search, because an
/// online change may move variables.
pub(in crate::emit::st) struct Pointers;

impl Search for Pointers {
    fn functions(&self, out: &mut Writer, block: &Block<'_>) {
        let name = &block.names.search;
        let (state, index) = (block.types.state.keyword(), block.types.index.keyword());
        out.comment("The first row whose source is not below the state, or the last row.");
        out.line(format_args!("FUNCTION {name} : {index}"));
        out.block("VAR_INPUT", "END_VAR", |out| {
            out.line(format_args!("source : POINTER TO {state};"));
            out.line(format_args!("last_row : {index};"));
            out.line(format_args!("state : {state};"));
        });
        out.block("VAR", "END_VAR", |out| {
            for variable in ["first", "last", "middle"] {
                out.line(format_args!("{variable} : {index};"));
            }
        });
        out.gap();
        out.code("#first := 0;");
        out.code("#last := #last_row;");
        halve(out, "source", "#last");
        out.code(format_args!("{name} := #first;"));
        out.line("END_FUNCTION");
        out.gap();
    }

    fn variables(&self, out: &mut Writer, index: Integer) {
        out.line(format_args!("first : {};", index.keyword()));
    }

    fn find(&self, out: &mut Writer, block: &Block<'_>, source: &str, rows: usize) {
        let call = [
            "#first :=".to_owned(),
            format!("{}(source :=", block.names.search),
            format!("ADR(#{source}),"),
            format!("last_row := {},", rows - 1),
            "state := #state);".to_owned(),
        ];
        out.code_in_parts(&call);
    }

    fn cost(&self, rows: usize) -> Cost {
        let halvings = halvings(rows);
        // The call, four statements around the loop.
        Cost { statements: 5 + 3 * halvings, iterations: halvings, probes: halvings }
    }
}

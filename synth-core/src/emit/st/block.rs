//! The function block: interface, tables, and the cycle.

use super::integer::{Integer, Types};
use super::names::{EventNames, Names, OutputNames, STATE_NO};
use super::writer::Writer;
use super::{Options, Trigger, Unexpected};
use crate::controller::tables::{Mapping, Tables};

/// Writes the type of `pending` and the function block, an empty line last.
pub(super) fn write(out: &mut Writer, tables: &Tables, options: &Options, names: &Names, types: &Types) {
    let block = Block { tables, options, names, types };
    out.block("TYPE", "END_TYPE", |out| {
        let last = tables.events.len().saturating_sub(1);
        out.line(format_args!("{} : ARRAY [0..{last}] OF BOOL;", names.events_type));
    });
    out.gap();
    out.line(format_args!("FUNCTION_BLOCK {}", names.function_block));
    interface(out, tables, names, types.state_no, true);
    block.constants(out);
    block.variables(out);
    out.gap();
    block.call(out);
    out.line("END_FUNCTION_BLOCK");
    out.gap();
}

/// `VAR_INPUT` and `VAR_OUTPUT` of the function block and, without initial values, of the program.
pub(super) fn interface(out: &mut Writer, tables: &Tables, names: &Names, state_no: Integer, initial: bool) {
    out.block("VAR_INPUT", "END_VAR", |out| {
        out.line("enable : BOOL := TRUE;");
        out.line("reset : BOOL;");
        for event in &names.events {
            out.line(format_args!("{} : BOOL;", event.input));
        }
    });
    out.block("VAR_OUTPUT", "END_VAR", |out| {
        for component in &names.components {
            out.line(format_args!("{} : INT;", component.output));
        }
        let value = if initial { format!(" := {}", tables.initial) } else { String::new() };
        out.line(format_args!("{STATE_NO} : {}{value};", state_no.keyword()));
        out.line(format_args!("pending : {};", names.events_type));
        out.line("unexpected : BOOL;");
        out.line("overrun : BOOL;");
    });
}

struct Block<'a> {
    tables: &'a Tables,
    options: &'a Options,
    names: &'a Names,
    types: &'a Types,
}

impl Block<'_> {
    /// The events that occur in some row, with their indices.
    fn events(&self) -> impl Iterator<Item = (usize, &Mapping, &EventNames, &str)> {
        let tables = self.tables.events.iter().zip(&self.names.events).enumerate();
        tables
            .filter(|(_, (table, _))| !table.mapping.source.is_empty())
            .map(|(index, (table, names))| (index, &table.mapping, names, table.event.text.as_str()))
    }

    fn has_super_steps(&self) -> bool {
        !self.tables.super_steps.source.is_empty()
    }

    /// A drain without super steps is one cycle.
    fn drains(&self) -> bool {
        self.options.drain && self.has_super_steps()
    }

    /// Per component its names and the type of its codes.
    fn components(&self) -> impl Iterator<Item = (&OutputNames, Integer)> {
        self.names.components.iter().zip(self.types.codes.iter().copied())
    }

    fn constants(&self, out: &mut Writer) {
        if self.events().next().is_none() && !self.has_super_steps() {
            return;
        }
        let state = self.types.state.keyword();
        out.block("VAR CONSTANT", "END_VAR", |out| {
            for (_, mapping, names, text) in self.events() {
                out.comment(text);
                out.array(&names.source, state, &mapping.source);
                out.array(&names.target, state, &mapping.target);
            }
            if self.has_super_steps() {
                out.comment("super steps");
                out.array("source", state, &self.tables.super_steps.source);
                out.array("target", state, &self.tables.super_steps.target);
                for (table, (names, codes)) in self.tables.components.iter().zip(self.components()) {
                    out.array(&names.codes, codes.keyword(), &table.codes);
                }
            }
        });
    }

    fn variables(&self, out: &mut Writer) {
        let index = self.types.index.keyword();
        out.block("VAR", "END_VAR", |out| {
            out.line(format_args!("state : {} := {};", self.types.state.keyword(), self.tables.initial));
            if self.options.trigger == Trigger::Edge && !self.names.events.is_empty() {
                out.line(format_args!("previous : {};", self.names.events_type));
            }
            if !self.names.events.is_empty() {
                out.line(format_args!("index : {index};"));
            }
            let has_rows = self.events().next().is_some();
            if has_rows || self.has_super_steps() {
                out.line(format_args!("first : {index};"));
                out.line(format_args!("last : {index};"));
                out.line(format_args!("middle : {index};"));
            }
            if has_rows {
                out.line("changed : BOOL;");
            }
            if self.has_super_steps() {
                out.line("due : BOOL;");
            }
            if self.drains() {
                out.line("done : BOOL;");
            }
        });
    }

    /// The body.
    fn call(&self, out: &mut Writer) {
        for component in &self.names.components {
            out.line(format_args!("{} := 0;", component.output));
        }
        out.line("overrun := FALSE;");
        let faults = self.options.unexpected == Unexpected::Fault;
        if !faults {
            out.line("unexpected := FALSE;");
        }
        out.gap();
        out.line("IF reset THEN");
        out.indented(|out| self.reset(out));
        // A controller without any event or super step has nothing to do.
        if !self.names.events.is_empty() || self.has_super_steps() {
            out.line(if faults { "ELSIF enable AND NOT unexpected THEN" } else { "ELSIF enable THEN" });
            out.indented(|out| self.run(out));
        }
        out.line("END_IF;");
        out.gap();
        if self.options.trigger == Trigger::Edge {
            for (index, event) in self.names.events.iter().enumerate() {
                out.line(format_args!("previous[{index}] := {};", event.input));
            }
        }
        let state = self.types.state.converted(self.types.state_no, "state");
        out.line(format_args!("{STATE_NO} := {state};"));
    }

    fn reset(&self, out: &mut Writer) {
        out.line(format_args!("state := {};", self.tables.initial));
        if self.options.unexpected == Unexpected::Fault {
            out.line("unexpected := FALSE;");
        }
        self.for_each_event(out, |out| out.line("pending[index] := FALSE;"));
    }

    fn for_each_event(&self, out: &mut Writer, inside: impl FnOnce(&mut Writer)) {
        if let Some(last) = self.names.events.len().checked_sub(1) {
            out.block(format_args!("FOR index := 0 TO {last} DO"), "END_FOR;", inside);
        }
    }

    fn run(&self, out: &mut Writer) {
        for (index, event) in self.names.events.iter().enumerate() {
            self.raise(out, index, &event.input);
        }
        if self.drains() {
            out.block("REPEAT", "UNTIL done", |out| self.cycle(out));
            out.line("END_REPEAT;");
        } else {
            self.cycle(out);
        }
        self.refuse(out);
    }

    fn raise(&self, out: &mut Writer, index: usize, input: &str) {
        let raised = match self.options.trigger {
            Trigger::Edge => format!("{input} AND NOT previous[{index}]"),
            Trigger::Level => input.to_owned(),
        };
        out.block(format_args!("IF {raised} THEN"), "END_IF;", |out| {
            out.line(format_args!("overrun := overrun OR pending[{index}];"));
            out.line(format_args!("pending[{index}] := TRUE;"));
        });
    }

    fn cycle(&self, out: &mut Writer) {
        if self.events().next().is_some() {
            out.block("REPEAT", "UNTIL NOT changed", |out| {
                out.line("changed := FALSE;");
                for (index, mapping, names, text) in self.events() {
                    out.comment(text);
                    out.block(format_args!("IF pending[{index}] THEN"), "END_IF;", |out| {
                        consume(out, index, mapping, names);
                    });
                }
            });
            out.line("END_REPEAT;");
        }
        if self.has_super_steps() {
            self.super_step(out);
        }
    }

    fn super_step(&self, out: &mut Writer) {
        out.comment("super step");
        search(out, "source", self.tables.super_steps.source.len());
        out.line("due := source[first] = state;");
        if self.drains() {
            out.line("done := NOT due;");
            for component in &self.names.components {
                let (output, codes) = (&component.output, &component.codes);
                out.block(format_args!("IF {output} <> 0 AND {codes}[first] <> 0 THEN"), "END_IF;", |out| {
                    out.line("done := TRUE;");
                });
            }
        }
        out.block(if self.drains() { "IF NOT done THEN" } else { "IF due THEN" }, "END_IF;", |out| {
            for (names, codes) in self.components() {
                let code = codes.converted(Integer::Int, &format!("{}[first]", names.codes));
                if self.drains() {
                    // A command of an earlier super step stays.
                    out.block(format_args!("IF {} = 0 THEN", names.output), "END_IF;", |out| {
                        out.line(format_args!("{} := {code};", names.output));
                    });
                } else {
                    out.line(format_args!("{} := {code};", names.output));
                }
            }
            out.line("state := target[first];");
        });
    }

    /// What is pending while the controller waits for the environment fits nowhere.
    fn refuse(&self, out: &mut Writer) {
        if self.names.events.is_empty() {
            return;
        }
        let each = |out: &mut Writer| {
            self.for_each_event(out, |out| {
                out.line("unexpected := unexpected OR pending[index];");
                if self.options.unexpected == Unexpected::Drop {
                    out.line("pending[index] := FALSE;");
                }
            });
        };
        if self.has_super_steps() {
            out.block("IF NOT due THEN", "END_IF;", each);
        } else {
            each(out);
        }
    }
}

/// Follows event `index`, which is pending, if the state has a row for it.
fn consume(out: &mut Writer, index: usize, mapping: &Mapping, names: &EventNames) {
    search(out, &names.source, mapping.source.len());
    out.block(format_args!("IF {}[first] = state THEN", names.source), "END_IF;", |out| {
        out.line(format_args!("state := {}[first];", names.target));
        out.line(format_args!("pending[{index}] := FALSE;"));
        out.line("changed := TRUE;");
    });
}

/// Makes `first` the first row whose source is not below the state, or the last row.
///
/// Inlined wherever it is needed: a function would copy its array at every call.
fn search(out: &mut Writer, source: &str, rows: usize) {
    out.line("first := 0;");
    if rows == 1 {
        return;
    }
    out.line(format_args!("last := {};", rows - 1));
    out.block("WHILE first < last DO", "END_WHILE;", |out| {
        out.line("middle := (first + last) / 2;");
        out.line(format_args!("IF {source}[middle] < state THEN"));
        out.indented(|out| out.line("first := middle + 1;"));
        out.line("ELSE");
        out.indented(|out| out.line("last := middle;"));
        out.line("END_IF;");
    });
}

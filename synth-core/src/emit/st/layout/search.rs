//! The binary search: where it stands, and how it gets at its array.

use crate::emit::st::block::Block;
use crate::emit::st::bound::Cost;
use crate::emit::st::integer::Integer;
use crate::emit::st::writer::Writer;

/// What is searched.
pub(in crate::emit::st) struct Entries<'a> {
    /// An ascending array of states.
    pub(in crate::emit::st) array: &'a str,
    /// Expressions of its first and its last entry to look at; there is one.
    pub(in crate::emit::st) first: &'a str,
    pub(in crate::emit::st) last: &'a str,
    /// Whether first and last may differ.
    pub(in crate::emit::st) several: bool,
}

/// A way to make `first` the last entry that is not above the state, or the first entry if all are.
pub(in crate::emit::st) trait Search: Sync {
    /// Declarations in front of the function block. All arrays have up to `length` entries, if their type must say it.
    fn functions(&self, out: &mut Writer, block: &Block<'_>, length: Option<usize>);

    /// Its variables in the function block.
    fn variables(&self, out: &mut Writer, index: Integer);

    fn find(&self, out: &mut Writer, block: &Block<'_>, entries: &Entries<'_>);

    /// What it costs at most in so many entries, if it is not known when the text is written that there is but one.
    fn cost(&self, entries: u64, several: bool) -> Cost;
}

/// Times that a binary search halves.
fn halvings(entries: u64) -> u64 {
    u64::from(entries.max(1).next_power_of_two().ilog2())
}

/// The loop of a binary search, up to `last`.
fn halve(out: &mut Writer, source: &str) {
    out.code("WHILE #first < #last DO");
    out.indented(|out| {
        out.code("#middle := (#first + #last + 1) / 2;");
        out.code(format_args!("IF #{source}[#middle] <= #state THEN"));
        out.indented(|out| out.code("#first := #middle;"));
        out.code("ELSE");
        out.indented(|out| out.code("#last := #middle - 1;"));
        out.code("END_IF;");
    });
    out.code("END_WHILE;");
}

/// The search where it is needed: a function of the standard would copy its array at every call.
pub(in crate::emit::st) struct Inline;

impl Search for Inline {
    fn functions(&self, _: &mut Writer, _: &Block<'_>, _: Option<usize>) {}

    fn variables(&self, out: &mut Writer, index: Integer) {
        for name in ["first", "last", "middle"] {
            out.line(format_args!("{name} : {};", index.keyword()));
        }
    }

    fn find(&self, out: &mut Writer, _: &Block<'_>, entries: &Entries<'_>) {
        out.code(format_args!("#first := {};", entries.first));
        if entries.several {
            out.code(format_args!("#last := {};", entries.last));
            halve(out, entries.array);
        }
    }

    fn cost(&self, entries: u64, several: bool) -> Cost {
        let halvings = halvings(entries);
        let around = if several { 3 } else { 1 };
        Cost { statements: around + 3 * halvings, iterations: halvings, probes: halvings }
    }
}

/// One function, which gets the address of an array. The address is taken for every search, because an online change
/// may move variables.
pub(in crate::emit::st) struct Pointers;

impl Search for Pointers {
    fn functions(&self, out: &mut Writer, block: &Block<'_>, length: Option<usize>) {
        let name = &block.names.search;
        let (state, index) = (block.types.state.keyword(), block.types.index.keyword());
        // A pointer to an element is indexed as it is: CODESYS and TwinCAT do not look behind it.
        let (pointed, source) = match length {
            Some(length) => (format!("ARRAY [0..{}] OF {state}", length.saturating_sub(1)), "source^"),
            None => (state.to_owned(), "source"),
        };
        out.comment("The last entry of first_row to last_row that is not above state, or first_row.");
        out.line(format_args!("FUNCTION {name} : {index}"));
        out.block("VAR_INPUT", "END_VAR", |out| {
            out.line(format_args!("source : POINTER TO {pointed};"));
            out.line(format_args!("first_row : {index};"));
            out.line(format_args!("last_row : {index};"));
            out.line(format_args!("state : {state};"));
        });
        out.block("VAR", "END_VAR", |out| {
            for variable in ["first", "last", "middle"] {
                out.line(format_args!("{variable} : {index};"));
            }
        });
        out.gap();
        out.code("#first := #first_row;");
        out.code("#last := #last_row;");
        halve(out, source);
        out.code(format_args!("{name} := #first;"));
        out.line("END_FUNCTION");
        out.gap();
    }

    fn variables(&self, out: &mut Writer, index: Integer) {
        out.line(format_args!("first : {};", index.keyword()));
    }

    fn find(&self, out: &mut Writer, block: &Block<'_>, entries: &Entries<'_>) {
        let call = [
            "#first :=".to_owned(),
            format!("{}(source :=", block.names.search),
            format!("ADR(#{}),", entries.array),
            format!("first_row := {},", entries.first),
            format!("last_row := {},", entries.last),
            "state := #state);".to_owned(),
        ];
        out.code_in_parts(&call);
    }

    fn cost(&self, entries: u64, _: bool) -> Cost {
        let halvings = halvings(entries);
        // The call, four statements around the loop.
        Cost { statements: 5 + 3 * halvings, iterations: halvings, probes: halvings }
    }
}

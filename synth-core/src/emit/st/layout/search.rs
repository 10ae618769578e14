//! The binary search: where it stands, and how it gets at its array.

use crate::emit::st::block::Block;
use crate::emit::st::bound::Cost;
use crate::emit::st::integer::Integer;
use crate::emit::st::unit::{Declarations, Kind, Section, Type, Unit};
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
    /// What it calls. All arrays have up to `length` entries, if their type must say it.
    fn functions<'a>(&self, block: &'a Block<'_>, length: Option<usize>) -> Vec<Unit<'a>>;

    /// Its variables in the function block; unless `several`, no [`Entries`] are.
    fn variables(&self, out: &mut Section, index: Integer, several: bool);

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
    fn functions<'a>(&self, _: &'a Block<'_>, _: Option<usize>) -> Vec<Unit<'a>> {
        Vec::new()
    }

    fn variables(&self, out: &mut Section, index: Integer, several: bool) {
        out.variable("first", index);
        if several {
            out.variable("last", index);
            out.variable("middle", index);
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
    fn functions<'a>(&self, block: &'a Block<'_>, length: Option<usize>) -> Vec<Unit<'a>> {
        let name = &block.names.search;
        let (state, index) = (block.types.state, block.types.index);
        // A pointer to an element is indexed as it is: CODESYS and TwinCAT do not look behind it.
        let (pointed, source) = match length {
            Some(length) => (Type::array(length.saturating_sub(1), state), "source^"),
            None => (state.into(), "source"),
        };
        let mut declarations = Declarations::default();
        declarations.section("VAR_INPUT", |out| {
            out.variable("source", Type::pointer(pointed));
            out.variable("first_row", index);
            out.variable("last_row", index);
            out.variable("state", state);
        });
        declarations.section("VAR", |out| {
            for variable in ["first", "last", "middle"] {
                out.variable(variable, index);
            }
        });
        let body = move |out: &mut Writer| {
            out.code("#first := #first_row;");
            out.code("#last := #last_row;");
            halve(out, source);
            out.code(format_args!("{name} := #first;"));
        };
        vec![Unit {
            comment: Some("The last entry of first_row to last_row that is not above state, or first_row."),
            kind: Kind::Function(index.into()),
            name,
            declarations,
            body: Box::new(body),
        }]
    }

    fn variables(&self, out: &mut Section, index: Integer, _: bool) {
        out.variable("first", index);
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

//! Runs of consecutive states, and a string of targets of as few bits as they need.

use proc_macro2::TokenStream;
use quote::quote;

use super::super::columns::{Column, Layout, Width, byte_string, number};
use super::super::commands::code_width;
use super::Rows;
use crate::controller::runs;
use crate::controller::tables::Tables;

/// More states have targets that the runtime's reader, four bytes at any bit, does not hold.
pub(super) const MOST_STATES: u32 = 1 << 25;

/// The columns of the runtime's `Runs`.
pub(super) struct Runs {
    first: Column,
    start: Column,
    base: Column,
    width: Column,
    state: Column,
    end: Column,
    /// The targets, the least significant bit first.
    bits: Vec<u32>,
    codes: Vec<Column>,
    /// The most runs of an event, and those of the super steps.
    most: (u32, u32),
}

impl Runs {
    pub(super) fn new(tables: &Tables) -> Runs {
        let runs = runs::Runs::of(tables);
        let states = Width::of(tables.states.saturating_sub(1));
        let mappings = runs.base.len();
        let mut bits = Bits::default();
        let (mut start, mut width) = (Vec::with_capacity(mappings), Vec::with_capacity(mappings));
        let mut end = Vec::with_capacity(runs.state.len());
        for mapping in 0..mappings {
            let own = runs.first[mapping] as usize..runs.first[mapping + 1] as usize;
            let rows = runs.row[own.start]..runs.row[own.end];
            let targets = &runs.target[rows.start as usize..rows.end as usize];
            let each = u32::BITS - targets.iter().max().map_or(0, |most| most.leading_zeros()).min(31);
            start.push(bits.length);
            width.push(if targets.is_empty() { 0 } else { each });
            end.extend(own.map(|run| runs.row[run + 1] - rows.start));
            targets.iter().for_each(|&target| bits.push(target, each));
        }
        let codes = tables.components.iter().zip(&runs.codes);
        let most = (0..mappings - 1).map(|mapping| runs.count(mapping)).max().unwrap_or(0);
        Runs {
            most: (most, runs.count(mappings - 1)),
            codes: codes.map(|(c, codes)| Column::new(code_width(c), codes.clone())).collect(),
            first: Column::narrow(runs.first),
            start: Column::narrow(start),
            base: Column::new(states, runs.base),
            width: Column::narrow(width),
            state: Column::new(states, runs.state),
            end: Column::narrow(end),
            bits: bits.finish(),
        }
    }
}

/// Numbers of any width, one behind the other.
#[derive(Default)]
struct Bits {
    bytes: Vec<u32>,
    length: u32,
}

impl Bits {
    fn push(&mut self, number: u32, width: u32) {
        for bit in 0..width {
            if self.length.is_multiple_of(8) {
                self.bytes.push(0);
            }
            if let Some(last) = self.bytes.last_mut() {
                *last |= (number >> bit & 1) << (self.length % 8);
            }
            self.length += 1;
        }
    }

    /// The bytes, with as many more as a reader of four bytes needs.
    fn finish(mut self) -> Vec<u32> {
        self.bytes.extend([0; 3]);
        self.bytes
    }
}

impl Rows for Runs {
    fn columns(&self) -> Vec<&Column> {
        vec![&self.first, &self.start, &self.base, &self.width, &self.state, &self.end]
    }

    fn further_bytes(&self) -> usize {
        self.bits.len()
    }

    fn probes(&self) -> (u32, u32) {
        // The search, on processors of 32 bits that which may end early, and both ends of the run that it finds.
        let probes = |runs: u32| runs.checked_ilog2().map_or(0, |log| log + 3);
        (probes(self.most.0), probes(self.most.1))
    }

    fn environment(&self) -> TokenStream {
        quote!(RUNS.lookup(event.index(), state))
    }

    fn super_step(&self) -> (TokenStream, TokenStream) {
        let mapping = number(self.base.numbers().len() as u32 - 1);
        let row = if self.codes.is_empty() { quote!(_) } else { quote!(row) };
        (quote!(let (#row, place) = RUNS.row(#mapping, state)?;), quote!(RUNS.target(#mapping, place)))
    }

    fn codes(&self) -> &[Column] {
        &self.codes
    }

    fn statics(&self, layout: Layout) -> TokenStream {
        let columns = [&self.first, &self.start, &self.state, &self.end, &self.base];
        let types = columns.map(|column| column.ty(layout));
        let [first, start, state, end, base] = columns.map(|column| column.value(layout));
        let width = self.width.value(Layout::Arrays);
        let (mappings, bytes) = (number(self.base.numbers().len() as u32), number(self.bits.len() as u32));
        let bits = byte_string(Width::One, &self.bits);
        quote! {
            /// Events in table order, then the super steps.
            static RUNS: ::controller_template::Runs<#(#types,)* #mappings, #bytes> =
                ::controller_template::Runs {
                    first: #first,
                    start: #start,
                    state: #state,
                    end: #end,
                    base: #base,
                    width: #width,
                    bits: *#bits,
                };
        }
    }
}

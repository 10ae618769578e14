//! Ascending sources, which are searched, and targets: the published tables, one behind the other.

use proc_macro2::TokenStream;
use quote::quote;

use super::super::columns::{Column, Layout, Width, number};
use super::super::commands::code_width;
use super::{Rows, searched};
use crate::controller::tables::{Mapping, Tables};

/// The columns of the runtime's `Mappings`: events in table order, then the super steps.
pub(super) struct Search {
    mappings: Mappings,
    codes: Vec<Column>,
    /// The most rows of an event, and those of the super steps.
    most: (usize, usize),
}

/// Several mapping functions in three columns.
struct Mappings {
    first: Column,
    source: Column,
    target: Column,
}

impl Mappings {
    /// One behind the other; the states are `0..states`.
    fn new<'m>(states: u32, mappings: impl Iterator<Item = &'m Mapping>) -> Mappings {
        let states = Width::of(states.saturating_sub(1));
        let mut first = vec![0];
        let (mut source, mut target) = (Vec::new(), Vec::new());
        for mapping in mappings {
            source.extend(&mapping.source);
            target.extend(&mapping.target);
            first.push(source.len() as u32);
        }
        Mappings {
            first: Column::narrow(first),
            source: Column::new(states, source),
            target: Column::new(states, target),
        }
    }

    fn columns(&self) -> [&Column; 3] {
        [&self.first, &self.source, &self.target]
    }

    /// Type and value.
    fn item(&self, layout: Layout) -> (TokenStream, TokenStream) {
        let (first_ty, ty) = (self.first.ty(layout), self.source.ty(layout));
        let [first, source, target] = self.columns().map(|column| column.value(layout));
        (
            quote!(::controller_template::Mappings<#first_ty, #ty>),
            quote! {
                ::controller_template::Mappings { first: #first, source: #source, target: #target }
            },
        )
    }
}

impl Search {
    pub(super) fn new(tables: &Tables) -> Search {
        let events = || tables.events.iter().map(|table| &table.mapping);
        let most = events().map(|mapping| mapping.source.len()).max().unwrap_or(0);
        Search {
            mappings: Mappings::new(tables.states, events().chain([&tables.super_steps])),
            codes: tables.components.iter().map(|c| Column::new(code_width(c), c.codes.clone())).collect(),
            most: (most, tables.super_steps.source.len()),
        }
    }
}

impl Rows for Search {
    fn columns(&self) -> Vec<&Column> {
        self.mappings.columns().into()
    }

    fn probes(&self) -> (u32, u32) {
        (searched(self.most.0), searched(self.most.1))
    }

    fn environment(&self) -> TokenStream {
        quote!(ROWS.lookup(event.index(), state))
    }

    fn super_step(&self) -> (TokenStream, TokenStream) {
        // Behind all events; one more entry of `first` ends them.
        let mapping = number(self.mappings.first.numbers().len() as u32 - 2);
        let row = if self.codes.is_empty() { quote!(_) } else { quote!(row) };
        (
            quote!(let (#row, target) = ROWS.row(#mapping, state)?;),
            quote!(::core::option::Option::Some(target)),
        )
    }

    fn codes(&self) -> &[Column] {
        &self.codes
    }

    fn statics(&self, layout: Layout) -> TokenStream {
        if self.mappings.source.numbers().is_empty() {
            return quote!();
        }
        let (ty, value) = self.mappings.item(layout);
        quote! {
            /// Events in table order, then the super steps.
            static ROWS: #ty = #value;
        }
    }
}

//! Two columns per event and a binary search, as published.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::super::columns::{Column, Layout, Width};
use super::super::commands::code_width;
use super::super::docs::code;
use super::super::idents::Idents;
use super::{Rows, searched};
use crate::controller::tables::{Mapping, Tables};

/// Sources, searched, and targets.
pub(super) struct Search<'a> {
    tables: &'a Tables,
    idents: &'a Idents,
    /// Per event with rows.
    events: Vec<Pair>,
    super_steps: Pair,
    codes: Vec<Column>,
}

/// The columns of a mapping function.
struct Pair {
    source: Column,
    target: Column,
}

impl Pair {
    fn new(states: Width, mapping: &Mapping) -> Pair {
        let column = |numbers: &Vec<u32>| Column::new(states, numbers.clone());
        Pair { source: column(&mapping.source), target: column(&mapping.target) }
    }

    /// `static name: Mapping<…> = …;`
    fn item(&self, doc: &str, name: &Ident, layout: Layout) -> TokenStream {
        let ty = self.source.ty(layout);
        let (source, target) = (self.source.value(layout), self.target.value(layout));
        quote! {
            #[doc = #doc]
            static #name: ::controller_template::Mapping<#ty> =
                ::controller_template::Mapping::new(#source, #target);
        }
    }
}

impl<'a> Search<'a> {
    pub(super) fn new(tables: &'a Tables, idents: &'a Idents) -> Search<'a> {
        let states = Width::of(tables.states.saturating_sub(1));
        let mappings = tables.events.iter().map(|table| &table.mapping);
        Search {
            tables,
            idents,
            events: mappings.filter(|m| !m.source.is_empty()).map(|m| Pair::new(states, m)).collect(),
            super_steps: Pair::new(states, &tables.super_steps),
            codes: tables.components.iter().map(|c| Column::new(code_width(c), c.codes.clone())).collect(),
        }
    }

    /// Events with rows, or those without.
    fn idents(&self, with_rows: bool) -> impl Iterator<Item = &super::super::idents::EventIdents> {
        let events = self.tables.events.iter().zip(&self.idents.events);
        events.filter(move |(table, _)| table.mapping.source.is_empty() != with_rows).map(|(_, names)| names)
    }
}

impl Rows for Search<'_> {
    fn columns(&self) -> Vec<&Column> {
        self.events.iter().chain([&self.super_steps]).flat_map(|pair| [&pair.source, &pair.target]).collect()
    }

    fn probes(&self) -> (u32, u32) {
        let probes = |pair: &Pair| searched(pair.source.numbers().len());
        (self.events.iter().map(probes).max().unwrap_or(0), probes(&self.super_steps))
    }

    fn environment(&self) -> TokenStream {
        let variants = self.idents(true).map(|names| &names.variant);
        let mappings = self.idents(true).map(|names| &names.mapping);
        let never: Vec<_> = self.idents(false).map(|names| &names.variant).collect();
        let never = (!never.is_empty()).then(|| quote!(#(Event::#never)|* => ::core::option::Option::None,));
        quote! {
            match event {
                #(Event::#variants => #mappings.lookup(state),)*
                #never
            }
        }
    }

    fn super_step(&self) -> (TokenStream, TokenStream) {
        (quote!(let row = SUPER_STEPS.row(state)?;), quote!(SUPER_STEPS.target(row)))
    }

    fn codes(&self) -> &[Column] {
        &self.codes
    }

    fn statics(&self, layout: Layout) -> TokenStream {
        let with_rows = self.tables.events.iter().filter(|table| !table.mapping.source.is_empty());
        let events = with_rows.zip(self.idents(true)).zip(&self.events).map(|((table, names), pair)| {
            pair.item(&format!(" {}", code(&table.event.text)), &names.mapping, layout)
        });
        let steps = (!self.tables.super_steps.source.is_empty())
            .then(|| self.super_steps.item(" Super steps.", &format_ident!("SUPER_STEPS"), layout));
        quote!(#(#events)* #steps)
    }
}

//! All rows of events in one array; super steps straight by their states.

use std::collections::BTreeMap;

use proc_macro2::TokenStream;
use quote::quote;

use super::super::columns::{Column, Layout, Width, number};
use super::super::commands::code_width;
use super::search::Mappings;
use super::{Rows, searched};
use crate::controller::comb;
use crate::controller::tables::Tables;

/// The columns of the runtime's `Comb`, and of the super steps.
pub(super) struct Comb {
    first: u32,
    displacement: Column,
    check: Column,
    target: Column,
    super_steps: SuperSteps,
    /// Per super step the number of its commands in `codes`.
    command_set: Column,
    codes: Vec<Column>,
}

/// Super steps, found by their states.
enum SuperSteps {
    /// Of consecutive states from the first on: targets.
    Span(u32, Column),
    /// Of any states: searched.
    Mapping(Mappings),
}

impl Comb {
    pub(super) fn new(tables: &Tables) -> Comb {
        let states = Width::of(tables.states.saturating_sub(1));
        let packed = comb::Comb::of(tables);
        let (sets, set_of) = command_sets(tables);
        let codes = tables.components.iter().enumerate();
        Comb {
            first: packed.first,
            displacement: Column::narrow(packed.displacement),
            check: Column::narrow(packed.check),
            target: Column::new(states, packed.target),
            super_steps: SuperSteps::new(tables),
            command_set: Column::narrow(set_of),
            codes: codes
                .map(|(c, table)| Column::new(code_width(table), sets.iter().map(|set| set[c]).collect()))
                .collect(),
        }
    }

    fn has_steps(&self) -> bool {
        !self.command_set.numbers().is_empty()
    }

    fn has_rows(&self) -> bool {
        !self.check.numbers().is_empty()
    }
}

impl SuperSteps {
    fn new(tables: &Tables) -> SuperSteps {
        let mapping = &tables.super_steps;
        let span = |first| {
            let states = Width::of(tables.states.saturating_sub(1));
            SuperSteps::Span(first, Column::new(states, mapping.target.clone()))
        };
        match mapping.source[..] {
            [first, .., last] if (last - first) as usize + 1 == mapping.source.len() => span(first),
            [first] => span(first),
            _ => SuperSteps::Mapping(Mappings::new(tables.states, [mapping].into_iter())),
        }
    }

    fn columns(&self) -> Vec<&Column> {
        match self {
            SuperSteps::Span(_, target) => vec![target],
            SuperSteps::Mapping(mapping) => mapping.columns().into(),
        }
    }

    fn item(&self, layout: Layout) -> TokenStream {
        let (ty, value) = match self {
            SuperSteps::Span(first, target) => {
                let (ty, target, first) = (target.ty(layout), target.value(layout), number(*first));
                (
                    quote!(::controller_template::Span<#ty>),
                    quote!(::controller_template::Span::new(#first, #target)),
                )
            }
            SuperSteps::Mapping(mapping) => mapping.item(layout),
        };
        quote! {
            /// Super steps.
            static SUPER_STEPS: #ty = #value;
        }
    }
}

/// The distinct codes of super steps, one per component, in order of their first rows, and per row which it has.
fn command_sets(tables: &Tables) -> (Vec<Vec<u32>>, Vec<u32>) {
    let mut known = BTreeMap::new();
    let mut sets = Vec::new();
    let mut set_of = Vec::with_capacity(tables.super_steps.source.len());
    for row in 0..tables.super_steps.source.len() {
        let set: Vec<u32> = tables.components.iter().map(|component| component.codes[row]).collect();
        set_of.push(*known.entry(set.clone()).or_insert_with(|| {
            sets.push(set);
            sets.len() as u32 - 1
        }));
    }
    (sets, set_of)
}

impl Rows for Comb {
    fn columns(&self) -> Vec<&Column> {
        let mut columns = vec![&self.displacement, &self.check, &self.target, &self.command_set];
        columns.extend(self.super_steps.columns());
        columns
    }

    fn probes(&self) -> (u32, u32) {
        let super_step = match &self.super_steps {
            SuperSteps::Span(..) => 0,
            SuperSteps::Mapping(_) => searched(self.command_set.numbers().len()),
        };
        (u32::from(self.has_rows()), super_step)
    }

    fn environment(&self) -> TokenStream {
        quote!(COMB.lookup(event.index(), state))
    }

    fn super_step(&self) -> (TokenStream, TokenStream) {
        let commands = (!self.codes.is_empty())
            .then(|| quote!(let row = ::controller_template::Column::index(&COMMAND_SET, step)?;));
        match &self.super_steps {
            SuperSteps::Span(..) => {
                (quote!(let step = SUPER_STEPS.row(state)?; #commands), quote!(SUPER_STEPS.target(step)))
            }
            SuperSteps::Mapping(_) => {
                let step = if self.codes.is_empty() { quote!(_) } else { quote!(step) };
                (
                    quote!(let (#step, target) = SUPER_STEPS.row(0, state)?; #commands),
                    quote!(::core::option::Option::Some(target)),
                )
            }
        }
    }

    fn codes(&self) -> &[Column] {
        &self.codes
    }

    fn statics(&self, layout: Layout) -> TokenStream {
        let rows = self.has_rows().then(|| {
            let columns = [&self.displacement, &self.check, &self.target];
            let types = columns.map(|column| column.ty(layout));
            let [displacement, check, target] = columns.map(|column| column.value(layout));
            let first = number(self.first);
            quote! {
                /// The rows of all events.
                static COMB: ::controller_template::Comb<#(#types),*> = ::controller_template::Comb {
                    displacement: #displacement,
                    first: #first,
                    check: #check,
                    target: #target,
                };
            }
        });
        let steps = self.has_steps().then(|| self.super_steps.item(layout));
        let commands = (self.has_steps() && !self.codes.is_empty()).then(|| {
            let (ty, value) = (self.command_set.ty(layout), self.command_set.value(layout));
            quote! {
                /// Per super step which commands it has.
                static COMMAND_SET: #ty = #value;
            }
        });
        quote!(#rows #steps #commands)
    }
}

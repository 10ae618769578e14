//! All rows of events in one array; super steps straight by their states.

use std::collections::BTreeMap;

use proc_macro2::TokenStream;
use quote::quote;

use super::super::columns::{Column, Layout, Width, number};
use super::super::commands::code_width;
use super::Rows;
use crate::controller::comb;
use crate::controller::tables::Tables;

/// The columns of the runtime's `Comb`, and of the super steps.
pub(super) struct Comb {
    first: u32,
    displacement: Column,
    check: Column,
    target: Column,
    /// The state of the first super step, if they are of consecutive states.
    first_step: Option<u32>,
    /// The number of events.
    events: u32,
    /// Per super step.
    step_target: Column,
    /// Per super step the number of its commands in `codes`.
    command_set: Column,
    codes: Vec<Column>,
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
            first_step: packed.super_steps,
            events: tables.events.len() as u32,
            step_target: Column::new(states, tables.super_steps.target.clone()),
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

    /// The targets of super steps.
    fn steps(&self, layout: Layout) -> TokenStream {
        let (ty, target) = (self.step_target.ty(layout), self.step_target.value(layout));
        let (ty, value) = match self.first_step {
            Some(first) => {
                let first = number(first);
                (
                    quote!(::controller_template::Span<#ty>),
                    quote!(::controller_template::Span::new(#first, #target)),
                )
            }
            None => (ty, target),
        };
        quote! {
            /// Targets of super steps.
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
        vec![&self.displacement, &self.check, &self.target, &self.command_set, &self.step_target]
    }

    fn probes(&self) -> (u32, u32) {
        (u32::from(self.has_rows()), u32::from(self.first_step.is_none()))
    }

    fn environment(&self) -> TokenStream {
        quote!(COMB.lookup(event.index(), state))
    }

    fn super_step(&self) -> (TokenStream, TokenStream) {
        let commands = (!self.codes.is_empty())
            .then(|| quote!(let row = ::controller_template::Column::index(&COMMAND_SET, step)?;));
        match self.first_step {
            Some(_) => {
                (quote!(let step = SUPER_STEPS.row(state)?; #commands), quote!(SUPER_STEPS.target(step)))
            }
            None => {
                let event = number(self.events);
                (
                    quote!(let step = COMB.index(#event, state)?; #commands),
                    quote!(::controller_template::Column::get(&SUPER_STEPS, step)),
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
        let steps = self.has_steps().then(|| self.steps(layout));
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

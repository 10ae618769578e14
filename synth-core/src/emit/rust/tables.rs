//! The static tables, and the marker type that hands them to the runtime.

use std::collections::BTreeMap;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::columns::{Layout, Width, number};
use super::controller::words;
use super::docs::code;
use super::engine::Rows;
use super::idents::Idents;
use crate::controller::tables::{FORMAT_VERSION, Tables};

/// `Tables`, then every static.
pub(super) fn items(tables: &Tables, idents: &Idents, rows: &dyn Rows) -> TokenStream {
    let owed = Owed::new(tables);
    let columns = rows.columns().into_iter().chain(rows.codes());
    let numbers: usize = columns.map(|column| column.numbers().len()).sum();
    let layout = Layout::of(numbers + owed.set.len() + owed.words.len());
    let version = number(FORMAT_VERSION);
    let marker = marker(tables, idents, rows);
    let owed_fn = owed.function();
    let statics = rows.statics(layout);
    let codes = codes(tables, idents, rows, layout);
    let owed = owed.statics(layout);
    quote! {
        /// Version of the meaning of these tables.
        pub const FORMAT_VERSION: u32 = #version;

        const _: () = ::core::assert!(
            FORMAT_VERSION == ::controller_template::FORMAT_VERSION,
            "generated for another version of `controller-template`"
        );

        #marker
        #owed_fn
        #statics
        #codes
        #owed
    }
}

/// The marker type and its implementation of the runtime's trait.
fn marker(tables: &Tables, idents: &Idents, rows: &dyn Rows) -> TokenStream {
    let state = Width::of(tables.states.saturating_sub(1)).ty();
    let [initial, states] = [tables.initial, tables.states].map(number);
    let environment = environment(tables, rows);
    let super_step = super_step(tables, idents, rows);
    quote! {
        #[derive(Clone, PartialEq, Eq, Debug)]
        struct Tables;

        impl ::controller_template::Tables for Tables {
            type State = #state;
            type Event = Event;
            type Commands = Commands;

            const VERSION: u32 = Controller::TABLE_VERSION;
            const STATES: u32 = #states;
            const INITIAL: #state = #initial;

            fn index(event: Event) -> usize {
                event.index()
            }

            fn event(index: usize) -> ::core::option::Option<Event> {
                Event::from_index(index)
            }

            #environment
            #super_step
        }
    }
}

fn environment(tables: &Tables, rows: &dyn Rows) -> TokenStream {
    if tables.events.iter().all(|table| table.mapping.source.is_empty()) {
        return quote! {
            fn environment(_: Event, _: Self::State) -> ::core::option::Option<Self::State> {
                ::core::option::Option::None
            }
        };
    }
    let target = rows.environment();
    quote! {
        fn environment(event: Event, state: Self::State) -> ::core::option::Option<Self::State> {
            #target
        }
    }
}

fn super_step(tables: &Tables, idents: &Idents, rows: &dyn Rows) -> TokenStream {
    if tables.super_steps.source.is_empty() {
        return quote! {
            fn super_step(_: Self::State) -> ::core::option::Option<(Self::State, Commands)> {
                ::core::option::Option::None
            }
        };
    }
    let (find, target) = rows.super_step();
    let fields = idents.components.iter().map(|component| &component.field);
    let commands = idents.components.iter().map(|component| &component.command);
    let codes = idents.components.iter().map(|component| &component.codes);
    quote! {
        fn super_step(state: Self::State) -> ::core::option::Option<(Self::State, Commands)> {
            #find
            let commands = Commands {
                #(#fields: #commands::from_code(::controller_template::Column::get(&#codes, row)?),)*
            };
            ::core::option::Option::Some((#target?, commands))
        }
    }
}

/// Per component the codes that super steps command.
fn codes(tables: &Tables, idents: &Idents, rows: &dyn Rows, layout: Layout) -> TokenStream {
    if tables.super_steps.source.is_empty() {
        return quote!();
    }
    let items = tables.components.iter().zip(&idents.components).zip(rows.codes());
    let items = items.map(|((table, names), column)| {
        let doc = format!(" Codes that super steps command to {}; 0 is none.", code(&table.object));
        let (name, ty, value) = (&names.codes, column.ty(layout), column.value(layout));
        quote!(#[doc = #doc] static #name: #ty = #value;)
    });
    quote!(#(#items)*)
}

/// Which events are owed in which state: the distinct sets, and per state the number of its set.
struct Owed {
    /// Number of events in words of 32.
    width: usize,
    /// The words of every distinct set, one set after the other, in order of their first states.
    words: Vec<u32>,
    /// Per state.
    set: Vec<u32>,
}

impl Owed {
    fn new(tables: &Tables) -> Self {
        let width = words(tables);
        let mut known: BTreeMap<&[u32], u32> = BTreeMap::new();
        let mut words = Vec::new();
        let mut set = Vec::with_capacity(tables.owed.len());
        for events in &tables.owed {
            let next = known.len() as u32;
            set.push(*known.entry(events).or_insert_with(|| {
                let first = words.len();
                words.resize(first + width, 0);
                for &event in events {
                    words[first + event as usize / 32] |= 1 << (event % 32);
                }
                next
            }));
        }
        Owed { width, words, set }
    }

    fn is_empty(&self) -> bool {
        self.words.iter().all(|&word| word == 0)
    }

    /// `Tables::owed(state)`.
    fn function(&self) -> TokenStream {
        let width = Literal::usize_unsuffixed(self.width);
        let function = if self.is_empty() {
            quote! {
                const fn owed(_: u32) -> ::controller_template::Bits<#width> {
                    ::controller_template::Bits::new([0; #width])
                }
            }
        } else {
            quote! {
                fn owed(state: u32) -> ::controller_template::Bits<#width> {
                    ::controller_template::Bits::of_state(&OWED_SET, &OWED, state)
                }
            }
        };
        quote!(impl Tables { #function })
    }

    fn statics(&self, layout: Layout) -> TokenStream {
        if self.is_empty() {
            return quote!();
        }
        let width = Width::of(self.set.iter().copied().max().unwrap_or(0));
        let set_ty = layout.ty(width, self.set.len());
        let set = layout.value(width, &self.set);
        let words_ty = layout.ty(Width::Four, self.words.len());
        let words = layout.value(Width::Four, &self.words);
        quote! {
            /// Per state, which set of events is owed there.
            static OWED_SET: #set_ty = #set;
            /// The sets, one bit an event.
            static OWED: #words_ty = #words;
        }
    }
}

//! The static tables, and the marker type that hands them to the runtime.

use std::collections::BTreeMap;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::columns::{Layout, Width, number};
use super::commands::code_width;
use super::controller::words;
use super::docs::code;
use super::idents::Idents;
use crate::controller::tables::{FORMAT_VERSION, Mapping, Tables};

/// `Tables`, then every static.
pub(super) fn items(tables: &Tables, idents: &Idents) -> TokenStream {
    let owed = Owed::new(tables);
    let shape = Shape {
        states: Width::of(tables.states.saturating_sub(1)),
        layout: Layout::of(numbers(tables, &owed)),
    };
    let version = number(FORMAT_VERSION);
    let marker = marker(tables, idents, shape);
    let owed_fn = owed.function();
    let statics = statics(tables, idents, shape);
    let owed = owed.statics(shape.layout);
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
        #owed
    }
}

/// What all columns have in common.
#[derive(Clone, Copy)]
struct Shape {
    states: Width,
    layout: Layout,
}

impl Shape {
    fn mapping(self, mapping: &Mapping) -> (TokenStream, TokenStream) {
        let ty = self.layout.ty(self.states, mapping.source.len());
        let source = self.layout.value(self.states, &mapping.source);
        let target = self.layout.value(self.states, &mapping.target);
        (
            quote!(::controller_template::Mapping<#ty>),
            quote!(::controller_template::Mapping::new(#source, #target)),
        )
    }
}

/// How many numbers all columns have.
fn numbers(tables: &Tables, owed: &Owed) -> usize {
    let rows = tables.events.iter().map(|table| table.mapping.source.len()).sum::<usize>();
    let steps = tables.super_steps.source.len() * (2 + tables.components.len());
    2 * rows + steps + owed.set.len() + owed.words.len()
}

/// The marker type and its implementation of the runtime's trait.
fn marker(tables: &Tables, idents: &Idents, shape: Shape) -> TokenStream {
    let state = shape.states.ty();
    let initial = number(tables.initial);
    let environment = environment(tables, idents);
    let super_step = super_step(tables, idents);
    quote! {
        #[derive(Clone, PartialEq, Eq, Debug)]
        struct Tables;

        impl ::controller_template::Tables for Tables {
            type State = #state;
            type Event = Event;
            type Commands = Commands;

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

fn environment(tables: &Tables, idents: &Idents) -> TokenStream {
    let (with, without): (Vec<_>, Vec<_>) =
        tables.events.iter().zip(&idents.events).partition(|(table, _)| !table.mapping.source.is_empty());
    let state = if with.is_empty() { quote!(_) } else { quote!(state) };
    let variants = with.iter().map(|(_, names)| &names.variant);
    let mappings = with.iter().map(|(_, names)| &names.mapping);
    let never = (!without.is_empty()).then(|| {
        let variants = without.iter().map(|(_, names)| &names.variant);
        quote!(#(Event::#variants)|* => ::core::option::Option::None,)
    });
    quote! {
        fn environment(event: Event, #state: Self::State) -> ::core::option::Option<Self::State> {
            match event {
                #(Event::#variants => #mappings.lookup(state),)*
                #never
            }
        }
    }
}

fn super_step(tables: &Tables, idents: &Idents) -> TokenStream {
    if tables.super_steps.source.is_empty() {
        return quote! {
            fn super_step(_: Self::State) -> ::core::option::Option<(Self::State, Commands)> {
                ::core::option::Option::None
            }
        };
    }
    let fields = idents.components.iter().map(|component| &component.field);
    let commands = idents.components.iter().map(|component| &component.command);
    let codes = idents.components.iter().map(|component| &component.codes);
    quote! {
        fn super_step(state: Self::State) -> ::core::option::Option<(Self::State, Commands)> {
            let row = SUPER_STEPS.row(state)?;
            let commands = Commands {
                #(#fields: #commands::from_code(::controller_template::Column::get(&#codes, row)?),)*
            };
            ::core::option::Option::Some((SUPER_STEPS.target(row)?, commands))
        }
    }
}

/// A mapping function per event that has rows, one of the super steps, and the codes of every component.
fn statics(tables: &Tables, idents: &Idents, shape: Shape) -> TokenStream {
    let events =
        tables.events.iter().zip(&idents.events).filter(|(table, _)| !table.mapping.source.is_empty()).map(
            |(table, names)| {
                let doc = format!(" {}", code(&table.event.text));
                let name = &names.mapping;
                let (ty, value) = shape.mapping(&table.mapping);
                quote!(#[doc = #doc] static #name: #ty = #value;)
            },
        );
    let steps = (!tables.super_steps.source.is_empty()).then(|| {
        let (ty, value) = shape.mapping(&tables.super_steps);
        let codes = tables.components.iter().zip(&idents.components).map(|(table, names)| {
            let doc = format!(" Codes that super steps command to {}; 0 is none.", code(&table.object));
            let name = &names.codes;
            let width = code_width(table);
            let ty = shape.layout.ty(width, table.codes.len());
            let value = shape.layout.value(width, &table.codes);
            quote!(#[doc = #doc] static #name: #ty = #value;)
        });
        quote! {
            /// Super steps.
            static SUPER_STEPS: #ty = #value;
            #(#codes)*
        }
    });
    quote! {
        #(#events)*
        #steps
    }
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

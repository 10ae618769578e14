//! `Event`: the environment's events.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::columns::Width;
use super::docs::code;
use super::idents::Idents;
use crate::controller::tables::Tables;

/// The enum, and its conversions to and from positions in table order.
pub(super) fn items(tables: &Tables, idents: &Idents) -> TokenStream {
    let count = Literal::usize_unsuffixed(tables.events.len());
    let variants = &idents.events;
    let docs = tables.events.iter().map(|table| format!(" {}", code(&table.event.text)));
    // An enum without variants has no representation and nothing to cast.
    let (repr, index) = if tables.events.is_empty() {
        (quote!(), quote!(match self {}))
    } else {
        let repr = Width::of(tables.events.len() as u32 - 1).ty();
        (quote!(#[repr(#repr)]), quote!(self as usize))
    };
    quote! {
        ::controller_template::formatted! {
            /// Events of the environment, in table order.
            #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
            #repr
            pub enum Event {
                #(#[doc = #docs] #variants,)*
            }
        }

        impl Event {
            const fn index(self) -> usize {
                #index
            }

            fn from_index(index: usize) -> ::core::option::Option<Self> {
                EVENTS.get(index).copied()
            }
        }

        static EVENTS: [Event; #count] = [#(Event::#variants),*];
    }
}

/// What there is with feature `names`.
pub(super) fn names(tables: &Tables, idents: &Idents) -> TokenStream {
    let count = Literal::usize_unsuffixed(tables.events.len());
    let variants = &idents.events;
    let texts = tables.events.iter().map(|table| &table.event.text);
    quote! {
        impl Event {
            /// Every event, in table order.
            pub const ALL: [Self; #count] = [#(Self::#variants),*];

            /// The event with a text.
            #[must_use]
            pub fn from_text(text: &str) -> ::core::option::Option<Self> {
                Self::ALL.into_iter().find(|event| event.text() == text)
            }

            /// `sender -> receiver.operation(arguments)`.
            #[must_use]
            pub const fn text(self) -> &'static str {
                match self {
                    #(Self::#variants => #texts,)*
                }
            }
        }
    }
}

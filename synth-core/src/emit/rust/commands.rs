//! `<Object>Command`, one enum per component, and `Commands`, at most one of each.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::columns::Width;
use super::docs::code;
use super::idents::{ComponentIdents, Idents};
use crate::controller::tables::{ComponentTable, Tables};

/// Every enum, then the struct.
pub(super) fn items(tables: &Tables, idents: &Idents) -> TokenStream {
    let enums = tables.components.iter().zip(&idents.components).map(|(table, names)| command(table, names));
    let set = set(tables, idents);
    quote! {
        #(#enums)*
        #set
    }
}

/// What there is with feature `names`.
pub(super) fn names(tables: &Tables, idents: &Idents) -> TokenStream {
    let items = tables.components.iter().zip(&idents.components).map(|(table, names)| {
        let command = &names.command;
        let variants = names.commands.iter().map(|command| &command.variant).collect::<Vec<_>>();
        let texts = table.commands.iter().map(|event| &event.text).collect::<Vec<_>>();
        quote! {
            impl #command {
                /// The command with a text.
                #[must_use]
                pub fn from_text(text: &str) -> ::core::option::Option<Self> {
                    match text {
                        #(#texts => ::core::option::Option::Some(Self::#variants),)*
                        _ => ::core::option::Option::None,
                    }
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
    });
    quote!(#(#items)*)
}

/// What there is with feature `serde`, as the runtime wants it.
pub(super) fn serialized(idents: &Idents) -> TokenStream {
    let commands = idents.components.iter().map(|component| &component.command).collect::<Vec<_>>();
    let fields = idents.components.iter().map(|component| &component.field);
    quote! {
        struct Commands {
            #(#fields: #commands,)*
        }
        struct Event;
        #(struct #commands;)*
    }
}

fn command(table: &ComponentTable, names: &ComponentIdents) -> TokenStream {
    let ComponentIdents { command, secondary, .. } = names;
    let doc = format!(" Commands to {}.", code(&table.object));
    let variants = names.commands.iter().map(|command| &command.variant).collect::<Vec<_>>();
    let methods = names.commands.iter().map(|command| &command.method);
    let docs = table.commands.iter().map(|event| format!(" {}", code(&event.text)));
    let codes = (1..=table.commands.len()).map(Literal::usize_unsuffixed).collect::<Vec<_>>();
    let ty = code_width(table).ty();
    quote! {
        ::controller_template::formatted! {
            #[doc = #doc]
            #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
            #[repr(#ty)]
            pub enum #command {
                #(#[doc = #docs] #variants = #codes,)*
            }
        }

        impl #command {
            /// The code in tables and in other languages' controllers; it is never 0.
            #[must_use]
            pub const fn code(self) -> #ty {
                self as #ty
            }

            /// The command of a code.
            #[must_use]
            pub const fn from_code(code: #ty) -> ::core::option::Option<Self> {
                match code {
                    #(#codes => ::core::option::Option::Some(Self::#variants),)*
                    _ => ::core::option::Option::None,
                }
            }

            /// Has the secondary do it.
            pub fn apply<S: #secondary + ?Sized>(self, secondary: &mut S) {
                match self {
                    #(Self::#variants => #secondary::#methods(secondary),)*
                }
            }
        }
    }
}

/// The type of a component's codes.
pub(super) fn code_width(table: &ComponentTable) -> Width {
    Width::of(table.commands.len() as u32)
}

fn set(tables: &Tables, idents: &Idents) -> TokenStream {
    let fields = idents.components.iter().map(|component| &component.field).collect::<Vec<_>>();
    let types = idents.components.iter().map(|component| &component.command);
    let docs = tables.components.iter().map(|table| format!(" To {}.", code(&table.object)));
    let dispatch = dispatch(idents);
    let (other, overlaps) = match fields.as_slice() {
        [] => (quote!(_), quote!(false)),
        [field] => (quote!(other), quote!(self.#field.is_some() && other.#field.is_some())),
        _ => (quote!(other), quote!(#((self.#fields.is_some() && other.#fields.is_some()))||*)),
    };
    quote! {
        ::controller_template::formatted! {
            /// What one call commands: at most one command to each component.
            #[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
            #[must_use = "a command that is not carried out is lost"]
            pub struct Commands {
                #(#[doc = #docs] pub #fields: ::core::option::Option<#types>,)*
            }
        }

        impl Commands {
            /// Whether there is none.
            #[must_use]
            pub fn is_empty(self) -> bool {
                self == <Self as ::core::default::Default>::default()
            }

            #dispatch
        }

        impl ::controller_template::CommandSet for Commands {
            fn overlaps(self, #other: Self) -> bool {
                #overlaps
            }

            fn union(self, #other: Self) -> Self {
                Self { #(#fields: self.#fields.or(other.#fields),)* }
            }
        }
    }
}

/// One method that hands every command to its secondary; none without components.
fn dispatch(idents: &Idents) -> TokenStream {
    if idents.components.is_empty() {
        return quote!();
    }
    let fields = idents.components.iter().map(|component| &component.field).collect::<Vec<_>>();
    let traits = idents.components.iter().map(|component| &component.secondary);
    quote! {
        /// Has every secondary do what is commanded to its component.
        pub fn dispatch(self, #(#fields: &mut (impl #traits + ?Sized)),*) {
            #(if let ::core::option::Option::Some(command) = self.#fields {
                command.apply(#fields);
            })*
        }
    }
}

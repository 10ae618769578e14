//! A trait per component: what its secondary state machine must be able to do.

use proc_macro2::TokenStream;
use quote::quote;

use super::docs::code;
use super::idents::Idents;
use crate::controller::tables::Tables;

/// Every trait.
pub(super) fn items(tables: &Tables, idents: &Idents) -> TokenStream {
    let traits = tables.components.iter().zip(&idents.components).map(|(table, names)| {
        let secondary = &names.secondary;
        let doc =
            format!(" Secondary of {}: starts what is commanded and returns at once.", code(&table.object));
        let methods = names.commands.iter().map(|command| &command.method);
        let docs = table.commands.iter().map(|event| format!(" {}", code(&event.text)));
        quote! {
            #[doc = #doc]
            pub trait #secondary {
                #(#[doc = #docs] fn #methods(&mut self);)*
            }
        }
    });
    quote!(#(#traits)*)
}

//! `Inputs`, `Outputs` and `Memory`.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::{Idents, doc};
use crate::emit::scan::Source;
use crate::plant::{Use, Variable};

pub(super) fn items(source: &Source<'_>, idents: &Idents) -> TokenStream {
    let inputs = fields(source, idents, |usage| usage == Use::Input);
    let analogues = (0..).zip(&idents.analogues).map(|(analogue, name)| {
        let fits = source.analogue_fits(analogue, i32::MIN.into(), i32::MAX.into());
        let integer = format_ident!("{}", if fits { "i32" } else { "i64" });
        let text = format!("`{}`", source.program.analogues[analogue as usize]);
        let doc = doc([text.as_str()]);
        quote!(#doc pub #name: #integer,)
    });
    let outputs = fields(source, idents, |usage| usage == Use::Output);
    let is_memory = |usage| matches!(usage, Use::Memory(_));
    let has_memory = source.program.variables.iter().any(|variable| is_memory(variable.usage));
    let memory_field = has_memory.then(|| {
        quote! {
            /// Relays of the controller, which are connected to nothing.
            pub memory: Memory,
        }
    });
    let memory = has_memory.then(|| memory(source, idents, &fields(source, idents, is_memory)));
    quote! {
        /// What sensors say, read before a scan.
        #[derive(Clone, Copy, Default, PartialEq, Eq, Hash, Debug)]
        pub struct Inputs {
            #inputs
            #(#analogues)*
        }
        /// What a scan sets and resets, and reads as the last one left it; all of it off at first.
        #[derive(Clone, Copy, Default, PartialEq, Eq, Hash, Debug)]
        pub struct Outputs {
            #outputs
            #memory_field
        }
        #memory
    }
}

fn memory(source: &Source<'_>, idents: &Idents, fields: &TokenStream) -> TokenStream {
    let initial = source.program.variables.iter().zip(&idents.variables).filter_map(|(variable, name)| {
        if let Use::Memory(value) = variable.usage { Some((name, value)) } else { None }
    });
    let (names, values): (Vec<_>, Vec<_>) = initial.unzip();
    // Clippy wants it derived where it can be.
    let (derived, written) = if values.contains(&true) {
        let default = quote! {
            impl Default for Memory {
                fn default() -> Self {
                    Self { #(#names: #values),* }
                }
            }
        };
        (None, Some(default))
    } else {
        (Some(quote!(Default,)), None)
    };
    quote! {
        /// What the controller remembers from scan to scan.
        #[derive(Clone, Copy, #derived PartialEq, Eq, Hash, Debug)]
        pub struct Memory {
            #fields
        }
        #written
    }
}

fn fields(source: &Source<'_>, idents: &Idents, wanted: impl Fn(Use) -> bool) -> TokenStream {
    let variables = source.program.variables.iter().zip(&idents.variables);
    let field = |(Variable { name, doc: lines, .. }, field): (&Variable, _)| {
        let title = format!("`{name}`");
        let lines = std::iter::once(title.as_str()).chain(super::gap(lines));
        let doc = doc(lines);
        quote!(#doc pub #field: bool,)
    };
    variables.filter(|(variable, _)| wanted(variable.usage)).map(field).collect()
}

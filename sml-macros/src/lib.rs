//! `sml!`: a verified controller from a scenario specification, at compile time.
//!
//! Written in place or in a file of its own, relative to the package:
//!
//! ```text
//! sml_macros::sml! { specification Cell { … } }
//! sml_macros::sml!("specs/cell.sml");
//! ```
//!
//! Both expand to `pub mod <specification>`; what is in there is described by the crate `controller-template`, which
//! the invoking crate must depend on. A specification that is wrong or that no controller can meet is a compile error
//! at the token that is to blame. For more than 200,000 states use a build script.

use proc_macro2::{Literal, TokenStream, TokenTree};
use quote::{quote, quote_spanned};
use std::path::PathBuf;

/// A verified controller from a scenario specification, see the [crate] documentation.
#[proc_macro]
pub fn sml(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    let tokens = TokenStream::from(input);
    let mut read_files = Vec::new();
    let package = PathBuf::from(std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default());
    let mut read = |path: &str| {
        let bytes = std::fs::read(package.join(path)).map_err(|error| error.to_string())?;
        read_files.push(path.to_owned());
        Ok(bytes)
    };
    let module = match path_literal(&tokens) {
        None => synth_core::embed::inline(&tokens, &mut read),
        Some((literal, path)) => match read(&path) {
            Ok(bytes) => synth_core::embed::file(&path, &bytes, literal.span(), &mut read),
            Err(why) => {
                let message =
                    format!("`{path}` cannot be read: {why}\n  help: paths are relative to the package");
                quote_spanned!(literal.span()=> ::core::compile_error! { #message })
            }
        },
    };
    // The compiler watches what is included, so a change of a file expands the macro again.
    let watched = read_files.iter().map(|path| {
        let path = if path.starts_with('/') {
            quote!(#path)
        } else {
            let path = format!("/{path}");
            quote!(::core::concat!(::core::env!("CARGO_MANIFEST_DIR"), #path))
        };
        quote!(
            const _: &[u8] = ::core::include_bytes!(#path);
        )
    });
    quote!(#module #(#watched)*).into()
}

/// The path, if the input is one string literal.
fn path_literal(tokens: &TokenStream) -> Option<(Literal, String)> {
    let mut tokens = tokens.clone().into_iter();
    let (Some(TokenTree::Literal(literal)), None) = (tokens.next(), tokens.next()) else { return None };
    let path = syn::parse_str::<syn::LitStr>(&literal.to_string()).ok()?.value();
    Some((literal, path))
}

//! `sml!`: a verified controller from a scenario specification, at compile time.
//!
//! Written in place or in a file of its own, relative to the package:
//!
//! ```text
//! sml_macros::sml! { specification Cell { … } }
//! sml_macros::sml!("specs/cell.sml");
//! ```
//!
//! An attribute in front chooses how generated code finds the row of a state: `#![engine = "auto"]` (what is taken without
//! one), `"search"`, `"runs"` or `"comb"`.
//!
//! ```text
//! sml_macros::sml! { #![engine = "runs"] "specs/cell.sml" }
//! ```
//!
//! Both expand to `pub mod <specification>`; what is in there is described by the crate `controller-template`, which
//! the invoking crate must depend on. A specification that is wrong or that no controller can meet is a compile error
//! at the token that is to blame. For more than 100,000 states use a build script, also for more than 10,000 in an editor:
//! rust-analyzer expands macros at every key, and gets the advice instead of a controller.

use proc_macro2::{Span, TokenStream, TokenTree};
use quote::{quote, quote_spanned};
use std::path::{Path, PathBuf};
use synth_core::embed::{self, Expander};
use synth_core::syntax::read_bounded;

/// A verified controller from a scenario specification, see the [crate] documentation.
#[proc_macro]
pub fn sml(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    let (engine, tokens) = match embed::engine(&TokenStream::from(input)) {
        Ok(split) => split,
        Err(error) => return error.into(),
    };
    let mut read_files = Vec::new();
    let package = PathBuf::from(std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default());
    let mut read = |path: &str| {
        let bytes = std::fs::File::open(package.join(path)).and_then(read_bounded);
        let bytes = bytes.map_err(|error| error.to_string())?;
        read_files.push(path.to_owned());
        Ok(bytes)
    };
    let expander = Expander::of(&std::env::current_exe().unwrap_or_default());
    let module = match Input::of(&tokens) {
        Input::Specification => embed::inline(&tokens, engine, expander, &mut read),
        Input::Path(span, path) => match read(&path) {
            Ok(bytes) => embed::file(&path, &bytes, span, engine, expander, &mut read),
            Err(why) => {
                let why =
                    format!("`{path}` cannot be read: {why}\n  help: paths are relative to the package");
                compile_error(span, &why)
            }
        },
        Input::Neither(span) => {
            compile_error(span, "expected a specification, or the path of one as a string and nothing else")
        }
    };
    // The compiler watches what is included, so a change of a file expands the macro again.
    let watched = read_files.iter().map(|path| {
        let path = if Path::new(path).is_absolute() {
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

enum Input {
    /// Tokens, right or wrong.
    Specification,
    /// One string literal.
    Path(Span, String),
    /// Something at this place that is no part of a path; a specification begins with a word.
    Neither(Span),
}

impl Input {
    fn of(tokens: &TokenStream) -> Input {
        let mut tokens = tokens.clone().into_iter();
        let Some(TokenTree::Literal(literal)) = tokens.next() else { return Input::Specification };
        match (syn::parse_str::<syn::LitStr>(&literal.to_string()), tokens.next()) {
            (Ok(path), None) if path.suffix().is_empty() => Input::Path(literal.span(), path.value()),
            (Ok(_), Some(more)) => Input::Neither(more.span()),
            _ => Input::Neither(literal.span()),
        }
    }
}

fn compile_error(span: Span, text: &str) -> TokenStream {
    quote_spanned!(span=> ::core::compile_error! { #text })
}

//! `sml!`: a verified controller from a scenario specification, at compile time. `plant!`: one from the automata of a plant.
//!
//! # Scenarios
//!
//! Written in place or in a file of its own, relative to the package:
//!
//! ```text
//! sml_macros::sml! { specification Cell { … } }
//! sml_macros::sml!("specs/cell.sml");
//! ```
//!
//! An attribute in front chooses how generated code finds the row of a state: `#![engine = "auto"]` (what is taken without
//! one), `"search"`, `"runs"` or `"comb"`. Another, `#![minimize = "ordered"]`, how the controller is made smaller: `"none"`, `"exact"` (what
//! is taken without one), `"assume"` or `"ordered"`. `#![monitor]` makes the monitor of the controller instead, `pub mod <specification>_monitor`.
//!
//! ```text
//! sml_macros::sml! { #![engine = "runs"] "specs/cell.sml" }
//! ```
//!
//! Both expand to `pub mod <specification>`; what is in there is described by the crate `controller-template`, which
//! the invoking crate must depend on. A specification that is wrong or that no controller can meet is a compile error
//! at the token that is to blame. For more than 100,000 states use a build script, also for more than 10,000 in an editor:
//! rust-analyzer expands macros at every key, and gets the advice instead of a controller. What it asks for again it gets from
//! memory, and a compiler from the folder that the environment variable `SML_CACHE` names.
//!
//! # Plants
//!
//! The same for plants of automata and constraints:
//!
//! ```text
//! sml_macros::plant! { plant Station { … } }
//! sml_macros::plant!("specs/station.plant");
//! ```
//!
//! They expand to `pub mod <plant>` with `Inputs`, `Outputs` and `scan`, which depends on nothing. Attributes in front:
//!
//! | attribute | what it does |
//! |---|---|
//! | `#![dont_care = "none"]` | impossible values of inputs issue no command; what is taken without it |
//! | `#![dont_care = "decodable"]`, `"all"` | shorter formulas, free where the plant never comes, or cannot be |
//! | `#![extract]` | at most one event a scan, the first in the order of the plant |
//! | `#![follow = "events"]` | a controller as `sml!` makes it, which follows events instead of reading states |
//!
//! A plant that is wrong, or whose constraints nothing can keep, is a compile error at the token that is to blame. The limits
//! are those of `sml!`.

use proc_macro2::{Span, TokenStream, TokenTree};
use quote::{quote, quote_spanned};
use std::path::{Path, PathBuf};
use synth_core::cache::{self, Folder, Recent, Store};
use synth_core::embed::{self, Expander, plant};
use synth_core::syntax::{Reader, read_bounded};

/// A verified controller from a scenario specification, see the [crate] documentation.
#[proc_macro]
pub fn sml(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    expand(input, "a specification", embed::choices, embed::inline, embed::file)
}

/// A state-feedback controller from the automata of a plant, see the [crate] documentation.
#[proc_macro]
pub fn plant(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    // Plants import nothing.
    expand(
        input,
        "a plant",
        plant::options,
        |tokens, choice, expander, store, _| plant::inline(tokens, choice, expander, store),
        |path, bytes, span, choice, expander, store, _| {
            plant::file(path, bytes, span, choice, expander, store)
        },
    )
}

/// Options in front, then `what`, or the path of a file with it.
fn expand<O>(
    input: proc_macro::TokenStream,
    what: &str,
    options: impl FnOnce(&TokenStream) -> Result<(O, TokenStream), TokenStream>,
    inline: impl FnOnce(&TokenStream, O, Expander, Option<&dyn Store>, Reader<'_>) -> TokenStream,
    file: impl FnOnce(&str, &[u8], Span, O, Expander, Option<&dyn Store>, Reader<'_>) -> TokenStream,
) -> proc_macro::TokenStream {
    let (options, tokens) = match options(&TokenStream::from(input)) {
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
    let folder = folder();
    let store: Option<&dyn Store> = match expander {
        Expander::Editor => Some(&RECENT),
        Expander::Compiler => folder.as_ref().map(|folder| folder as &dyn Store),
    };
    let module = match Input::of(&tokens) {
        Input::Inline => inline(&tokens, options, expander, store, &mut read),
        Input::Path(span, path) => match read(&path) {
            Ok(bytes) => file(&path, &bytes, span, options, expander, store, &mut read),
            Err(why) => {
                let why =
                    format!("`{path}` cannot be read: {why}\n  help: paths are relative to the package");
                compile_error(span, &why)
            }
        },
        Input::Neither(span) => {
            compile_error(span, &format!("expected {what}, or the path of one as a string and nothing else"))
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

/// What an editor is told again: its process lives on from key to key.
static RECENT: Recent = Recent::new();

/// A compiler's cache. Nobody but the user can say where it is: Cargo names no folder to macros.
fn folder() -> Option<Folder> {
    std::env::var_os(cache::VARIABLE).filter(|path| !path.is_empty()).map(Folder::at)
}

enum Input {
    /// Tokens, right or wrong.
    Inline,
    /// One string literal.
    Path(Span, String),
    /// Something at this place that is no part of a path; what can stand here begins with a word.
    Neither(Span),
}

impl Input {
    fn of(tokens: &TokenStream) -> Input {
        let mut tokens = tokens.clone().into_iter();
        let Some(TokenTree::Literal(literal)) = tokens.next() else { return Input::Inline };
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

//! What the macro `sml!` does with its input, without being a macro.

use crate::diagnostic::{Diagnostic, compile_errors, render};
use crate::emit::rust;
use crate::explore::Limits;
use crate::pipeline::{Options, Timings, compile};
use crate::syntax::{FileId, Loaded, Reader, load, load_imports, parse_tokens};
use proc_macro2::{Span, TokenStream};
use quote::quote_spanned;

/// More states than this are left to a build script, so that an editor that expands the macro does not hang.
pub const MACRO_STATES: usize = 200_000;

fn options() -> Options {
    Options { limits: Limits { states: MACRO_STATES, ..Limits::default() }, ..Options::default() }
}

/// The controller of a specification written in the macro, or a `compile_error!` at each token that is wrong.
///
/// `read` is asked for imported files, relative to the folder of the package.
#[must_use]
pub fn inline(tokens: &TokenStream, read: Reader<'_>) -> TokenStream {
    let (file, diagnostics) = parse_tokens(tokens.clone(), FileId(0));
    let Some(file) = file else { return compile_errors(&diagnostics, tokens) };
    let mut loaded = load_imports("sml!", file, read);
    loaded.diagnostics.splice(0..0, diagnostics);
    match compile(&loaded, &options(), &mut Timings::default()) {
        Ok(tables) => rust::module(&tables, &rust::Options::default()),
        Err(failure) => {
            let diagnostics =
                failure.diagnostics().into_iter().map(|d| advise(d, &loaded)).collect::<Vec<_>>();
            compile_errors(&diagnostics, tokens)
        }
    }
}

/// The controller of a specification in a file, or one `compile_error!` at `span` that shows what is wrong where.
#[must_use]
pub fn file(path: &str, bytes: &[u8], span: Span, read: Reader<'_>) -> TokenStream {
    let loaded = load(path, bytes, read);
    match compile(&loaded, &options(), &mut Timings::default()) {
        Ok(tables) => rust::module(&tables, &rust::Options::default()),
        Err(failure) => {
            let diagnostics =
                failure.diagnostics().into_iter().map(|d| advise(d, &loaded)).collect::<Vec<_>>();
            let text = render(&diagnostics, &loaded.sources, false);
            quote_spanned!(span=> ::core::compile_error! { #text })
        }
    }
}

/// A limit cannot be raised in a macro, but in a build script.
fn advise(diagnostic: Diagnostic, loaded: &Loaded) -> Diagnostic {
    if diagnostic.code != crate::diagnostic::Code::LimitReached {
        return diagnostic;
    }
    let file = loaded.sources.path(Loaded::MAIN);
    let file = if file == "sml!" { "cell.sml" } else { file };
    diagnostic.help(format!("move it to a build script: `synth_core::build::compile({file:?})`"))
}

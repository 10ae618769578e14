//! What the macro `sml!` does with its input, without being a macro.

use crate::diagnostic::{Code, Diagnostic, compile_errors, compile_errors_at};
use crate::emit::rust;
use crate::explore::Limits;
use crate::pipeline::{Options, Timings, compile};
use crate::syntax::{Loaded, Reader, load, load_imports, parse_tokens};
use proc_macro2::{Span, TokenStream};

/// More states than this are left to a build script, so that an editor that expands the macro does not hang.
pub const MACRO_STATES: usize = 200_000;

/// What outputs name as the file of a specification that has none.
const INLINE: &str = "sml!";

fn options() -> Options {
    Options { limits: Limits { states: MACRO_STATES, ..Limits::default() }, ..Options::default() }
}

/// The controller of a specification written in the macro, or a `compile_error!` at each token that is wrong.
///
/// `read` is asked for imported files, relative to the folder of the package.
#[must_use]
pub fn inline(tokens: &TokenStream, read: Reader<'_>) -> TokenStream {
    let (file, diagnostics) = parse_tokens(tokens.clone(), Loaded::MAIN);
    let mut loaded = file.map_or_else(Loaded::default, |file| load_imports(INLINE, file, read));
    loaded.diagnostics.splice(0..0, diagnostics);
    controller(&loaded).unwrap_or_else(|diagnostics| {
        let diagnostics = diagnostics.into_iter().map(advise_inline).collect::<Vec<_>>();
        compile_errors(&diagnostics, tokens, &loaded)
    })
}

/// The controller of a specification in a file, or a `compile_error!` at `span` for each mistake that shows its place.
#[must_use]
pub fn file(path: &str, bytes: &[u8], span: Span, read: Reader<'_>) -> TokenStream {
    let loaded = load(path, bytes, read);
    controller(&loaded).unwrap_or_else(|diagnostics| compile_errors_at(span, &diagnostics, &loaded.sources))
}

fn controller(loaded: &Loaded) -> Result<TokenStream, Vec<Diagnostic>> {
    match compile(loaded, &options(), &mut Timings::default()) {
        Ok(tables) => Ok(rust::module(&tables, &rust::Options::default())),
        Err(failure) => Err(failure.diagnostics().into_iter().map(|d| advise(d, loaded)).collect()),
    }
}

/// A limit cannot be raised in a macro, but in a build script.
fn advise(diagnostic: Diagnostic, loaded: &Loaded) -> Diagnostic {
    if diagnostic.code != Code::LimitReached {
        return diagnostic;
    }
    let file = loaded.sources.path(Loaded::MAIN);
    let file = if file == INLINE { "cell.sml" } else { file };
    diagnostic.help(format!("move it to a build script: `synth_core::build::compile({file:?})`"))
}

/// A macro is no file.
fn advise_inline(diagnostic: Diagnostic) -> Diagnostic {
    match diagnostic.code {
        Code::Empty if diagnostic.span.file == Loaded::MAIN => {
            let message = "the macro contains no specification".to_owned();
            Diagnostic { message, ..diagnostic }
                .help("write `specification Name { … }` here, or the path of a file as a string")
        }
        Code::MissingImport if diagnostic.span.file == Loaded::MAIN => {
            diagnostic.help("paths in the macro are relative to the package")
        }
        _ => diagnostic,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::Span;

    #[track_caller]
    fn check(path: &str, expect: &str) {
        let loaded = load(path, b"", &mut |_| Err(String::new()));
        let limit =
            Diagnostic::error(Code::LimitReached, Span::default(), "too large").help("raise `--max-states`");
        assert_eq!(advise(limit, &loaded).help.as_deref(), Some(expect));
    }

    #[test]
    fn beyond_the_limit_a_build_script_helps() {
        check(
            "specs/line.sml",
            "move it to a build script: `synth_core::build::compile(\"specs/line.sml\")`",
        );
        check(INLINE, "move it to a build script: `synth_core::build::compile(\"cell.sml\")`");
    }
}

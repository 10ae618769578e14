//! What the macro `sml!` does with its input, without being a macro; [`plant`] is the same for `plant!`.

mod attribute;
mod cached;
pub mod plant;

use self::attribute::{Attribute, take_off};
use self::cached::cached;
use crate::cache::{Key, Store};
use crate::controller::Level;
use crate::controller::tables::Provenance;
use crate::diagnostic::{Code, Diagnostic, compile_errors, compile_errors_at};
use crate::emit::rust::{self, Engine};
use crate::explore::Limits;
use crate::pipeline::{Options, Timings, compile};
use crate::syntax::{Loaded, Reader, load, load_imports, parse_tokens, print};
use proc_macro2::{Span, TokenStream};
use std::path::Path;

/// Who waits for the macro, and so how many states it may take.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Expander {
    /// `rustc`, which runs a macro unoptimised: 0.08 ms a state.
    Compiler,
    /// An editor, at every key.
    Editor,
}

impl Expander {
    /// The expander of this process: rust-analyzer runs macros in processes of its own, named after it.
    #[must_use]
    pub fn of(executable: &Path) -> Expander {
        let name = executable.file_name().unwrap_or_default().to_string_lossy();
        if name.contains("rust-analyzer") { Expander::Editor } else { Expander::Compiler }
    }

    /// More states than this are left to a build script.
    #[must_use]
    pub fn states(self) -> usize {
        match self {
            Expander::Compiler => 100_000,
            Expander::Editor => 10_000,
        }
    }

    fn options(self) -> Options {
        Options { limits: Limits { states: self.states(), ..Limits::default() }, ..Options::default() }
    }

    /// A limit cannot be raised in a macro, but in a build script that compiles `file`.
    fn advise(self, diagnostic: Diagnostic, file: &str) -> Diagnostic {
        if diagnostic.code != Code::LimitReached {
            return diagnostic;
        }
        let diagnostic = match self {
            Expander::Compiler => diagnostic,
            Expander::Editor => diagnostic.note(format!(
                "this is the limit of the macro in an editor; the compiler goes on to {} states",
                Expander::Compiler.states()
            )),
        };
        diagnostic.help(format!("move it to a build script: `synth_core::build::compile({file:?})`"))
    }
}

/// What the attributes of a macro choose.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Choices {
    /// How generated code finds the row of a state.
    pub engine: Engine,
    /// How the controller is made smaller.
    pub level: Level,
    /// Whether its monitor is made instead.
    pub monitor: bool,
}

/// Takes `#![engine = "…"]`, `#![minimize = "…"]` and `#![monitor]` off the beginning of the macro's input, which may have none.
///
/// # Errors
///
/// A `compile_error!` at what is wrong with it.
pub fn choices(tokens: &TokenStream) -> Result<(Choices, TokenStream), TokenStream> {
    const EXPECTED: &str = "`#![engine = \"…\"]`, `#![minimize = \"…\"]` or `#![monitor]`";
    let mut choices = Choices::default();
    let rest = take_off(tokens, EXPECTED, |Attribute { name, value, span }| match value {
        Some((value, at)) if name == "engine" => {
            choices.engine = value.parse().map_err(|why| (*at, why))?;
            Ok(())
        }
        Some((value, at)) if name == "minimize" => {
            choices.level = value.parse().map_err(|why| (*at, why))?;
            Ok(())
        }
        None if name == "monitor" => {
            choices.monitor = true;
            Ok(())
        }
        _ => Err((*span, format!("expected {EXPECTED}"))),
    })?;
    Ok((choices, rest))
}

/// What outputs name as the file of a specification that has none.
const INLINE: &str = "sml!";

/// The controller of a specification written in the macro, or a `compile_error!` at each token that is wrong.
///
/// `read` is asked for imported files, relative to the folder of the package; `store` for the module, which does not depend
/// on where the macro stands.
#[must_use]
pub fn inline(
    tokens: &TokenStream,
    choices: Choices,
    expander: Expander,
    store: Option<&dyn Store>,
    read: Reader<'_>,
) -> TokenStream {
    let (file, diagnostics) = parse_tokens(tokens.clone(), Loaded::MAIN);
    let mut loaded = file.map_or_else(Loaded::default, |file| load_imports(INLINE, file, read));
    loaded.diagnostics.splice(0..0, diagnostics);
    controller(&loaded, choices, expander, store).unwrap_or_else(|diagnostics| {
        let diagnostics = diagnostics.into_iter().map(advise_inline).collect::<Vec<_>>();
        compile_errors(&diagnostics, tokens, &loaded)
    })
}

/// The controller of a specification in a file, or a `compile_error!` at `span` for each mistake that shows its place.
#[must_use]
pub fn file(
    path: &str,
    bytes: &[u8],
    span: Span,
    choices: Choices,
    expander: Expander,
    store: Option<&dyn Store>,
    read: Reader<'_>,
) -> TokenStream {
    let loaded = load(path, bytes, read);
    controller(&loaded, choices, expander, store)
        .unwrap_or_else(|diagnostics| compile_errors_at(span, &diagnostics, &loaded.sources))
}

fn controller(
    loaded: &Loaded,
    choices: Choices,
    expander: Expander,
    store: Option<&dyn Store>,
) -> Result<TokenStream, Vec<Diagnostic>> {
    let Choices { engine, level, monitor } = choices;
    let options = Options { level, monitor, ..expander.options() };
    let key = || {
        let key = Key::new("sml!", &(engine, options)).sources(&loaded.sources);
        match loaded.files.last() {
            // Tokens have no text; as for the hash of the input, the canonical form stands for it.
            Some(main) if is_inline(loaded) => key.text(&print(main)),
            _ => key,
        }
    };
    // What cannot be read at all may be shown as if it could.
    let store = store.filter(|_| loaded.diagnostics.is_empty());
    cached(store, key, || match compile(loaded, &options, &mut Timings::default()) {
        Ok(mut tables) => {
            without_lines(&mut tables.provenance, INLINE);
            Ok(rust::module(&tables, &rust::Options { engine, ordered: options.is_ordered() }))
        }
        Err(failure) => {
            let file = file_to_be(loaded);
            Err(failure.diagnostics().into_iter().map(|d| expander.advise(d, file)).collect())
        }
    })
}

/// Requirements of a macro in place: a module that told their lines would be another one wherever the macro moves.
fn without_lines(provenance: &mut Provenance, inline: &str) {
    provenance.requirements.iter_mut().filter(|one| one.file == inline).for_each(|one| one.line = 0);
}

fn is_inline(loaded: &Loaded) -> bool {
    loaded.sources.path(Loaded::MAIN) == INLINE
}

/// The file of a specification, or what it could be called.
fn file_to_be(loaded: &Loaded) -> &str {
    if is_inline(loaded) { "cell.sml" } else { loaded.sources.path(Loaded::MAIN) }
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
        for expander in [Expander::Compiler, Expander::Editor] {
            let advised = expander.advise(limit.clone(), file_to_be(&loaded));
            assert_eq!(advised.help.as_deref(), Some(expect));
        }
    }

    #[test]
    fn editors_are_told_from_compilers() {
        let of = |path: &str| Expander::of(Path::new(path));
        assert_eq!(of("/toolchain/libexec/rust-analyzer-proc-macro-srv"), Expander::Editor);
        assert_eq!(of("/extension/rust-analyzer"), Expander::Editor);
        assert_eq!(of("/toolchain/bin/rustc"), Expander::Compiler);
        assert_eq!(of("/home/rust-analyzer/bin/rustc"), Expander::Compiler);
        assert_eq!(of(""), Expander::Compiler);
    }

    #[test]
    fn an_editor_waits_for_fewer_states() {
        // Fourteen lamps, each switched by a user of its own: 2^14 states.
        let lamps: String = (0..14).map(|i| format!("object lamp{i}: Lamp object user{i}: User ")).collect();
        let scenarios: String =
            (0..14).map(|i| format!("guarantee scenario S{i} {{ user{i} -> lamp{i}.setLit(*) }} ")).collect();
        let text = format!(
            "specification Lamps {{ domain {{ class Lamp {{ lit: bool }} class User {{ }} class Control {{ }} }} {lamps} \
             controllable {{ Control }} collaboration C {{ {scenarios} }} }}"
        );
        let tokens: TokenStream = text.parse().expect("tokens");
        let shown = inline(&tokens, Choices::default(), Expander::Editor, None, &mut |_| Err(String::new()))
            .to_string();
        for part in
            ["the limit of 10000 states was reached", "move it to a build script", "goes on to 100000"]
        {
            assert!(shown.contains(part), "{shown}");
        }
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

//! The same for plants: what the macro `plant!` does.

use super::Expander;
use super::attribute::{Attribute, Wrong, take_off};
use crate::diagnostic::{Code, Diagnostic, compile_errors, compile_errors_at};
use crate::emit::rust::scan;
use crate::emit::scan::Source;
use crate::pipeline::{Failure, Timings};
use crate::plant::{DontCare, Loaded, Options, pipeline};
use crate::syntax;
use proc_macro2::{Span, TokenStream};

/// What outputs name as the file of a plant that has none.
const INLINE: &str = "plant!";

/// Takes `#![dont_care = "…"]` and `#![extract]` off the beginning of the macro's input, which may have none.
///
/// # Errors
///
/// A `compile_error!` at what is wrong with them.
pub fn options(tokens: &TokenStream) -> Result<(Options, TokenStream), TokenStream> {
    const EXPECTED: &str = "`#![dont_care = \"…\"]` or `#![extract]`";
    let mut options = Options::default();
    let rest = take_off(tokens, EXPECTED, |Attribute { name, value, span }| {
        match (name.to_string().as_str(), value) {
            ("dont_care", Some((value, at))) => options.dont_care = dont_care(value, *at)?,
            ("extract", None) => options.extract = true,
            _ => return Err((*span, format!("expected {EXPECTED}"))),
        }
        Ok(())
    })?;
    Ok((options, rest))
}

fn dont_care(text: &str, at: Span) -> Result<DontCare, Wrong> {
    match text {
        "none" => Ok(DontCare::None),
        "decodable" => Ok(DontCare::Decodable),
        "all" => Ok(DontCare::All),
        _ => Err((at, format!("unknown policy `{text}`; there are `none`, `decodable`, `all`"))),
    }
}

/// The controller of a plant written in the macro, or a `compile_error!` at each token that is wrong.
#[must_use]
pub fn inline(tokens: &TokenStream, options: Options, expander: Expander) -> TokenStream {
    let loaded = Loaded::of_tokens(INLINE, tokens);
    module(&loaded, options, expander).unwrap_or_else(|diagnostics| {
        let diagnostics: Vec<_> = diagnostics.into_iter().map(advise_inline).collect();
        compile_errors(&diagnostics, tokens, &syntax::Loaded::default())
    })
}

/// The controller of a plant in a file, or a `compile_error!` at `span` for each mistake that shows its place.
#[must_use]
pub fn file(path: &str, bytes: &[u8], span: Span, options: Options, expander: Expander) -> TokenStream {
    let loaded = Loaded::of_file(path, bytes);
    module(&loaded, options, expander)
        .unwrap_or_else(|diagnostics| compile_errors_at(span, &diagnostics, &loaded.sources))
}

fn module(loaded: &Loaded, options: Options, expander: Expander) -> Result<TokenStream, Vec<Diagnostic>> {
    let (plant, _) = loaded.plant.as_ref().map_err(Clone::clone)?;
    let limits = expander.options().limits;
    let supervised = pipeline::control(plant, &limits, options, &mut Timings::default());
    let supervised = supervised.map_err(|failure| advise(&failure, loaded, expander))?;
    let program = &supervised.feedback.program;
    Ok(scan::module(&Source { program, events: &plant.events, provenance: &loaded.provenance }))
}

fn advise(failure: &Failure, loaded: &Loaded, expander: Expander) -> Vec<Diagnostic> {
    let file = loaded.sources.path(syntax::Loaded::MAIN);
    let file = if file == INLINE { "cell.plant" } else { file };
    failure.diagnostics().into_iter().map(|diagnostic| expander.advise(diagnostic, file)).collect()
}

/// A macro is no file.
fn advise_inline(diagnostic: Diagnostic) -> Diagnostic {
    if diagnostic.code != Code::Empty {
        return diagnostic;
    }
    Diagnostic { message: "the macro contains no plant".to_owned(), ..diagnostic }
        .help("write `plant Name { … }` here, or the path of a file as a string")
}

#[cfg(test)]
mod tests {
    use super::{Expander, Options, inline};
    use proc_macro2::TokenStream;

    #[test]
    fn an_editor_waits_for_fewer_states() {
        let lamps: String = (0..14)
            .map(|i| {
                format!(
                    "output Y{i} controllable on{i} {{ set Y{i} }} controllable off{i} {{ reset Y{i} }} automaton Lamp{i} {{ \
                     initial state Off [!Y{i}] {{ on{i} -> On }} state On [Y{i}] {{ off{i} -> Off }} }} "
                )
            })
            .collect();
        let tokens: TokenStream = format!("plant Lamps {{ {lamps} }}").parse().expect("tokens");
        let shown = inline(&tokens, Options::default(), Expander::Editor).to_string();
        for part in
            ["the limit of 10000 states was reached", "goes on to 100000", "compile(\\\"cell.plant\\\")"]
        {
            assert!(shown.contains(part), "{part}: {shown}");
        }
    }
}

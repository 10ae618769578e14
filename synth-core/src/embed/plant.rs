//! The same for plants: what the macro `plant!` does.

use super::attribute::{Attribute, Wrong, take_off};
use super::cached::cached;
use super::{Expander, without_lines};
use crate::cache::{Key, Store};
use crate::controller::Level;
use crate::controller::tables::{Provenance, Tables};
use crate::diagnostic::{Code, Diagnostic, compile_errors, compile_errors_at};
use crate::emit::rust::{self, scan};
use crate::emit::scan::Source;
use crate::explore::Limits;
use crate::pipeline::{Failure, Timings};
use crate::plant::{DontCare, Loaded, Options, Plant, event_based, pipeline};
use crate::syntax;
use proc_macro2::{Span, TokenStream};

/// What outputs name as the file of a plant that has none.
const INLINE: &str = "plant!";

/// What is asked for in front of a plant.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Choice {
    /// What program is made.
    pub options: Options,
    /// The controller follows events instead of reading states.
    pub follows_events: bool,
}

/// Takes `#![dont_care = "…"]`, `#![extract]` and `#![follow = "…"]` off the beginning of the macro's input, which may have none.
///
/// # Errors
///
/// A `compile_error!` at what is wrong with them.
pub fn options(tokens: &TokenStream) -> Result<(Choice, TokenStream), TokenStream> {
    const EXPECTED: &str = "`#![dont_care = \"…\"]`, `#![extract]` or `#![follow = \"…\"]`";
    let mut choice = Choice::default();
    let rest = take_off(tokens, EXPECTED, |Attribute { name, value, span }| {
        match (name.to_string().as_str(), value) {
            ("dont_care", Some((value, at))) => choice.options.dont_care = dont_care(value, *at)?,
            ("extract", None) => choice.options.extract = true,
            ("follow", Some((value, at))) => choice.follows_events = follows_events(value, *at)?,
            _ => return Err((*span, format!("expected {EXPECTED}"))),
        }
        Ok(())
    })?;
    Ok((choice, rest))
}

fn dont_care(text: &str, at: Span) -> Result<DontCare, Wrong> {
    match text {
        "none" => Ok(DontCare::None),
        "decodable" => Ok(DontCare::Decodable),
        "all" => Ok(DontCare::All),
        _ => Err((at, format!("unknown policy `{text}`; there are `none`, `decodable`, `all`"))),
    }
}

fn follows_events(text: &str, at: Span) -> Result<bool, Wrong> {
    match text {
        "states" => Ok(false),
        "events" => Ok(true),
        _ => Err((at, format!("a controller cannot follow `{text}`; there are `states` and `events`"))),
    }
}

/// The controller of a plant written in the macro, or a `compile_error!` at each token that is wrong.
///
/// `store` is asked for the module, which does not depend on where the macro stands.
#[must_use]
pub fn inline(
    tokens: &TokenStream,
    choice: Choice,
    expander: Expander,
    store: Option<&dyn Store>,
) -> TokenStream {
    let loaded = Loaded::of_tokens(INLINE, tokens);
    module(&loaded, choice, expander, store).unwrap_or_else(|diagnostics| {
        let diagnostics: Vec<_> = diagnostics.into_iter().map(advise_inline).collect();
        compile_errors(&diagnostics, tokens, &syntax::Loaded::default())
    })
}

/// The controller of a plant in a file, or a `compile_error!` at `span` for each mistake that shows its place.
#[must_use]
pub fn file(
    path: &str,
    bytes: &[u8],
    span: Span,
    choice: Choice,
    expander: Expander,
    store: Option<&dyn Store>,
) -> TokenStream {
    let loaded = Loaded::of_file(path, bytes);
    module(&loaded, choice, expander, store)
        .unwrap_or_else(|diagnostics| compile_errors_at(span, &diagnostics, &loaded.sources))
}

fn module(
    loaded: &Loaded,
    choice: Choice,
    expander: Expander,
    store: Option<&dyn Store>,
) -> Result<TokenStream, Vec<Diagnostic>> {
    let (plant, _) = loaded.plant.as_ref().map_err(Clone::clone)?;
    let limits = expander.options().limits;
    let key = || Key::new("plant!", &(choice, limits)).sources(&loaded.sources).text(&loaded.canonical);
    cached(store, key, || {
        let module = synthesize(plant, choice, &limits, loaded.provenance.clone());
        module.map_err(|failure| advise(&failure, loaded, expander))
    })
}

fn synthesize(
    plant: &Plant,
    choice: Choice,
    limits: &Limits,
    provenance: Provenance,
) -> Result<TokenStream, Failure> {
    let timings = &mut Timings::default();
    if choice.follows_events {
        let followed = pipeline::follow(plant, limits, Level::default(), timings)?;
        let options = " --follow events".to_owned();
        let mut provenance = event_based::provenance(plant, Provenance { options, ..provenance });
        without_lines(&mut provenance, INLINE);
        let tables = Tables::new(&plant.name, &followed.controller, provenance);
        return Ok(rust::module(&tables, &rust::Options::default()));
    }
    let supervised = pipeline::control(plant, limits, choice.options, timings)?;
    let provenance = Provenance { options: choice.options.words(), ..provenance };
    let program = &supervised.feedback.program;
    Ok(scan::module(&Source { program, events: &plant.events, provenance: &provenance }))
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
    use super::{Choice, Expander, inline};
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
        let shown = inline(&tokens, Choice::default(), Expander::Editor, None).to_string();
        for part in
            ["the limit of 10000 states is too small", "goes on to 100000", "compile(\\\"cell.plant\\\")"]
        {
            assert!(shown.contains(part), "{part}: {shown}");
        }
    }
}

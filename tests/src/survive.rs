//! What must hold of any bytes that are given as a specification or a plant: for the fuzz target, and for what it found.

use proc_macro2::TokenStream;
use synth_core::diagnostic::{Diagnostic, compile_errors, render, to_json};
use synth_core::explore::Limits;
use synth_core::pipeline::{Failure, Options, Timings, play_and_solve, specification, synthesize};
use synth_core::plant;
use synth_core::syntax::ast::File;
use synth_core::syntax::{FileId, Loaded, Pos, Sources, Span, load, parse_text, parse_tokens, print};

/// Reads, resolves, plays a little, synthesizes, and shows every diagnostic in every format; reads and resolves the same
/// bytes as a plant.
///
/// # Panics
/// When something panics, a place lies outside the text, a text is refused without a diagnostic or accepted with one,
/// a tree changes by being printed and read, or a controller does not pass verification.
pub fn check(bytes: &[u8]) {
    let loaded = load("x.sml", bytes, &mut |_| Err("there are no other files".to_owned()));
    check_diagnostics(&loaded.diagnostics, &loaded.sources);
    if let Ok(text) = std::str::from_utf8(bytes) {
        check_tree(text);
        check_tokens(text);
        check_plant(text);
    }
    match specification(&loaded) {
        Ok(spec) => {
            if let Err(failure) = play(&spec) {
                check_diagnostics(&failure.diagnostics(), &loaded.sources);
            }
        }
        Err(failure) => {
            let found = failure.diagnostics();
            assert!(!found.is_empty(), "refused without a word");
            check_diagnostics(&found, &loaded.sources);
        }
    }
}

/// Few states: most of what can go wrong goes wrong at once.
fn play(spec: &synth_core::model::Spec) -> Result<(), Failure> {
    let options = Options {
        limits: Limits { states: 60, memory: 64 << 20, ..Limits::default() },
        ..Options::default()
    };
    let mut timings = Timings::default();
    let mut solved = play_and_solve(spec, &options, &mut timings)?;
    let made = synthesize(&mut solved, &options, &mut timings);
    let ours = matches!(made, Err(Failure::Unverified(_) | Failure::Inconsistent(_)));
    assert!(!ours, "{made:?}");
    made.map(drop)
}

fn check_tree(text: &str) {
    let (tree, errors) = parse_text(text, FileId(0));
    assert!(tree.is_some() || !errors.is_empty(), "refused without a word");
    assert!(errors.is_sorted_by_key(|d| d.span.start), "the first mistake is not told first");
    let (Some(tree), true) = (tree, errors.is_empty()) else { return };
    let printed = print(&tree);
    let (again, errors) = parse_text(&printed, FileId(0));
    assert_eq!(errors, [], "what was printed cannot be read:\n{printed}");
    let again = again.expect("a tree without errors");
    assert_eq!(shape(&tree), shape(&again), "{printed}");
    assert_eq!(printed, print(&again));
}

/// The tree without its places.
#[must_use]
pub fn shape(file: &File) -> String {
    let text = format!("{file:?}");
    let mut pieces = text.split(": Span {");
    let mut shape = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        shape.push_str(piece.split_once("} }").map_or(piece, |(_, rest)| rest));
    }
    shape
}

/// The same bytes as a plant.
fn check_plant(text: &str) {
    let found = match plant::read(text, FileId(0)) {
        Ok((plant, warnings)) => [warnings, plant::unreadable(&plant)].concat(),
        Err(errors) => {
            assert!(!errors.is_empty(), "refused without a word");
            errors
        }
    };
    let mut sources = Sources::new();
    sources.add("x.plant", text);
    check_diagnostics(&found, &sources);
    let (Some(tree), errors) = plant::parse_text(text, FileId(0)) else { return };
    if errors.is_empty() {
        let printed = plant::print(&tree);
        let (again, errors) = plant::parse_text(&printed, FileId(0));
        assert_eq!(errors, [], "what was printed cannot be read:\n{printed}");
        assert_eq!(again.map(|tree| plant::print(&tree)), Some(printed));
    }
}

/// The way of a macro, whose tokens come from Rust's lexer.
fn check_tokens(text: &str) {
    let Ok(tokens) = text.parse::<TokenStream>() else { return };
    let (tree, errors) = parse_tokens(tokens.clone(), FileId(0));
    assert!(tree.is_some() || !errors.is_empty(), "refused without a word");
    let shown = compile_errors(&errors, &tokens, &Loaded::default());
    assert_eq!(shown.is_empty(), errors.is_empty());
}

fn check_diagnostics(diagnostics: &[Diagnostic], sources: &Sources) {
    for diagnostic in diagnostics {
        assert!(!diagnostic.message.is_empty());
        check_place(diagnostic.span, sources, diagnostic);
        diagnostic.labels.iter().for_each(|(span, _)| check_place(*span, sources, diagnostic));
    }
    for color in [false, true] {
        assert_eq!(render(diagnostics, sources, color).is_empty(), diagnostics.is_empty());
    }
    assert_eq!(to_json(diagnostics, sources).as_array().map(Vec::len), Some(diagnostics.len()));
}

/// A place without a line concerns the whole; any other lies in the text, its end behind its start.
fn check_place(span: Span, sources: &Sources, diagnostic: &Diagnostic) {
    if span.start.line == 0 {
        return;
    }
    let text = sources.text(span.file);
    let lines: Vec<usize> = text.split('\n').map(|line| line.chars().count()).collect();
    let lies_in = |at: Pos| {
        let line = lines.get(at.line as usize - 1);
        // The replacement of what is not UTF-8, and the end of a line, are one column wide.
        line.is_some_and(|&length| at.column >= 1 && at.column as usize <= length + 2)
    };
    assert!(lies_in(span.start) && lies_in(span.end) && span.start <= span.end, "{diagnostic:?}");
    assert!(text.get(sources.bytes(span)).is_some(), "{diagnostic:?}");
}

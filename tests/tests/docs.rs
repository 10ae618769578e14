//! The documentation keeps its word: every `sml` and `plant` block of `docs/*.md` and `README.md` is what its info string says.
//!
//! | Info string | The block |
//! |---|---|
//! | `sml` | is realizable and compiles to verified tables |
//! | `sml,unrealizable` | is not realizable |
//! | `sml,error,SML0029` | is refused with exactly these codes, in this order |
//! | `sml,fragment` | can be read as sections, scenarios or the body of one |
//!
//! | `plant` | is a plant without warnings, whose states can be read and whose constraints can be kept |
//! | `plant,fragment` | can be read as items of a plant |
//!
//! `classic=realizable` or `classic=unrealizable` behind any of the first two adds the verdict of classic semantics.

use sml_tests::{corpus, fast};
use std::path::{Path, PathBuf};
use synth_core::explore::Limits;
use synth_core::pipeline::{Failure, Options, Timings, compile};
use synth_core::plant;
use synth_core::playout::Semantics;
use synth_core::syntax::{FileId, RESERVED};

/// A fenced block: its text, where it begins, the language, and what follows it in the info string.
struct Block {
    place: String,
    language: String,
    claims: Vec<String>,
    text: String,
}

fn blocks(name: &str, page: &str) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut lines = (1..).zip(page.lines());
    while let Some((number, line)) = lines.next() {
        let Some(info) = line.trim_start().strip_prefix("```") else { continue };
        let body = lines.by_ref().map(|(_, line)| line).take_while(|line| line.trim_start() != "```");
        let text: String = body.flat_map(|line| [line, "\n"]).collect();
        let mut words = info.split(',').map(|word| word.trim().to_owned());
        let language = words.next().unwrap_or_default();
        if matches!(language.as_str(), "sml" | "plant") {
            blocks.push(Block { place: format!("{name}:{number}"), language, claims: words.collect(), text });
        }
    }
    blocks
}

fn verdict(text: &str, classic: bool) -> Result<(), Failure> {
    let options = Options { semantics: Semantics { classic }, ..Options::default() };
    compile(&fast::loaded(text), &options, &mut Timings::default()).map(|_| ())
}

/// What became of the block, in the words of an info string.
fn outcome(text: &str, classic: bool) -> String {
    match verdict(text, classic) {
        Ok(()) => "realizable".to_owned(),
        Err(Failure::Unrealizable(_)) => "unrealizable".to_owned(),
        Err(failure) => {
            let codes: Vec<String> = failure.diagnostics().iter().map(|d| d.code.to_string()).collect();
            codes.join(",")
        }
    }
}

fn can_be_read(text: &str) -> bool {
    let wrapped = [
        format!("specification X {{ {text} }}"),
        format!("specification X {{ collaboration C {{ {text} }} }}"),
        format!("specification X {{ collaboration C {{ guarantee scenario S {{ {text} }} }} }}"),
    ];
    wrapped.iter().any(|text| corpus::parse(text).is_ok())
}

/// Why the block about a plant breaks its word.
fn broken_plant(block: &Block) -> Option<String> {
    let claims: Vec<&str> = block.claims.iter().map(String::as_str).collect();
    let (text, whole) = match claims.as_slice() {
        [] => (block.text.clone(), true),
        ["fragment"] => (format!("plant X {{ {} }}", block.text), false),
        _ => return Some(format!("unknown claims {claims:?}")),
    };
    let found = if whole {
        match plant::read(&text, FileId(0)) {
            Err(errors) => errors,
            Ok((plant, odd)) => match plant::supervise(&plant, &Limits::default()) {
                Err(_) => return Some("no feedback keeps the constraints".to_owned()),
                Ok(closed) => [odd, plant::unreadable(&plant), plant::warnings(&plant, &closed)].concat(),
            },
        }
    } else {
        plant::parse_text(&text, FileId(0)).1
    };
    let codes: Vec<String> = found.iter().map(|d| format!("{} {}", d.code, d.message)).collect();
    (!codes.is_empty()).then(|| codes.join(", "))
}

/// Why the block breaks its word.
fn broken(block: &Block) -> Option<String> {
    if block.language == "plant" {
        return broken_plant(block);
    }
    let claims: Vec<&str> = block.claims.iter().map(String::as_str).collect();
    let (expected, classic) = match claims.as_slice() {
        ["fragment"] if can_be_read(&block.text) => return None,
        ["fragment"] => return Some("no fragment of a specification".to_owned()),
        ["error", codes @ ..] if !codes.is_empty() => (codes.join(","), None),
        ["unrealizable"] => ("unrealizable".to_owned(), None),
        ["unrealizable", classic] => ("unrealizable".to_owned(), classic.strip_prefix("classic=")),
        [] => ("realizable".to_owned(), None),
        [classic] if classic.starts_with("classic=") => {
            ("realizable".to_owned(), classic.strip_prefix("classic="))
        }
        _ => return Some(format!("unknown claims {claims:?}")),
    };
    let found = outcome(&block.text, false);
    if found != expected {
        return Some(format!("{found} instead of {expected}"));
    }
    let classic = classic.map(|expected| (expected, outcome(&block.text, true)));
    classic
        .filter(|(expected, found)| expected != found)
        .map(|(expected, found)| format!("classic: {found} instead of {expected}"))
}

/// The pages, those of `docs` by name.
fn pages() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut pages: Vec<PathBuf> = std::fs::read_dir(root.join("docs"))
        .expect("the documentation exists")
        .map(|entry| entry.expect("the documentation is readable").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "md"))
        .collect();
    pages.sort();
    pages.extend(Some(root.join("README.md")).filter(|path| path.exists()));
    pages
}

#[test]
fn specifications_are_what_they_are_said_to_be() {
    let mut checked = 0;
    let mut wrong = Vec::new();
    for path in pages() {
        let page = std::fs::read_to_string(&path).expect("the page is text");
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        for block in blocks(&name, &page) {
            checked += 1;
            wrong.extend(broken(&block).map(|why| format!("{}: {why}", block.place)));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(checked >= 5, "only {checked} blocks were found");
}

fn words(text: &str) -> Vec<&str> {
    text.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).collect()
}

/// Whether one of the spellings in the first cell of the row occurs in the text, as far as keywords tell.
fn uses(row: &str, text: &str) -> bool {
    let cell = row.trim_start_matches('|').split(" | ").next().unwrap_or_default();
    let used = words(text);
    let spellings: Vec<&str> = cell.split('`').skip(1).step_by(2).collect();
    spellings.is_empty()
        || spellings.iter().any(|spelling| {
            let told = words(spelling).into_iter().filter(|word| RESERVED.contains(word));
            told.into_iter().all(|word| used.contains(&word))
                && ["*", "..=", "="].iter().all(|sign| !spelling.contains(sign) || text.contains(sign))
        })
}

#[test]
fn a_row_without_its_construct_is_found() {
    assert!(uses("| `wait strict [c]` | waits | `x` |", "wait strict [true]"));
    assert!(!uses("| `wait strict [c]` | waits | `x` |", "wait [true]"));
    assert!(uses("| `urgent`, `requested` | soon | `x` |", "requested a -> b.c()"));
    assert!(!uses("| argument `*` | any | `x` |", "a -> b.c()"));
}

/// Examples that the pages name exist, and use what the row is about: a specification in a cell of its own after a
/// construct.
#[test]
fn the_corpus_is_covered_by_the_language_reference() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/language.md");
    let page = std::fs::read_to_string(page).expect("the language reference exists");
    let known = corpus::all();
    let examples = page.lines().filter(|line| line.starts_with('|')).filter_map(|line| {
        let cell = line.trim_end_matches('|').rsplit('|').next()?.trim();
        let name = cell.strip_prefix('`')?.strip_suffix('`').filter(|name| !name.starts_with('-'))?;
        Some((line, name))
    });
    let mut checked = 0;
    for (row, example) in examples {
        let text = if example.contains('/') {
            let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(example);
            std::fs::read_to_string(path).ok()
        } else {
            known.iter().find(|entry| entry.name == example).map(|entry| entry.text.clone())
        };
        let text = text.unwrap_or_else(|| panic!("there is no example `{example}`"));
        assert!(uses(row, &text), "`{example}` does not use {row}");
        checked += 1;
    }
    assert!(checked > 30, "only {checked} examples were found");
}

#[track_caller]
fn check(info: &str, text: &str, expect: Option<&str>) {
    let page = format!("text\n```{info}\n{text}\n```\ntext\n");
    let blocks = blocks("page", &page);
    let found = blocks.first().map(|block| broken(block).unwrap_or_default());
    assert_eq!(found.as_deref(), expect);
}

const LAMP: &str = "specification L { domain d { class C { go() } class L { on() } } object c: C object l: L \
                    controllable { C } collaboration S { guarantee scenario G { l -> c.go() urgent c -> l.on() } } }";

#[test]
fn false_claims_are_found() {
    check("rust", LAMP, None);
    check("sml", LAMP, Some(""));
    check("sml,classic=realizable", LAMP, Some(""));
    check("sml,classic=unrealizable", LAMP, Some("classic: realizable instead of unrealizable"));
    check("sml,unrealizable", LAMP, Some("realizable instead of unrealizable"));
    check("sml,error,SML0004", LAMP, Some("realizable instead of SML0004"));
    check("sml,error", LAMP, Some("unknown claims [\"error\"]"));
    check("sml", "specification L { }", Some("SML0026 instead of realizable"));
    check("sml,fragment", "urgent c -> l.on()", Some(""));
    check("sml,fragment", "urgent c l.on()", Some("no fragment of a specification"));
    check("plant", "plant X { automaton A { initial state B } }", Some(""));
    check("plant", "plant X { }", Some("SML0126 the plant `X` has no component"));
    check(
        "plant",
        "plant X { input C automaton A { initial state B } }",
        Some("SML0097 nothing uses the input `C`"),
    );
    let refused = "plant X { automaton A { initial state B } constraint C: never A.B }";
    check("plant", refused, Some("no feedback keeps the constraints"));
    check("plant,fragment", "input A", Some(""));
    check("plant,fragment", "input", Some("SML0004 expected the name of an input, found `}`"));
    check("plant,error", "", Some("unknown claims [\"error\"]"));
}

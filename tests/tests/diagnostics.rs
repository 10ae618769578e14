//! The table of diagnostic codes: its examples are what they are said to be, and the page `docs/diagnostics.md` is it.

use sml_tests::fast;
use std::fmt::Write as _;
use std::path::Path;
use synth_core::diagnostic::{Code, Severity};
use synth_core::explore::Limits;
use synth_core::pipeline::{Failure, Options, Timings, compile};
use synth_core::plant;
use synth_core::syntax::FileId;

/// What the examples speak of, those of section 1 to 19 aside, which only have to be read.
const WORLD: &str = "
  domain world {
    class Lamp { lit: bool  level: 0..=3  next: Lamp  on()  dim(to: 0..=3) }
    class Controller { pressed() asked() }
    class User { }
  }
  object controller: Controller
  object lamp: Lamp
  object user: User
  controllable { Controller }
";

/// Where an example can stand: with `HERE` in its place a text is a specification.
fn contexts() -> Vec<String> {
    let promise =
        "assumption scenario Promise { user -> controller.pressed() eventually user -> controller.asked() }";
    vec![
        "HERE".to_owned(),
        "HERE specification X { }".to_owned(),
        "specification X { domain { HERE } }".to_owned(),
        "specification X { domain { class A { HERE } } }".to_owned(),
        "specification X { domain { class Door { } } HERE }".to_owned(),
        format!("specification X {{ {WORLD} HERE }}"),
        format!("specification X {{ {WORLD} collaboration C {{ HERE }} }}"),
        format!(
            "specification X {{ {WORLD} collaboration C {{ dynamic role Lamp some {promise} \
             guarantee scenario G {{ user -> controller.pressed() HERE }} }} }}"
        ),
    ]
}

/// The codes of all mistakes.
fn codes(text: &str) -> Vec<Code> {
    match compile(&fast::loaded(text), &Options::default(), &mut Timings::default()) {
        Ok(_) | Err(Failure::Unrealizable(_)) => Vec::new(),
        Err(failure) => failure.diagnostics().iter().map(|d| d.code).collect(),
    }
}

/// What only has to be read may name what is declared nowhere.
fn is_right(code: Code, found: &[Code]) -> bool {
    found.is_empty()
        || (code as u16) < 20 && found.iter().all(|&found| found as u16 >= 20 && found as u16 <= 49)
}

/// The text behind `label` in an explanation, with the lines that continue it.
fn example(code: Code, label: &str) -> Option<String> {
    let mut lines = code.explanation().lines().skip_while(|line| !line.starts_with(label));
    let first = lines.next()?.strip_prefix(label)?.trim().to_owned();
    let more = lines.take_while(|line| line.starts_with("        ")).map(str::trim);
    Some([first].into_iter().chain(more.map(str::to_owned)).collect::<Vec<_>>().join("\n"))
}

/// Codes about specifications whose examples leave something out, or that need more than one text.
const WITHOUT_EXAMPLES: [Code; 8] = [
    Code::Empty,
    Code::TooDeep,
    Code::Encoding,
    Code::TooLarge,
    Code::MissingImport,
    Code::CyclicImport,
    Code::LimitReached,
    Code::Unrealizable,
];

#[test]
fn examples_are_wrong_and_right() {
    let mut checked = 0;
    for &code in Code::ALL {
        let pair = (example(code, "Wrong:"), example(code, "Right:"));
        let (Some(wrong), Some(right)) = pair else { continue };
        // From 90 up codes are warnings, whose examples are in tests of their own, and about other files.
        if code as u16 >= 90 || WITHOUT_EXAMPLES.contains(&code) {
            continue;
        }
        let fits = |context: &String| {
            let of = |text: &str| codes(&context.replace("HERE", text));
            is_right(code, &of(&right)) && of(&wrong).first() == Some(&code)
        };
        let tried: Vec<String> = contexts()
            .iter()
            .map(|context| {
                let of = |text: &str| codes(&context.replace("HERE", text));
                format!("{context:.40}…: wrong {:?}, right {:?}", of(&wrong), of(&right))
            })
            .collect();
        assert!(contexts().iter().any(fits), "{code}: {wrong}\n{right}\n{}", tried.join("\n"));
        checked += 1;
    }
    let about_specifications =
        Code::ALL.iter().filter(|&&code| (code as u16) < 70 && !WITHOUT_EXAMPLES.contains(&code)).count();
    assert!(checked >= about_specifications, "{checked} of {about_specifications} have examples");
}

/// Where an example about plants can stand.
const PLANTS: [&str; 3] = [
    "plant X { output Motor input Closed automaton Base { initial state Only } HERE }",
    "plant X { output Motor input Closed uncontrollable open uncontrollable shut uncontrollable run uncontrollable stop HERE }",
    "plant X { controllable run automaton Door { initial state Shut { run -> Shut } } HERE }",
];

/// The codes of all that is said about a plant, and whether it can be used: `read` from inputs and outputs, too.
fn plant_codes(text: &str, read: bool) -> (Vec<Code>, bool) {
    let diagnostics = match plant::read(text, FileId(0)) {
        Err(errors) => errors,
        Ok((plant, warnings)) if read => {
            let closed = plant::supervise(&plant, &Limits::default()).expect("a feedback");
            [warnings, plant::unreadable(&plant), plant::warnings(&plant, &closed)].concat()
        }
        Ok((_, warnings)) => warnings,
    };
    let good = diagnostics.iter().all(|d| d.severity == Severity::Warning);
    (diagnostics.iter().map(|d| d.code).collect(), good)
}

#[test]
fn examples_about_plants_are_wrong_and_right() {
    for &code in Code::ALL.iter().filter(|&&code| matches!(code as u16, 120..=139 | 144 | 148)) {
        let pair = (example(code, "Wrong:"), example(code, "Right:"));
        let (Some(wrong), Some(right)) = pair else { panic!("{code} has no examples") };
        let tried = PLANTS.map(|context| {
            let of = |text: &str| plant_codes(&context.replace("HERE", text), code >= Code::NoFormula);
            (of(&wrong), of(&right))
        });
        let fits = tried
            .iter()
            .any(|((wrong, _), (right, good))| wrong.contains(&code) && !right.contains(&code) && *good);
        assert!(fits, "{code}: {wrong}\n{right}\n{tried:?}");
    }
}

/// The page, from the table.
fn page() -> String {
    let mut page = String::from(
        "# Diagnostics\n\nEvery message of the tool has a code. This page is what `sml explain` prints, code by code; \
         it is made from the table in\n`synth-core/src/diagnostic/code.rs`, and a test keeps it up to date.\n\n\
         | Code | Is about |\n|---|---|\n",
    );
    for code in Code::ALL {
        _ = writeln!(page, "| [{code}](#{}) | {} |", code.to_string().to_lowercase(), code.title());
    }
    for code in Code::ALL {
        _ = write!(page, "\n## {code}\n\n**{}**\n\n", code.title());
        let mut fenced = false;
        for line in code.explanation().lines() {
            let is_example = line.starts_with("Wrong:") || line.starts_with("Right:");
            if is_example && !fenced {
                page.push_str("```text\n");
                fenced = true;
            }
            _ = writeln!(page, "{line}");
        }
        if fenced {
            page.push_str("```\n");
        }
    }
    page
}

/// With `SML_BLESS` it is written anew.
#[test]
fn the_page_is_fresh() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/diagnostics.md");
    if std::env::var_os("SML_BLESS").is_some() {
        std::fs::write(&path, page()).expect("written");
    }
    let found = std::fs::read_to_string(&path).unwrap_or_default();
    assert_eq!(found, page(), "SML_BLESS=1 cargo test -p sml-tests --test diagnostics");
}

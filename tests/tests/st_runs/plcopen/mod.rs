//! PLCopen XML holds what the Structured Text holds: read back, it is the same text, token for token, and it runs.

mod reader;
mod schema;

use crate::{CALLS, all_options, calls, mutations};
use reader::{structured_text, tokens};
use sml_tests::beside::difference;
use sml_tests::corpus;
use sml_tests::tables::{self, Size};
use synth_core::controller::Controller;
use synth_core::controller::tables::{Provenance, Requirement, Tables};
use synth_core::emit::st::plcopen::{Dialect, document};
use synth_core::emit::st::{self, Encoding, Options};

const DIALECTS: [Dialect; 2] = [Dialect::Iec, Dialect::Codesys];

/// The defaults for every dialect and encoding; the target is that of the dialect.
fn variants() -> impl Iterator<Item = (Dialect, Options)> {
    [Encoding::Runs, Encoding::Rows].into_iter().flat_map(|encoding| {
        DIALECTS
            .map(|dialect| (dialect, Options { target: dialect.target(), encoding, ..Options::default() }))
    })
}

fn written(tables: &Tables, dialect: Dialect, options: Options) -> String {
    document(tables, dialect, &options).expect("it fits")
}

/// The document keeps to the schema and holds the Structured Text.
#[track_caller]
fn check(name: &str, tables: &Tables, dialect: Dialect, options: Options) {
    let xml = written(tables, dialect, options);
    assert_eq!(schema::check(&xml), Ok(()), "{name}, {dialect:?}");
    let text = st::text(tables, &options).expect("it fits");
    let (found, expected) = (tokens(&structured_text(&xml)), tokens(&text));
    if let Some(at) = (0..found.len().max(expected.len())).find(|&at| found.get(at) != expected.get(at)) {
        let around = |tokens: &[String]| tokens[at.min(tokens.len())..tokens.len().min(at + 9)].join(" ");
        panic!("{name}, {dialect:?}: `{}` instead of `{}`", around(&found), around(&expected));
    }
}

/// How the text in a document differs from the interpreter.
fn runs(
    xml: &str,
    tables: &Tables,
    controller: &Controller,
    options: Options,
    calls: usize,
) -> Option<String> {
    difference(&structured_text(xml), tables, controller, options, calls)
}

#[test]
fn the_corpus_runs() {
    for (name, controller) in corpus::controllers() {
        let tables = Tables::new(&name, &controller, Provenance::default());
        for (dialect, options) in variants() {
            check(&name, &tables, dialect, options);
            let xml = written(&tables, dialect, options);
            assert_eq!(runs(&xml, &tables, &controller, options, calls() / 4), None, "{name}, {options:?}");
        }
    }
}

#[test]
fn every_option_is_in_the_document() {
    let size = |states, events, rows, components| Size { states, events, rows, components };
    let random = [size(30, 70, 10, 4), size(256, 3, 30, 1), size(9, 4, 50, 0)];
    let random = (1..).zip(random).map(|(seed, size)| tables::random("Random", size, seed));
    for tables in
        [tables::cell(), tables::empty(), tables::inner(), tables::names()].into_iter().chain(random)
    {
        for (dialect, Options { target, encoding, .. }) in variants() {
            for options in all_options() {
                check(&tables.specification, &tables, dialect, Options { target, encoding, ..options });
            }
        }
    }
}

#[test]
fn equal_values_are_repeated() {
    let xml = written(
        &tables::random("Random", Size { states: 300, events: 2, rows: 200, components: 2 }, 9),
        Dialect::Iec,
        Options::default(),
    );
    let document = roxmltree::Document::parse(&xml).expect("well-formed");
    let mut repeated = 0;
    for array in document.descendants().filter(|node| node.has_tag_name("arrayValue")) {
        let values: Vec<_> = array.children().filter(|node| node.has_tag_name("value")).collect();
        let literal = |node: &roxmltree::Node<'_, '_>| {
            node.first_element_child().expect("a value").attribute("value").map(str::to_owned)
        };
        assert!(values.windows(2).all(|pair| literal(&pair[0]) != literal(&pair[1])));
        assert!(values.iter().all(|value| value.attribute("repetitionValue") != Some("1")));
        repeated += values.iter().filter(|value| value.has_attribute("repetitionValue")).count();
    }
    assert!(repeated > 10, "only {repeated}");
}

/// In the published encoding, where each entry means something.
#[test]
fn a_wrong_entry_is_noticed() {
    let tables = tables::cell();
    let controller = tables::controller(&tables);
    for (dialect, options) in variants().filter(|(_, options)| options.encoding == Encoding::Rows) {
        let xml = written(&tables, dialect, options).replace("</value><value", "</value>\n<value");
        let faulty = mutations(&xml, |line| line.starts_with("<value><simpleValue"));
        assert!(faulty.len() > 10, "only {}", faulty.len());
        for faulty in faulty {
            assert!(runs(&faulty, &tables, &controller, options, CALLS).is_some(), "{faulty}");
        }
    }
}

#[test]
fn a_wrong_initial_value_is_noticed() {
    let tables = tables::cell();
    let controller = tables::controller(&tables);
    for (dialect, options) in variants() {
        let xml = written(&tables, dialect, options);
        // The function that searches has an input of that name.
        let at = xml.rfind("<variable name=\"state\">").expect("a variable");
        let initial = "<initialValue><simpleValue value=\"0\"/></initialValue>";
        let faulty = format!("{}{}", &xml[..at], xml[at..].replacen(initial, &initial.replace('0', "6"), 1));
        assert_ne!(faulty, xml);
        assert!(runs(&faulty, &tables, &controller, options, CALLS).is_some(), "{options:?}");
    }
}

/// The requirements are told where the text has its comment, whatever characters they have.
#[test]
fn documentation_holds_any_text() {
    let mut tables = tables::cell();
    let hostile = "a ]]> b -- <c> & \"d\" (* e *) \u{0}\u{1b}\u{b}\r\u{85}\u{fffe}\u{ffff} ä 漢 😀 *)";
    tables.provenance.file = format!("{hostile}.sml");
    tables.provenance.requirements.push(Requirement {
        scenario: "Cell.Hostile".to_owned(),
        kind: "assumption",
        text: vec![hostile.to_owned(), " </p></xhtml></documentation>".to_owned()],
        file: "specs/cell.sml".to_owned(),
        line: 77,
    });
    let controller = tables::controller(&tables);
    for (dialect, options) in variants() {
        let xml = written(&tables, dialect, options);
        assert_eq!(schema::check(&xml), Ok(()));
        let document = roxmltree::Document::parse(&xml).expect("well-formed");
        let told = document.descendants().find(|node| {
            node.has_tag_name("documentation")
                && node.parent_element().is_some_and(|pou| pou.attribute("pouType") == Some("functionBlock"))
        });
        let told =
            told.and_then(|node| node.first_element_child()).and_then(|text| text.text()).expect("a text");
        for part in [
            "guarantee Cell.Deliver, specs/smallcell.sml:12\n    Every <blank> [1] is *pressed*,\n",
            "assumption Cell.Hostile, specs/cell.sml:77\n    a ]]> b -- <c> & \"d\" ( * e * ) ",
            " ä 漢 😀 * )\n    </p></xhtml></documentation>",
            "Codes of arm_cmd",
            "--target plcopen",
        ] {
            assert!(told.contains(part), "{part:?}\n{told}");
        }
        assert_eq!(told.contains("--dialect codesys"), dialect == Dialect::Codesys);
        assert_eq!(runs(&xml, &tables, &controller, options, calls() / 4), None);
    }
}

#[test]
fn deterministic() {
    for (dialect, options) in variants() {
        let once = written(&tables::cell(), dialect, options);
        assert_eq!(once, written(&tables::cell(), dialect, options));
        assert!(once.ends_with("</project>\n"));
    }
}

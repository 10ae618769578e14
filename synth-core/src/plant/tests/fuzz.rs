//! Whatever the input, there is a plant or a diagnostic, and a picture of it.

use proptest::prelude::*;
use proptest::sample::Index;

use super::trees::shape;
use super::{corpus, found, tree};
use crate::diagnostic::{Severity, compile_errors, render};
use crate::plant::{parse_text, parse_tokens, print, read, unreadable};
use crate::syntax::tests::fuzz::{Change, apply, change, pieces};
use crate::syntax::{FileId, Loaded, Sources};

fn survive(text: &str) {
    let (read_tree, errors) = parse_text(text, FileId(0));
    assert!(read_tree.is_some() || !errors.is_empty(), "{text}");
    assert!(errors.is_sorted_by_key(|d| d.span.start), "{text}");
    let found = found(text);
    assert!(found.is_sorted_by_key(|d| d.span.start), "{text}");
    let refused = found.iter().any(|d| d.severity == Severity::Error);
    assert_eq!(refused, read(text, FileId(0)).is_err(), "{text}");
    let mut sources = Sources::new();
    sources.add("x.plant", text);
    assert_eq!(render(&found, &sources, false).is_empty(), found.is_empty());
    if let Ok((plant, _)) = read(text, FileId(0)) {
        let _ = render(&unreadable(&plant), &sources, false);
    }
    if errors.is_empty() {
        let read = read_tree.expect("a tree without errors");
        assert_eq!(shape(&tree(&print(&read))), shape(&read), "{text}");
    }
    if let Ok(tokens) = text.parse::<proc_macro2::TokenStream>() {
        let (_, errors) = parse_tokens(tokens.clone(), FileId(0));
        let _ = compile_errors(&errors, &tokens, &Loaded::default());
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn changed_plants(which in any::<Index>(), changes in prop::collection::vec(change(), 1..6)) {
        let mut corpus = corpus();
        let (_, text) = corpus.swap_remove(which.index(corpus.len()));
        let mut pieces = pieces(&text);
        changes.iter().for_each(|change: &Change| apply(&mut pieces, change));
        survive(&pieces.concat());
    }

    #[test]
    fn any_text(text in any::<String>()) {
        survive(&text);
        survive(&format!("plant X {{ {text} }}"));
    }
}

//! Plants of the corpus can be read; every mistake is told at its place; nothing panics.

mod effects;
mod errors;
mod fuzz;
mod help;
mod mutations;
mod readable;
mod trees;
mod warnings;

use super::{ast, parse_text, read};
use crate::diagnostic::Diagnostic;
use crate::syntax::FileId;

/// The corpus, by path.
fn corpus() -> Vec<(String, String)> {
    let directory = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/plants");
    let mut files: Vec<_> = std::fs::read_dir(directory)
        .expect("the corpus")
        .map(|entry| entry.expect("an entry").path())
        .collect();
    files.sort();
    assert!(!files.is_empty());
    files
        .into_iter()
        .map(|path| (path.display().to_string(), std::fs::read_to_string(&path).expect("UTF-8")))
        .collect()
}

/// The tree of a text, which must have no mistake.
#[track_caller]
fn tree(text: &str) -> ast::File {
    let (tree, errors) = parse_text(text, FileId(0));
    assert_eq!(errors, [], "{text}");
    tree.expect("a tree without errors")
}

/// All that is said about a text, errors or warnings.
fn found(text: &str) -> Vec<Diagnostic> {
    read(text, FileId(0)).map_or_else(|errors| errors, |(_, warnings)| warnings)
}

/// A plant in which nothing is odd: a motor with two sensors, a bit, ranges of an analogue input. `HERE` is replaced.
const WORLD: &str = "plant World {
output Motor, Lamp
memory Seen
input Closed, Opened
range Cold = Heat in -50..=10
range Hot = Heat in 60..=90
controllable open { set Motor reset Lamp }
controllable stop { reset Motor set Lamp }
controllable note { set Seen }
uncontrollable closes
uncontrollable opens
automaton Door {
  initial state Shut [!Motor && Closed] { open -> Moves }
  state Moves [Motor && !Opened] { opens -> Open }
  state Open [Motor && Opened] { stop -> Back }
  state Back [!Motor && !Closed] { closes -> Shut }
}
automaton Eye { initial state Blind [!Seen && (Cold || !Hot)] { note -> Sees } state Sees [Seen] }
constraint automaton Turn { initial state Mine { open -> Yours } state Yours { closes -> Mine } }
constraint Rest: open only when Eye.Sees && !Turn.Yours
HERE
}";

/// The world with items of `marked` behind its own.
fn world(marked: &str) -> String {
    WORLD.replace("HERE", marked)
}

#[test]
fn the_corpus_is_not_odd() {
    for (path, text) in corpus() {
        assert_eq!(found(&text), [], "{path}");
    }
    assert_eq!(found(&world("")), []);
}

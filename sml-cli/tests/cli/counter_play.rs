//! Counter-plays of `sml check`: annotated text, JSON, and a sequence diagram.

use crate::support::{corpus, scratch, sml, sml_reading};
use serde_json::json;

#[test]
fn every_step_says_who_wants_it() {
    let run = sml("check breaks_assumption/spec.sml");
    for line in [
        "user -> ctl.start()\n",
        "ctl -> dev.go()      ← C.Goes (breaks_assumption/spec.sml:14)\n",
        "refused: ctl -> dev.go() by C.AcknowledgedFirst (breaks_assumption/spec.sml:18)\n",
    ] {
        assert!(run.stdout.contains(line), "{line}: {}", run.stdout);
    }
    let run = sml("check forbidden_constraint/spec.sml");
    let line = "violates C.Once (forbidden_constraint/spec.sml:15): forbidden here\n";
    assert!(run.stdout.contains(line), "{}", run.stdout);
}

#[test]
fn steps_as_json() {
    let document = sml("check breaks_assumption/spec.sml --format json").json();
    let explanation = &document["explanation"];
    let place = |line: u32, column: u32, scenario: &str| json!({ "scenario": scenario, "file": "breaks_assumption/spec.sml", "line": line, "column": column });
    let steps = explanation["steps"].as_array().expect("steps");
    assert_eq!(
        steps[1],
        json!({
            "event": "ctl -> dev.go()", "side": "system", "case": 5, "in_loop": false,
            "wanted_by": [place(14, 52, "C.Goes")], "forbidden": [], "violates": [],
        })
    );
    assert_eq!(
        steps[3],
        json!({
            "event": "silence", "side": "environment", "case": 6, "in_loop": true, "wanted_by": [], "violates": [],
            "forbidden": [{ "event": "ctl -> dev.go()", "by": [place(18, 31, "C.AcknowledgedFirst")] }],
        })
    );
    let texts: Vec<_> = steps.iter().map(|step| step["event"].clone()).collect();
    let play = explanation["play"].as_array().expect("a play").iter();
    let cycle = explanation["loop"].as_array().expect("a loop").iter();
    assert_eq!(texts, play.chain(cycle).cloned().collect::<Vec<_>>());
}

/// Panics unless every line of a diagram is one that Mermaid's grammar of sequence diagrams knows, with participants
/// that are declared and blocks that are closed.
fn read(diagram: &str) {
    let mut lines = diagram.lines();
    assert_eq!(lines.next(), Some("sequenceDiagram"));
    let mut participants = Vec::new();
    let mut depth = 0;
    let is_known = |participants: &[String], id: &str| participants.iter().any(|one| one == id);
    for line in lines.map(str::trim) {
        let text = if let Some(rest) = line.strip_prefix("participant ") {
            let (id, name) = rest.split_once(" as ").expect("an alias");
            assert!(!is_known(&participants, id), "{line}");
            participants.push(id.to_owned());
            name
        } else if let Some(rest) = line.strip_prefix("Note over ") {
            let (over, text) = rest.split_once(": ").expect("a text");
            assert!(over.split(',').all(|id| is_known(&participants, id)), "{line}");
            text
        } else if let Some(title) = line.strip_prefix("loop ") {
            depth += 1;
            title
        } else if line == "end" {
            depth -= 1;
            "closed"
        } else {
            let (ends, text) = line.split_once(": ").expect("a message");
            let (from, to) = ends.split_once("->>").expect("an arrow");
            assert!(is_known(&participants, from) && is_known(&participants, to), "{line}");
            text
        };
        assert!(!text.is_empty(), "{line}");
        // An entity is the only place for `#` and `;`.
        let mut rest = text;
        while let Some(at) = rest.find(['#', ';']) {
            let entity = rest[at..].strip_prefix('#').expect("an entity");
            let (digits, after) = entity.split_once(';').expect("its end");
            assert!(!digits.is_empty() && digits.chars().all(|c| c.is_ascii_digit()), "{line}");
            rest = after;
        }
        assert!(!text.contains(['"', '<', '%', '`', '\\']), "{line}");
        let words = text.split(|c: char| !c.is_alphanumeric() && c != '_');
        assert!(words.clone().all(|word| !word.eq_ignore_ascii_case("end")), "{line}");
    }
    assert_eq!(depth, 0, "{diagram}");
    assert!(!participants.is_empty());
}

#[test]
fn diagrams_of_the_corpus_are_well_formed() {
    let folder = scratch("diagrams_of_the_corpus");
    let mut drawn = 0;
    for (name, expected) in corpus() {
        let path = folder.join(format!("{name}.mmd"));
        let run = sml(&format!("check {name}/spec.sml --sequence {}", path.display()));
        if expected["default"]["realizable"] == true {
            assert!(run.stderr.contains("no counter-play") && !path.exists(), "{name}");
        } else {
            read(&std::fs::read_to_string(&path).expect("a diagram"));
            drawn += 1;
        }
    }
    assert!(drawn > 4);
}

#[test]
fn a_diagram_on_stdout() {
    let run = sml("check breaks_assumption/spec.sml --sequence -");
    assert_eq!(run.code, 1);
    let expect = "\
sequenceDiagram
    participant p0 as user
    participant p1 as ctl
    participant p2 as dev
    p0->>p1: start()
    p1->>p2: go()
    Note over p1,p2: wanted by C.Goes (breaks_assumption/spec.sml:14)
    p0->>p1: start()
    loop for ever
        Note over p0,p2: nothing happens any more
        Note over p0,p2: refused: ctl -> dev.go() by C.AcknowledgedFirst (breaks_assumption/spec.sml:18)
        Note over p0,p2: never met: C.Goes (breaks_assumption/spec.sml:14)
    end
";
    assert_eq!(run.stdout, expect);
    // The report goes where people look.
    assert!(run.stderr.contains("not realizable"), "{}", run.stderr);
    assert_eq!(sml("check breaks_assumption/spec.sml --sequence - --format json").code, 2);
}

#[test]
fn names_that_mermaid_reads_as_keywords() {
    let text = "specification S {
      domain d { class Env { } class Ctl { end() loop() } }
      object end: Env  object participant: Ctl
      controllable { Ctl }
      collaboration C { guarantee scenario end { end -> participant.end() strict end -> participant.loop() } }
    }";
    let run = sml_reading("check - --sequence -", text.as_bytes());
    assert_eq!(run.code, 1, "{}", run.stderr);
    read(&run.stdout);
    assert!(run.stdout.contains("participant p0 as #101;nd\n"), "{}", run.stdout);
}

#[test]
fn a_diagram_is_written_whole_or_not_at_all() {
    let folder = scratch("a_diagram_is_written_whole");
    let path = folder.join("old.mmd");
    std::fs::write(&path, "old").expect("a file");
    assert_eq!(sml(&format!("check memory/spec.sml --sequence {}", path.display())).code, 0);
    assert_eq!(std::fs::read_to_string(&path).expect("a file"), "old");
    let run = sml(&format!("check breaks_assumption/spec.sml --sequence {}/no/such.mmd", folder.display()));
    assert_eq!(run.code, 4);
    std::fs::write(folder.join("s.sml"), "specification S { }").expect("a file");
    let same = folder.join("s.sml");
    let run = sml(&format!("check {} --sequence {}", same.display(), same.display()));
    assert_eq!(run.code, 2);
    assert_eq!(std::fs::read_to_string(&same).expect("a file"), "specification S { }");
}

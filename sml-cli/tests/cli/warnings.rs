//! Warnings: where they are shown, and what comes of denying them.

use crate::support::{listing, scratch, sml, sml_reading};

/// Realizable, with one warning that the text shows and one that takes a play.
const UNTIDY: &str = "specification Untidy {
  domain { class User { } class Ctl { press() stop() spare() } class Arm { go() rest() } }
  object user: User object ctl: Ctl object arm: Arm controllable { Ctl }
  collaboration C {
    guarantee scenario G { user -> ctl.press() urgent ctl -> arm.go() }
    guarantee scenario Never { ctl -> arm.rest() urgent ctl -> arm.go() }
    guarantee scenario Stop { user -> ctl.stop() urgent ctl -> arm.go() }
  }
}";

#[track_caller]
fn check(arguments: &str, code: i32, shown: &[&str]) {
    let run = sml_reading(&format!("check - {arguments} --format json"), UNTIDY.as_bytes());
    let document = run.json();
    let diagnostics = document["diagnostics"].as_array().expect("diagnostics");
    let codes: Vec<&str> = diagnostics.iter().filter_map(|one| one["code"].as_str()).collect();
    assert_eq!((run.code, codes.as_slice()), (code, shown), "{arguments}: {}", run.stderr);
    assert_eq!(document["realizable"], true);
    assert!(diagnostics.iter().all(|one| one["severity"] == "warning"));
}

#[test]
fn warnings_come_in_the_order_of_places() {
    check("", 0, &["SML0097", "SML0093"]);
}

#[test]
fn a_denied_warning_is_1() {
    check("--deny SML0093", 1, &["SML0097", "SML0093"]);
    check("--deny sml0097", 1, &["SML0097", "SML0093"]);
    check("--deny SML0090,SML0092", 0, &["SML0097", "SML0093"]);
    check("--deny SML0090 --deny SML0097", 1, &["SML0097", "SML0093"]);
    check("--deny-warnings", 1, &["SML0097", "SML0093"]);
}

#[test]
fn an_allowed_warning_is_not_shown() {
    check("--allow SML0097", 0, &["SML0093"]);
    check("--deny-warnings --allow SML0097,SML0093", 0, &[]);
    check("--deny SML0093 --allow SML0097", 1, &["SML0093"]);
}

#[test]
fn a_code_that_is_no_warning_is_2() {
    for wrong in ["SML0070", "unused", "9"] {
        let run = sml(&format!("check memory/spec.sml --deny {wrong}"));
        assert_eq!(run.code, 2);
        assert!(run.stderr.contains("SML0090") && run.stderr.contains("SML0099"), "{}", run.stderr);
    }
}

#[test]
fn products_come_with_the_warnings_that_cost_nothing() {
    for command in ["synth -", "export - --target rust"] {
        let run = sml_reading(command, UNTIDY.as_bytes());
        assert_eq!(run.code, 0);
        assert!(run.stderr.contains("warning[SML0097]"), "{}", run.stderr);
        assert!(!run.stderr.contains("SML0093"), "{}", run.stderr);
        assert!(!run.stdout.contains("SML0097"), "{}", run.stdout);
    }
}

#[test]
fn where_a_warning_is_denied_nothing_is_written() {
    let folder = scratch("denied");
    let out = folder.join("out");
    for command in ["synth", "export --target rust"] {
        for denied in ["--deny SML0097", "--deny SML0093", "--deny-warnings"] {
            let run = sml_reading(&format!("{command} - {denied} -o {}", out.display()), UNTIDY.as_bytes());
            assert_eq!(run.code, 1, "{command} {denied}: {}", run.stderr);
            assert!(run.stderr.contains("this warning is denied"), "{}", run.stderr);
            assert!(run.stdout.is_empty());
            assert!(listing(&folder).is_empty());
        }
        let run = sml_reading(&format!("{command} - --deny SML0090 -o {}", out.display()), UNTIDY.as_bytes());
        assert_eq!(run.code, 0, "{}", run.stderr);
        std::fs::remove_file(&out).expect("it was written");
    }
    let run = sml_reading("synth - --deny SML0093 --format json", UNTIDY.as_bytes());
    assert_eq!((run.code, run.diagnostic()), (1, "SML0093".to_owned()));
}

#[test]
fn an_unrealizable_specification_is_told_first() {
    let run = sml("check pc_no_a1_safe_strict/spec.sml --format json");
    let document = run.json();
    let severities = document["diagnostics"].as_array().expect("diagnostics").iter();
    let severities: Vec<&str> = severities.filter_map(|one| one["severity"].as_str()).collect();
    assert_eq!((run.code, severities[0]), (1, "error"));
    assert!(severities.len() > 1 && severities[1..].iter().all(|severity| *severity == "warning"));
}

//! The process as a whole keeps to `--max-memory`.

use crate::support::{listing, scratch, sml, switches};
use std::fs;

/// Ended by its memory: nothing but the failure is on stdout, and only on request.
#[track_caller]
fn ends(arguments: &str, note: &str) {
    let run = sml(arguments);
    assert_eq!((run.code, run.stdout.as_str()), (3, ""), "{arguments}: {}", run.stderr);
    for part in ["SML0054", note] {
        assert!(run.stderr.contains(part), "{arguments}: {}", run.stderr);
    }
    let run = sml(&format!("{arguments} --format json"));
    assert_eq!((run.code, run.diagnostic().as_str()), (3, "SML0054"), "{arguments}: {}", run.stderr);
}

#[test]
fn what_is_made_of_states_is_limited() {
    let file = switches("memory", 13);
    let folder = file.parent().expect("a folder");
    let (file, output) = (file.display(), folder.join("controller.json"));
    let figures =
        format!("{} states and {} transitions were found; what is made of them", 14 << 13, 26 << 13);
    ends(&format!("synth {file} --max-memory 12M"), &figures);
    ends(&format!("check {file} --max-memory 12M --deny-warnings"), &figures);
    let synth = format!("synth {file} -o {} --max-memory", output.display());
    ends(&format!("{synth} 12M"), &figures);
    assert_eq!(listing(folder), ["switches.sml"], "nothing is left behind");
    let run = sml(&format!("{synth} 1G"));
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert_eq!(listing(folder), ["controller.json", "switches.sml"]);
    let controller = fs::read(&output).expect("a controller");
    ends(&format!("{synth} 12M"), &figures);
    assert_eq!(fs::read(&output).expect("a controller"), controller, "it stays as it was");
    ends(&format!("verify {file} {} --max-memory 1M", output.display()), "needs more");
}

/// A state with thousands of moves.
#[test]
fn wide_states_are_limited_while_they_are_explored() {
    let text = "specification Wide {
  domain { class User { } class Control { x: 0..=1500  y: 0..=1500  z: 0..=1500 } }
  object user: User
  object control: Control
  controllable { Control }
  collaboration C {
    guarantee scenario X { user -> control.setX(*) }
    guarantee scenario Y { user -> control.setY(*) }
    guarantee scenario Z { user -> control.setZ(*) }
  }
}";
    let file = scratch("memory_wide").join("wide.sml");
    fs::write(&file, text).expect("a file");
    ends(&format!("check {} --max-memory 10M", file.display()), "SML0054");
}

//! Memory beyond exploration: the process as a whole keeps to `--max-memory`.

use crate::support::{listing, sml, switches};

#[test]
fn what_is_made_of_states_is_limited() {
    let file = switches("memory", 12);
    let folder = file.parent().expect("a folder");
    let arguments = |memory: &str| {
        format!("synth {} -o {}/controller.json --max-memory {memory}", file.display(), folder.display())
    };
    let run = sml(&arguments("4M"));
    assert_eq!((run.code, run.stdout.as_str()), (3, ""), "{}", run.stderr);
    let figures =
        format!("{} states and {} transitions were found; what is made of them", 13 << 12, 24 << 12);
    assert!(run.stderr.contains(&figures), "{}", run.stderr);
    assert_eq!(listing(folder), ["switches.sml"], "nothing is left behind");

    let run = sml(&format!("{} --format json", arguments("4M")));
    assert_eq!((run.code, run.diagnostic().as_str()), (3, "SML0054"), "{}", run.stderr);
    let run = sml(&arguments("1G"));
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert_eq!(listing(folder), ["controller.json", "switches.sml"]);
}

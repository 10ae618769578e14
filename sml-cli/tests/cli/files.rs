//! Files are written whole or not at all.

use crate::support::{listing, scratch, sml};
use std::fs;

#[test]
fn a_product_replaces_a_file() {
    let folder = scratch("a_product_replaces_a_file");
    let path = folder.join("c.json");
    fs::write(&path, "old and much longer than what comes ".repeat(100)).expect("a file");
    let run = sml(&format!("synth memory/spec.sml -o {}", path.display()));
    assert_eq!((run.code, run.stdout.as_str()), (0, ""), "{}", run.stderr);
    assert_eq!(fs::read_to_string(&path).expect("a file"), sml("synth memory/spec.sml").stdout);
    assert_eq!(listing(&folder), ["c.json"]);
}

#[test]
fn a_failure_leaves_everything_as_it_was() {
    let folder = scratch("a_failure_leaves_everything");
    let path = folder.join("out");
    fs::write(&path, "old").expect("a file");
    let out = path.display();
    for (arguments, code) in [
        ("synth unreal_clash/spec.sml", 1),
        ("export unreal_clash/spec.sml --target iec", 1),
        ("synth memory/expected.json", 2),
        ("export memory/spec.sml --target svg", 2),
        ("synth production_cell/spec.sml --max-states 10", 3),
        ("export no_such.sml --target rust", 4),
    ] {
        for format in ["text", "json"] {
            let run = sml(&format!("{arguments} -o {out} --format {format}"));
            assert_eq!(run.code, code, "{arguments}: {}", run.stderr);
            assert_eq!(fs::read_to_string(&path).expect("a file"), "old", "{arguments}");
            assert_eq!(listing(&folder), ["out"], "{arguments}");
        }
    }
    let fresh = folder.join("fresh");
    assert_eq!(sml(&format!("synth unreal_clash/spec.sml -o {}", fresh.display())).code, 1);
    assert!(!fresh.exists());
}

#[test]
fn the_specification_is_never_overwritten() {
    let folder = scratch("the_specification_is_never_overwritten");
    let path = folder.join("spec.sml");
    fs::copy(crate::support::specs().join("memory/spec.sml"), &path).expect("a copy");
    let before = fs::read(&path).expect("a file");
    let file = path.display();
    assert_eq!(sml(&format!("synth {file} -o {}/./spec.sml", folder.display())).code, 2);
    assert_eq!(sml(&format!("export {file} --target dot -o {file}")).code, 2);
    assert_eq!(fs::read(&path).expect("a file"), before);
}

#[test]
fn a_dash_is_stdout() {
    let plain = sml("export memory/spec.sml --target dot");
    let dash = sml("export memory/spec.sml --target dot -o -");
    assert_eq!((plain.code, plain.stdout), (dash.code, dash.stdout));
    assert!(!crate::support::specs().join("-").exists());
}

#[cfg(unix)]
#[test]
fn permissions_and_links_stay() {
    use std::os::unix::fs::{PermissionsExt as _, symlink};
    let folder = scratch("permissions_and_links_stay");
    let (path, link) = (folder.join("c.json"), folder.join("link"));
    fs::write(&path, "old").expect("a file");
    fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).expect("permissions");
    symlink("c.json", &link).expect("a link");
    assert_eq!(sml(&format!("synth memory/spec.sml -o {}", link.display())).code, 0);
    assert!(fs::symlink_metadata(&link).expect("a link").is_symlink());
    assert_eq!(fs::metadata(&path).expect("a file").permissions().mode() & 0o777, 0o640);
    assert_ne!(fs::read_to_string(&path).expect("a file"), "old");
    assert_eq!(sml("synth memory/spec.sml -o /dev/null").code, 0);
}

#[test]
fn check_tells_stale_from_fresh() {
    let path = scratch("check_tells_stale_from_fresh").join("memory.rs");
    let export = format!("export memory/spec.sml --target rust -o {}", path.display());
    let run = sml(&format!("{export} --check"));
    assert_eq!(run.code, 1);
    assert!(run.stderr.contains("is missing") && run.stderr.contains("run `sml export"), "{}", run.stderr);
    assert_eq!(sml(&export).code, 0);
    assert_eq!(sml(&format!("{export} --check")).code, 0);
    let text = fs::read_to_string(&path).expect("a file");
    fs::write(&path, format!("{text} ")).expect("a file");
    let run = sml(&format!("{export} --check --format json"));
    assert_eq!((run.code, run.diagnostic().as_str()), (1, "SML0107"));
    assert_eq!(run.json()["diagnostics"][0]["file"], path.display().to_string());
    assert_eq!(fs::read_to_string(&path).expect("a file"), format!("{text} "));
}

/// Version control may end lines with CR and LF.
#[test]
fn check_says_the_first_line_that_differs() {
    let path = scratch("check_says_the_first_line_that_differs").join("memory.st");
    let export = format!("export memory/spec.sml --target iec -o {}", path.display());
    assert_eq!(sml(&export).code, 0);
    let text = fs::read_to_string(&path).expect("a file");
    fs::write(&path, text.replace('\n', "\r\n")).expect("a file");
    assert_eq!(sml(&format!("{export} --check")).code, 0);
    fs::write(&path, text.replacen("Controller ", "Controler ", 1)).expect("a file");
    let run = sml(&format!("{export} --check"));
    assert_eq!(run.code, 1);
    for part in [":1", "line 1 is: `(* Controler Memory", "it would be: `(* Controller Memory"] {
        assert!(run.stderr.contains(part), "{part}\n{}", run.stderr);
    }
}

/// The command line that generates a file again can be pasted.
#[test]
fn command_lines_are_quoted_for_a_shell() {
    let folder = scratch("command_lines_are_quoted_for_a_shell");
    let spec = folder.join("my spec's.sml");
    fs::copy(crate::support::specs().join("memory/spec.sml"), &spec).expect("a copy");
    let shown = spec.display().to_string().replace('\'', r"'\''");
    let templates = folder.join("my templates");
    let mut command = crate::support::command("export --target iec -o");
    command.arg(folder.join("it.st")).arg(&spec).arg("--templates").arg(&templates);
    assert_eq!(crate::support::finish(&mut command).code, 0);
    let text = fs::read_to_string(folder.join("it.st")).expect("a file");
    let text = text.replace(" *)\n(* ", " ");
    let line = format!("sml export '{shown}' --target iec --templates '{}' *)", templates.display());
    assert!(text.contains(&line), "{line}\n{text}");
    command.arg("--check");
    assert_eq!(crate::support::finish(&mut command).code, 0);
    fs::write(folder.join("it.st"), "").expect("a file");
    let run = crate::support::finish(&mut command);
    assert!(run.stderr.contains(&format!("run `sml export '{shown}' --target iec -o ")), "{}", run.stderr);
}

#[test]
fn stdin_is_a_dash_in_command_lines() {
    let text = fs::read(crate::support::specs().join("memory/spec.sml")).expect("the corpus exists");
    let run = crate::support::sml_reading("export - --target iec", &text);
    assert!(run.stdout.contains("sml export - --target iec *)"), "{}", run.stdout);
    let folder = scratch("stdin_is_a_dash_in_command_lines");
    let check = format!("export - --target iec --check -o {}/missing.st", folder.display());
    let run = crate::support::sml_reading(&check, &text);
    assert!(run.stderr.contains("run `sml export - --target iec -o"), "{}", run.stderr);
}

//! `sml export --templates`: written once, never overwritten, and compared with the specification later.

use crate::support::{Run, listing, scratch, sml, specs};
use std::fs;
use std::path::{Path, PathBuf};

const FILES: [&str; 3] =
    ["ProductionCell_depositArm.st", "ProductionCell_feedArm.st", "ProductionCell_press.st"];

/// A folder with a copy of the production cell.
struct Cell {
    folder: PathBuf,
}

impl Cell {
    fn new(test: &str) -> Cell {
        let cell = Cell { folder: scratch(test) };
        cell.specify("", "");
        cell
    }

    /// The cell, something in it renamed.
    fn specify(&self, from: &str, to: &str) {
        let text = fs::read_to_string(specs().join("production_cell/spec.sml")).expect("the corpus exists");
        fs::write(self.folder.join("cell.sml"), text.replace(from, to)).expect("a file");
    }

    fn templates(&self) -> PathBuf {
        self.folder.join("plc/secondaries")
    }

    /// `sml export` with `--templates` and what else is given.
    fn export(&self, options: &str) -> Run {
        let (folder, templates) = (self.folder.display(), self.templates());
        sml(&format!("export {folder}/cell.sml --target iec --templates {} {options}", templates.display()))
    }

    /// The same with `-o`.
    fn export_both(&self, options: &str) -> Run {
        self.export(&format!("-o {}/cell.st {options}", self.folder.display()))
    }

    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.templates().join(name)).expect("a template")
    }
}

#[track_caller]
fn check(run: &Run, code: i32, parts: &[&str]) {
    assert_eq!(run.code, code, "{}", run.stderr);
    for part in parts {
        assert!(run.stderr.contains(part), "{part}\n---\n{}", run.stderr);
    }
}

#[test]
fn templates_come_beside_the_product() {
    let cell = Cell::new("templates_come_beside_the_product");
    let run = cell.export("");
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    assert!(run.stdout.contains("FUNCTION_BLOCK ProductionCell_Controller"));
    assert_eq!(listing(&cell.templates()), FILES);
    assert!(cell.read(FILES[2]).contains("FUNCTION_BLOCK ProductionCell_press"));
    let names = sml(&format!("names {}/cell.sml --target iec", cell.folder.display())).json();
    let components = names["components"].as_array().expect("components");
    let files: Vec<&str> = components.iter().filter_map(|c| c["file"].as_str()).collect();
    assert_eq!(files, FILES);
    for (component, file) in components.iter().zip(FILES) {
        assert_eq!(format!("{}.st", component["secondary"].as_str().expect("a name")), file);
    }
    assert_eq!(names["owed"], "owed");
}

#[test]
fn languages_have_templates() {
    let folder = scratch("languages_have_templates");
    for (target, file) in [
        ("iec", "Memory_lamp.st"),
        ("codesys", "Memory_lamp.st"),
        ("twincat", "Memory_lamp.st"),
        ("siemens", "Memory_lamp.scl"),
        ("case", "Memory_lamp.st"),
        ("plcopen", "Memory_lamp.st"),
        ("rust", "lamp.rs"),
    ] {
        let dir = folder.join(target);
        let run = sml(&format!("export memory/spec.sml --target {target} --templates {}", dir.display()));
        check(&run, 0, &[]);
        assert_eq!(listing(&dir), [file]);
    }
    for target in ["json", "dot", "mermaid"] {
        let dir = folder.join(target);
        let run = sml(&format!("export memory/spec.sml --target {target} --templates {}", dir.display()));
        check(&run, 2, &["there are no templates"]);
        assert!(!dir.exists());
    }
}

#[test]
fn templates_are_never_overwritten() {
    let cell = Cell::new("templates_are_never_overwritten");
    check(&cell.export_both(""), 0, &[]);
    let filled = cell.read(FILES[0]).replace("done := FALSE;", "done := sensor;");
    fs::write(cell.templates().join(FILES[0]), &filled).expect("a file");
    fs::write(cell.templates().join(FILES[1]), "").expect("a file");
    fs::remove_file(cell.templates().join(FILES[2])).expect("it is there");
    // The head of the first is still right; the empty one says nothing; the third comes again.
    let run = cell.export_both("");
    check(&run, 0, &["warning", FILES[1], "does not say which interface", "never overwritten"]);
    assert!(!run.stderr.contains(FILES[0]) && !run.stderr.contains(FILES[2]), "{}", run.stderr);
    assert_eq!((cell.read(FILES[0]), cell.read(FILES[1])), (filled, String::new()));
    assert_eq!(listing(&cell.templates()), FILES);
    for format in ["text", "json"] {
        let run = cell.export_both(&format!("--check --format {format}"));
        assert_eq!(run.code, 1);
    }
}

#[test]
fn stale_templates_say_what_is_new_and_gone() {
    let cell = Cell::new("stale_templates_say_what_is_new_and_gone");
    check(&cell.export_both(""), 0, &[]);
    let before: Vec<String> = FILES.iter().map(|file| cell.read(file)).collect();
    let names: [&str; 2] = ["pressingFinished", "pressed"];
    cell.specify(names[0], names[1]);
    let run = cell.export_both("");
    let new = "new: event press_controller_pressed: press -> controller.pressed()";
    let gone = "gone: event press_controller_pressingFinished: press -> controller.pressingFinished()";
    check(&run, 0, &["warning", FILES[2], "another interface", new, gone, "adapt it by hand"]);
    assert!(!run.stderr.contains(FILES[1]), "{}", run.stderr);
    let after: Vec<String> = FILES.iter().map(|file| cell.read(file)).collect();
    assert_eq!(after, before);
    // A template that was adapted, head included, is not stale.
    let adapted = before[2].replace(names[0], names[1]);
    let fresh = cell.folder.join("fresh");
    let run = sml(&format!(
        "export {}/cell.sml --target iec --templates {}",
        cell.folder.display(),
        fresh.display()
    ));
    check(&run, 0, &[]);
    let fingerprint = |text: &str| text.split("Interface ").nth(1).expect("a head")[..16].to_owned();
    let head = fs::read_to_string(fresh.join(FILES[2])).expect("a template");
    let adapted = adapted.replace(&fingerprint(&adapted), &fingerprint(&head));
    fs::write(cell.templates().join(FILES[2]), adapted).expect("a file");
    let run = cell.export_both("--check");
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
}

/// Commands as well as events count, and what does not concern a component does not.
#[test]
fn only_what_concerns_a_component_makes_it_stale() {
    for (from, to, stale) in [
        ("startPressing", "press", [false, false, true]),
        ("releaseItem", "drop", [true, true, false]),
        ("blankArrived", "arrived", [false, false, false]),
        ("G1:", "G7:", [false, false, false]),
        ("specification ProductionCell", "specification Cell", [true, true, true]),
    ] {
        let cell = Cell::new("only_what_concerns_a_component");
        check(&cell.export(""), 0, &[]);
        cell.specify(from, to);
        let run = cell.export("--check");
        assert_eq!(run.code, i32::from(stale.contains(&true)), "{from}: {}", run.stderr);
        for (file, stale) in FILES.iter().zip(stale) {
            let file =
                file.replace("ProductionCell", if from.contains(' ') { "Cell" } else { "ProductionCell" });
            assert_eq!(run.stderr.contains(&file), stale, "{from}, {file}: {}", run.stderr);
        }
    }
}

#[test]
fn check_writes_nothing() {
    let cell = Cell::new("check_writes_nothing");
    let product = cell.folder.join("cell.st");
    let run = cell.export_both("--check");
    check(&run, 1, &["cell.st` is missing", FILES[0], FILES[1], FILES[2], "is missing"]);
    assert_eq!(listing(&cell.folder), ["cell.sml"]);
    let run = cell.export_both("--check --format json");
    let diagnostics = run.json()["diagnostics"].as_array().expect("diagnostics").clone();
    let codes: Vec<&str> = diagnostics.iter().filter_map(|one| one["code"].as_str()).collect();
    assert_eq!((run.code, codes), (1, vec!["SML0107"; 4]));

    check(&cell.export_both(""), 0, &[]);
    check(&cell.export_both("--check"), 0, &[]);
    // The product alone is stale, with other options for one.
    check(&cell.export_both("--check --owed"), 1, &["cell.st` is stale"]);
    // A template alone.
    fs::remove_file(cell.templates().join(FILES[1])).expect("it is there");
    check(&cell.export_both("--check"), 1, &[FILES[1], "is missing", "`feedArm`"]);
    assert_eq!(listing(&cell.templates()), [FILES[0], FILES[2]]);
    fs::remove_file(&product).expect("it is there");
    // Templates alone are enough to check, and nothing is printed.
    let run = cell.export("--check");
    check(&run, 1, &[FILES[1]]);
    assert!(run.stdout.is_empty() && !run.stderr.contains("cell.st`"), "{}", run.stderr);
    for nothing in ["", "-o -"] {
        check(&sml(&format!("export memory/spec.sml --target iec --check {nothing}")), 2, &["--templates"]);
    }
}

#[test]
fn a_folder_that_cannot_be_written_leaves_the_product_alone() {
    let cell = Cell::new("a_folder_that_cannot_be_written");
    let product = cell.folder.join("cell.st");
    fs::write(&product, "old").expect("a file");
    // A file stands where the folder, or the folder around it, would be.
    for blocked in ["plc", "plc/secondaries"] {
        let blocked = cell.folder.join(blocked);
        fs::create_dir_all(blocked.parent().expect("a folder")).expect("a folder");
        fs::write(&blocked, "in the way").expect("a file");
        assert_eq!(cell.export_both("").code, 4);
        assert_eq!(fs::read_to_string(&product).expect("a file"), "old");
        assert_eq!(fs::read_to_string(&blocked).expect("a file"), "in the way");
        fs::remove_file(&blocked).expect("a file");
    }
    // A folder stands where a template would be.
    fs::create_dir_all(cell.templates().join(FILES[1])).expect("a folder");
    for option in ["", "--check"] {
        assert_eq!(cell.export_both(option).code, 4, "{option}");
        assert_eq!(fs::read_to_string(&product).expect("a file"), "old");
    }
}

/// Nothing is written for a specification that has no controller.
#[test]
fn an_unrealizable_specification_gets_no_templates() {
    let dir = scratch("an_unrealizable_specification_gets_no_templates").join("secondaries");
    let run =
        sml(&format!("export unreal_clash/spec.sml --target iec --templates {}", Path::new(&dir).display()));
    assert_eq!(run.code, 1);
    assert!(!dir.exists());
}

/// Whatever a template is called in `-o`, it stays; so does one of another specification.
#[test]
fn a_product_never_replaces_a_template() {
    let cell = Cell::new("a_product_never_replaces_a_template");
    let folder = cell.folder.display().to_string();
    let output = |path: &str| cell.export(&format!("-o {folder}/{path}"));
    // Before there is any, and beside a folder that is not there yet.
    let template = format!("plc/secondaries/{}", FILES[2]);
    check(&output(&template), 2, &["would be overwritten"]);
    assert!(!cell.templates().exists());
    check(&output("cell.st"), 0, &[]);
    let before = cell.read(FILES[2]);
    for path in [template.clone(), format!("plc/./secondaries/../secondaries/{}", FILES[2])] {
        check(&output(&path), 2, &["would be overwritten"]);
        check(&sml(&format!("export {folder}/cell.sml --target iec -o {folder}/{path}")), 2, &[FILES[2]]);
        check(&sml(&format!("synth memory/spec.sml -o {folder}/{path}")), 2, &[FILES[2]]);
    }
    assert_eq!(cell.read(FILES[2]), before);
    // A product may be replaced, and so may a file that says nothing.
    check(&output("cell.st"), 0, &[]);
    fs::write(cell.folder.join("other.st"), "FUNCTION_BLOCK x").expect("a file");
    check(&output("other.st"), 0, &[]);
}

#[test]
fn a_list_that_is_not_that_of_its_fingerprint_is_stale() {
    let cell = Cell::new("a_list_that_is_not_that_of_its_fingerprint");
    check(&cell.export(""), 0, &[]);
    let edited =
        cell.read(FILES[2]).replace("- command 1: controller -> press.startPressing()", "- command 1: x()");
    fs::write(cell.templates().join(FILES[2]), edited).expect("a file");
    let parts = ["is stale", "gone: command 1: x()", "new: command 1: controller -> press.startPressing()"];
    check(&cell.export("--check"), 1, &parts);
}

#[test]
fn watchdogs_are_wired_where_the_primary_has_owed() {
    let cell = Cell::new("watchdogs_are_wired");
    check(&cell.export("--owed"), 0, &[]);
    let [with, without] = ["--owed", ""].map(|option| {
        check(&cell.export(option), 0, &[]);
        let text = cell.read(FILES[2]);
        fs::remove_dir_all(cell.templates()).expect("it is there");
        text
    });
    assert!(with.contains("_owed := primary.owed[") && !with.contains("--owed"), "{with}");
    let (_, apart) = without.split_once("needs a primary exported with --owed").expect("it says so");
    assert!(apart.contains("_owed := primary.owed["), "{without}");
}

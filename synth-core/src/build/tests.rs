use super::*;
use crate::plant::DontCare;
use crate::playout::Semantics;
use crate::testing::{Scratch, world};

fn answers(body: &str) -> String {
    world(&format!("guarantee scenario Answers {{ user -> control.press() {body} }}"))
}

/// A package whose specification imports another one.
struct Package {
    scratch: Scratch,
    main: &'static str,
}

impl Package {
    fn new(name: &str) -> Package {
        let package = Package { scratch: Scratch::new(name), main: "main.sml" };
        package.write("world.sml", &answers("urgent control -> lamp.on()"));
        package.write("main.sml", "import \"world.sml\" specification Main { }");
        package
    }

    fn write(&self, path: &str, text: &str) {
        fs::write(self.scratch.path().join(path), text).expect("a file");
    }

    fn folder(&self) -> PathBuf {
        self.scratch.path().join("cache")
    }

    fn module(&self, build: &Build) -> Result<Module, Vec<Diagnostic>> {
        let bytes = fs::read(self.scratch.path().join(self.main)).expect("a file");
        let cache = Folder::at(self.folder());
        build.module(self.main, &bytes, self.scratch.path(), Some(&cache)).result
    }

    fn entries(&self) -> Vec<PathBuf> {
        let mut files: Vec<PathBuf> = fs::read_dir(self.folder())
            .map(|files| files.map(|file| file.expect("a file").path()).collect())
            .unwrap_or_default();
        files.sort();
        files
    }

    /// Has every entry lie, so that a synthesis can be told from a hit.
    fn poison(&self, build: &Build) {
        let loaded =
            load(self.main, &fs::read(self.scratch.path().join(self.main)).expect("a file"), &mut |path| {
                read(self.scratch.path(), path)
            });
        let key = Key::new("build script", build).sources(&loaded.sources);
        Folder::at(self.folder()).put(&key, &lie().texts());
    }
}

fn lie() -> Module {
    Module { text: "a lie".to_owned(), warnings: Vec::new() }
}

#[test]
fn what_was_made_once_is_not_made_again() {
    let package = Package::new("build-hit");
    let build = Build::new();
    let first = package.module(&build).expect("a module");
    assert!(first.text.contains("pub mod main"), "{}", first.text);
    assert_eq!(package.entries().len(), 1);
    assert_eq!(package.module(&build), Ok(first));
    assert_eq!(package.entries().len(), 1);
    package.poison(&build);
    assert_eq!(package.entries().len(), 1);
    assert_eq!(package.module(&build), Ok(lie()), "there was a synthesis");
}

#[test]
fn any_text_counts() {
    let package = Package::new("build-texts");
    let build = Build::new();
    let first = package.module(&build).expect("a module");
    package.poison(&build);

    package.write("world.sml", &answers("urgent control -> lamp.off()"));
    let imported = package.module(&build).expect("a module");
    assert!(imported != lie() && imported != first);

    package.write("world.sml", &answers("urgent control -> lamp.on()"));
    assert_eq!(package.module(&build), Ok(lie()), "as before");
    package.write("main.sml", "import \"./world.sml\" specification Main { }");
    assert_ne!(package.module(&build), Ok(lie()), "another path");
    package.write("main.sml", "import \"world.sml\" specification Main { } // And");
    assert_ne!(package.module(&build), Ok(lie()), "another hash of the input is shown");
}

#[test]
fn any_option_counts() {
    let package = Package::new("build-options");
    let builds = [
        Build::new(),
        Build::new().max_states(1000),
        Build::new().engine(Engine::Runs),
        Build::new().deny("SML0090"),
        Build::new().deny_warnings(),
        Build::new().allow("SML0090"),
        Build::new().options(Options { semantics: Semantics { classic: true }, ..Options::default() }),
        Build::new().plant_options(plant::Options { dont_care: DontCare::All, ..plant::Options::default() }),
    ];
    for (count, build) in builds.iter().enumerate() {
        assert_eq!(package.entries().len(), count);
        assert_ne!(package.module(build), Ok(lie()));
        package.poison(build);
        assert_eq!(package.module(build), Ok(lie()));
    }
}

#[test]
fn a_damaged_entry_is_made_again() {
    let package = Package::new("build-damaged");
    let build = Build::new();
    let first = package.module(&build).expect("a module");
    let entry = package.entries().remove(0);
    for damaged in ["", "damaged"] {
        fs::write(&entry, damaged).expect("a file");
        assert_eq!(package.module(&build).as_ref(), Ok(&first));
        assert!(fs::metadata(&entry).expect("an entry").len() > 1000, "it was not mended");
    }
}

#[test]
fn warnings_are_shown_again() {
    let package = Package::new("build-warnings");
    package.write("main.sml", "import \"world.sml\" specification Main { domain { class Spare { } } }");
    let first = package.module(&Build::new()).expect("a module");
    let warning = "main.sml:1:56: class `Spare` is never used (SML0097; `sml check` says more)";
    assert_eq!(first.warnings.first().map(String::as_str), Some(warning));
    assert_eq!(package.module(&Build::new()), Ok(first));
}

#[test]
fn what_is_wrong_is_not_kept() {
    let package = Package::new("build-wrong");
    package.module(&Build::new().deny("SML0097").max_states(1)).expect_err("too many states");
    package.write("main.sml", "import \"world.sml\" specification Main { domain { class Spare { } } }");
    let denied = package.module(&Build::new().deny("SML0097")).expect_err("a denied warning");
    assert_eq!(denied[0].code, Code::Unused);
    package.write("main.sml", "import \"gone.sml\" specification Main { }");
    package.module(&Build::new()).expect_err("no such file");
    assert!(package.entries().is_empty());
}

/// An unreadable byte is shown like a character that can be read.
#[test]
fn what_only_looks_the_same_is_no_hit() {
    let package = Package::new("build-bytes");
    let text = "specification Main { } // \u{FFFD}";
    package.write("main.sml", text);
    package.write("world.sml", "");
    package.poison(&Build::new());
    assert_eq!(package.module(&Build::new()), Ok(lie()));
    let bytes = [text.trim_end_matches('\u{FFFD}').as_bytes(), &[0xFF]].concat();
    fs::write(package.scratch.path().join("main.sml"), bytes).expect("a file");
    assert_eq!(package.module(&Build::new()).expect_err("no text")[0].code, Code::Encoding);
}

#[test]
fn plants_are_cached_too() {
    let plant = |level: &str| {
        format!(
            "plant Clamp {{ output Air input Open, Shut controllable close {{ set Air }} uncontrollable shut \
             automaton Jaw {{ initial state Wide [!Air && {level}Open] {{ close -> Closes }} \
             state Closes [Air && !Shut] {{ shut -> Tight }} state Tight [Air && Shut] }} }}"
        )
    };
    let package = Package { main: "clamp.plant", ..Package::new("build-plant") };
    package.write("clamp.plant", &plant(""));
    let first = package.module(&Build::new()).expect("a module");
    assert!(first.text.contains("pub mod clamp"), "{}", first.text);
    let sources = plant::Loaded::of_file("clamp.plant", plant("").as_bytes()).sources;
    let key = Key::new("build script", &Build::new()).sources(&sources);
    Folder::at(package.folder()).put(&key, &lie().texts());
    assert_eq!(package.module(&Build::new()), Ok(lie()), "there was a synthesis");
    package.write("clamp.plant", &plant("!"));
    let second = package.module(&Build::new()).expect("a module");
    assert!(second != first && second != lie());
}

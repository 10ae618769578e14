//! A build script that compiles a specification or a plant, and the macro with a file, in a package of their own: what is
//! built, and when again.

use sml_tests::scratch::Scratch;
use std::path::{Path, PathBuf};
use std::time::SystemTime;
use std::{fs, io};

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// The domain and what the press of a button does, for import.
const DEVICES: &str = "\
specification Devices {
  domain cell { class Bulb { on() off() } class Button { } class Control { pressed() } }
  object control: Control
  object bulb: Bulb
  object lamp: Bulb
  object button: Button
  controllable { Control }
  collaboration Devices {
    guarantee scenario Answers { button -> control.pressed() urgent control -> bulb.on() }
  }
}
";

const CELL: &str = "\
import \"devices.sml\"
specification Cell {
  collaboration Cell {
    guarantee scenario Also { button -> control.pressed() urgent control -> lamp.on() }
  }
}
";

/// Says what the controller in `cell` commands.
const MAIN: &str = "
fn main() {
    let commands = cell::Controller::new().react(cell::Event::ButtonControlPressed).expect(\"it fits\");
    println!(\"{:?} {:?}\", commands.bulb, commands.lamp);
}
";

/// A package with `src/main.rs` and the two specifications above.
struct Package {
    directory: PathBuf,
    scratch: Scratch,
}

impl Package {
    /// `dependencies` ends the manifest.
    fn new(name: &str, dependencies: &str, main: &str) -> io::Result<Self> {
        let parent = env!("CARGO_TARGET_TMPDIR");
        let scratch = Scratch::new(parent, name, &[], dependencies)?;
        let package = Package { directory: Path::new(parent).join(name), scratch };
        let specs = package.directory.join("specs");
        if specs.exists() {
            fs::remove_dir_all(specs)?;
        }
        // What is not downloaded cannot be chosen.
        package.write("Cargo.lock", &fs::read_to_string(format!("{ROOT}/Cargo.lock"))?)?;
        package.write("src/main.rs", main)?;
        package.write("specs/devices.sml", DEVICES)?;
        package.write("specs/cell.sml", CELL)?;
        Ok(package)
    }

    /// With a build script that runs `compile` and notes each of its runs.
    fn with_script(name: &str, compile: &str) -> io::Result<Self> {
        let dependencies = format!("[build-dependencies]\nsynth-core = {{ path = \"{ROOT}/synth-core\" }}\n");
        let main = format!("include!(concat!(env!(\"OUT_DIR\"), \"/cell.rs\"));\n{MAIN}");
        let package = Package::new(name, &dependencies, &main)?;
        let script = format!(
            "use std::io::Write as _;\n\
             fn main() {{\n    \
                 let mut runs = std::fs::File::options().create(true).append(true).open(\"runs.txt\").unwrap();\n    \
                 writeln!(runs, \"{{}}\", std::env::var(\"OUT_DIR\").unwrap()).unwrap();\n    \
                 {compile}\n\
             }}\n"
        );
        package.write("build.rs", &script)?;
        package.write("runs.txt", "")?;
        Ok(package)
    }

    fn write(&self, path: &str, text: &str) -> io::Result<()> {
        self.scratch.write(path, text)
    }

    fn read(&self, path: &str) -> String {
        fs::read_to_string(self.directory.join(path)).expect("a text")
    }

    /// Replaces what must be there.
    #[track_caller]
    fn edit(&self, path: &str, old: &str, new: &str) {
        let text = self.read(path);
        assert!(text.contains(old), "{text}");
        self.write(path, &text.replace(old, new)).expect("the file can be written");
    }

    /// Success, standard output and standard error of `cargo run`.
    fn run(&self) -> (bool, String, String) {
        // Dependencies are compiled once for all packages.
        let target = concat!(env!("CARGO_TARGET_TMPDIR"), "/build-script-target");
        let arguments = ["run", "--quiet", "--target-dir", target];
        let output = self.scratch.cargo(&arguments, "").expect("cargo runs");
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("text");
        (output.status.success(), text(output.stdout), text(output.stderr))
    }

    #[track_caller]
    fn check_run(&self, expect: &str) {
        let (success, out, err) = self.run();
        assert!(success, "{err}");
        assert_eq!((out.trim_end(), err.as_str()), (expect, ""));
    }

    /// Fails, says each of `parts`, and nothing of the tool's own innards.
    #[track_caller]
    fn check_failure(&self, parts: &[&str]) {
        let (success, _, err) = self.run();
        assert!(!success);
        for part in parts {
            assert!(err.contains(part), "{part:?} in\n{err}");
        }
        assert!(!err.contains("panicked") && !err.contains("RUST_BACKTRACE"), "{err}");
    }

    fn script_runs(&self) -> usize {
        self.read("runs.txt").lines().count()
    }

    /// The file that the script wrote.
    fn generated(&self) -> PathBuf {
        Path::new(self.read("runs.txt").lines().last().expect("a run")).join("cell.rs")
    }
}

#[test]
fn warnings_of_the_specification_are_shown() -> io::Result<()> {
    let package = Package::with_script("build_script_warnings", COMPILE)?;
    package.edit("specs/cell.sml", "  collaboration", "  domain { class Spare { } }\n  collaboration");
    // What the script says to Cargo; Cargo, asked to be quiet, shows no warnings.
    let said = || {
        let generated = package.generated();
        let folder = generated.ancestors().nth(2).expect("a folder");
        fs::read_to_string(folder.join("output")).expect("the script has run")
    };
    assert!(package.run().0);
    let warning =
        "cargo::warning=specs/cell.sml:3:18: class `Spare` is never used (SML0097; `sml check` says more)";
    assert!(said().lines().any(|line| line == warning), "{}", said());
    let denying = "synth_core::build::Build::new().deny(\"SML0097\").compile(\"specs/cell.sml\");";
    package.edit("build.rs", COMPILE, denying);
    package.check_failure(&["class `Spare` is never used", "this warning is denied"]);
    package.edit("build.rs", ".deny(\"SML0097\")", ".deny_warnings().allow(\"SML0097\")");
    assert!(package.run().0);
    assert!(!said().contains("Spare"), "{}", said());
    Ok(())
}

const COMPILE: &str = "synth_core::build::compile(\"specs/cell.sml\");";

#[test]
fn script_runs_again_when_a_specification_changes() -> io::Result<()> {
    let package = Package::with_script("script-again", COMPILE)?;
    package.check_run("Some(On) Some(On)");
    let runs = package.script_runs();
    package.check_run("Some(On) Some(On)");
    assert_eq!(package.script_runs(), runs, "nothing has changed");

    package.edit("specs/cell.sml", "lamp.on()", "lamp.off()");
    package.check_run("Some(On) Some(Off)");
    assert_eq!(package.script_runs(), runs + 1);

    package.edit("specs/devices.sml", "bulb.on()", "bulb.off()");
    package.check_run("Some(Off) Some(Off)");
    assert_eq!(package.script_runs(), runs + 2);

    package.edit("src/main.rs", "fn main", "// Edited.\nfn main");
    package.check_run("Some(Off) Some(Off)");
    assert_eq!(package.script_runs(), runs + 2, "the script does not depend on the program");
    Ok(())
}

#[test]
fn mistakes_are_shown_and_leave_the_output_alone() -> io::Result<()> {
    let package = Package::with_script("script-mistakes", COMPILE)?;
    package.check_run("Some(On) Some(On)");
    let before = fs::read(package.generated())?;

    package.edit("specs/cell.sml", "lamp.on()", "lamb.on()");
    package.check_failure(&[
        "error[SML0020]: unknown role or object `lamb`",
        "--> specs/cell.sml:4:77",
        "4 |     guarantee scenario Also",
        "help: write `lamp`, which is declared",
        "exit status: 1",
    ]);
    assert_eq!(fs::read(package.generated())?, before);

    package.edit("specs/cell.sml", "lamb.on()", "lamp.on()");
    package.edit("specs/devices.sml", "bulb.on()", "bulb.on(1)");
    package.check_failure(&["error[SML0023]", "--> specs/devices.sml:9"]);
    assert_eq!(fs::read(package.generated())?, before);

    package.edit("specs/devices.sml", "bulb.on(1)", "bulb.on()");
    let both = "urgent control -> lamp.on() } constraints [ forbidden control -> bulb.on() ]";
    package.edit("specs/cell.sml", "urgent control -> lamp.on() }", both);
    package.edit("specs/cell.sml", "urgent control -> lamp.on()", "button -> control.pressed()");
    package.check_failure(&["error[SML0070]: no controller can meet this specification"]);
    assert_eq!(fs::read(package.generated())?, before);

    package.write("specs/cell.sml", CELL)?;
    package.check_run("Some(On) Some(On)");
    assert_eq!(fs::read(package.generated())?, before);
    Ok(())
}

#[test]
fn missing_files_are_named() -> io::Result<()> {
    let package = Package::with_script("script-missing", COMPILE)?;
    fs::rename(package.directory.join("specs/cell.sml"), package.directory.join("specs/other.sml"))?;
    package.check_failure(&["error: specs/cell.sml cannot be read: ", "exit status: 1"]);
    fs::rename(package.directory.join("specs/other.sml"), package.directory.join("specs/cell.sml"))?;
    package.edit("specs/cell.sml", "devices.sml", "gone.sml");
    package.check_failure(&["error[SML0033]: `specs/gone.sml` cannot be read: ", "--> specs/cell.sml:1:8"]);
    package.write("specs/gone.sml", DEVICES)?;
    package.check_run("Some(On) Some(On)");
    Ok(())
}

#[test]
fn limits_are_those_of_the_script() -> io::Result<()> {
    let compile = "synth_core::build::Build::new().max_states(2).compile(\"specs/cell.sml\");";
    let package = Package::with_script("script-limit", compile)?;
    package.check_failure(&[
        "error[SML0054]: the limit of 2 states was reached",
        "help: raise it with `synth_core::build::Build`",
    ]);
    Ok(())
}

/// A clamp that closes once it is open.
const CLAMP: &str = "\
plant Clamp {
    output Air
    input Open, Shut
    controllable close { set Air }
    uncontrollable shut
    automaton Jaw {
        initial state Wide [!Air && Open] { close -> Closes }
        state Closes [Air && !Shut] { shut -> Tight }
        state Tight [Air && Shut]
    }
}
";

#[test]
fn plants_are_compiled_by_their_extension() -> io::Result<()> {
    let package = Package::with_script("script-plant", "synth_core::build::compile(\"specs/cell.plant\");")?;
    package.write("specs/cell.plant", CLAMP)?;
    let main = "include!(concat!(env!(\"OUT_DIR\"), \"/cell.rs\"));\n\
                fn main() { use clamp::{Inputs, Outputs, scan};\n\
                println!(\"{}\", scan(&Inputs { open: true, shut: false }, &mut Outputs::default()).iter().count()); }";
    package.write("src/main.rs", main)?;
    package.check_run("1");
    let runs = package.script_runs();

    package.edit("specs/cell.plant", "[!Air && Open]", "[!Air && !Open]");
    package.check_run("0");
    assert_eq!(package.script_runs(), runs + 1);

    package.edit("specs/cell.plant", "[Air && !Shut]", "[Air]");
    package.check_failure(&[
        "error[SML0135]: `Tight` cannot be told from `Closes`",
        "--> specs/cell.plant:9:15",
        "exit status: 1",
    ]);

    package.write("specs/cell.plant", &CLAMP.replace("input Open", "input Spare, Open"))?;
    package.edit("build.rs", "compile(\"", "Build::new().deny_warnings().compile(\"");
    package.check_failure(&["nothing uses the input `Spare`", "this warning is denied"]);
    Ok(())
}

/// Generated files say how they were made, as far as it was not by default.
#[test]
fn plants_can_be_followed_instead_of_read() -> io::Result<()> {
    let compile = "synth_core::build::Build::new().follow_events().compile(\"specs/cell.plant\");";
    let package = Package::with_script("script-follow", compile)?;
    package.write("specs/cell.plant", CLAMP)?;
    let main = |what: &str, option: &str| {
        format!(
            "include!(concat!(env!(\"OUT_DIR\"), \"/cell.rs\"));\n\
             const TEXT: &str = include_str!(concat!(env!(\"OUT_DIR\"), \"/cell.rs\"));\n\
             fn main() {{ println!(\"{{:?}} {{}}\", {what}, TEXT.contains({option:?})); }}"
        )
    };
    package.write("src/main.rs", &main("clamp::Controller::new().cycle().jaw", "--follow events"))?;
    package.check_run("Some(Close) true");

    let options = "plant_options(synth_core::plant::Options { extract: true, ..Default::default() })";
    package.edit("build.rs", "follow_events()", options);
    package.write("src/main.rs", &main("clamp::Outputs::default().air", "--target rust --extract"))?;
    package.check_run("false true");
    Ok(())
}

/// Cache entries in a folder with the times at which they were written.
fn entries(folder: &Path) -> io::Result<Vec<(PathBuf, SystemTime)>> {
    let mut entries = Vec::new();
    for file in fs::read_dir(folder)? {
        let file = file?;
        entries.push((file.path(), file.metadata()?.modified()?));
    }
    entries.sort();
    Ok(entries)
}

/// A synthesis would write its entry once more.
#[test]
fn what_was_compiled_before_is_not_compiled_again() -> io::Result<()> {
    let package = Package::with_script("script-cache", COMPILE)?;
    package.check_run("Some(On) Some(On)");
    let folder = package.generated().with_file_name("sml-cache");
    fs::remove_dir_all(&folder)?;
    let edit = |old, new, expect| {
        package.edit("specs/devices.sml", old, new);
        package.check_run(expect);
        entries(&folder)
    };
    let off = edit("bulb.on()", "bulb.off()", "Some(Off) Some(On)")?;
    assert_eq!(off.len(), 1);
    let both = edit("bulb.off()", "bulb.on()", "Some(On) Some(On)")?;
    assert_eq!(both.len(), 2);
    assert_eq!(edit("bulb.on()", "bulb.off()", "Some(Off) Some(On)")?, both);
    assert_eq!(edit("bulb.off()", "bulb.on()", "Some(On) Some(On)")?, both);

    for (entry, _) in &both {
        fs::write(entry, "damaged")?;
    }
    let runs = package.script_runs();
    edit("bulb.on()", "bulb.off()", "Some(Off) Some(On)")?;
    assert_eq!(package.script_runs(), runs + 1);

    // A file where the folder should be: nothing is kept, and nothing is wrong.
    fs::remove_dir_all(&folder)?;
    fs::write(&folder, "")?;
    package.edit("specs/devices.sml", "bulb.off()", "bulb.on()");
    package.check_run("Some(On) Some(On)");
    fs::remove_file(&folder)
}

const CONFIG: &str = "[env]\nSML_CACHE = { value = \"cache\", relative = true }\n";

#[test]
fn macros_use_the_folder_that_is_named() -> io::Result<()> {
    let dependency = format!("sml-macros = {{ path = \"{ROOT}/sml-macros\" }}\n");
    let main = format!("sml_macros::sml! {{ {DEVICES} }}\n{}", MAIN.replace("cell::", "devices::"));
    let main = main.replace("{:?} {:?}\", commands.bulb, commands.lamp", "{:?}\", commands.bulb");
    let package = Package::new("macro-cache", &dependency, &main)?;
    package.write(".cargo/config.toml", CONFIG)?;
    let folder = package.directory.join("cache");
    if folder.exists() {
        fs::remove_dir_all(&folder)?;
    }
    package.check_run("Some(On)");
    let known = entries(&folder)?;
    assert_eq!(known.len(), 1);
    package.edit("src/main.rs", "sml_macros::sml!", "// Moved.\nsml_macros::sml!");
    package.check_run("Some(On)");
    assert_eq!(entries(&folder)?, known);
    package.edit("src/main.rs", "bulb.on()", "bulb.off()");
    package.check_run("Some(Off)");
    assert_eq!(entries(&folder)?.len(), 2);
    Ok(())
}

/// Build scripts are compiled without optimisation, and so are their dependencies.
#[test]
fn production_cell_takes_less_than_a_second() -> io::Result<()> {
    // The shortest of several times, which what else the machine does changes least.
    let compile = "let folder = std::path::PathBuf::from(std::env::var(\"OUT_DIR\").unwrap()).join(\"sml-cache\");\n    \
                   let time = |cold: bool| (0..8).map(|_| {\n        \
                       if cold { let _ = std::fs::remove_dir_all(&folder); }\n        \
                       let start = std::time::Instant::now();\n        \
                       synth_core::build::compile(\"specs/production.cell.sml\");\n        \
                       start.elapsed().as_micros()\n    \
                   }).min().unwrap();\n    \
                   std::fs::write(\"microseconds.txt\", format!(\"{} {}\", time(true), time(false))).unwrap();";
    let package = Package::with_script("script-time", compile)?;
    package.write("specs/production.cell.sml", &fs::read_to_string("specs/production_cell/spec.sml")?)?;
    let main = "include!(concat!(env!(\"OUT_DIR\"), \"/production.cell.rs\"));\n\
                fn main() { println!(\"{}\", production_cell::Controller::new().state()); }";
    package.write("src/main.rs", main)?;
    package.check_run("0");
    let times = package.read("microseconds.txt");
    let milliseconds = |text: &str| text.parse::<f64>().expect("a number") / 1000.0;
    let (cold, cached) =
        times.split_once(' ').map(|(a, b)| (milliseconds(a), milliseconds(b))).expect("two numbers");
    println!(
        "production cell in a build script without optimisation: {cold:.1} ms, from the cache {cached:.1} ms"
    );
    assert!(cold < 1000.0, "{cold} ms");
    assert!(cached < cold / 3.0, "{cached} ms of {cold} ms");
    Ok(())
}

#[test]
fn macro_follows_the_file() -> io::Result<()> {
    let dependency = format!("sml-macros = {{ path = \"{ROOT}/sml-macros\" }}\n");
    let main = format!("sml_macros::sml!(\"specs/cell.sml\");\n{MAIN}");
    let package = Package::new("macro-again", &dependency, &main)?;
    package.check_run("Some(On) Some(On)");
    package.edit("specs/cell.sml", "lamp.on()", "lamp.off()");
    package.check_run("Some(On) Some(Off)");
    package.edit("specs/devices.sml", "bulb.on()", "bulb.off()");
    package.check_run("Some(Off) Some(Off)");

    package.edit("specs/devices.sml", "bulb.off()", "bulp.off()");
    package.check_failure(&[
        "error: [SML0020] unknown role or object `bulp`",
        "--> specs/devices.sml:9:80",
        "sml_macros::sml!(\"specs/cell.sml\");",
    ]);
    package.edit("specs/devices.sml", "bulp.off()", "bulb.on()");
    package.check_run("Some(On) Some(Off)");
    Ok(())
}

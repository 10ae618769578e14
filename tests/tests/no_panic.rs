//! No release build of a generated controller has a path to a panic: a program whose panic handler calls a function
//! that does not exist links nevertheless. Only where the linker is that of Linux.
#![cfg(all(target_os = "linux", target_arch = "x86_64"))]

use std::process::Output;

use sml_tests::scratch::Scratch;
use sml_tests::tables::{self, Size};
use synth_core::emit::rust::{Engine, Options, text};

const ENGINES: [Engine; 3] = [Engine::Search, Engine::Runs, Engine::Comb];

const MANIFEST: &str = r#"
[features]
control = []

[profile.release]
panic = "abort"
codegen-units = 1

[profile.small]
inherits = "release"
opt-level = "z"
"#;

fn build(scratch: &Scratch, arguments: &[&str]) -> Output {
    let link = ["-nostartfiles", "-nostdlib", "-static"].map(|flag| format!("-Clink-arg={flag}"));
    let mut all = vec!["rustc", "--quiet"];
    all.extend(arguments);
    all.push("--");
    all.extend(link.iter().map(String::as_str));
    scratch.cargo(&all, "").expect("cargo runs")
}

#[test]
fn a_release_build_has_no_path_to_a_panic() {
    let scratch =
        Scratch::new(env!("CARGO_TARGET_TMPDIR"), "no-panic", &["names"], MANIFEST).expect("written");
    let size = Size { states: 40, events: 6, rows: 40, components: 3 };
    for (file, tables) in [
        ("cell", tables::cell()),
        ("empty", tables::empty()),
        ("dense", tables::random("dense", size, 1)),
        ("wide", tables::random("wide", Size { events: 70, ..size }, 2)),
        ("packed", tables::random("packed", Size { states: 9000, ..size }, 3)),
    ] {
        for engine in ENGINES {
            let text = text(&tables, &Options { engine, ..Options::default() });
            scratch.write(&format!("src/{}/{file}.rs", engine.name()), &text).expect("written");
        }
    }
    let program = include_str!("no_panic/program.rs");
    for (engine, profile) in ENGINES.into_iter().flat_map(|engine| ["release", "small"].map(|p| (engine, p)))
    {
        let program = program.replace("include!(\"", &format!("include!(\"{}/", engine.name()));
        scratch.write("src/main.rs", &program).expect("written");
        let clean = build(&scratch, &["--profile", profile]);
        assert!(clean.status.success(), "{profile}: {}", String::from_utf8_lossy(&clean.stderr));
        let control = build(&scratch, &["--profile", profile, "--features", "control"]);
        let errors = String::from_utf8_lossy(&control.stderr);
        assert!(!control.status.success() && errors.contains("a_panic_is_reachable"), "{profile}: {errors}");
    }
}

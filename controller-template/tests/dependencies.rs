//! What a program gets with the runtime: nothing else, unless it asks for it.

use std::collections::BTreeSet;
use std::process::Command;

/// The direct dependencies with some features.
fn dependencies(features: &str) -> BTreeSet<String> {
    let tree = Command::new(env!("CARGO"))
        .args([
            "tree",
            "--offline",
            "--edges",
            "normal",
            "--prefix",
            "none",
            "--depth",
            "1",
            "--format",
            "{lib}",
        ])
        .args(["--package", "controller-template", "--no-default-features", "--features", features])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("cargo runs");
    assert!(tree.status.success(), "{}", String::from_utf8_lossy(&tree.stderr));
    let text = String::from_utf8(tree.stdout).expect("text");
    let mut names: BTreeSet<String> = text.lines().map(str::to_owned).collect();
    assert!(names.remove("controller_template"), "{text}");
    names
}

#[track_caller]
fn check(features: &str, expected: &[&str]) {
    assert_eq!(dependencies(features), expected.iter().map(|&name| name.to_owned()).collect(), "{features}");
}

#[test]
fn features_bring_one_each_and_nothing_else_does() {
    check("default", &[]);
    check("names", &[]);
    check("defmt", &["defmt"]);
    check("heapless", &["heapless"]);
    check("serde", &["serde"]);
    check("defmt,heapless,names,serde", &["defmt", "heapless", "serde"]);
}

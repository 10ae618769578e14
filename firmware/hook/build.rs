//! Writes the production cell's module as `$OUT_DIR/hook.rs`, and into it a copy of the runtime's machine; with the feature
//! `hookless` the copy is without observer: the source as it is now, less every mention. So it follows each change of the
//! loop, a use of the observer that is not known here does not compile, and nothing but the hook is another in the two.

use std::{env, fs, path::Path};

const MACHINE: &str = "../../controller-template/src/machine.rs";

fn main() {
    synth_core::build::compile("../../examples/production-cell/specs/production_cell.sml");
    println!("cargo::rerun-if-changed={MACHINE}");
    let out = env::var_os("OUT_DIR").expect("cargo sets it");
    let module = fs::read_to_string(Path::new(&out).join("production_cell.rs")).expect("it was written");
    // The loop must be able to name them; they are what they are.
    let items = module.replacen("struct Tables;", "pub struct Tables;", 1);
    let items = items.trim_end().strip_suffix('}').expect("the module ends");
    assert!(items.contains("Machine<Tables, 1>"), "the production cell has one word of events");
    let source = fs::read_to_string(MACHINE).expect("the runtime is there");
    let start = source.find("/// A controller at work").expect("the struct has its comment");
    // Features of the runtime are not those of this program.
    let lines = source[start..].lines().filter(|line| !line.trim().starts_with("#[cfg_attr("));
    let machine = lines.collect::<Vec<_>>().join("\n");
    let (machine, observer) = match env::var_os("CARGO_FEATURE_HOOKLESS") {
        Some(_) => (hookless(&machine), ""),
        None => (machine, "use ::controller_template::Observer;"),
    };
    let text = format!(
        "{items}\n    /// The runtime's machine.\n    pub mod machine {{\n\
         #![allow(dead_code, missing_docs, unused_imports, unused_variables)]\n\
         use ::controller_template::{{Bits, CommandSet, Number, Tables}};\n{observer}\n\
         pub type Controller = Machine<super::Tables, 1>;\n{machine}\n}}\n}}\n"
    );
    fs::write(Path::new(&out).join("hook.rs"), text).expect("it can be written");
}

/// Without any mention of the observer.
fn hookless(machine: &str) -> String {
    const PARAMETER: &str = "observer: &mut impl Observer<T::Event, T::Commands>";
    let mentions = |line: &str| {
        let line = line.trim();
        line.starts_with("observer.") || line.trim_end_matches(',') == PARAMETER
    };
    let lines: Vec<&str> = machine.lines().filter(|line| !mentions(line)).collect();
    let text = lines.join("\n").replace(&format!(", {PARAMETER}"), "");
    let text = text.replace(", observer)", ")").replace("(observer)", "()");
    assert!(!text.to_lowercase().contains("observer"), "a use of the observer that is not known:\n{text}");
    text
}

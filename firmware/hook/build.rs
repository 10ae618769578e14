//! Writes the production cell's module as `$OUT_DIR/hook.rs`, and into it, as `hookless`, the runtime's machine without its
//! observer: the source as it is now, less every mention. So it follows each change of the loop, and a use of the observer
//! that is not known here does not compile.

use std::{env, fs, path::Path};

const MACHINE: &str = "../../controller-template/src/machine.rs";

fn main() {
    synth_core::build::compile("../../examples/production-cell/specs/production_cell.sml");
    println!("cargo::rerun-if-changed={MACHINE}");
    let out = env::var_os("OUT_DIR").expect("cargo sets it");
    let module = fs::read_to_string(Path::new(&out).join("production_cell.rs")).expect("it was written");
    let (items, end) = module.trim_end().split_at(module.trim_end().len() - 1);
    assert_eq!(end, "}", "the module ends");
    let machine = hookless(&fs::read_to_string(MACHINE).expect("the runtime is there"));
    let words = items.matches("Machine<Tables, 1>").count();
    assert_eq!(words, 1, "the production cell has one word of events");
    // The loop must be able to name them; they are what they are.
    let items = items.replacen("struct Tables;", "pub struct Tables;", 1);
    let text = format!(
        "{items}\n    /// The runtime's machine, as if nobody could observe it.\n    pub mod hookless {{\n\
         #![allow(dead_code, missing_docs, unused_variables)]\n\
         use ::controller_template::{{Bits, CommandSet, Number, Tables}};\n\
         pub type Hookless = Machine<super::Tables, 1>;\n{machine}\n}}\n}}\n"
    );
    fs::write(Path::new(&out).join("hook.rs"), text).expect("it can be written");
}

fn hookless(machine: &str) -> String {
    const PARAMETER: &str = "observer: &mut impl Observer<T::Event, T::Commands>";
    let start = machine.find("/// A controller at work").expect("the struct has its comment");
    let mentions = |line: &str| {
        let line = line.trim();
        line.starts_with("observer.")
            || line.trim_end_matches(',') == PARAMETER
            || line.starts_with("#[cfg_attr(")
    };
    let lines: Vec<&str> = machine[start..].lines().filter(|line| !mentions(line)).collect();
    let text = lines.join("\n").replace(&format!(", {PARAMETER}"), "");
    let text = text.replace(", observer)", ")").replace("(observer)", "()");
    assert!(!text.to_lowercase().contains("observer"), "a use of the observer that is not known:\n{text}");
    text
}

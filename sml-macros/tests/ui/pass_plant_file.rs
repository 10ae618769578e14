//! A plant in a file, its path relative to the package; with all attributes, and without.
#![deny(warnings, missing_docs, unused)]

sml_macros::plant! { #![dont_care = "all"] #![extract] "specs/clamp.plant" }

mod careful {
    sml_macros::plant!("specs/clamp.plant");
}

fn main() {
    let inputs = clamp::Inputs { open: true, ..Default::default() };
    let mut outputs = clamp::Outputs::default();
    assert!(clamp::scan(&inputs, &mut outputs).contains(clamp::Event::Close));
    assert!(outputs.air);

    // Both switches: not possible, so nothing happens unless that may be anything.
    use careful::clamp::{Inputs, Outputs, scan};
    let mut outputs = Outputs::default();
    assert!(scan(&Inputs { open: false, shut: true }, &mut outputs).is_empty());
    assert!(scan(&Inputs { open: true, shut: false }, &mut outputs).contains(careful::clamp::Event::Close));
}
